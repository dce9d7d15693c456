"""Gears in the kinematic scheme from the side: wheels are lines across level shafts."""

from __future__ import annotations

from figures.canvas import Line, Piece, Strokes
from figures.plane import Point

RIM = 9.0  # half the width of a wheel's face in the scheme
WEB = 22.0  # from the plane of an internal mesh to the web of its ring


def shaft(start: Point, end: Point) -> Line:
    """A level shaft."""
    return Line("f-link", (start, end))


def bearing(at: Point) -> Strokes:
    """A bearing: a short stroke on each side of the shaft."""
    return Strokes("f-thick", tuple((at + rise - 8, at + rise + 8) for rise in (6j, -6j)))


def wheel(at: Point, radius: float) -> tuple[Piece, ...]:
    """A wheel fixed to a level shaft, with its face at both ends."""
    top = radius * 1j
    faces = tuple((at + end - RIM, at + end + RIM) for end in (top, -top))
    return (Line("f-thick", (at - top, at + top)), Strokes("f-thick", faces), fastening(at))


def ring(at: Point, radius: float, side: float) -> tuple[Piece, ...]:
    """A wheel with internal teeth: its web stands aside of the plane of the mesh.

    Args:
        at: The point of the axis in the plane of the mesh.
        radius: Its pitch radius.
        side: +1 for a web (and shaft) on the right of the mesh, -1 on the left.
    """
    web, top = at + side * WEB, radius * 1j
    cup = (at - side * RIM + top, web + top, web - top, at - side * RIM - top)
    return (Line("f-thick", cup), fastening(web))


def fastening(at: Point) -> Strokes:
    """The small cross of a wheel fixed to its shaft."""
    return Strokes("f-hatch", ((at - 4 - 4j, at + 4 + 4j), (at - 4 + 4j, at + 4 - 4j)))
