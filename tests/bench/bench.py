#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures what epf costs on every core, deterministically, in emulators. See README.md here.

    bench.py SCRATCH             builds and runs in the folder SCRATCH; writes results.csv and
                                 tables.md there, and prints the budgets
    bench.py SCRATCH --check     and fails when a figure is worse than in baseline.csv by more than
                                 2 %, or the README has other tables
    bench.py SCRATCH --update    and makes the figures the baseline, and the tables those of the README
    bench.py SCRATCH --self-test tests the counting and the gate instead
"""

import argparse
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True # no cache beside the sources

import figures
import image as images
import report
import selftest
import timing
import tracing

BASELINE = images.HERE / "baseline.csv"
README = images.HERE.parent.parent / "README.md"


def measure(cores, scratch):
    """All figures; results.csv gets everything that was traced."""
    found, rows = {}, []
    for core in cores:
        print(f"measuring {core}", flush=True)
        found[core], measured = figures.of_core(core, scratch)
        rows += [(core, *key, value) for key, value in measured.items()]
    with open(scratch / "results.csv", "w", newline="", encoding="utf-8") as stream:
        out = csv.writer(stream, lineterminator="\n")
        out.writerow(["core", "variant", "function", "form", "path", "metric", "value"])
        out.writerows(rows)
    return figures.by_core(found)


def check(table, all_cores):
    """Is everything as the baseline and the README say?"""
    worse, better = figures.compare(figures.read(BASELINE), table)
    for line in better:
        print(f"better: {line}")
    if better:
        print("renew the baseline with --update")
    for line in worse:
        print(f"WORSE: {line}")
    if all_cores:
        readme = README.read_text(encoding="utf-8")
        for name, block in report.blocks(table).items():
            if block not in readme:
                worse.append(name)
                print(f"WORSE: README.md has other figures in its table bench: {name}")
    return not worse


def update(table):
    readme = report.renewed(README.read_text(encoding="utf-8"), table)
    figures.write(BASELINE, table)
    README.write_text(readme, encoding="utf-8")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("scratch", type=Path)
    parser.add_argument("--cores", nargs="+", choices=timing.CORES, default=timing.CORES,
                        help="only these", metavar="CORE")
    what = parser.add_mutually_exclusive_group()
    for action in ("check", "update", "self-test"):
        what.add_argument(f"--{action}", action="store_true")
    return parser.parse_args()


def main():
    options = arguments()
    all_cores = set(options.cores) == set(timing.CORES)
    if options.update and not all_cores:
        raise images.Failure("--update needs all cores")
    options.scratch.mkdir(parents=True, exist_ok=True)
    tracing.build_tracers(options.scratch)
    if options.self_test:
        return selftest.passes(options.scratch)

    table = measure(options.cores, options.scratch)
    if all_cores:
        text = "\n\n".join(report.blocks(table).values()) + "\n"
        (options.scratch / "tables.md").write_text(text, encoding="utf-8")
    for line in report.budget_lines(images.HERE / "budgets.csv", table):
        print(line)
    if options.update:
        update(table)
    return check(table, all_cores) if options.check else True


if __name__ == "__main__":
    try:
        sys.exit(0 if main() else 1)
    except (images.Failure, OSError) as failure:
        sys.exit(f"bench: {failure}")
