#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures what epf costs on every core, deterministically, in emulators. See README.md here.

    bench.py SCRATCH             builds and runs in the folder SCRATCH; writes results.csv and
                                 tables.md there, and prints the budgets
    bench.py SCRATCH --check     and fails when a figure is worse than in baseline.csv by more than
                                 2 %, a bound is not near what was run, a budget is exceeded, or a
                                 README has other tables
    bench.py SCRATCH --update    and makes the figures the baseline, and the tables those of the READMEs
    bench.py SCRATCH --self-test tests the counting and the gate instead
"""

import argparse
import csv
import sys
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat
from pathlib import Path

sys.dont_write_bytecode = True # no cache beside the sources

import budgets
import figures
import gate
import image as images
import report
import selftest
import timing
import tracing

BASELINE = images.HERE / "baseline.csv"


def measure(cores, scratch):
    """The table of figures, {core: all that was traced}, and what has no bound."""
    found, measured, refusals = {}, {}, []
    with ProcessPoolExecutor() as pool: # several cores at a time
        for core, result in zip(cores, pool.map(figures.of_core, cores, repeat(scratch))):
            found[core], measured[core], refused = result
            refusals += refused
            print(f"measured {core}", flush=True)
    write_results(scratch / "results.csv", measured)
    return figures.by_core(found), measured, refusals


def write_results(file, measured):
    with open(file, "w", newline="", encoding="utf-8") as stream:
        out = csv.writer(stream, lineterminator="\n")
        out.writerow(["core", "variant", "function", "rule", "form", "contact", "path", "metric", "value"])
        for core, found in measured.items():
            out.writerows((core, *key, value) for key, value in found.items())


def write_tables(file, table):
    texts = [text for of_file in report.blocks(table).values() for text in of_file.values()]
    file.write_text("\n\n".join(texts) + "\n", encoding="utf-8")


def print_budgets(table, measured):
    """And return those that are exceeded without a reason."""
    verdicts = list(budgets.verdicts(budgets.read(), table, measured))
    for verdict, line in verdicts:
        print(f"{verdict:8} {line}")
    return [line for verdict, line in verdicts if verdict == "EXCEEDED"]


def print_gate(table, refusals, all_cores):
    """And return what is not near its bound."""
    failed, unneeded = gate.failures(table, refusals, gate.read_exceptions())
    for line in unneeded if all_cores else ():
        print(f"exceptions.csv: nothing needs {line}")
    for line in failed:
        print(f"FAILS: {line}")
    return failed


def compare(table, all_cores):
    """What is not as the baseline and the READMEs say."""
    worse, better = figures.compare(figures.read(BASELINE), table)
    if all_cores:
        worse += report.outdated(table)
    for line in better:
        print(f"better: {line}")
    if better:
        print("renew the baseline with --update")
    for line in worse:
        print(f"WORSE: {line}")
    return worse


def update(table):
    texts = report.renewed(table)
    figures.write(BASELINE, table)
    for file, text in texts.items():
        file.write_text(text, encoding="utf-8")


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
    scratch = options.scratch.resolve()
    all_cores = set(options.cores) == set(timing.CORES)
    if options.update and not all_cores:
        raise images.Failure("--update needs all cores")
    scratch.mkdir(parents=True, exist_ok=True)
    tracing.build_tracers(scratch)
    if options.self_test:
        return selftest.passes(scratch)

    table, measured, refusals = measure(options.cores, scratch)
    if all_cores:
        write_tables(scratch / "tables.md", table)
    wrong = print_budgets(table, measured) + print_gate(table, refusals, all_cores)
    if options.update:
        update(table)
    return not (wrong + compare(table, all_cores)) if options.check else True


if __name__ == "__main__":
    try:
        sys.exit(0 if main() else 1)
    except (images.Failure, OSError) as failure:
        sys.exit(f"bench: {failure}")
