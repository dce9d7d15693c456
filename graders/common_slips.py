"""Slips made in any task: by what a wrong answer is off, whatever was asked for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from enum import StrEnum
from functools import lru_cache
from math import pi
from typing import Any

from graders.verdict import Code


class CommonSlip(StrEnum):
    """The likelier slip first, where a number is off by what several of them do."""

    OPPOSITE_SIGN = "opposite_sign"
    KILO_PREFIX = "kilo_prefix"
    POWER_OF_TEN = "power_of_ten"
    INVERTED_RATIO = "inverted_ratio"
    DEGREES_RADIANS = "degrees_radians"
    TURNS_RADIANS = "turns_radians"
    FIELDS_EXCHANGED = "fields_exchanged"
    ROWS_FOR_COLUMNS = "rows_for_columns"
    SINE_COSINE = "sine_cosine"
    TERM_LOST = "term_lost"
    TERM_SIGN = "term_sign"
    FACTOR_LOST = "factor_lost"
    FACTOR_TWO = "factor_two"
    DIAMETER_RADIUS = "diameter_radius"
    PI_LOST = "pi_lost"
    UPSIDE_DOWN = "upside_down"
    POWER = "power"
    EXCHANGED = "exchanged"
    OTHER_FUNCTION = "other_function"


Slips = frozenset[CommonSlip]
NONE: Slips = frozenset()
Dimension = tuple[int, ...]  # exponents: the first is that of length, the third of time, the fourth of the angle
BY_CODE = {
    Code.OPPOSITE_SIGN: CommonSlip.OPPOSITE_SIGN,
    Code.OPPOSITE_CONVENTION: CommonSlip.OPPOSITE_SIGN,
    Code.FACTOR_OF_TEN: CommonSlip.POWER_OF_TEN,
    Code.INVERTED_RATIO: CommonSlip.INVERTED_RATIO,
}
ANGLE: Dimension = (0, 0, 0, 1, 0)
KILO, TEN = (3, 6, 9, 12), tuple(range(1, 13))


def slips_of(grader: Any, answer: Any, reference: Any, code: Code | None = None) -> Slips:
    """Tell which common slips make an answer out of a reference: the judge's own, or what its code says, if known."""
    own = getattr(grader, "slips", None)
    if own is not None:
        found: Slips = own(answer, reference)
        return found
    slip = BY_CODE.get(code or grader.check(answer, reference).code)
    return NONE if slip is None else frozenset((slip,))


def is_right(grader: Any, answer: Any, reference: Any) -> bool:
    """Tell whether an answer is right, without naming what is off where it is not, as far as a judge can do so."""
    own = getattr(grader, "right", None)
    return bool(own(answer, reference)) if own is not None else grader.check(answer, reference).code is Code.RIGHT


def agrees(grader: Any, answer: Any, value: Any) -> bool:
    """Tell whether an answer is a value to the precision with which it is typed, not only to its tolerance.

    Many slips are tried, so that a loose bound would name some of them for any number.
    """
    own = getattr(grader, "agrees", None)
    return bool(own(answer, value)) if own is not None else is_right(grader, answer, value)


def likeliest(each: Iterable[Slips]) -> CommonSlip | None:
    """Give the one slip that explains all answers."""
    shared: Slips | None = None
    for slips in each:
        shared = slips if shared is None else shared & slips
        if not shared:
            return None
    return next((slip for slip in CommonSlip if slip in shared), None) if shared else None


def off_by(ratio: float, tolerance: float, dimension: Dimension) -> Slips:
    """Tell which slips make a number by this ratio too large.

    Args:
        ratio: The number over the right one.
        tolerance: Relative, of the ratio.
        dimension: Exponents of the unit, the angle's included.
    """
    return frozenset(slip for slip, factor in _factors(dimension) if abs(ratio / factor - 1) <= tolerance)


@lru_cache(maxsize=64)
def _factors(dimension: Dimension) -> tuple[tuple[CommonSlip, float], ...]:
    return tuple(_listed(dimension))


def _of_diameters(dimension: Dimension) -> tuple[float, ...]:
    """Give what a diameter in the place of a radius changes: areas, moduli, stresses; of angles that of a twist."""
    if dimension[0]:
        return 4.0, 8.0, 16.0
    return (16.0,) if tuple(dimension) == ANGLE else ()


def _listed(dimension: Dimension) -> Iterator[tuple[CommonSlip, float]]:
    yield CommonSlip.OPPOSITE_SIGN, -1.0
    for sign in (1, -1):
        yield from ((CommonSlip.KILO_PREFIX, 10.0 ** (sign * power)) for power in KILO)
        yield from ((CommonSlip.POWER_OF_TEN, 10.0 ** (sign * power)) for power in TEN)
        yield CommonSlip.FACTOR_TWO, 2.0**sign
        if dimension[3]:
            yield CommonSlip.DEGREES_RADIANS, (180 / pi) ** sign
        if dimension[3] and dimension[2] == -1:
            yield from ((CommonSlip.TURNS_RADIANS, factor**sign) for factor in (2 * pi, 60.0, 30 / pi))
        yield CommonSlip.PI_LOST, pi**sign
        yield from ((CommonSlip.DIAMETER_RADIUS, factor**sign) for factor in _of_diameters(dimension))
