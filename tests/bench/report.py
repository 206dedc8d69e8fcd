# SPDX-License-Identifier: MIT
"""The tables for the README, and the budgets."""

import csv
import fnmatch

import figures
import image as images
import timing

TITLES = {
    "cortex-m0": "M0", "cortex-m0plus": "M0+", "cortex-m3": "M3", "cortex-m4f": "M4F",
    "cortex-m7": "M7", "cortex-m33": "M33", "rv32imac": "RV32 IMAC", "rv32imafc": "RV32 IMAFC",
    "atmega328p": "ATmega 328P", "atmega2560": "ATmega 2560",
}
TIMED = ("step", "set_velocity", "advance", "force", "output")


def markdown(first, rows, unit_of=lambda core: ""):
    heads = [first, *(TITLES[core] + unit_of(core) for core in timing.CORES)]
    lines = ["| " + " | ".join(heads) + " |", "|---" + "|--:" * len(timing.CORES) + "|"]
    for title, row in rows:
        lines.append("| " + " | ".join([title, *(f"{row[core]:,}" for core in timing.CORES)]) + " |")
    return "\n".join(lines)


def cost_table(table):
    rows = [("Algorithm 1, transcribed", figures.worst(table, "naive", "step", "cost"))]
    for variant in figures.VARIANTS:
        for function in TIMED:
            rows.append((f"{variant} `{function}`", figures.worst(table, variant, function, "cost")))
            if function == "advance":
                rows.append((f"{variant} `advance`, elastic", table[variant, "advance", "elastic", "cost"]))
    return markdown("cycles, or instructions (i)", rows,
                    lambda core: "" if figures.cost_metric(core) == "cycles" else " (i)")


def size_table(table):
    rows = [("Algorithm 1, transcribed: flash", table["naive", "step", "alone", "flash"])]
    for variant in figures.VARIANTS:
        rows += [
            (f"{variant}: flash, split calls, all forms", table[variant, "split", "all forms", "flash"]),
            (f"{variant}: flash, split calls, one form", table[variant, "split", "one form", "flash"]),
            (f"{variant}: flash, `step`, one form", table[variant, "joined", "one form", "flash"]),
            (f"{variant}: coefficients", table[variant, "coeffs", "any", "bytes"]),
            (f"{variant}: RAM per contact", table[variant, "contact", "any", "bytes"]),
            (f"{variant}: stack", figures.worst(table, variant, "run time", "stack")),
            (f"{variant}: stack of `coeffs_init`", table[variant, "coeffs_init", "worst", "stack"]),
        ]
    return markdown("bytes", rows)


def blocks(table):
    """What stands in the README, markers included."""
    tables = {"cost": cost_table(table), "size": size_table(table)}
    return {name: f"<!-- bench: {name} -->\n{text}\n<!-- bench: end -->" for name, text in tables.items()}


def replaced(text, name, block):
    """The text with another block between the markers of that name."""
    before, start, rest = text.partition(f"<!-- bench: {name} -->")
    _, end, after = rest.partition("<!-- bench: end -->")
    if not start or not end:
        raise images.Failure(f"README.md: no <!-- bench: {name} --> ... <!-- bench: end -->")
    return before + block + after


def renewed(readme, table):
    """The text of the README with these tables."""
    for name, block in blocks(table).items():
        readme = replaced(readme, name, block)
    return readme


def budget_lines(file, table):
    """One line for each budget: what comes nearest to it, or goes beyond, of the measured cores."""
    with open(file, newline="", encoding="utf-8") as stream:
        for row in csv.DictReader(stream):
            candidates = [(value, f"{core} {variant}")
                          for variant in fnmatch.filter(figures.VARIANTS, row["variant"])
                          for core, value in budgeted(table, variant, row).items()
                          if fnmatch.fnmatch(core, row["core"])]
            if candidates:
                yield budget_line(row, *max(candidates))


def budget_line(row, value, where):
    verdict = name = ""
    if row["at_most"]:
        verdict = "held" if value <= int(row["at_most"]) else "EXCEEDED"
        name = f", at most {row['at_most']}"
    if row["floor"]:
        name += f", floor {row['floor']}"
    return f"{verdict:8} {where} {row['function']} {row['path']} {row['metric']}: {value}{name}"


def budgeted(table, variant, row):
    """{core: the figure that a budget is about}; functions joined by + are summed."""
    functions, path, metric = row["function"].split("+"), row["path"], row["metric"]
    parts = [figures.worst(table, variant, function, metric) if path == "worst" else
             table[variant, function, path, metric] for function in functions]
    return {core: sum(part[core] for part in parts) for core in parts[0]}
