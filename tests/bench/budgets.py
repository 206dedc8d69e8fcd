# SPDX-License-Identifier: MIT
"""What epf may cost: budgets.csv, held or exceeded.

core      patterns, separated by spaces
function  or several, joined by +, whose worst are summed; "any"; "run time": any but coeffs_init
rule      of update, in a build with both; or "... alone", in a build for that one; "any"; of flash: of a
          library compiled for it
form      of f_ss, or "any"; "one": of a library compiled for one
path      "any"; "finite": with an ordinary contact, all but the extremes and what is rejected
at_most   of the worst that was run
exceeded_because  why it may be exceeded; without a reason it may not"""

import csv
import fnmatch

import figures
import image as images
import timing
from gate import matches

BUDGETS = images.HERE / "budgets.csv"
NOT_FINITE = ("extreme", "rejected")


def read(file=BUDGETS):
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def is_meant(budget, rule, form, contact, path):
    if budget["form"] not in ("any", form) or budget["rule"] not in ("any", rule):
        return False
    if budget["path"] == "finite":
        return contact == "ordinary" and path not in NOT_FINITE
    return budget["path"] in ("any", path)


def cost(core, measured, variant, function, budget):
    """The worst that was run in that form, on these paths."""
    return max((value for (*who, rule, form, contact, path, metric), value in measured.items()
                if who == [variant, function] and metric == timing.cost_metric(core)
                and is_meant(budget, rule, form, contact, path)), default=None)


def size(core, table, variant, function, budget):
    """What stands in the table of figures."""
    if budget["form"] == "one":
        return table[variant, function, budget["rule"], "one form", budget["metric"]].get(core)
    return figures.worst(table, variant, function, budget["metric"], budget["rule"]).get(core)


def values(core, table, measured, budget):
    """(value, variant) of all that a budget is about on that core."""
    for variant in fnmatch.filter(images.VARIANTS, budget["variant"]):
        functions = budget["function"].split("+")
        parts = [cost(core, measured, variant, function, budget) if budget["metric"] == "cost"
                 else size(core, table, variant, function, budget) for function in functions]
        if None in parts:
            raise images.Failure(f"a budget of what is not measured: {core} {dict(budget)}")
        yield sum(parts), variant


def verdict(budget, nearest):
    value, core, variant = nearest
    what = " ".join(budget[name] for name in ("function", "rule", "form", "path", "metric")
                    if budget[name] != "any")
    line = f"{core} {variant} {what}: {value}, at most {budget['at_most']}"
    if value <= int(budget["at_most"]):
        return "held", line
    reason = budget["exceeded_because"]
    return ("excepted", f"{line}: {reason}") if reason else ("EXCEEDED", line)


def verdicts(budgets, table, measured):
    """("held", "excepted" or "EXCEEDED"; a line) of each budget: of what comes nearest to it, or goes
    farthest beyond, on the cores that were measured, {core: what tracing.measure gives}."""
    for budget in budgets:
        found = [(value, core, variant) for core in measured if matches(budget["core"], core)
                 for value, variant in values(core, table, measured[core], budget)]
        if found:
            yield verdict(budget, max(found))
