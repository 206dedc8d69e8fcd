# SPDX-License-Identifier: MIT
"""What a call costs, from the instructions that it executed: exact counts, and cycles by Arm's
published timings for memory without wait states (technical reference manuals: DDI 0432, 0484, 0337,
0439). A multiplication takes one cycle on M0 and M0+, which is an option of the chip."""

import re
from functools import lru_cache

from image import Failure

ADDRESS = 0xFFFFFFFF # of a word of the trace; what else is in it, trace_avr.c says
CONDITIONS = "eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le|hs|lo"
CONDITIONAL_BRANCH = re.compile(f"b({CONDITIONS})$")
IT_BLOCK = re.compile("it[te]{0,3}$")
IN_IT_BLOCK = re.compile( # of what has a time of its own; more names would take "mls" for "m" and "ls"
    f"(bl?x?|push|pop|ldr|ldm|ldmia|[su]div|ml[as]|[su]mull|[su]mlal|mrs|msr|v[a-z]+?)({CONDITIONS})$")
END_LIKE_ONE = ("vmls", "vnmls")


def mnemonic(instruction):
    return instruction.name.split(".")[0]


@lru_cache(maxsize=None)
def unconditional(name):
    """The mnemonic without the condition that it has in an IT block; that of a branch stays."""
    match = IN_IT_BLOCK.match(name)
    return name if not match or match[1] == "b" or name in END_LIKE_ONE else match[1]


def registers(operands):
    """Words that a list of registers holds: {r4, lr}, {r0-r3}, {d8-d9}."""
    words = 0
    for item in re.search(r"\{(.*)\}", operands)[1].split(","):
        first, _, last = item.strip().partition("-")
        count = int(last[1:]) - int(first[1:]) + 1 if last else 1
        words += count * (2 if first[0] == "d" else 1)
    return words


def v6m(instruction, taken, refill):
    """Cycles on M0 (refill 3) and M0+ (refill 2): what a taken branch costs."""
    name, operands = mnemonic(instruction), instruction.operands
    if name == "bl":
        return refill + 1
    if name in ("b", "bx", "blx") or CONDITIONAL_BRANCH.match(name):
        return refill if taken else 1
    if name == "push" or name.startswith(("stm", "ldm")):
        return 1 + registers(operands)
    if name == "pop":
        return (refill + 1 if "pc" in operands else 1) + registers(operands)
    if name.startswith(("ldr", "str")):
        return 2
    if name in ("mrs", "msr", "dsb", "dmb", "isb"):
        return refill + 1
    if name in ("mov", "add") and operands.startswith("pc"):
        return refill
    return 1


def is_single_access(instruction):
    return re.match("(ldr|str)(?!d)", mnemonic(instruction)) is not None


def float_result(instruction):
    """The register that an arithmetic floating-point instruction makes, or None."""
    arithmetic = ("vdiv", "vsqrt", "vfma", "vfms", "vfnm", "vmla", "vmls", "vnml", "vadd", "vsub",
                  "vmul", "vnmul", "vcvt")
    match = re.match(r"[sd]\d+", instruction.operands)
    return match[0] if match and mnemonic(instruction).startswith(arithmetic) else None


def waits_for(previous, instruction):
    """Does it use the floating-point result of the instruction before?"""
    result = previous and float_result(previous)
    sources = instruction.operands.partition(",")[2]
    return bool(result) and re.search(rf"\b{result}\b", sources) is not None


# What varies on M3 and M4F: the refill of the pipeline, a division of integers, stores that hide
# behind the next instruction, loads and stores that overlap, and IT that is folded away. Loads and
# stores of the FPU overlap with nothing.
LOWEST = {"refill": 1, "division": 2, "store": 1, "overlap": True, "it": 0, "product": {}}
TYPICAL = {"refill": 2, "division": 7, "store": 2, "overlap": True, "it": 1, "product": {}}
HIGHEST = {"refill": 3, "division": 12, "store": 2, "overlap": False, "it": 1, "product": {}}

# M4F multiplies in one cycle, whatever the product. M3 needs more where the product has 64 bits, and
# the fewer the smaller the factors: typical are large ones here, the fractions of q31.
M3_LOWEST = {"mla": 2, "mls": 2, "umull": 3, "smull": 3, "umlal": 4, "smlal": 4}
M3_HIGHEST = {"mla": 2, "mls": 2, "umull": 5, "smull": 5, "umlal": 7, "smlal": 7}


def v7m(previous, instruction, taken, assumed):
    """Cycles on M3 and M4F."""
    name, operands = unconditional(mnemonic(instruction)), instruction.operands
    if name in ("b", "bl", "bx", "blx"):
        return 1 + (assumed["refill"] if taken else 0)
    if name in ("cbz", "cbnz") or CONDITIONAL_BRANCH.match(name):
        return 1 + (assumed["refill"] if taken else 0)
    if name in ("tbb", "tbh"):
        return 2 + assumed["refill"]
    if name in ("push", "pop") or name.startswith(("ldm", "stm")):
        if "pc" in operands:
            return 1 + registers(operands) + assumed["refill"] if taken else 1
        return 1 + registers(operands)
    if name.startswith(("ldrd", "strd")):
        return 3
    if is_single_access(instruction):
        if operands.startswith("pc"):
            return 2 + assumed["refill"] if taken else 1
        if assumed["overlap"] and previous and is_single_access(previous):
            return 1
        return assumed["store"] if name.startswith("str") else 2
    if name in ("sdiv", "udiv"):
        return assumed["division"]
    if name in ("mrs", "msr"):
        return 2
    if name in assumed["product"]:
        return assumed["product"][name]
    if IT_BLOCK.match(name):
        return assumed["it"]
    return float_cycles(name, operands) + waits_for(previous, instruction)


def float_cycles(name, operands):
    if name.startswith(("vdiv", "vsqrt")):
        return 14
    if name.startswith(("vldm", "vstm", "vpush", "vpop")):
        return 1 + registers(operands)
    if name.startswith(("vldr", "vstr")):
        return 3 if operands.startswith("d") else 2
    if name.startswith(("vfma", "vfms", "vfnm", "vmla", "vmls", "vnml")):
        return 3
    if name.startswith("vmov") and operands.count(",") >= 2:
        return 2
    return 1


MODELS = {
    "cortex-m0": {"cycles": lambda previous, this, taken: v6m(this, taken, 3)},
    "cortex-m0plus": {"cycles": lambda previous, this, taken: v6m(this, taken, 2)},
    "cortex-m3": {
        "cycles": lambda *step: v7m(*step, {**TYPICAL, "product": M3_HIGHEST}),
        "cycles_low": lambda *step: v7m(*step, {**LOWEST, "product": M3_LOWEST}),
        "cycles_high": lambda *step: v7m(*step, {**HIGHEST, "product": M3_HIGHEST}),
    },
    "cortex-m4f": {
        "cycles": lambda *step: v7m(*step, TYPICAL),
        "cycles_low": lambda *step: v7m(*step, LOWEST),
        "cycles_high": lambda *step: v7m(*step, HIGHEST),
    },
}


def pushed(previous, instruction, taken):
    """Bytes by which the stack grows."""
    name, operands = unconditional(mnemonic(instruction)), instruction.operands
    if name == "li" and previous and previous[1:] == ("add", "sp,sp,-64"):
        unused = re.match(r"t1,(0|-16|-32)$", operands) # libgcc's __riscv_save: later sp -= t1
        return int(unused[1]) if unused else 0
    if name == "push" or name == "vpush":
        return 4 * registers(operands)
    if re.search(r"\bpc\b", operands) and not taken:
        return 0 # skipped, in an IT block
    if name in ("pop", "vpop"):
        return -4 * registers(operands)
    if re.match(r"(ldm|vldm).*sp!", f"{name} {operands}"):
        return -4 * registers(operands)
    if re.match(r"(stm|vstm).*sp!", f"{name} {operands}"):
        return 4 * registers(operands)
    moved = re.search(r"\[sp, #(-?\d+)\]!|\[sp\], #(-?\d+)", operands)
    if moved:
        return -int(moved[1] or moved[2])
    summed = re.match(r"sp,\s*(?:sp,\s*)?#?(-?\d+)$", operands)
    if summed and name[:3] in ("add", "sub"):
        return int(summed[1]) if name[:3] == "sub" else -int(summed[1])
    return 0


class Meter:
    """Costs of calls of one program on one core."""

    def __init__(self, core, instructions):
        self.instructions = instructions
        self.models = MODELS.get(core, {})
        self.cost_of = lru_cache(maxsize=None)(self._cost_of)

    def _cost_of(self, step):
        """Of an instruction, given the addresses of the one before, its own, and of the one after."""
        before, at, after = step
        this = self.instructions[at]
        how = (self.instructions.get(before), this, after != at + this.size)
        return [model(*how) for model in self.models.values()], pushed(*how)

    def measure(self, words):
        """{metric: value} of a call on Arm or RISC-V, from its trace."""
        addresses = [word & ADDRESS for word in words]
        sums = [0] * len(self.models)
        depth = deepest = 0
        steps = zip([None, *addresses], addresses, [*addresses[1:], None])
        for costs, growth in map(self.cost_of, steps):
            for i, cost in enumerate(costs):
                sums[i] += cost
            depth += growth
            deepest = max(deepest, depth)
        if depth != 0:
            raise Failure(f"the stack is off by {depth} bytes after the call at {addresses[0]:#x}")
        return {"instructions": len(addresses), "stack": deepest, **dict(zip(self.models, sums))}


def measure_avr(words, instructions, return_address):
    """The same on AVR, where the simulator gives the cycles and the stack pointer. That is written by
    two instructions "out", before which it may be half of the old and half of the new."""
    stack_pointers = [word >> 32 & 0xFFFF for word in words
                      if instructions[word & ADDRESS].name != "out"]
    return {"instructions": len(words),
            "stack": stack_pointers[0] - min(stack_pointers) + return_address,
            "cycles": sum(word >> 48 for word in words)}


# counted.S, by hand: instructions, stack, cycles, lowest, highest, of its functions
COUNTED = {
    "cortex-m0": {
        "loop": {"instructions": 28, "stack": 16, "cycles": 55},
        "path": {"instructions": 10, "stack": 16, "cycles": 24},
    },
    "cortex-m0plus": {
        "loop": {"instructions": 28, "stack": 16, "cycles": 45},
        "path": {"instructions": 10, "stack": 16, "cycles": 21},
    },
    "cortex-m3": {
        "loop": {"instructions": 30, "stack": 16, "cycles": 65, "cycles_low": 47, "cycles_high": 81},
        "path": {"instructions": 13, "stack": 16, "cycles": 24, "cycles_low": 19, "cycles_high": 28},
    },
    "cortex-m4f": {
        "loop": {"instructions": 34, "stack": 16, "cycles": 80, "cycles_low": 64, "cycles_high": 96},
        "path": {"instructions": 15, "stack": 16, "cycles": 28, "cycles_low": 23, "cycles_high": 32},
    },
    "cortex-m7": {
        "loop": {"instructions": 34, "stack": 16},
        "path": {"instructions": 15, "stack": 16},
    },
    "cortex-m33": {
        "loop": {"instructions": 34, "stack": 16},
        "path": {"instructions": 15, "stack": 16},
    },
    "rv32imac": {
        "loop": {"instructions": 26, "stack": 16},
        "path": {"instructions": 12, "stack": 32},
    },
    "rv32imafc": {
        "loop": {"instructions": 26, "stack": 16},
        "path": {"instructions": 12, "stack": 32},
    },
    "atmega328p": {
        "loop": {"instructions": 25, "stack": 3, "cycles": 40},
        "path": {"instructions": 7, "stack": 5, "cycles": 17},
    },
    "atmega2560": {
        "loop": {"instructions": 25, "stack": 4, "cycles": 41},
        "path": {"instructions": 7, "stack": 7, "cycles": 20},
    },
}
CORES = tuple(COUNTED)


def cost_metric(core):
    """What the cost of a call is told in."""
    return "cycles" if "cycles" in COUNTED[core]["loop"] else "instructions"
