"""Zeros of a smooth function on a closed loop, tangencies included, from samples once around (domain HC-2).

A cell of the loop is known by five values. Where they bend evenly, and rise or fall clearly, it has one zero or none;
where they bend evenly and stay away from zero it has none; otherwise it is halved. So zeros close together are told
apart, and a narrow turn is not passed over.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import isfinite, pi
from typing import NamedTuple

from mechanics.errors import SingularError

Function = Callable[[float], float]

CELLS = 90
EVENLY = 0.5  # of the greatest bend that bends may be off a straight row
LEVEL = 1e-9  # of its nearest value: a function that varies less does not come to zero, however it trembles
CLEARLY = 2.0  # times its greatest bend that a function must rise from value to value to be taken as monotone
NARROW = 1e-9  # a cell as narrow is not halved
NEAR = 1e-6  # zeros as near to a tangency belong to it
MOST = 2000  # cells that are looked at
STEPS, CLOSE = 200, 1e-14  # of false position; its last step


class Zero(NamedTuple):
    at: float  # in [0, 2 pi)
    double: bool  # the function touches zero here and does not change its sign


Values = tuple[float, float, float, float, float]  # at the ends, the middle and the quarters of a cell
_Cell = tuple[float, float, Values]  # from left to right


def zeros(function: Function, rounding: float, cells: int = CELLS) -> list[Zero]:
    """Find all zeros of a function with period 2 pi.

    Args:
        function: Smooth and periodic.
        rounding: A value as small cannot be told from zero.
        cells: In how many equal parts the loop is first divided.

    Returns:
        The zeros, rising; two that are nearer than rounding are one double zero.

    Raises:
        OverflowError: A value is not finite.
        SingularError: The function is zero, or cannot be told from zero, along a whole part of the loop.
    """
    step = 2 * pi / (4 * cells)
    values = [function(i * step) for i in range(4 * cells)]
    values.append(values[0])
    if not all(map(isfinite, values)):
        raise OverflowError("a value on the loop is beyond the range of floats")
    cells_left: list[_Cell] = []
    for i in range(0, 4 * cells, 4):
        a, b, c, d, e = values[i : i + 5]
        if max(abs(a), abs(b), abs(c), abs(d), abs(e)) <= rounding:
            raise SingularError(f"the function is zero from {i * step:g} to {(i + 4) * step:g}")
        cells_left.append((i * step, (i + 4) * step, (a, b, c, d, e)))
    found: list[Zero] = []
    for _ in range(MOST):
        if not cells_left:
            return _merged(sorted(found))
        cell = cells_left.pop()
        zero = _known(function, *cell, rounding)
        if zero is None:
            cells_left += _halves(function, *cell)
        else:
            found += zero
    raise SingularError("the function cannot be told from zero along a part of the loop")


def _known(function: Function, left: float, right: float, values: Values, rounding: float) -> list[Zero] | None:
    """Give the zeros of a cell; None where five values do not tell them."""
    a, _, c, _, e = values
    sizes = [abs(value) for value in values]
    middle, narrow, nearest = (left + right) / 2, right - left < NARROW, min(sizes)
    if max(sizes) <= rounding:
        return [Zero(middle, True)]
    if max(values) - min(values) < LEVEL * nearest:
        return []
    bends = [before - 2 * here + after for before, here, after in zip(values, values[1:], values[2:], strict=False)]
    bend = max(abs(one) for one in bends)
    if not narrow and bend > rounding and abs(bends[0] - 2 * bends[1] + bends[2]) > EVENLY * bend:
        return None
    if narrow or _monotone(values, CLEARLY * bend):
        if (a < 0) != (e < 0):
            return [Zero(between(function, left, right, a, e), False)]
        return [Zero(middle, True)] if narrow and nearest <= rounding else []
    return [] if nearest > bend + rounding and (a < 0) == (c < 0) == (e < 0) else None


def _halves(function: Function, left: float, right: float, values: Values) -> list[_Cell]:
    a, b, c, d, e = values
    eighth, middle = (right - left) / 8, (left + right) / 2
    first, second, third, fourth = (function(left + k * eighth) for k in (1, 3, 5, 7))
    return [(left, middle, (a, first, b, second, c)), (middle, right, (c, third, d, fourth, e))]


def _monotone(values: Values, least: float) -> bool:
    steps = [after - before for before, after in pairwise(values)]
    return min(steps) > least or max(steps) < -least


def _merged(found: list[Zero]) -> list[Zero]:
    """Make one of all zeros near a tangency: simple if their signs change an odd number of times."""
    groups: list[list[Zero]] = []
    for zero in found:
        last = groups[-1] if groups else []
        if last and zero.at - last[-1].at < NEAR and (zero.double or last[-1].double):
            last.append(zero)
        else:
            groups.append([zero])
    merged: list[Zero] = []
    for group in groups:
        simple = [zero for zero in group if not zero.double]
        chosen = simple or group
        at = sum(zero.at for zero in chosen) / len(chosen)
        merged.append(Zero(at % (2 * pi), len(simple) % 2 == 0))
    return sorted(merged)


def between(function: Function, left: float, right: float, at_left: float, at_right: float) -> float:
    """Find the zero in a bracket by false position (Illinois form)."""
    kept, last, at_kept, at_last = left, right, at_left, at_right
    for _ in range(STEPS):
        if at_last == 0:
            break
        next_one = last - at_last * (last - kept) / (at_last - at_kept)
        value = function(next_one)
        if (value < 0) != (at_last < 0):
            kept, at_kept = last, at_last
        else:
            at_kept /= 2
        step, last, at_last = abs(next_one - last), next_one, value
        if step < CLOSE:
            break
    return last
