# SPDX-License-Identifier: MIT
"""Runs a program in its emulator and cuts the trace into the measured calls."""

import os
import re
import subprocess
from array import array

import image as images
import timing

MEASURED = re.compile(rf"epf_({'|'.join(images.VARIANTS)})_(\w+)|({'|'.join(images.RIVALS)})_(step)|"
                      r"(counted)_(loop|path)")
CASE = re.compile(r"(rule|form|contact|path)_(\w+)") # and the compiler's suffix to a copy: ".constprop.0"


def build_tracers(scratch):
    """The plugin of QEMU and the tracer for AVR, for this machine."""
    compiler = ("cc", "-std=c99", "-O2", "-Wall", "-Wextra", "-Werror")
    images.run(*compiler, "-shared", "-fPIC", images.HERE / "trace_qemu.c", "-o", scratch / "trace_qemu.so")
    images.run(*compiler, images.HERE / "trace_avr.c", "-o", scratch / "trace_avr", "-lsimavr")


def command(image, program, trace):
    """The emulator's command line, with the tracer in it."""
    scratch = image.folder.parent
    program = str(image.folder / program)
    emulator, *options = image.emulator
    if emulator.startswith("qemu"):
        return [emulator, "-plugin", f"{scratch / 'trace_qemu.so'},trace={trace}", *options, program]
    return [str(scratch / "trace_avr"), trace, *options, program]


def words(image, program):
    """What the tracer writes, instruction by instruction."""
    reader, writer = os.pipe()
    try:
        emulator = subprocess.Popen(command(image, program, f"/dev/fd/{writer}"), pass_fds=[writer],
                                    stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    except FileNotFoundError as error:
        raise images.Failure(f"{error.filename} is not installed") from error
    finally:
        os.close(writer)
    with open(reader, "rb") as pipe:
        while chunk := pipe.read(1 << 20):
            yield from array("Q", chunk)
    if emulator.wait() != 0:
        raise images.Failure(f"{image.core}: {program} ended with {emulator.returncode}")


def landmarks(image, program):
    """What the names of functions say: {address: ("rule", "form", "contact" or "path", its name)}, and
    {address: (variant, function)} of what is measured."""
    cases, measured = {}, {}
    variant, only = images.of_program(program)
    for address, _, name in images.symbols(image, program):
        case, function = CASE.match(name), MEASURED.fullmatch(name)
        if case:
            kind, value = case.groups()
            cases[address] = kind, value + images.ALONE if kind == "rule" and only else value
        elif function and function[1] in (variant, None):
            measured[address] = tuple(filter(None, function.groups()))
    return cases, measured


def calls(image, program, instructions):
    """((variant, function, rule, form, contact, path), words) of every measured call, callees included."""
    cases, measured = landmarks(image, program)
    case = {"rule": "any", "form": "any", "contact": "any", "path": "any"}
    before, executed = None, words(image, program)
    for word in executed:
        address = word & timing.ADDRESS
        if address in cases:
            kind, name = cases[address]
            case[kind] = name
        elif address in measured:
            address = before + instructions[before].size # where the call comes back to
            yield (*measured[word & timing.ADDRESS], *case.values()), (word, *until(address, executed))
        before = address


def until(address, executed):
    """What is executed before that address is come to."""
    for word in executed:
        if word & timing.ADDRESS == address:
            return
        yield word
    raise images.Failure(f"a call never comes back to {address:#x}")


def measure(image):
    """What measure_program() finds in all of them."""
    return {key: value for program in images.PROGRAMS
            for key, value in measure_program(image, program).items()}


def measure_program(image, program):
    """{(variant, function, rule, form, contact, path, metric): value}, the largest of such calls."""
    instructions = images.instructions(image, program)
    meter = timing.Meter(image.core, instructions)
    is_avr = image.core.startswith("atmega")
    return_address = 3 if image.core == "atmega2560" else 2
    known, results = {}, {}
    for call, executed in calls(image, program, instructions):
        bits = array("Q", executed).tobytes() # a fifth of the memory
        if bits not in known:
            known[bits] = (timing.measure_avr(executed, instructions, return_address) if is_avr
                             else meter.measure(executed))
        for metric, value in known[bits].items():
            key = (*call, metric)
            results[key] = max(results.get(key, 0), value)
    check_counted(image.core, results)
    return results


def check_counted(core, results):
    """What is counted by hand must come out as counted by hand."""
    for function, counted in timing.COUNTED[core].items():
        for metric, expected in counted.items():
            measured = results.pop(("counted", function, *4 * ["any"], metric), None)
            if measured != expected:
                raise images.Failure(f"{core}: {metric} of counted_{function} in counted.S: "
                                     f"{measured}, by hand {expected}")
