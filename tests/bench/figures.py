# SPDX-License-Identifier: MIT
"""The figures that are told and gated: {(variant, function, rule, path, metric): {core: value}}.

rule    of update, in a build with both: of the functions that depend on it; else "any", the worse of both;
        "saturated alone", "mean_value alone": of a build with that rule only
metric  cost   cycles, where the core is modelled, or else instructions: worst of forms and contacts
        bound  what no cost exceeds, of the machine code
        branch the most that a call costs more in a build with both rules than in one with that rule
        stack  bytes, worst of all paths
        deepest  the same of the machine code
        flash  bytes of a link of the function alone, or of a typical set of them
        ram    bytes of .data and .bss of that link
        bytes  of an object in RAM or flash
"""

import csv

import bound
import image as images
import timing
import tracing

WITH_RULE = ("advance", "update", "step") # what depends on the rule
LINKS = {
    "split": ("init", "set_velocity", "advance", "force", "output"),
    "joined": ("init", "step", "output"),
}
KEY = ("variant", "function", "rule", "path", "metric")


def folded(core, measured):
    """Of what tracing.measure gives: the cost of every path and the stack of every function. Of builds
    with one rule, no more than the worst."""
    found = {}
    for (variant, function, rule, _, _, path, metric), value in measured.items():
        alone = rule.endswith(images.ALONE)
        if alone and function not in WITH_RULE:
            continue
        if metric == timing.cost_metric(core):
            key = (variant, function, rule if function in WITH_RULE else "any",
                   "worst" if alone else path, "cost")
        elif metric == "stack":
            key = (variant, function, rule if alone else "any", "worst", "stack")
        else:
            continue
        found[key] = max(found.get(key, 0), value)
    return found


def branches(core, measured):
    """What a call costs more where the build has both rules than where it has one: the most of each
    function and rule."""
    found = {}
    for (variant, function, rule, *case, metric), value in measured.items():
        both = (variant, function, rule.removesuffix(images.ALONE), *case, metric)
        if both[2] != rule and function in WITH_RULE and metric == timing.cost_metric(core):
            key = (variant, function, both[2], "worst", "branch")
            found[key] = max(found.get(key, 0), measured[both] - value)
    return found


def sizes(image, measured):
    """What everything occupies."""
    found = {}

    def link(variant, name, rule, path, library, functions):
        flash, ram = images.occupied(image, library, *functions)
        found[variant, name, rule, path, "flash"] = flash
        found[variant, name, rule, path, "ram"] = ram

    for variant in images.VARIANTS:
        for function in sorted({key[1] for key in measured if key[0] == variant}):
            link(variant, function, "any", "alone", "epf_small", [f"epf_{variant}_{function}"])
        for name, parts in LINKS.items():
            functions = [f"epf_{variant}_{part}" for part in parts]
            link(variant, name, "any", "all forms", "epf_small", functions)
            for rule in images.RULES:
                link(variant, name, rule, "one form", f"epf_one_form_{rule}", functions)
    for rival in images.RIVALS:
        link(rival, "step", "any", "alone", "naive_small", [f"{rival}_step"])
    for name, size in images.object_sizes(image).items():
        kind, variant = name.split("_")
        found[variant, kind, "any", "any", "bytes"] = size
    return found


def bounded(bounds):
    """The same of what bound.of_image gives."""
    found = {}
    for (variant, function, rule), (cost, stack) in bounds.items():
        if rule == "any" or function in WITH_RULE:
            found[variant, function, rule, "worst", "bound"] = cost
            found[variant, function, rule, "worst", "deepest"] = stack
    return found


def check_complete(image, measured):
    """No public function of the library goes without being measured."""
    public = {name for _, _, name in images.symbols(image, "libepf_fast.a")
              if bound.RUN_TIME.fullmatch(name)}
    missing = public - {f"epf_{key[0]}_{key[1]}" for key in measured}
    if missing:
        raise images.Failure(f"{image.core}: not measured: {' '.join(sorted(missing))}")


def of_core(core, scratch):
    """Builds, runs and measures: the figures of a core, all that its trace gave, and why there is no
    bound of a function that should have one."""
    image = images.build(core, scratch)
    measured = tracing.measure(image)
    check_complete(image, measured)
    bounds, refusals = bound.of_image(image)
    found = {**folded(core, measured), **branches(core, measured), **bounded(bounds),
             **sizes(image, measured)}
    return found, measured, [(core, *function, reason) for function, reason in refusals.items()]


def by_core(figures_of_cores):
    """From {core: {key: value}} to {key: {core: value}}."""
    table = {}
    for core, found in figures_of_cores.items():
        for key, value in found.items():
            table.setdefault(key, {})[core] = value
    return table


def worst(table, variant, function, metric, rule="any"):
    """{core: the largest value of all paths} of a function; of "any"; of those called at "run time". By
    that rule; by "any" in a build with both."""
    def is_meant(name):
        return function in (name, "any") or (function == "run time" and name != "coeffs_init")

    def is_by(name):
        return name == rule or (rule == "any" and not name.endswith(images.ALONE))

    rows = [row for key, row in table.items()
            if key[0] == variant and is_meant(key[1]) and is_by(key[2]) and key[4] == metric]
    return {core: max(row[core] for row in rows) for core in (rows[0] if rows else {})}


def write(file, table):
    cores = [core for core in timing.CORES if any(core in row for row in table.values())]
    with open(file, "w", newline="", encoding="utf-8") as stream:
        out = csv.writer(stream, lineterminator="\n")
        out.writerow([*KEY, *cores])
        out.writerows([*key, *(row.get(core, "") for core in cores)] for key, row in table.items())


def read(file):
    try:
        with open(file, newline="", encoding="utf-8") as stream:
            rows = list(csv.DictReader(stream))
        return {tuple(row.pop(name) for name in KEY):
                {core: int(value) for core, value in row.items() if value} for row in rows}
    except (OSError, KeyError, ValueError) as error:
        raise images.Failure(f"{file} is no table of figures: {error}") from error


def compare(baseline, table):
    """What has become worse by more than 2 %, or is missing; and what has become better by that."""
    worse, better = [], []
    measured = {core for row in table.values() for core in row}
    for key in {**baseline, **table}:
        old_row, new_row = baseline.get(key, {}), table.get(key, {})
        for core in timing.CORES:
            old, new = old_row.get(core), new_row.get(core)
            place = f"{core} {' '.join(key)}"
            if core not in measured or old == new:
                continue
            if old is None:
                worse.append(f"{place}: {new}, not in the baseline")
            elif new is None:
                worse.append(f"{place}: no longer measured")
            elif 100 * new > 102 * old:
                worse.append(f"{place}: {new}, was {old}")
            elif 100 * new < 98 * old:
                better.append(f"{place}: {new}, was {old}")
    return worse, better
