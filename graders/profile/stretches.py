"""A curve along a bar as stretches without a jump inside, each a polynomial of the distance from its start."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import TypeAlias

from graders.profile.polynomial import Polynomial, shifted, value

Rows: TypeAlias = tuple[tuple[float, ...], ...]
Ordinates: TypeAlias = tuple[float, float, float | None, float | None]
NEGLIGIBLE = 1e-9  # of the largest ordinate, and of a place


@dataclass(frozen=True, slots=True)
class Stretch:
    """A part of a curve: its ends, and its polynomial in the distance from the start (SI units)."""

    start: float
    end: float
    curve: Polynomial

    def at(self, x: float) -> float:
        """Give the ordinate at a place."""
        return value(self.curve, x - self.start)

    def part(self, start: float, end: float) -> Stretch:
        """Give the same curve between two other places."""
        return Stretch(start, end, shifted(self.curve, start - self.start))

    def scaled(self, factor: float) -> Stretch:
        """Give the curve with all ordinates multiplied."""
        return Stretch(self.start, self.end, tuple(factor * c for c in self.curve))


Profile: TypeAlias = tuple[Stretch, ...]


@lru_cache(maxsize=512)
def profile_of(rows: Rows) -> Profile:
    """Read a matrix whose rows are start, end and coefficients of a stretch."""
    return tuple(Stretch(row[0], row[1], row[2:]) for row in rows)


def rows_of(profile: Iterable[Stretch]) -> Rows:
    """Write a profile as a matrix with rows of equal length."""
    held = tuple(profile)
    width = max(len(one.curve) for one in held)
    return tuple((one.start, one.end, *one.curve, *[0.0] * (width - len(one.curve))) for one in held)


def highest(profile: Iterable[Stretch]) -> float:
    """Give the largest magnitude of a curve over ends and five inner points of each stretch."""
    return max(abs(one.at(x)) for one in profile for x in inner_places(one.start, one.end))


def inner_places(start: float, end: float) -> list[float]:
    """Give places at which two polynomials of low degree are compared: both ends and five between them."""
    return [start + (end - start) * share / 6 for share in range(7)]


def covering(profile: Sequence[Stretch], start: float, end: float) -> Stretch | None:
    """Give the part of a profile between two neighbouring borders, or None where nothing is drawn."""
    middle = (start + end) / 2
    for one in profile:
        if one.start <= middle <= one.end:
            return one.part(start, end)
    return None


def ordinates_of(profile: Sequence[Stretch]) -> tuple[Ordinates, ...] | None:
    """Write a curve as rows of a table: a place, the ordinates left and right of it, and that half-way to the next.

    Args:
        profile: The stretches, from left to right, in SI units.

    Returns:
        A row for each end of a stretch. Right of a place nothing stands where the curve does not jump, half-way nothing
        where it runs straight. None for a curve that no table holds: with a gap, or of a degree above two.
    """
    least = NEGLIGIBLE * highest(profile)
    rows = [_row(one, before, least) for before, one in zip((None, *profile), profile, strict=False)]
    gaps = any(abs(one.end - other.start) > NEGLIGIBLE * abs(one.end) for one, other in pairwise(profile))
    if gaps or any(row is None for row in rows):
        return None
    last = profile[-1]
    return (*filter(None, rows), (last.end, last.at(last.end), None, None))


def _row(one: Stretch, before: Stretch | None, least: float) -> Ordinates | None:
    length = one.end - one.start
    if any(abs(c) * length**power > least for power, c in enumerate(one.curve) if power > 2):
        return None
    left, right, end = before.at(before.end) if before else one.at(one.start), one.at(one.start), one.at(one.end)
    middle = one.at(one.start + length / 2)
    bent, jumps = abs(middle - (right + end) / 2) > least, abs(right - left) > least
    return one.start, left, right if jumps else None, middle if bent else None
