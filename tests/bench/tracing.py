# SPDX-License-Identifier: MIT
"""Runs a program in its emulator and cuts the trace into the measured calls."""

import os
import re
import subprocess
from array import array

import image as images
import timing

MEASURED = re.compile(r"epf_(f32|q31|q15)_(\w+)|(naive)_(step)|(counted)_(loop)")


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
    """{address: (form, path, function)}, one of the three set: what the names of functions say."""
    found = {}
    for address, _, name in images.symbols(image, program):
        measured = MEASURED.fullmatch(name)
        if name.startswith("form_"):
            found[address] = (name[5:], None, None)
        elif name.startswith("path_"):
            found[address] = (None, name[5:], None)
        elif measured:
            found[address] = (None, None, tuple(filter(None, measured.groups())))
    return found


def calls(image, program, instructions):
    """(form, path, (variant, function), words) of every measured call, callees included."""
    marks = landmarks(image, program)
    form = path = "any"
    inside = function = end = before = None
    for word in words(image, program):
        address = word & timing.ADDRESS
        if inside is not None:
            if address != end:
                inside.append(word)
                continue
            yield form, path, function, tuple(inside)
            inside = None
        elif address in marks:
            new_form, new_path, function = marks[address]
            form, path = new_form or form, new_path or path
            if function:
                inside, end = [word], before + instructions[before].size
        before = address


def measure(image):
    """What measure_program() finds in all of them."""
    return {key: value for program in images.PROGRAMS
            for key, value in measure_program(image, program).items()}


def measure_program(image, program):
    """{(variant, function, form, path, metric): value}, the largest of the calls of that kind."""
    instructions = images.instructions(image, program)
    meter = timing.Meter(image.core, instructions)
    is_avr = image.core.startswith("atmega")
    return_address = 3 if image.core == "atmega2560" else 2
    known, results = {}, {}
    for form, path, (variant, function), executed in calls(image, program, instructions):
        if executed not in known:
            known[executed] = (timing.measure_avr(executed, instructions, return_address) if is_avr
                               else meter.measure(executed))
        for metric, value in known[executed].items():
            key = (variant, function, form, path, metric)
            results[key] = max(results.get(key, 0), value)
    check_counted(image.core, results)
    return results


def check_counted(core, results):
    """What is counted by hand must come out as counted by hand."""
    for metric, expected in timing.COUNTED[core].items():
        measured = results.pop(("counted", "loop", "any", "any", metric), None)
        if measured != expected:
            raise images.Failure(f"{core}: {metric} of counted.S are {measured}, by hand {expected}")
