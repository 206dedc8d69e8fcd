# SPDX-License-Identifier: MIT
"""The tables of the READMEs."""

import figures
import floor as floors
import image as images
import timing

TITLES = {
    "cortex-m0": "M0", "cortex-m0plus": "M0+", "cortex-m3": "M3", "cortex-m4f": "M4F",
    "cortex-m7": "M7", "cortex-m33": "M33", "rv32imac": "RV32 IMAC", "rv32imafc": "RV32 IMAFC",
    "atmega328p": "ATmega 328P", "atmega2560": "ATmega 2560",
}
TIMED = ("step", "set_velocity", "advance", "force", "output")
ROOT = images.HERE.parent.parent
README = ROOT / "README.md"
NOTES = images.HERE / "README.md"


def markdown(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|---" + "|--:" * (len(heads) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def by_core(first, rows, unit_of=lambda core: ""):
    """A column for each core; rows are (title, {core: value}) or (title, {core: value}, {core: bound})."""
    heads = [first, *(TITLES[core] + unit_of(core) for core in timing.CORES)]
    return markdown(heads, [[title, *(cell(core, *values) for core in timing.CORES)]
                            for title, *values in rows])


def cell(core, values, bounds=None):
    run = f"{values[core]:,}"
    return f"{run} / {bounds[core]:,}" if bounds and core in bounds else run


def cost_table(table):
    rows = [("Algorithm 1, transcribed", figures.worst(table, "naive", "step", "cost"))]
    for variant in figures.VARIANTS:
        for function in TIMED:
            rows.append((f"{variant} `{function}`", figures.worst(table, variant, function, "cost"),
                         figures.worst(table, variant, function, "bound")))
            if function == "advance":
                rows.append((f"{variant} `advance`, elastic", table[variant, "advance", "elastic", "cost"]))
    return by_core("run / bound: cycles, or instructions (i)", rows,
                   lambda core: "" if timing.cost_metric(core) == "cycles" else " (i)")


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
    return by_core("bytes", rows)


def floor_table(table):
    """What the floor is made of, and above it what was run and the bound."""
    floor = floors.read()
    total = floors.totals(floor)
    rows = [[what, *("" if value is None else str(value) for value in row.values())]
            for what, row in floor.items()]
    rows.append(["**floor**", *(f"**{value}**" for value in total.values())])
    for title, value in (
            ("worst that was run", lambda v, f: figures.worst(table, v, f, "cost")),
            ("bound", lambda v, f: figures.worst(table, v, f, "bound"))):
        rows.append([title, *(str(value(variant, function)[core]) for core, variant, function in total)])
    heads = [f"{TITLES[core]} {variant} `{function}`" for core, variant, function in total]
    return markdown(["cycles", *heads], rows)


def blocks(table):
    """{file: {name: what stands there, markers included}}"""
    tables = {README: {"cost": cost_table(table), "size": size_table(table)},
              NOTES: {"floor": floor_table(table)}}
    return {file: {name: f"<!-- bench: {name} -->\n{text}\n<!-- bench: end -->"
                   for name, text in of_file.items()} for file, of_file in tables.items()}


def replaced(text, name, block):
    """The text with another block between the markers of that name."""
    before, start, rest = text.partition(f"<!-- bench: {name} -->")
    _, end, after = rest.partition("<!-- bench: end -->")
    if not start or not end:
        raise images.Failure(f"no <!-- bench: {name} --> ... <!-- bench: end -->")
    return before + block + after


def renewed(table):
    """{file: its text with these tables}"""
    texts = {}
    for file, of_file in blocks(table).items():
        text = file.read_text(encoding="utf-8")
        for name, block in of_file.items():
            text = replaced(text, name, block)
        texts[file] = text
    return texts


def outdated(table):
    """A line for each table that stands otherwise in its file."""
    for file, of_file in blocks(table).items():
        text = file.read_text(encoding="utf-8")
        for name, block in of_file.items():
            if block not in text:
                yield f"{file.relative_to(ROOT)} has other figures in its table bench: {name}"
