# SPDX-License-Identifier: MIT
"""That the counting counts, and that the gate closes."""

import figures
import image as images
import report
import timing
import tracing


def must(true, what):
    if not true:
        raise images.Failure(f"self-test: {what}")


def refuses(action, what):
    try:
        action()
    except images.Failure:
        return
    raise images.Failure(f"self-test: {what} is not refused")


def check_counting(core, scratch):
    """counted.S comes out as counted by hand, and another figure is refused."""
    measured = tracing.measure(images.build(core, scratch))
    must(measured["q15", "step", "lorentzian", "mixed", "instructions"] > 0, f"no step on {core}")
    right = timing.COUNTED[core]
    for metric in right:
        timing.COUNTED[core] = {**right, metric: right[metric] + 1}
        counted = {("counted", "loop", "any", "any", name): value for name, value in right.items()}
        refuses(lambda: tracing.check_counted(core, counted), f"{core}: a wrong count of {metric}")
    timing.COUNTED[core] = right
    print(f"{core}: counted as by hand: {right}")


def check_gate():
    """Of a figure of 200, 204 passes, 205 does not, 195 is better; so does what comes or goes."""
    key, core = ("q15", "step", "mixed", "cost"), "cortex-m0"
    baseline = {key: {core: 200}}
    verdicts = {value: tuple(map(len, figures.compare(baseline, {key: {core: value}})))
                for value in (195, 196, 200, 204, 205)}
    must(verdicts == {195: (0, 1), 196: (0, 0), 200: (0, 0), 204: (0, 0), 205: (1, 0)},
         f"the gate's verdicts are {verdicts}")
    must(len(figures.compare({key: {core: 0}}, {key: {core: 1}})[0]) == 1, "1 after 0 passes")
    other = {("q31", *key[1:]): {core: 1}}
    must(len(figures.compare(baseline, other)[0]) == 2, "a lost and a new figure pass")
    must(figures.compare(baseline, {}) == ([], []), "a core that was not measured is compared")
    print("the gate closes at 2 %")


def check_files(scratch):
    """What is written is read; a broken baseline and a README without markers are refused."""
    table = {("q15", "step", "mixed", "cost"): {"cortex-m0": 200, "cortex-m3": 100}}
    file = scratch / "self-test.csv"
    figures.write(file, table)
    must(figures.read(file) == table, "figures do not survive their file")
    file.write_text("nonsense\n1\n")
    refuses(lambda: figures.read(file), "a broken baseline")
    refuses(lambda: figures.read(scratch / "none.csv"), "a missing baseline")
    must(report.replaced("a <!-- bench: x -->\nold\n<!-- bench: end --> b", "x", "NEW") == "a NEW b",
         "a table is not replaced")
    refuses(lambda: report.replaced("a", "x", "NEW"), "a README without markers")
    print("files are read as written")


def passes(scratch):
    check_gate()
    check_files(scratch)
    for core in ("cortex-m0plus", "cortex-m4f", "atmega328p"):
        check_counting(core, scratch)
    return True
