"""What a graphical method draws, as plain numbers: named points, vectors and auxiliary lines (domain VM-1 to VM-6).

No figure is made here.
Points of a mechanism are in metres; a vector is drawn in a scale, so many metres for its unit.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from mechanics.checks import finite

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Arrow:
    """A vector drawn from its tail to its head."""

    name: str
    tail: Point
    head: Point


@dataclass(frozen=True, slots=True)
class Line:
    """An auxiliary line between two points: a ray, a normal, a parallel."""

    name: str
    start: Point
    end: Point


@dataclass(frozen=True, slots=True)
class Drawing:
    points: Mapping[str, Point]
    arrows: tuple[Arrow, ...]
    lines: tuple[Line, ...] = ()


def arrow(name: str, tail: Point, vector: Point, scale: float = 1.0) -> Arrow:
    """Draw a vector at a point.

    Args:
        name: Its name.
        tail: Where it begins, in metres.
        vector: The vector in its own unit.
        scale: Metres drawn for one unit.
    """
    return Arrow(name, tail, (tail[0] + scale * vector[0], tail[1] + scale * vector[1]))


def check(unit: str, **values: Point) -> None:
    """Refuse a point or vector that is not finite.

    Raises:
        ValueError: A component is NaN or infinite; the message has the name of the value.
    """
    for name, (x, y) in values.items():
        finite(f"{name} x", x, unit)
        finite(f"{name} y", y, unit)
