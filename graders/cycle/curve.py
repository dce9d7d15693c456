"""A periodic table of a cycle as smooth curves: six-point Lagrange interpolation between its rows.

The phase of a cycle runs from 0 to 1; the rows stand at equal steps of it, the last repeats the first one turn later.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

Rows: TypeAlias = tuple[tuple[float, ...], ...]
Knot: TypeAlias = tuple[int, tuple[float, ...]]

LEAST = 8  # rows of a reference


@dataclass(frozen=True, slots=True)
class Cycle:
    """The columns of a reference: abscissae with both ends of the turn, and periodic ordinates."""

    starts: tuple[float, ...]  # of the abscissae
    turns: tuple[float, ...]  # what a whole cycle adds to each abscissa
    ordinates: tuple[tuple[float, ...], ...]  # column by column, without the last row

    @property
    def scales(self) -> tuple[float, ...]:
        """Give the amplitude of each ordinate: half of its range, or its size where it is constant."""
        return tuple((max(column) - min(column)) / 2 or max(map(abs, column)) for column in self.ordinates)

    def knot(self, phase: float) -> Knot:
        """Give the first of the six rows around a phase, and their weights."""
        place = phase % 1.0 * len(self.ordinates[0])
        row = int(place)
        return row - 2, _weights(place - row)

    def at(self, column: int, knot: Knot) -> float:
        """Give an ordinate at a knot."""
        values, (row, weights) = self.ordinates[column], knot
        count = len(values)
        return sum(w * values[(row + k) % count] for k, w in enumerate(weights))


def _weights(s: float) -> tuple[float, ...]:
    """Lagrange's weights of the nodes -2 .. 3 at s from 0 to 1."""
    a, b, c, d, e, f = s + 2, s + 1, s, s - 1, s - 2, s - 3
    return (
        -b * c * d * e * f / 120,
        a * c * d * e * f / 24,
        -a * b * d * e * f / 12,
        a * b * c * e * f / 12,
        -a * b * c * d * f / 24,
        a * b * c * d * e / 120,
    )


@lru_cache(maxsize=256)
def cycle_of(rows: Rows, abscissae: int) -> Cycle:
    """Read a reference matrix: a row a step, the abscissae first.

    Raises:
        ValueError: Too few rows.
    """
    if len(rows) <= LEAST:
        raise ValueError(f"a cycle of {len(rows)} rows is too coarse: at least {LEAST + 1} are needed")
    columns: Sequence[tuple[float, ...]] = tuple(zip(*rows, strict=True))
    turns = tuple(column[-1] - column[0] for column in columns[:abscissae])
    return Cycle(tuple(column[0] for column in columns[:abscissae]), turns, tuple(c[:-1] for c in columns[abscissae:]))
