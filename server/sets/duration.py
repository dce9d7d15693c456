"""How long the tasks of a set take, as their exercises estimate it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from exercises import catalogue


@dataclass(frozen=True, slots=True)
class Span:
    """A time in minutes; of a pool a student may be dealt the shortest exercise or the longest."""

    least: int
    most: int

    def __str__(self) -> str:
        return f"{self.least}" if self.least == self.most else f"{self.least}–{self.most}"


def needed(pools: Iterable[Sequence[str]]) -> Span:
    """Add up the tasks of these pools; what is no longer in the catalogue counts for nothing."""
    each = [_minutes(pool) for pool in pools]
    return Span(sum(min(one) for one in each), sum(max(one) for one in each))


def _minutes(pool: Sequence[str]) -> list[int]:
    return [catalogue.load(one).exercise.minutes for one in pool if one in catalogue.ids()] or [0]
