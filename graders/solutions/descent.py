"""A zero of one residual near a point: down its slope in all symbols at once, kept inside the box."""

from __future__ import annotations

from collections.abc import Sequence

from graders.solutions.beside import Beside, beside
from graders.solutions.scene import Side
from graders.solutions.zeros import Line, Zero, secant, touching

SLOPES = 5  # how often the slope is taken anew
ALONG = 6  # steps along one slope
DROP = 1e-8  # of the first value: near enough to go on in balls
FURTHEST = 3.0  # in units of the first step
STALLED = 1e-3  # of the first value: what is left of it may be a zero that is only touched
REACH = 5e-2  # of a range: how far that is looked for
NUDGE = 1e-7  # of a range: over which slopes are taken
EDGE = 1e-6  # of a range: nearer to an end a symbol has no room


def descended(side: Side, start: Sequence[float], used: Sequence[int]) -> Zero | None:
    """Find a zero of the only residual of a side near a start; None where none is found inside the box."""
    try:
        return _descended(side, start, used)
    except (ZeroDivisionError, OverflowError):  # slopes beyond doubles lead nowhere
        return None


def _descended(side: Side, start: Sequence[float], used: Sequence[int]) -> Zero | None:
    moving = [at for at in used if side.scene.width(at)]
    point, first = list(start), side.doubles(start)
    if first is None or not moving:
        return None
    value, slopes = first[0], list[float]()
    for _ in range(SLOPES):
        found = _slopes(side, point, moving, value)
        if found is None or not any(found):
            return None
        slopes = found
        point, value = _slid(side, point, value, moving, slopes)
        if abs(value) <= DROP * abs(first[0]):
            return _proved(side, point, moving, slopes)
    return _touched(side, point, moving, slopes) if abs(value) < STALLED * abs(first[0]) else None


def _slopes(side: Side, point: list[float], moving: Sequence[int], here: float) -> list[float] | None:
    """Give the slopes over shares of the ranges."""
    found = []
    for at in moving:
        low, high = side.scene.ranges[at]
        kept, share = point[at], NUDGE if point[at] < (low + high) / 2 else -NUDGE
        point[at] = kept + share * (high - low)
        there = side.doubles(point)
        point[at] = kept
        if there is None:
            return None
        found.append((there[0] - here) / share)
    return found


def _slid(
    side: Side, start: list[float], value: float, moving: Sequence[int], slopes: Sequence[float]
) -> tuple[list[float], float]:
    """Go along a slope by the secant rule to the least size found; gives the place and the value there."""
    square = sum(slope * slope for slope in slopes)
    shares = [value * slope / square for slope in slopes]
    before, here, best = (0.0, value), 1.0, (start, value)
    longest = max(map(abs, shares))
    here = min(1.0, 0.5 / longest) if longest else 1.0
    for _ in range(ALONG):
        point = _at(side, start, moving, shares, here)
        found = side.doubles(point)
        if found is None:
            here /= 2
            continue
        if abs(found[0]) < abs(best[1]):
            best = point, found[0]
        fall = found[0] - before[1]
        if abs(best[1]) <= DROP * abs(value) or not fall:
            break
        step = found[0] * (here - before[0]) / fall
        before, here = (here, found[0]), min(FURTHEST, max(0.0, here - step))
    return best


def _at(
    side: Side, start: Sequence[float], moving: Sequence[int], shares: Sequence[float], length: float
) -> list[float]:
    point = list(start)
    for at, share in zip(moving, shares, strict=True):
        low, high = side.scene.ranges[at]
        point[at] = min(high, max(low, point[at] - length * share * (high - low)))
    return point


def _steepest(side: Side, point: Sequence[float], moving: Sequence[int], slopes: Sequence[float]) -> int:
    """Choose the symbol that moves the residual most and has room to move."""
    weighed = []
    for at, slope in zip(moving, slopes, strict=True):
        low, high = side.scene.ranges[at]
        room = low + EDGE * (high - low) < point[at] < high - EDGE * (high - low)
        weighed.append((abs(slope) * (1.0 if room else 1e-3), at))
    return max(weighed)[1]


def _proved(side: Side, point: Sequence[float], moving: Sequence[int], slopes: Sequence[float]) -> Zero | None:
    at = _steepest(side, point, moving, slopes)
    zero = secant(Line(side, point, at), point[at])
    return zero if zero is not None and beside(side, zero) is Beside.ZERO else None


def _touched(side: Side, point: Sequence[float], moving: Sequence[int], slopes: Sequence[float]) -> Zero | None:
    """Look for a zero without a change of sign, to which steps close in slowly."""
    at = _steepest(side, point, moving, slopes)
    low, high = side.scene.ranges[at]
    reach = REACH * (high - low)
    return touching(Line(side, point, at), max(low, point[at] - reach), min(high, point[at] + reach))
