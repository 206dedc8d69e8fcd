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
RIVALS = {
    "naive": "Algorithm 1, transcribed", "lugre_euler": "LuGre, explicit Euler in time",
    "lugre_exact": "LuGre, exact for a velocity that is held",
    "ep_euler": "elasto-plastic, explicit Euler in time",
}
SATURATED = f"saturated{images.ALONE}"
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


def in_cost_unit(first, rows):
    return by_core(f"{first}: cycles, or instructions (i)", rows,
                   lambda core: "" if timing.cost_metric(core) == "cycles" else " (i)")


def cost_row(table, title, variant, function, rule="any"):
    """The worst that was run, and the bound."""
    return (title, *(figures.worst(table, variant, function, metric, rule)
                     for metric in ("cost", "bound")))


def cost_table(table):
    rows = [cost_row(table, RIVALS["naive"], "naive", "step")]
    for variant in images.VARIANTS:
        for function in TIMED:
            title = f"{variant} `{function}`"
            rows.append(cost_row(table, title, variant, function))
            if function in figures.WITH_RULE:
                rows.append(cost_row(table, f"{title}, saturated", variant, function, SATURATED))
            if function == "advance":
                rows.append((f"{title}, elastic", elastic(table, variant)))
    return in_cost_unit("run / bound", rows)


def elastic(table, variant):
    """{core: what an elastic displacement costs}, by either rule"""
    rows = [table[variant, "advance", rule, "elastic", "cost"] for rule in images.RULES]
    return {core: max(row[core] for row in rows) for core in rows[0]}


def rule_table(table):
    """What each rule costs in a build with both, and alone."""
    return in_cost_unit("both / alone", [
        (f"{variant} `{function}`, {rule.replace('_', ' ')}",
         figures.worst(table, variant, function, "cost", rule),
         figures.worst(table, variant, function, "cost", rule + images.ALONE))
        for variant in images.VARIANTS for function in TIMED if function in figures.WITH_RULE
        for rule in images.RULES])


def rival_table(table):
    return in_cost_unit("run", [
        *(cost_row(table, title, rival, "step") for rival, title in RIVALS.items()),
        *((f"{variant} `step`", figures.worst(table, variant, "step", "cost"))
          for variant in images.VARIANTS)])


def size_table(table):
    def flash(variant, links, rule, path):
        return table[variant, links, rule, path, "flash"]

    rows = [("Algorithm 1, transcribed: flash", flash("naive", "step", "any", "alone"))]
    for variant in images.VARIANTS:
        rows += [
            (f"{variant}: flash, split calls, all forms, both rules",
             flash(variant, "split", "any", "all forms")),
            *((f"{variant}: flash, {title}, one form, {rule.replace('_', ' ')}",
               flash(variant, links, rule, "one form"))
              for title, links in (("split calls", "split"), ("`step`", "joined"))
              for rule in reversed(images.RULES)),
            (f"{variant}: coefficients", table[variant, "coeffs", "any", "any", "bytes"]),
            (f"{variant}: RAM per contact", table[variant, "contact", "any", "any", "bytes"]),
            (f"{variant}: stack", figures.worst(table, variant, "run time", "stack")),
            (f"{variant}: stack of `coeffs_init`", table[variant, "coeffs_init", "any", "worst", "stack"]),
        ]
    return by_core("bytes", rows)


def floor_table(table):
    """What the floor is made of, and above it what was run and the bound."""
    floor = floors.read()
    total = floors.totals(floor)
    rows = [[what, *("" if value is None else str(value) for value in row.values())]
            for what, row in floor.items()]
    rows.append(["**floor**", *(f"**{value}**" for value in total.values())])
    for title, metric in (("worst that was run", "cost"), ("bound", "bound")):
        rows.append([title, *(str(figures.worst(table, variant, function, metric, rule + images.ALONE)[core])
                              for core, variant, function, rule in total)])
    heads = [f"{TITLES[core]} {variant} `{function}`, {rule.replace('_', ' ')}"
             for core, variant, function, rule in total]
    return markdown(["cycles", *heads], rows)


def blocks(table):
    """{file: {name: what stands there, markers included}}"""
    tables = {README: {"cost": cost_table(table), "size": size_table(table)},
              NOTES: {"rules": rule_table(table), "rivals": rival_table(table),
                      "floor": floor_table(table)}}
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
