"""Lines of the drawing language: axes, vectors, hatching, arcs with heads, leaders."""

from __future__ import annotations

from math import copysign

from figures.canvas import Arc, Circle, Line, Piece, Strokes
from figures.plane import Point, direction, unit

# length and half width
VECTOR_HEAD = (11.0, 3.6)
SMALL_HEAD = (9.0, 2.4)


def axis(*points: Point) -> Line:
    """A centre line."""
    return Line("f-axis", points)


def hidden(*points: Point) -> Line:
    """A hidden edge or a line of construction."""
    return Line("f-hid", points)


def thin(*points: Point) -> Line:
    """An extension line, a leader or a reference for an angle."""
    return Line("f-thin", points)


def head(tip: Point, angle: float, style: str, size: tuple[float, float] = VECTOR_HEAD) -> Line:
    """A filled head whose tip is exactly the given point, pointing along ``angle``."""
    length, half = size
    back, side = tip - length * unit(angle), half * 1j * unit(angle)
    return Line(f"h-{style}", (tip, back + side, back - side), closed=True)


def vector(start: Point, end: Point, style: str = "pos") -> tuple[Piece, ...]:
    """A vector with its head at ``end``; the shaft stops inside the head."""
    angle = direction(start, end)
    return (Line(f"f-{style}", (start, end - 7 * unit(angle))), head(end, angle, style))


def thin_arrow(start: Point, end: Point, style: str = "thin", line: str = "f-thin") -> tuple[Piece, ...]:
    """A thin arrow: an axis with a sense, one arrow of a distributed load."""
    angle = direction(start, end)
    return (Line(line, (start, end - 6 * unit(angle))), head(end, angle, style, SMALL_HEAD))


def hatch(start: Point, end: Point) -> Strokes:
    """Hatching of the frame along a line, on the right of the way from ``start`` to ``end``."""
    along = unit(direction(start, end))
    stroke = 8 * along * complex(-1, -1)
    count = int((abs(end - start) - 2) // 7)
    first = (abs(end - start) - 7 * (count - 1) + 8) / 2  # strokes lean back, so their foot is centred
    places = [start + along * (first + 7 * i) for i in range(count)]
    return Strokes("f-hatch", tuple((place, place + stroke) for place in places))


def arc(
    centre: Point, radius: float, start: float, end: float, style: str = "thin", height: float | None = None
) -> tuple[Piece, ...]:
    """An arc with a head at ``end``: the head is the sign convention.

    Args:
        centre: Where the angle stands.
        radius: Its radius, user units.
        start: Where it begins, radians.
        end: Where its tip lies; smaller than ``start`` for a clockwise arc.
        style: The style of line and head.
        height: The upright radius, for an arc seen from the side.
    """
    size = SMALL_HEAD if style == "thin" else VECTOR_HEAD
    curve = Arc(f"f-{style}", centre, radius, start, end, height)
    back = _stepped_back(curve, size[0])
    shaft = Arc(f"f-{style}", centre, radius, start, back + (end - back) / 4, height)
    return (shaft, head(curve.at(end), direction(curve.at(back), curve.at(end)), style, size))


def _stepped_back(curve: Arc, length: float) -> float:
    """The angle at which the curve is ``length`` away from its end, at most half of the arc back."""
    sense = copysign(1.0, curve.end - curve.start)
    whole = abs(curve.end - curve.start) / 2
    steps = (whole * i / 64 for i in range(1, 65))
    tip = curve.at(curve.end)
    far = (step for step in steps if abs(curve.at(curve.end - sense * step) - tip) >= length)
    return curve.end - sense * next(far, whole)


def leader(target: Point, shelf: tuple[Point, Point]) -> tuple[Piece, ...]:
    """A thin line from a dot at the object to the shelf under a text."""
    near, far = sorted(shelf, key=lambda end: abs(end - target))
    return (Circle("h-thin", target, 1.6), thin(target, near, far))
