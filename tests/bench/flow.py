# SPDX-License-Identifier: MIT
"""Where an instruction may lead, on Arm and on RISC-V: what a path through machine code is made of."""

import re
from collections import namedtuple

import timing
from image import Failure

# The instructions that may follow within the function, the function that is called before them, and
# whether the function may return here
Flow = namedtuple("Flow", "after callee returns")


class Refused(Failure):
    """Code of which no longest path is known: a loop, recursion, a jump to who knows where."""


def flow(core, at, instruction):
    """Where the instruction at that address leads."""
    of_core = risc_v if core.startswith("rv") else arm
    return of_core(instruction, at + instruction.size)


def target(instruction):
    """The address that a direct branch names, as the last of its operands."""
    return int(instruction.operands.split(",")[-1].strip(), 16)


def arm(instruction, following):
    name, operands = timing.mnemonic(instruction), instruction.operands
    always = timing.unconditional(name)
    skipped = [] if always == name else [following] # by its condition, in an IT block
    if re.match(r"cbn?z$", name) or timing.CONDITIONAL_BRANCH.match(name):
        return Flow([following, target(instruction)], None, False)
    if always == "bl":
        return Flow([following], target(instruction), False)
    if always == "b":
        return Flow([target(instruction), *skipped], None, False)
    if is_return(always, operands):
        return Flow(skipped, None, True)
    if always in ("bx", "blx", "tbb", "tbh") or operands.startswith("pc"):
        raise Refused(f"indirect jump: {name} {operands}")
    return Flow([following], None, False)


def is_return(name, operands):
    if name == "bx":
        return operands == "lr"
    if name == "ldr":
        return operands.startswith("pc, [sp]")
    return name.startswith(("pop", "ldm")) and re.search(r"\bpc\b", operands) is not None


def risc_v(instruction, following):
    name, operands = timing.mnemonic(instruction), instruction.operands
    if name in ("ret", "mret") or (name == "jr" and operands == "ra"):
        return Flow([], None, True)
    if name == "jal" and operands.partition(",")[0] in ("ra", operands): # "jal f" is "jal ra,f"
        return Flow([following], target(instruction), False)
    if name == "j":
        return Flow([target(instruction)], None, False)
    if re.match(r"b(eq|ne|lt|ge|le|gt)u?z?$", name):
        return Flow([following, target(instruction)], None, False)
    if name in ("jal", "jr", "jalr"):
        raise Refused(f"indirect jump: {name} {operands}")
    return Flow([following], None, False)
