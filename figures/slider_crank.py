"""A slider-crank over its vector polygon, always in one pose: nothing is to scale, so nothing is told.

The crank turns about A, the rod runs from B to C, the slider moves along x through A. Angles are counter-clockwise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import asin, cos, radians, sin
from typing import Literal

from figures.canvas import Drawing, Piece
from figures.joints import ground, ground_line, revolute, slider
from figures.label import number, point, symbol
from figures.lines import arc, axis, hidden, thin
from figures.members import link
from figures.picture import Picture, Words
from figures.placing import written
from figures.plane import Point, direction, left_of, unit
from figures.polygon import Side, between, side

CRANK, ROD, CRANK_ANGLE = 138.0, 368.0, radians(46)
WIDTH = 572.0
_DROP = 196.0  # from the axis of the scheme to that of the polygon
_ROD_ANGLE = -asin(CRANK * sin(CRANK_ANGLE) / ROD)
_A: Point = 0j
_B = CRANK * unit(CRANK_ANGLE)
_C = complex(CRANK * cos(CRANK_ANGLE) + ROD * cos(_ROD_ANGLE), 0)


@dataclass(frozen=True, slots=True)
class Names:
    """The names in the figure; an empty one is left out, with its arc."""

    points: tuple[str, str, str] = ("A", "B", "C")
    links: tuple[str, str, str] = ("1", "2", "3")
    vectors: tuple[str, str, str] = ("l1", "l2", "l3")
    angles: tuple[str, str] = ("α1", "α2")
    speed: str = "ω1"


def draw(prefix: str, words: Words, names: Names, sense: Literal["ccw", "cw"] = "ccw", polygon: bool = True) -> Picture:
    """Draw the scheme and, under it in the same pose, its vector polygon.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        names: Letters of points, links, vectors, angles and of the speed of the crank.
        sense: In which sense the crank turns.
        polygon: Whether the polygon is drawn; where it is asked for, it is not.
    """
    if polygon:
        pieces = [*_projections(), *_scheme(names, sense), *_polygon(names)]
    else:
        pieces = [*_scheme(names, sense), *written(symbol("x", "thin"), _C + 62 + 8j, "middle")]
    svg = Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH)
    return Picture(svg, words.table)


def draw_polygon(prefix: str, title: str, vectors: Sequence[tuple[str, str, str]]) -> Picture:
    """Draw a student's vectors between the nodes A, B and C, in the pose of the scheme.

    Args:
        prefix: The id of the figure on its page.
        title: What it shows.
        vectors: Name, start and end of each vector; one with an unknown node is left out.
    """
    axes = (axis(_A - 38, _C + 66), *written(symbol("x", "thin"), _C + 62 + 8j, "middle"))
    return between(prefix, title, {"A": _A, "B": _B, "C": _C}, vectors, axes, WIDTH)


def _projections() -> tuple[Piece, ...]:
    down = _DROP * 1j
    return (hidden(_A - 34j, _A - down), hidden(_B - 9j, _B - down), hidden(_C - 34j, _C - down))


def _scheme(names: Names, sense: Literal["ccw", "cw"]) -> list[Piece]:
    pieces: list[Piece] = [axis(_A - 38, _C + 66), *ground_line(_C - 60 - 15j, _C + 62 - 15j), slider(_C)]
    pieces += (*ground(_A), link(_A, _B, _C))
    pieces += _angle(_A, 46, CRANK_ANGLE, names.angles[0])
    if names.speed:
        ends = (radians(60), radians(94)) if sense == "ccw" else (radians(94), radians(60))
        pieces += (*arc(_A, 84, *ends, "vel"), *written(symbol(names.speed, "vel"), 99 * 1j - 8, "middle"))
    pieces += [mark for at in (_A, _B, _C) for mark in revolute(at)]
    for name, at in zip(names.points, (_A - 18 + 10j, _B + 16j, _C + 26j), strict=True):
        pieces += written(point(name), at, "middle") if name else ()
    for name, at in zip(
        names.links, (left_of(_A, _B, -14, 0.62) - 4j, left_of(_B, _C, 10), _C + 40 + 20j), strict=True
    ):
        pieces += written(number(name), at, "middle") if name else ()
    return pieces


def _angle(at: Point, radius: float, angle: float, name: str) -> tuple[Piece, ...]:
    """An arc from the direction of x, its name at its middle, outside."""
    if not name:
        return ()
    middle = at + (radius + 8) * unit(angle / 2) - 6j
    return (*arc(at, radius, 0, angle), *written(symbol(name), middle))


def _polygon(names: Names) -> list[Piece]:
    down = _DROP * 1j
    a, b, c = _A - down, _B - down, _C - down
    pieces: list[Piece] = [axis(a - 38, c + 66), *written(symbol("x", "thin"), c + 62 + 8j, "middle")]
    pieces += _angle(a, 46, CRANK_ANGLE, names.angles[0])
    if names.angles[1]:
        turn = direction(b, c)
        pieces += (thin(b, b + 96), *arc(b, 76, 0, turn), *written(symbol(names.angles[1]), b + 102 - 9j))
    sides = (Side(a, b, names.vectors[0], 1), Side(b, c, names.vectors[1], -1), Side(a, c, names.vectors[2], -1))
    return pieces + [mark for one in sides for mark in side(one)]
