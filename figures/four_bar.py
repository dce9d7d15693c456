"""A four-bar linkage, always in one pose: nothing is to scale, so nothing is told.

The crank turns about A, the rocker about D, the coupler runs from B to C; the frame's pivots lie on x.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import radians
from typing import Literal

from figures.canvas import Drawing, Piece
from figures.joints import ground, revolute
from figures.label import number, point, symbol
from figures.lines import arc, axis, hidden, thin
from figures.members import link
from figures.picture import Picture, Words
from figures.placing import written
from figures.plane import Point, direction, left_of, unit

WIDTH = 572.0
CRANK_ANGLE = radians(58)
_A: Point = 0j
_B = 116 * unit(CRANK_ANGLE)
_C = complex(300, 218)
_D = complex(348, 0)


@dataclass(frozen=True, slots=True)
class Names:
    """The names in the figure; an empty one is left out, with its arc."""

    points: tuple[str, str, str, str] = ("A", "B", "C", "D")
    links: tuple[str, str, str] = ("1", "2", "3")
    angles: tuple[str, str, str] = ("α1", "α2", "α3")
    speed: str = "ω1"


def draw(
    prefix: str, words: Words, names: Names, sense: Literal["ccw", "cw"] = "ccw", diagonal: bool = False
) -> Picture:
    """Draw the linkage with the joint C on the left of the way from B to D.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        names: Letters of points, links, angles and of the speed of the crank.
        sense: In which sense the crank turns.
        diagonal: Whether the line BD is drawn, which tells the assemblies apart.
    """
    pieces: list[Piece] = [axis(_A - 40, _D + 86), *written(symbol("x", "thin"), _D + 82 + 8j, "middle")]
    pieces += [hidden(_B, _D)] if diagonal else []
    pieces += [*ground(_A), *ground(_D), link(_A, _B), link(_B, _C), link(_D, _C)]
    pieces += _angles(names)
    pieces += _speed(names.speed, sense) if names.speed else ()
    pieces += [mark for at in (_A, _B, _C, _D) for mark in revolute(at)]
    for name, at in zip(names.points, (_A - 20 + 10j, _B - 14 + 12j, _C + 16j, _D + 18 + 8j), strict=True):
        pieces += written(point(name), at, "middle") if name else ()
    middles = (left_of(_A, _B, 13, 0.62), left_of(_B, _C, 13), left_of(_D, _C, -14))
    for name, at in zip(names.links, middles, strict=True):
        pieces += written(number(name), at - 5j, "middle") if name else ()
    svg = Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH)
    return Picture(svg, words.table)


def _angles(names: Names) -> list[Piece]:
    """Arcs from the direction of x at the start of each vector."""
    pieces: list[Piece] = []
    for name, at, angle, radius in (
        (names.angles[0], _A, CRANK_ANGLE, 44.0),
        (names.angles[1], _B, direction(_B, _C), 92.0),
        (names.angles[2], _D, direction(_D, _C), 44.0),
    ):
        if not name:
            continue
        pieces += [thin(at, at + radius + 22)] if at is _B else []
        middle = at + (radius + 10) * unit(angle / 2) - (6j if angle < 1.5 else 2j)
        pieces += [*arc(at, radius, 0, angle), *written(symbol(name), middle)]
    return pieces


def _speed(name: str, sense: Literal["ccw", "cw"]) -> tuple[Piece, ...]:
    ends = (radians(74), radians(112)) if sense == "ccw" else (radians(112), radians(74))
    return (*arc(_A, 84, *ends, "vel"), *written(symbol(name, "vel"), _A + 99j - 14, "middle"))
