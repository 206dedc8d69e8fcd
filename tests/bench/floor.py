# SPDX-License-Identifier: MIT
"""What the mathematics asks for, counted by hand: floor.csv. A cell has cycles, or instructions, which
are charged as timing.py charges those that are traced: "3 ldr" are three loads in a row."""

import csv

import image as images
import timing

FLOOR = images.HERE / "floor.csv"
KINDS = {
    "ldr": ("ldr", "r0, [r1, #4]"), "str": ("str", "r0, [r1, #4]"),
    "vldr": ("vldr", "s0, [r1, #4]"), "vstr": ("vstr", "s0, [r1, #4]"),
    "cmp": ("cmp", "r0, r1"), "vcmp": ("vcmp.f32", "s0, s1"), "vmrs": ("vmrs", "APSR_nzcv, fpscr"),
    "branch": ("beq.n", "0"), "return": ("bx", "lr"),
    "integer": ("adds", "r0, r1, r2"),
    "float": ("vadd.f32", "s0, s1, s2"), "vdiv": ("vdiv.f32", "s0, s1, s2"),
}


def cycles(core, cell):
    """What a cell amounts to, branches not taken, results not waited for."""
    return sum(int(part) if part.isdigit() else of_kind(core, *part.split())
               for part in cell.split(", ") if part)


def of_kind(core, number, kind):
    if kind not in KINDS:
        raise images.Failure(f"{FLOOR.name}: no instruction is called {kind}")
    this = images.Instruction(2, *KINDS[kind])
    model = timing.MODELS[core]["cycles"]
    befores = [None] + [this] * (int(number) - 1)
    return sum(model(before, this, kind == "return") for before in befores)


def read(file=FLOOR):
    """{what: {(core, variant, function, rule): cycles, or None where nothing is asked for}}"""
    with open(file, newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    found = {}
    for row in rows:
        what = row.pop("what")
        found[what] = {tuple(place.split()): cycles(place.split()[0], cell) if cell else None
                       for place, cell in row.items()}
    return found


def totals(floor):
    """{(core, variant, function, rule): the floor}"""
    places = next(iter(floor.values()))
    return {place: sum(row[place] or 0 for row in floor.values()) for place in places}
