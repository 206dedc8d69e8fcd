# SPDX-License-Identifier: MIT
"""What no call can exceed: the longest path through the machine code of a function and of all that it
calls, and the deepest stack. There may be paths that no input takes, so this is a bound; what was run
is only the worst so far. The truth lies between the two.

There is no bound on AVR, whose compiler shifts in loops, and none for f32 where floats are libgcc's,
which divides in a loop. There f32's own code is searched for loops all the same."""

import re
from collections import namedtuple

import flow
import image as images
import timing
from flow import Flow, Refused

WITH_FPU = ("cortex-m4f", "cortex-m7", "cortex-m33", "rv32imafc")
RUN_TIME = re.compile(r"epf_(f32|q31|q15)_(?!coeffs_init$)(\w+)")
SOFT_FLOAT = re.compile(r"__aeabi_c?f\w+|__aeabi_u?[il]2f|__\w+[sd]f\w*")

Bound = namedtuple("Bound", "cost stack")
ONE_EACH = lambda previous, instruction, taken: 1


def in_order(start, followers):
    """All that can be reached from start, each behind all that can follow it; refuses a circle."""
    order, finished, unfinished, todo = [], set(), set(), [(start, False)]
    while todo:
        node, is_left = todo.pop()
        if is_left:
            unfinished.remove(node)
            finished.add(node)
            order.append(node)
        elif node in unfinished:
            raise Circle(node)
        elif node not in finished:
            unfinished.add(node)
            todo.append((node, True))
            todo += [(follower, False) for follower in followers(node)]
    return order


class Circle(Exception):
    """A node that can be reached from itself."""


class Program:
    """The machine code of a program. What an instruction costs depends on the one before it, so a node
    of a path is a pair of addresses: where it comes from (None: from a call or a return), where it is."""

    def __init__(self, core, instructions, names, is_free=lambda name: False):
        self.core, self.instructions, self.names = core, instructions, names
        self.cost = timing.MODELS.get(core, {}).get("cycles", ONE_EACH)
        self.free = {address for address, name in names.items() if is_free(name)}
        self.bounds = {address: Bound(0, 0) for address in self.free}
        self.active = []

    def place(self, at):
        function = max((address for address in self.names if address <= at), default=at)
        return f"{self.names.get(function, '')}+{at - function:#x}"

    def bound(self, function):
        """The Bound of a call of the function at that address; Refused where there is none."""
        if function in self.active:
            raise Refused(f"recursion into {self.place(function)}")
        if function not in self.bounds:
            self.active.append(function)
            try:
                order = in_order((None, function), self.followers)
                self.bounds[function] = Bound(self.longest(order), self.deepest(order))
            except Circle as circle:
                raise Refused(f"loop at {self.place(circle.args[0][1])}") from circle
            finally:
                self.active.pop()
        return self.bounds[function]

    def flow(self, at):
        """Where the instruction leads; a jump to a function that is free is as good as a return."""
        if at not in self.instructions:
            raise Refused(f"no instruction at {self.place(at)}")
        try:
            after, callee, returns = flow.flow(self.core, at, self.instructions[at])
        except Refused as refusal:
            raise Refused(f"{refusal} at {self.place(at)}") from refusal
        inside = [address for address in after if address not in self.free]
        return Flow(inside, callee, returns or len(inside) < len(after))

    def followers(self, node):
        _, at = node
        after, callee, _ = self.flow(at)
        return [(at if callee is None else None, address) for address in after]

    def longest(self, order):
        """The cost of the longest path from the last node of the order to a return."""
        costs = {}
        for node in order:
            costs[node] = max(self.ways(node, costs))
        return costs[order[-1]]

    def ways(self, node, costs):
        """What is left from here, by every way that leads on."""
        before, at = node
        this, previous = self.instructions[at], self.instructions.get(before)
        _, callee, returns = self.flow(at)
        called = 0 if callee is None else self.bound(callee).cost
        if returns:
            yield self.cost(previous, this, True)
        for follower in self.followers(node):
            taken = callee is not None or follower[1] != at + this.size
            yield self.cost(previous, this, taken) + called + costs[follower]

    def deepest(self, order):
        """The most that the stack grows by; at one place it must have one depth, at a return none."""
        depths, most = {order[-1][1]: 0}, 0
        for node in reversed(order):
            at = node[1]
            depth, (_, callee, returns) = depths[at] + self.growth(node), self.flow(at)
            called = 0 if callee is None else self.bound(callee).stack
            most = max(most, depth + called)
            if returns and depths[at] + self.growth(node, returns=True) != 0:
                raise Refused(f"the stack is off at {self.place(at)}")
            for _, follower in self.followers(node):
                if depths.setdefault(follower, depth) != depth:
                    raise Refused(f"the stack has two depths at {self.place(follower)}")
        return most

    def growth(self, node, returns=False):
        before, at = node
        return timing.pushed(self.instructions.get(before), self.instructions[at], returns)


def of_image(image):
    """{(variant, function, rule): Bound}, and {(variant, function, rule): why there is none}, of all
    functions that are called at run time. The rule is the one that a build has alone, or "any"."""
    bounds, refusals = {}, {}
    for program in () if image.core.startswith("atmega") else images.PROGRAMS:
        variant, only = images.of_program(program)
        rule = only + images.ALONE if only else "any"
        instructions = images.instructions(image, program)
        names = {address: name for address, size, name in images.symbols(image, program) if size}
        for address, name in names.items():
            public = RUN_TIME.fullmatch(name)
            if not public or public[1] != variant:
                continue
            place = (*public.groups(), rule)
            is_soft = variant == "f32" and image.core not in WITH_FPU
            try:
                found = of_function(image.core, instructions, names, address, is_soft)
            except Refused as refusal:
                refusals[place] = str(refusal)
            else:
                if not is_soft:
                    bounds[place] = found
        check_counted(image.core, instructions, names)
    return bounds, refusals


def check_counted(core, instructions, names):
    """What is counted by hand must come out as counted by hand."""
    entry = next(address for address, name in names.items() if name == "counted_path")
    counted = timing.COUNTED[core]["path"]
    by_hand = Bound(counted[timing.cost_metric(core)], counted["stack"])
    found = Program(core, instructions, names).bound(entry)
    if found != by_hand:
        raise images.Failure(f"{core}: counted_path in counted.S: {found}, by hand {by_hand}")


def of_function(core, instructions, names, address, is_soft):
    """The bound of a function; without what soft float adds, if its code is not to be looked at."""
    is_free = SOFT_FLOAT.fullmatch if is_soft else lambda name: False
    return Program(core, instructions, names, is_free).bound(address)
