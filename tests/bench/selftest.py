# SPDX-License-Identifier: MIT
"""That the counting counts, and that the gate closes. selftest_bound.py: that the bound is one."""

import budgets
import figures
import floor
import gate
import image as images
import report
import selftest_bound
import timing
import tracing
from expect import must, refuses

CORES = ("cortex-m0plus", "cortex-m3", "cortex-m4f", "rv32imac", "atmega328p")


def check_counting(core, scratch):
    """counted.S comes out as counted by hand, and another figure is refused."""
    image = images.build(core, scratch)
    measured = tracing.measure_program(image, "q15")
    must(measured["q15", "step", "mean_value", "lorentzian", "ordinary", "mixed", "instructions"] > 0,
         f"no step on {core}")
    right = timing.COUNTED[core]
    for function, counted in right.items():
        for metric in counted:
            wrong = {**counted, metric: counted[metric] + 1}
            timing.COUNTED[core] = {**right, function: wrong}
            results = {("counted", name, *4 * ["any"], name_of): value
                       for name, of_function in right.items() for name_of, value in of_function.items()}
            refuses(lambda: tracing.check_counted(core, results), f"{core}: a wrong count of {metric}")
    timing.COUNTED[core] = right
    print(f"{core}: counted as by hand: {right}")
    return image


def gate_on(run, limit, used, deepest, refusals=(), exceptions=(), core="cortex-m0", more=0):
    """How many findings of the gate fail, of one function."""
    def key(path, metric, rule="any"):
        return "q15", "step", rule, path, metric
    table = {key("mixed", "cost", "saturated"): {core: run}, key("worst", "bound"): {core: limit},
             key("worst", "stack"): {core: used}, key("worst", "deepest"): {core: deepest},
             key("worst", "branch", "saturated"): {core: more},
             key("worst", "cost", "saturated alone"): {core: 2 * run}} # is no part of the others
    failed, unneeded = gate.failures(table, refusals, exceptions)
    return len(failed), len(unneeded)


def check_bound_gate():
    """A bound is to be within 10 %, or 15 % of instructions; the stack is to be equal."""
    step = {"core": "cortex-m0 rv32*", "variant": "q15", "function": "step", "rule": "*",
            "reason": "a test"}
    excused = [{"what": what, **step} for what in gate.WHAT]
    refusal = [("cortex-m0", "q15", "step", "any", "loop at f")]
    must(gate_on(100, 110, 8, 8) == (0, 0), "what is near its bound fails")
    must(gate_on(100, 111, 8, 8) == (1, 0), "a bound of 111 % passes")
    must(gate_on(100, 115, 8, 8, core="rv32imac") == (0, 0), "a bound of 115 % of instructions fails")
    must(gate_on(100, 116, 8, 8, core="rv32imac") == (1, 0), "a bound of 116 % of instructions passes")
    must(gate_on(100, 100, 8, 12) == (1, 0), "a stack that no path needs passes")
    must(gate_on(100, 100, 8, 8, refusal) == (1, 0), "code with a loop passes")
    must(gate_on(100, 100, 8, 8, more=gate.BRANCH) == (0, 0), "a branch fails")
    must(gate_on(100, 100, 8, 8, more=gate.BRANCH + 1) == (1, 0), "more than a branch passes")
    must(gate_on(1000, 1000, 8, 8, more=40) == (0, 0), "4 % fail")
    must(gate_on(1000, 1000, 8, 8, more=41) == (1, 0), "more than 4 % passes")
    must(gate_on(100, 111, 8, 12, refusal, excused, more=gate.BRANCH + 1) == (0, 0), "exceptions do not help")
    must(gate_on(100, 111, 8, 12, refusal, excused, "cortex-m3", gate.BRANCH + 1) == (3, 3), "they help others")
    must(gate_on(100, 110, 8, 8, (), excused) == (0, 4), "what nothing needs is not told")
    must(gate_on(101, 100, 8, 8, (), excused)[0] == 1, "more than the bound passes")
    must(gate_on(100, 100, 12, 8, (), excused)[0] == 1, "more stack than there is passes")
    print("the gate closes at 110 % and 115 % of what was run, and where stacks differ; and at one branch")


def check_budgets():
    """A budget is of the rule, the form, the path and the contact that it names."""
    core = "cortex-m4f"
    traced = {("f32", "step", rule, form, contact, path, "cycles"): value
              for rule, form, contact, path, value in (
                  ("saturated", "lorentzian", "ordinary", "mixed", 1),
                  ("saturated", "gaussian", "ordinary", "mixed", 2),
                  ("saturated", "lorentzian", "ordinary", "elastic", 3),
                  ("saturated", "lorentzian", "stiff", "mixed", 4),
                  ("saturated", "lorentzian", "ordinary", "extreme", 5),
                  ("mean_value", "lorentzian", "ordinary", "mixed", 6))}

    def verdict_of(form, path, at_most, reason="", rule="saturated"):
        budget = {"core": "cortex-m0 cortex-m4*", "variant": "f32", "function": "step", "rule": rule,
                  "form": form, "path": path, "metric": "cost", "at_most": str(at_most), "exceeded_because": reason}
        (verdict, line), = budgets.verdicts([budget], {}, {core: traced})
        return verdict, line
    for form, path, worst in (("lorentzian", "mixed", 4), ("gaussian", "finite", 2),
                              ("lorentzian", "finite", 3), ("any", "extreme", 5), ("any", "any", 5)):
        must(verdict_of(form, path, worst)[0] == "held", f"{form} {path} is above {worst}")
        must(verdict_of(form, path, worst - 1)[0] == "EXCEEDED", f"{form} {path} is below {worst}")
    for rule, worst in (("mean_value", 6), ("any", 6), ("saturated", 5)):
        must(verdict_of("any", "any", worst, rule=rule)[0] == "held", f"{rule} is above {worst}")
        must(verdict_of("any", "any", worst - 1, rule=rule)[0] == "EXCEEDED", f"{rule} is below {worst}")
    verdict, line = verdict_of("any", "any", 4, "a test")
    must(verdict == "excepted" and line.endswith("at most 4: a test"), "a reason does not help")
    refuses(lambda: verdict_of("any", "moonlit", 4), "a budget of a path that is not")
    print("budgets are of what they name")


def check_floor():
    """The floor is charged as what is traced."""
    for cell, cycles in (("17", 17), ("3 ldr", 4), ("3 vldr", 6), ("2 vldr, 1 vdiv, 4", 22), ("1 return", 3)):
        must(floor.cycles("cortex-m4f", cell) == cycles, f"{cell} does not cost {cycles}")
    refuses(lambda: floor.cycles("cortex-m4f", "3 wishes"), "a floor of wishes")
    print("the floor is charged as what is traced")


def check_gate():
    """Of a figure of 200, 204 passes, 205 does not, 195 is better; so does what comes or goes."""
    key, core = ("q15", "step", "any", "mixed", "cost"), "cortex-m0"
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
    """What is written is read; a broken baseline, a README without markers, an exception without a
    reason are refused."""
    table = {("q15", "step", "any", "mixed", "cost"): {"cortex-m0": 200, "cortex-m3": 100}}
    file = scratch / "self-test.csv"
    figures.write(file, table)
    must(figures.read(file) == table, "figures do not survive their file")
    file.write_text("nonsense\n1\n")
    refuses(lambda: figures.read(file), "a broken baseline")
    refuses(lambda: figures.read(scratch / "none.csv"), "a missing baseline")
    file.write_text("what,core,variant,function,rule,reason\nbound,*,*,init,*,\n")
    refuses(lambda: gate.read_exceptions(file), "an exception without a reason")
    must(report.replaced("a <!-- bench: x -->\nold\n<!-- bench: end --> b", "x", "NEW") == "a NEW b",
         "a table is not replaced")
    refuses(lambda: report.replaced("a", "x", "NEW"), "a README without markers")
    must(report.cell("m0", {"m0": 1000}, {"m0": 1100}) == "1,000 / 1,100", "a cell has no bound")
    must(report.cell("m0", {"m0": 1000}, {}) == "1,000", "a bound that is not")
    print("files are read as written")


def passes(scratch):
    check_gate()
    check_bound_gate()
    check_budgets()
    check_floor()
    check_files(scratch)
    selftest_bound.check()
    for core in CORES:
        image = check_counting(core, scratch)
        if not core.startswith("atmega"):
            selftest_bound.check_counted(image)
    return True
