"""What one side does at a zero of the other: is it zero there too, is it proved not to be, or is it not known."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

from flint import arb

from graders.language.balls import precision
from graders.solutions.scene import BITS, Side
from graders.solutions.zeros import FAR, NEAR, Zero

FINE = 1024  # bits for a zero of high order
SHRUNK = arb(2) ** -20
FLAT = arb(2) ** -100
SLANT = 0.7548776662  # shares of the ranges by which the symbols are moved, so that no direction is special


class Beside(Enum):
    """What is found at a zero."""

    ZERO = "zero"
    OTHER = "other"
    UNDEFINED = "undefined"
    UNSURE = "unsure"


def beside(side: Side, zero: Zero) -> Beside:
    """Tell what a side does at a zero of the other one."""
    values = side.balls(zero.point)
    if values is not None and not all(value.contains(0) for value in values):
        return Beside.OTHER
    middle = [arb(x.mid()) for x in zero.point]
    if values is not None and _far_below(values, side.balls(_points(side, middle, zero.free, NEAR)[0])):
        return Beside.ZERO
    if values is None and side.balls(middle) is None:
        return _hole(side, middle, zero.free)
    for bits in (BITS, FINE):
        with precision(bits):
            if _small(side, middle, zero.free, flat=bits == FINE):
                return Beside.ZERO
    return Beside.UNSURE


def _points(side: Side, middle: Sequence[arb], free: Sequence[int], step: arb) -> list[list[arb]]:
    """Give the points a step away along the free symbols, on both sides."""
    found = []
    for sign in (-1, 1):
        point = list(middle)
        for order, at in enumerate(free):
            point[at] += step * (sign * SLANT**order * side.scene.width(at))
        found.append(point)
    return found


def _around(side: Side, middle: Sequence[arb], free: Sequence[int], step: arb) -> list[list[arb] | None]:
    return [side.balls(point) for point in _points(side, middle, free, step)]


def _far_below(here: Sequence[arb], beyond: Sequence[arb] | None) -> bool:
    if beyond is None:
        return False
    return all(one.abs_upper() < SHRUNK * other.abs_lower() for one, other in zip(here, beyond, strict=True))


def _small(side: Side, middle: Sequence[arb], free: Sequence[int], flat: bool) -> bool:
    """Tell whether the values are far smaller here than a small step away, on a side where they exist."""
    here = side.balls(middle)
    near = [values for values in _around(side, middle, free, NEAR) if values is not None]
    if here is None or not near:
        return False
    pairs = [pair for values in near for pair in zip(here, values, strict=True)]
    return all(
        value.abs_upper() < SHRUNK * beyond.abs_lower() or (flat and flat_zero(value) and beyond.contains(0))
        for value, beyond in pairs
    )


def flat_zero(value: arb) -> bool:
    """Tell whether a ball holds zero and nothing far from it: the sign of what vanishes is no zero."""
    return bool(value.contains(0) and value.abs_upper() < FLAT)


def _hole(side: Side, middle: Sequence[arb], free: Sequence[int]) -> Beside:
    """Where a side has no value at the place itself, what is around it decides."""
    if _nowhere(side, middle, free):
        return Beside.UNDEFINED
    near, far = _around(side, middle, free, NEAR), _around(side, middle, free, FAR)
    found = {_limit(one, other) for one, other in zip(near, far, strict=True) if one is not None and other is not None}
    return found.pop() if len(found) == 1 else Beside.UNSURE


def _limit(near: Sequence[arb], far: Sequence[arb]) -> Beside:
    pairs = list(zip(near, far, strict=True))
    if all(one.abs_upper() < SHRUNK * other.abs_lower() for one, other in pairs):
        return Beside.ZERO
    return Beside.OTHER if any(one.abs_lower() * 2 > other.abs_upper() for one, other in pairs) else Beside.UNSURE


def _nowhere(side: Side, middle: Sequence[arb], free: Sequence[int]) -> bool:
    """Tell whether there is proved to be no value here nor around."""
    around = (*_points(side, middle, free, FAR), *_points(side, middle, free, NEAR))
    return all(side.nowhere(point) for point in (middle, *around))
