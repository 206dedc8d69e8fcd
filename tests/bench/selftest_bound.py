# SPDX-License-Identifier: MIT
"""That the bound is one: graphs and assembly whose bound and stack are counted by hand, and code of
which none is known."""

import bound
import image as images
from expect import must, refuses


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
            ("another", program(
                "cortex-m3", "push {lr}", "it eq", "ldreq pc, [sp], #4", "ldr pc, [sp], #4"),
             2 + 1 + 1 + 4, 4),
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
    print("loops, recursion, indirect jumps and a stack that does not come out even are refused")


def check_counted(image):
    """The bound of counted.S is as counted by hand; what has none is refused."""
    instructions = images.instructions(image, "q15")
    names = {address: name for address, size, name in images.symbols(image, "q15") if size}
    entries = {name: address for address, name in names.items()}
    program = bound.Program(image.core, instructions, names)
    bound.check_counted(image.core, instructions, names)
    for name, because in (("counted_loop", "loop at counted_loop+0x"),
                          ("refused_recursion", "recursion into refused_recursion+0x0"),
                          ("refused_jump", "indirect jump")):
        refuses(lambda: program.bound(entries[name]), f"{image.core}: {name}", because)
    print(f"{image.core}: the bound is as counted by hand; loop, recursion and indirect jump are refused")


def check():
    check_graphs()
    check_refusals()
