"""Zeros of a smooth function on a closed loop, tangencies included, from samples once around (domain HC-2)."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import NamedTuple

Function = Callable[[float], float]

SAMPLES = 360
TOUCH = 1e-13  # of the largest value seen: an extremum as small touches zero
CLOSE = 1e-14  # a step of false position as short as this is the last
STEPS = 200
_SHARE = (3 - 5**0.5) / 2  # golden section


class Zero(NamedTuple):
    at: float  # in [0, 2 pi)
    double: bool  # the function touches zero here and does not change its sign


def zeros(function: Function, samples: int = SAMPLES) -> list[Zero]:
    """Find all zeros of a function with period 2 pi.

    A sign change between neighbours is a zero. An extremum that comes nearer to zero than both neighbours is looked at
    closely: it may hide two zeros, or touch.

    Args:
        function: Smooth and periodic.
        samples: How many places are looked at; two extrema between neighbours are not seen.

    Returns:
        The zeros, rising.
    """
    step = 2 * pi / samples
    values = [function(i * step) for i in range(samples)]
    touch = TOUCH * max(abs(value) for value in values)
    found: list[Zero] = []
    for i, here in enumerate(values):
        before, after = values[i - 1], values[(i + 1) % samples]
        if (here < 0) != (after < 0):
            found.append(Zero(between(function, i * step, (i + 1) * step, here, after), False))
        elif (before < 0) == (here < 0) and abs(here) <= abs(before) and abs(here) < abs(after):
            found += _near_extremum(function, (i - 1) * step, i * step, (i + 1) * step, touch)
    return sorted(Zero(zero.at % (2 * pi), zero.double) for zero in found)


def _near_extremum(function: Function, left: float, middle: float, right: float, touch: float) -> list[Zero]:
    """Descend to the value nearest to zero by golden section, until the sign changes or the bracket is spent."""
    sign = -1.0 if function(middle) < 0 else 1.0
    lowest = sign * function(middle)
    while lowest > touch and right - left > 1e-8:
        longer = right if right - middle > middle - left else left
        tried = middle + _SHARE * (longer - middle)
        value = sign * function(tried)
        if value < lowest:
            left, right = (middle, right) if tried > middle else (left, middle)
            middle, lowest = tried, value
        elif tried > middle:
            right = tried
        else:
            left = tried
    if lowest > touch:
        return []
    if lowest >= -touch:
        return [Zero(middle, True)]
    ends = ((left, middle), (middle, right))
    return [Zero(between(function, a, b, function(a), function(b)), False) for a, b in ends]


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
