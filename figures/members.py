"""Members and their supports: links, beams, shaft segments; pin, roller and fixed end."""

from __future__ import annotations

from math import pi

from figures.canvas import Circle, Line, Piece
from figures.joints import ground, ground_line
from figures.lines import hidden
from figures.plane import Point, unit

BEAM_DEPTH = 10.0
WALL = 96.0


def link(*points: Point) -> Line:
    """A link or an arm."""
    return Line("f-link", points)


def bar(start: Point, end: Point, depth: float = BEAM_DEPTH) -> Line:
    """A level member of a given depth about its axis: a beam, a segment of a shaft."""
    half = depth / 2 * 1j
    return Line("f-body", (start - half, end - half, end + half, start + half), closed=True)


def bore(start: Point, end: Point, diameter: float) -> tuple[Piece, ...]:
    """The hidden edges of a bore along a level axis."""
    half = diameter / 2 * 1j
    return (hidden(start + half, end + half), hidden(start - half, end - half))


def pin_support(at: Point) -> tuple[Piece, ...]:
    """A pin support under a point of a beam."""
    return (*ground(at), Circle("f-o", at, 4.0))


def roller_support(at: Point) -> tuple[Piece, ...]:
    """A roller under a point of a beam: a triangle on two circles, its base hatched."""
    triangle = Line("f-o", (at, at - 12 - 18j, at + 12 - 18j), closed=True)
    wheels = tuple(Circle("f-o", at + aside - 22.2j, 4.2) for aside in (-7, 7))
    base = at - 26.4j
    return (triangle, *wheels, *ground_line(base - 22, base + 22), Circle("f-o", at, 4.0))


def fixed_end(at: Point, outward: float) -> tuple[Piece, ...]:
    """A fixed end: a thick line across the axis, hatched outside.

    Args:
        at: The end of the axis.
        outward: The direction from the member into the wall, radians.
    """
    across = WALL / 2 * unit(outward + pi / 2)
    return ground_line(at - across, at + across)
