"""Closing in on a zero of a function of one number: in doubles between opposite signs, in balls by secant steps."""

from __future__ import annotations

import math
from collections.abc import Callable

from flint import arb

LAST = arb(2) ** -190  # of the range: a step behind which a zero stands


def closed_in(
    function: Callable[[float], float], ends: tuple[float, float], values: tuple[float, float], close: float
) -> float:
    """Close in on a change of sign in doubles, until what is left is such a share of the way between the ends.

    Args:
        function: It may be not a number somewhere.
        ends: Where its signs are opposite.
        values: Its values there.
        close: The share.

    Source:
        T. R. Chandrupatla, A new hybrid quadratic/bisection algorithm, Advances in Engineering Software 28, 1997.
    """
    (b, a), (fb, fa), width, share = ends, values, close * abs(ends[1] - ends[0]), 0.5
    for _ in range(60):
        x = a + share * (b - a)
        value = function(x)
        if not value or math.isnan(value):
            return x
        (c, fc), (b, fb) = ((a, fa), (b, fb)) if value * fa > 0 else ((b, fb), (a, fa))
        a, fa = x, value
        least = width / abs(b - a) if b != a else 1.0
        if least > 0.5:
            break
        share = min(1 - least, max(least, _next_share((a, fa), (b, fb), (c, fc))))
    return a if abs(fa) < abs(fb) else b


def _next_share(one: tuple[float, float], two: tuple[float, float], last: tuple[float, float]) -> float:
    """Give the share of the way from one point to the other, where a parabola of x over the values of three is zero."""
    (a, fa), (b, fb), (c, fc) = one, two, last
    if fa in (fb, fc) or fb == fc:
        return 0.5
    place, height = (a - b) / (c - b), (fa - fb) / (fc - fb)
    if not (height * height < place and (1 - height) ** 2 < 1 - place):
        return 0.5
    return fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)


def polished(function: Callable[[arb], arb | None], start: arb, width: arb) -> arb | None:
    """Make secant steps from a place near a zero until they are tiny; None where they do not close in."""
    one, two = start, start + width * arb(2) ** -50
    first, second = function(one), function(two)
    for _ in range(14):
        if first is None or second is None:
            return None
        slope = (second - first).mid()
        if slope == 0:
            return two
        step = (second.mid() * (two - one).mid() / slope).mid()
        if abs(step) > width:
            return None
        one, first, two = two, second, (two - step).mid()
        if abs(step) < LAST * width:
            return two
        second = function(two)
    return None


def lowest(function: Callable[[float], float], low: float, high: float) -> float:
    """Find the place of the least size by golden section."""
    ratio = (math.sqrt(5) - 1) / 2
    a, b = low, high
    for _ in range(40):
        one, two = b - ratio * (b - a), a + ratio * (b - a)
        if abs(function(one)) < abs(function(two)):
            b = two
        else:
            a = one
    return (a + b) / 2
