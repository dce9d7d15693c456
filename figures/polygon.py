"""Vector polygons: sides with heads at the nodes and a named vector beside each."""

from __future__ import annotations

from dataclasses import dataclass
from math import copysign

from figures.canvas import Piece
from figures.label import symbol
from figures.lines import vector
from figures.placing import written
from figures.plane import Point, direction, left_of, unit


@dataclass(frozen=True, slots=True)
class Side:
    """One vector of the polygon; its name stands on the left of its way (+1) or on the right (-1)."""

    start: Point
    end: Point
    name: str
    aside: float = 1.0
    style: str = "pos"
    share: float = 0.5


def side(one: Side) -> tuple[Piece, ...]:
    """The vector with its head at the end node and its name, under an arrow, beside it."""
    arrow = vector(one.start, one.end, one.style)
    if not one.name:
        return arrow
    label = symbol(one.name, one.style, arrow=True)
    normal = copysign(1.0, one.aside) * 1j * unit(direction(one.start, one.end))
    # the near side of the label's room clears the line by 8
    box = label.box(0, "middle")
    reach = abs(normal.real) * label.width / 2 + (
        -normal.imag * box.bottom if normal.imag > 0 else -normal.imag * box.top
    )
    at = left_of(one.start, one.end, 0, one.share) + (8 + reach) * normal
    return (*arrow, *written(label, at, "middle"))


def polygon(sides: tuple[Side, ...]) -> tuple[Piece, ...]:
    """All sides of a polygon, in their order."""
    return tuple(mark for one in sides for mark in side(one))
