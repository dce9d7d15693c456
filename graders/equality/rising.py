"""Which way a formula goes along a symbol: what only rises or falls is least at an end and has one zero at most."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TypeAlias

from graders.equality.inside import RISING
from graders.language.intervals import Interval, side_of_zero
from graders.language.program import Operation, Program

Trend: TypeAlias = int | None  # 1 where it rises, -1 where it falls, 0 where it stays, None where it is not known
FALLING: Mapping[str, Interval] = {"acos": (-1.0, 1.0), "acot": (-math.inf, math.inf)}
QUARTERS = {"sin": 0.5, "cos": 1.0, "tan": 0.5}  # half turns from where a wave begins to rise, or a tangent, to zero


def trends(program: Program, ranges: Sequence[Interval], symbol: int) -> list[Trend]:
    """Tell which way each slot goes along an input, the others being anything in their ranges.

    Args:
        program: Its operations.
        ranges: The values of all slots on the box.
        symbol: The number of the input.
    """
    first, found = len(program.inputs), list[Trend]([0]) * len(ranges)
    found[symbol] = 1
    for slot, operation in enumerate(program.operations, first):
        moving = any(found[at] != 0 for at in operation[1])
        found[slot] = _way(operation, found, ranges) if moving else 0
    return found


def _way(operation: Operation, found: Sequence[Trend], ranges: Sequence[Interval]) -> Trend:
    name, arguments = operation
    own, values = [found[at] for at in arguments], [ranges[at] for at in arguments]
    if None in own or not all(map(math.isfinite, (end for ends in values for end in ends))):
        return None
    if len(arguments) == 1:
        return _times(own[0], _of_one(name, values[0]))
    return _of_two(name, own, values) if len(arguments) == 2 else None


def _of_two(name: str, own: Sequence[Trend], values: Sequence[Interval]) -> Trend:
    signs = [1 if low >= 0 else -1 if high <= 0 else 0 for low, high in values]  # a factor may vanish at an end
    match name:
        case "+":
            return _both(own[0], own[1])
        case "-":
            return _both(own[0], _times(own[1], -1))
        case "*":
            return _both(_scaled(own[0], signs[1]), _scaled(own[1], signs[0]))
        case "/" if side_of_zero(values[1]):
            return _both(_scaled(own[0], signs[1]), _scaled(_times(own[1], -1), signs[0]))
        case "^" | "root" if own[1] == 0 and values[0][0] >= 0 and side_of_zero(values[1]):
            return _times(own[0], signs[1])
    return None


def _of_one(name: str, values: Interval) -> Trend:
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


def _of_wave(name: str, values: Interval) -> Trend:
    """Tell which way a sine, a cosine or a tangent goes within one half turn."""
    first, last = (end / math.pi + QUARTERS[name] for end in values)
    half = math.floor(first)
    if last > half + 1 or (name == "tan" and not half < first <= last < half + 1):
        return None
    return 1 if name == "tan" or half % 2 == 0 else -1


def _of_power(power: int, values: Interval) -> Trend:
    if power % 2 or values[0] >= 0:
        return 1 if power else 0
    return -1 if values[1] <= 0 else None


def _scaled(way: Trend, sign: int) -> Trend:
    """Turn a way by the sign of a factor; what stays may have a factor of any sign."""
    return way if way == 0 else _times(way, sign or None)


def _times(one: Trend, other: Trend) -> Trend:
    return None if one is None or other is None else one * other


def _both(one: Trend, other: Trend) -> Trend:
    """Give the way of a sum."""
    if one is None or other is None or one * other < 0:
        return None
    return one or other
