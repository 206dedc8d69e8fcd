# SPDX-License-Identifier: MIT
"""That the counting counts, that the bound is one, and that the gate closes."""

import bound
import budgets
import figures
import floor
import gate
import image as images
import report
import timing
import tracing
from flow import Refused

CORES = ("cortex-m0plus", "cortex-m3", "cortex-m4f", "rv32imac", "atmega328p")


def must(true, what):
    if not true:
        raise images.Failure(f"self-test: {what}")


def refuses(action, what, because=""):
    try:
        action()
    except images.Failure as failure:
        must(because in str(failure), f"{what} is refused because of: {failure}")
        return
    raise images.Failure(f"self-test: {what} is not refused")


def check_counting(core, scratch):
    """counted.S comes out as counted by hand, and another figure is refused."""
    image = images.build(core, scratch)
    measured = tracing.measure(image)
    must(measured["q15", "step", "lorentzian", "ordinary", "mixed", "instructions"] > 0,
         f"no step on {core}")
    right = timing.COUNTED[core]
    for function, counted in right.items():
        for metric in counted:
            wrong = {**counted, metric: counted[metric] + 1}
            timing.COUNTED[core] = {**right, function: wrong}
            results = {("counted", name, "any", "any", "any", name_of): value
                       for name, of_function in right.items() for name_of, value in of_function.items()}
            refuses(lambda: tracing.check_counted(core, results), f"{core}: a wrong count of {metric}")
    timing.COUNTED[core] = right
    print(f"{core}: counted as by hand: {right}")
    return image


def check_bound_of_counted(image):
    """The bound of counted.S is as counted by hand; what has none is refused."""
    instructions = images.instructions(image, "fixed")
    names = {address: name for address, size, name in images.symbols(image, "fixed") if size}
    entries = {name: address for address, name in names.items()}
    program = bound.Program(image.core, instructions, names)
    bound.check_counted(image.core, instructions, names)
    for name, because in (("counted_loop", "loop at counted_loop+0x"),
                          ("refused_recursion", "recursion into refused_recursion+0x0"),
                          ("refused_jump", "indirect jump")):
        refuses(lambda: program.bound(entries[name]), f"{image.core}: {name}", because)
    print(f"{image.core}: the bound is as counted by hand; loop, recursion and indirect jump are refused")


def program(core, *lines, free=()):
    """A program by hand, an instruction of two bytes a line; f is the function at 0, g that at 0x20."""
    instructions = {2 * i: images.Instruction(2, *(line.split(" ", 1) + [""])[:2])
                    for i, line in enumerate(lines) if line}
    return bound.Program(core, instructions, {0: "f", 0x20: "g"}, free.__contains__)


def check_graphs():
    """Bounds of hand-made graphs, on M0: 1 for an instruction, 3 for a branch taken, 1 if not."""
    g_at_0x20 = [""] * 12 + ["sub sp, #12", "add sp, #12", "bx lr"] # from 0x8 on: costs 5
    for what, code, cost, stack in (
            ("a straight line", program("cortex-m0", "movs r0, #0", "bx lr"), 4, 0),
            ("the longer way, not taken", program(
                "cortex-m0", "beq.n 6", "movs r0, #0", "movs r0, #0", "bx lr"), 6, 0),
            ("the longer way, taken", program(
                "cortex-m0", "beq.n 8", "bx lr", "", "", "movs r0, #0", "bx lr"), 7, 0),
            ("two diamonds", program(
                "cortex-m0", "beq.n 4", "movs r0, #0", "beq.n 8", "movs r0, #0", "bx lr"), 9, 0),
            ("a call", program("cortex-m0", "push {r4, lr}", "bl 20", "pop {r4, pc}", "", *g_at_0x20),
             3 + 4 + 5 + 6, 8 + 12),
            ("two calls, the stack of one", program(
                "cortex-m0", "push {r4, lr}", "bl 20", "bl 20", "pop {r4, pc}", *g_at_0x20),
             3 + 2 * (4 + 5) + 6, 8 + 12),
            ("a call in the place of a return", program(
                "cortex-m0", "b.n 20", "", "", "", *g_at_0x20), 3 + 5, 12),
            ("a free function", program("cortex-m0", "push {r4, lr}", "bl 20", "pop {r4, pc}", free="g"),
             3 + 4 + 6, 8),
            ("a jump to a free function", program("cortex-m0", "movs r0, #0", "b.n 20", free="g"), 4, 0),
            ("a return in an IT block", program(
                "cortex-m3", "it eq", "bxeq lr", "movs r0, #0", "bx lr"), 1 + 1 + 1 + 3, 0),
            ("a load behind a load", program(
                "cortex-m3", "cbz r0, 6", "ldr r0, [r1]", "ldr r0, [r1]", "bx lr"), 1 + 2 + 1 + 3, 0),
            ("a load behind a load, but not where a branch leads to it", program(
                "cortex-m3", "cbz r0, 4", "ldr r0, [r1]", "ldr r0, [r1]", "bx lr"), 3 + 2 + 3, 0)):
        found = code.bound(0)
        must(found == (cost, stack), f"{what}: {found}, by hand {(cost, stack)}")
    print("bounds of graphs are as counted by hand")


def check_refusals():
    """Of what no bound is known is refused, and says why."""
    for because, lines in (
            ("loop at f+0x0", ["b.n 0"]),
            ("loop at f+0x4", ["movs r0, #0", "subs r0, #1", "bne.n 2", "bx lr"]),
            ("loop at f+0x6", ["beq.n 4", "movs r0, #0", "subs r0, #1", "bne.n 4", "bx lr"]),
            ("recursion into f+0x0", ["push {r4, lr}", "bl 0", "pop {r4, pc}"]),
            ("recursion into f+0x0", ["bl 20", "bx lr", *[""] * 14, "bl 0", "bx lr"]),
            ("indirect jump: bx r3 at f+0x0", ["bx r3"]),
            ("indirect jump: blx r3 at f+0x0", ["blx r3", "bx lr"]),
            ("indirect jump: mov pc, r3 at f+0x0", ["mov pc, r3"]),
            ("two depths at f+0x4", ["beq.n 4", "push {r4, lr}", "bx lr"]),
            ("the stack is off at f+0x2", ["push {r4, lr}", "bx lr"]),
            ("no instruction at f+0x2", ["movs r0, #0"])):
        refuses(lambda: program("cortex-m0", *lines).bound(0), because, because)
    refuses(lambda: program("rv32imac", "jr a5").bound(0), "RISC-V: jr", "indirect jump")
    refuses(lambda: program("cortex-m0", "b.n 0", free="g").bound(0), "a loop beside free code", "loop")
    must(issubclass(Refused, images.Failure), "what is refused does not end the tool")
    print("loops, recursion, indirect jumps and a stack that does not come out even are refused")


def gate_on(run, limit, used, deepest, refusals=(), exceptions=(), core="cortex-m0"):
    """How many findings of the gate fail, of one function."""
    def key(path, metric):
        return "q15", "step", path, metric
    table = {key("mixed", "cost"): {core: run}, key("worst", "bound"): {core: limit},
             key("worst", "stack"): {core: used}, key("worst", "deepest"): {core: deepest}}
    failed, unneeded = gate.failures(table, refusals, exceptions)
    return len(failed), len(unneeded)


def check_bound_gate():
    """A bound is to be within 10 %, or 15 % of instructions; the stack is to be equal."""
    step = {"core": "cortex-m0 rv32*", "variant": "q15", "function": "step", "reason": "a test"}
    excused = [{"what": what, **step} for what in gate.WHAT]
    refusal = [("cortex-m0", "q15", "step", "loop at f")]
    must(gate_on(100, 110, 8, 8) == (0, 0), "what is near its bound fails")
    must(gate_on(100, 111, 8, 8) == (1, 0), "a bound of 111 % passes")
    must(gate_on(100, 115, 8, 8, core="rv32imac") == (0, 0), "a bound of 115 % of instructions fails")
    must(gate_on(100, 116, 8, 8, core="rv32imac") == (1, 0), "a bound of 116 % of instructions passes")
    must(gate_on(100, 100, 8, 12) == (1, 0), "a stack that no path needs passes")
    must(gate_on(100, 100, 8, 8, refusal) == (1, 0), "code with a loop passes")
    must(gate_on(100, 111, 8, 12, refusal, excused) == (0, 0), "exceptions do not help")
    must(gate_on(100, 111, 8, 12, refusal, excused, "cortex-m3") == (2, 2), "they help others")
    must(gate_on(100, 110, 8, 8, (), excused) == (0, 3), "what nothing needs is not told")
    must(gate_on(101, 100, 8, 8, (), excused)[0] == 1, "more than the bound passes")
    must(gate_on(100, 100, 12, 8, (), excused)[0] == 1, "more stack than there is passes")
    print("the gate closes at 110 % and 115 % of what was run, and where stacks differ")


def check_budgets():
    """A budget is of the form, the path and the contact that it names."""
    core = "cortex-m4f"
    traced = {("f32", "step", form, contact, path, "cycles"): value for form, contact, path, value in (
        ("lorentzian", "ordinary", "mixed", 1), ("gaussian", "ordinary", "mixed", 2),
        ("lorentzian", "ordinary", "extreme", 3), ("lorentzian", "stiff", "mixed", 4),
        ("lorentzian", "ordinary", "elastic", 5))}

    def verdict_of(form, path, at_most, reason=""):
        budget = {"core": "cortex-m0 cortex-m4*", "variant": "*", "function": "step", "form": form,
                  "path": path, "metric": "cost", "at_most": str(at_most), "exceeded_because": reason}
        budget["variant"] = "f32"
        (verdict, line), = budgets.verdicts([budget], {}, {core: traced})
        return verdict, line
    for form, path, worst in (("lorentzian", "mixed", 4), ("gaussian", "finite", 2),
                              ("lorentzian", "finite", 5), ("any", "extreme", 3), ("any", "any", 5)):
        must(verdict_of(form, path, worst)[0] == "held", f"{form} {path} is above {worst}")
        must(verdict_of(form, path, worst - 1)[0] == "EXCEEDED", f"{form} {path} is below {worst}")
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
    """What is written is read; a broken baseline, a README without markers, an exception without a
    reason are refused."""
    table = {("q15", "step", "mixed", "cost"): {"cortex-m0": 200, "cortex-m3": 100}}
    file = scratch / "self-test.csv"
    figures.write(file, table)
    must(figures.read(file) == table, "figures do not survive their file")
    file.write_text("nonsense\n1\n")
    refuses(lambda: figures.read(file), "a broken baseline")
    refuses(lambda: figures.read(scratch / "none.csv"), "a missing baseline")
    file.write_text("what,core,variant,function,reason\nbound,*,*,init,\n")
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
    check_graphs()
    check_refusals()
    for core in CORES:
        image = check_counting(core, scratch)
        if not core.startswith("atmega"):
            check_bound_of_counted(image)
    return True
