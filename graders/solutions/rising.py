"""Which way a residual goes along a symbol: what only rises or only falls has one zero at most."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TypeAlias

from graders.language.intervals import INTERVALS, Interval, side_of_zero
from graders.language.program import Operation, Program, Runner

Way: TypeAlias = int | None  # 1 where it rises, -1 where it falls, 0 where it stays, None where it is not known
RISING: Mapping[str, Interval] = {  # and between which values of the argument
    **dict.fromkeys(("degrees", "sinh", "tanh", "atan", "exp"), (-math.inf, math.inf)),
    **dict.fromkeys(("sqrt", "ln", "log"), (0.0, math.inf)),
    "asin": (-1.0, 1.0),
}
FALLING: Mapping[str, Interval] = {"acos": (-1.0, 1.0), "acot": (-math.inf, math.inf)}
QUARTERS = {"sin": 0.5, "cos": 1.0, "tan": 0.5}  # half turns from where a wave begins to rise, or a tangent, to zero


def ways(program: Program, box: Sequence[Interval], symbol: int) -> list[Way]:
    """Tell which way each output goes along an input, the others being anything in their ranges.

    Args:
        program: The outputs.
        box: The ranges of the inputs.
        symbol: The number of the input.
    """
    ranges = Runner(program, INTERVALS).slots(list(box))
    first = len(box)
    found: list[Way] = [int(at == symbol) for at in range(first)]
    found += [0] * (len(program.operations) + len(program.literals))  # literals count from the end
    for slot, operation in enumerate(program.operations, first):
        moving = any(found[at] != 0 for at in operation[1])
        found[slot] = _way(operation, found, ranges) if moving else 0
    return [found[output] for output in program.outputs]


def _way(operation: Operation, found: Sequence[Way], ranges: Sequence[Interval]) -> Way:
    name, arguments = operation
    own, values = [found[at] for at in arguments], [ranges[at] for at in arguments]
    if None in own or not all(map(math.isfinite, (end for ends in values for end in ends))):
        return None
    if len(arguments) == 1:
        return _times(own[0], _of_one(name, values[0]))
    return _of_two(name, own, values) if len(arguments) == 2 else None


def _of_two(name: str, own: Sequence[Way], values: Sequence[Interval]) -> Way:
    signs = [side_of_zero(ends) for ends in values]
    match name:
        case "+":
            return _both(own[0], own[1])
        case "-":
            return _both(own[0], _times(own[1], -1))
        case "*":
            return _both(_scaled(own[0], signs[1]), _scaled(own[1], signs[0]))
        case "/" if signs[1]:
            return _both(_scaled(own[0], signs[1]), _scaled(_times(own[1], -1), signs[0]))
        case "^" | "root" if own[1] == 0 and values[0][0] >= 0 and signs[1]:
            return _times(own[0], signs[1])
    return None


def _of_one(name: str, values: Interval) -> Way:
    """Tell which way a function of one argument goes on a range."""
    low, high = values
    for functions, way in ((RISING, 1), (FALLING, -1)):
        if name in functions:
            return way if functions[name][0] <= low and high <= functions[name][1] else None
    if name == "negate":
        return -1
    if name == "abs":
        return side_of_zero(values) or None
    if name in QUARTERS:
        return _of_wave(name, values)
    return _of_power(int(name[5:]), values) if name[:5] == "power" else None


def _of_wave(name: str, values: Interval) -> Way:
    """Tell which way a sine, a cosine or a tangent goes within one half turn."""
    first, last = (end / math.pi + QUARTERS[name] for end in values)
    half = math.floor(first)
    if last > half + 1 or (name == "tan" and not half < first <= last < half + 1):
        return None
    return 1 if name == "tan" or half % 2 == 0 else -1


def _of_power(power: int, values: Interval) -> Way:
    if power % 2 or values[0] >= 0:
        return 1 if power else 0
    return -1 if values[1] <= 0 else None


def _scaled(way: Way, sign: int) -> Way:
    """Turn a way by the sign of a factor; what stays may have a factor of any sign."""
    return way if way == 0 else _times(way, sign or None)


def _times(one: Way, other: Way) -> Way:
    return None if one is None or other is None else one * other


def _both(one: Way, other: Way) -> Way:
    """Give the way of a sum."""
    if one is None or other is None or one * other < 0:
        return None
    return one or other
