# SPDX-License-Identifier: MIT
"""What is built for a core: the programs to trace, and links whose size is measured."""

import re
import shutil
import subprocess
from collections import namedtuple
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOOLCHAINS = HERE.parent.parent / "cmake" / "toolchains"

VARIANTS = ("f32", "q31", "q15")
RULES = ("saturated", "mean_value")
RIVALS = ("naive", "lugre_euler", "lugre_exact", "ep_euler") # what one would otherwise take
ALONE = " alone" # said of a rule in a build that has no other

# Each measures the functions of a variant, linked with both rules or with one; "naive" those of the rivals
PROGRAMS = (*VARIANTS, *(f"{variant}_{rule}" for variant in VARIANTS for rule in RULES), "naive")

Image = namedtuple("Image", "core folder link objdump emulator")
Instruction = namedtuple("Instruction", "size name operands")


class Failure(Exception):
    """Told to the user in one line."""


def of_program(program):
    """(variant, the rule that it has alone or "") of a program."""
    variant, _, rule = program.partition("_")
    return variant, rule


def run(*command, **options):
    """The output of a command that must succeed."""
    command = [str(word) for word in command]
    if shutil.which(command[0]) is None:
        raise Failure(f"{command[0]} is not installed")
    done = subprocess.run(command, text=True, capture_output=True, check=False, **options)
    if done.returncode != 0:
        raise Failure(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def build(core, scratch):
    """Builds all that is measured for a core."""
    folder = scratch / core
    toolchain = TOOLCHAINS / f"{core}.cmake"
    run("cmake", "-S", HERE / "program", "-B", folder, f"-DCMAKE_TOOLCHAIN_FILE={toolchain}")
    run("cmake", "--build", folder)
    compiler, flags, objdump, emulator = (folder / "toolchain.txt").read_text().splitlines()
    return Image(core, folder, [compiler, *flags.split()], objdump, emulator.split(";"))


def instructions(image, program):
    """The program as {address: Instruction}."""
    text = run(image.objdump, "-d", image.folder / program)
    found = {}
    for line in text.splitlines():
        match = re.match(r"\s*([0-9a-f]+):\t([0-9a-f ]+?)\s*\t(\S+)\t?(.*)", line)
        if match:
            address, code, name, operands = match.groups()
            size = len(code.replace(" ", "")) // 2
            operands = re.split(r"\s(?:[@;<]|# )", operands)[0].strip() # without the comment
            found[int(address, 16)] = Instruction(size, name, operands)
    return found


def plain(name):
    """The name of a function without what a build for one form or rule adds, see epf/detail/names.h."""
    return name.partition("_for_")[0]


def linked_symbols(image, file):
    """[(address, size, name)] of the functions and objects of a file, by their names for the linker."""
    pattern = re.compile(r"([0-9a-f]+) .{7} \S+\t([0-9a-f]+) (?:\.hidden )?(\S+)$", re.M)
    found = pattern.findall(run(image.objdump, "-t", image.folder / file))
    return [(int(address, 16), int(size, 16), name) for address, size, name in found]


def symbols(image, file):
    """The same by their names in C."""
    return [(address, size, plain(name)) for address, size, name in linked_symbols(image, file)]


def object_sizes(image):
    """{name: bytes} of the objects in sizes.c."""
    return {name: size for _, size, name in symbols(image, "libsizes.a") if size}


def occupied(image, library, *functions):
    """Bytes (in flash, in RAM) of a link of these functions with all that they need, and no more."""
    elf = image.folder / "occupied"
    linked = {plain(name): name for _, _, name in linked_symbols(image, f"lib{library}.a")}
    roots = [f"-Wl,-u,{linked[name]}" for name in functions]
    run(*image.link, "-nostartfiles", "-Wl,--gc-sections", f"-Wl,-e,{linked[functions[0]]}", *roots,
        image.folder / f"lib{library}.a", "-lm", "-o", elf)
    sections = re.findall(r"^ +\d+ (\S+) +([0-9a-f]{8}) .*\n +(.*)$",
                          run(image.objdump, "-h", elf), re.M)
    flash = sum(int(size, 16) for _, size, flags in sections if "LOAD" in flags)
    ram = sum(int(size, 16) for name, size, _ in sections if name in (".data", ".bss"))
    return flash, ram
