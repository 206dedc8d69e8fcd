# SPDX-License-Identifier: MIT
"""That the worst which was run comes near the bound: what fails, but for the named exceptions.

exceptions.csv names them, each with its reason: of the bound, of the stack, and of code that is refused
because it has a loop, recursion or an indirect jump; and of what a build with both rules costs more.
Core, variant, function and rule are patterns; of cores there may be several."""

import csv
import fnmatch

import figures
import image as images
import timing

EXCEPTIONS = images.HERE / "exceptions.csv"
WHAT = ("bound", "stack", "refused", "branch")
MOST = {"cycles": 110, "instructions": 115} # % of what was run, where that is the cost
PLACE = ("core", "variant", "function", "rule")
BRANCH = 10 # cycles or instructions: a load, a comparison, a branch, and registers that are laid out
            # otherwise; or 4 % of a call, if that is more


def matches(patterns, name):
    """Does one of these patterns, separated by spaces, match?"""
    return any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns.split())


def read_exceptions(file=EXCEPTIONS):
    with open(file, newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    for row in rows:
        if row.get("what") not in WHAT or not row.get("reason"):
            raise images.Failure(f"{file}: no exception, or none with a reason: {dict(row)}")
    return rows


def of_bound(core, run, bound):
    """(what, what is wrong) with a bound, given the worst that was run."""
    most = MOST[timing.cost_metric(core)]
    if run > bound:
        yield "no bound", f"{run} were run, its bound is {bound}"
    if 100 * bound > most * run:
        yield "bound", f"its bound, {bound}, is more than {most} % of the worst that was run, {run}"


def of_stack(_, used, deepest):
    """The same of the stack."""
    if used > deepest:
        yield "no bound", f"{used} bytes of stack were used, its code needs {deepest}"
    if used < deepest:
        yield "stack", f"its code needs {deepest} bytes of stack, at most {used} were used"


def of_branch(_, run, more):
    """The same of a build with both rules: a call costs what it costs alone, but for one branch."""
    if more > max(BRANCH, run * 4 // 100):
        yield "branch", f"in a build with both rules it costs up to {more} more; at worst {run}"


# What is compared with what, and how
CHECKS = {"bound": ("cost", of_bound), "deepest": ("stack", of_stack),
          "branch": ("cost", of_branch)}


def findings(table, refusals):
    """(what, core, variant, function, rule, what is wrong) of all that is wrong."""
    for place in refusals:
        yield "refused", *place
    for (variant, function, rule, _, metric), bounds in table.items():
        if metric in CHECKS:
            of, check = CHECKS[metric]
            run = figures.worst(table, variant, function, of, rule)
            for core, limit in bounds.items():
                for what, wrong in check(core, run[core], limit):
                    yield what, core, variant, function, rule, wrong


def failures(table, refusals, exceptions):
    """(what fails, as lines; the exceptions that nothing needs, as lines)."""
    failed, needed = [], []
    for *place, wrong in findings(table, refusals):
        named = [row for row in exceptions if is_about(row, *place)]
        needed += named
        if not named:
            failed.append(f"{' '.join(place[1:])}: {wrong}")
    unneeded = [" ".join(row[name] for name in ("what", *PLACE))
                for row in exceptions if row not in needed]
    return failed, unneeded


def is_about(row, what, *place):
    return row["what"] == what and all(matches(row[name], value) for name, value in zip(PLACE, place))
