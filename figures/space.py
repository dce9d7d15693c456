"""Bodies in space on the sheet: parallel projection, arcs in a plane, joint cylinders, frames.

Vectors are triples, z up. The eye looks from the front right and from above; depth is not shortened.
"""

from __future__ import annotations

from math import atan2, ceil, cos, hypot, pi, radians, sin

from figures.canvas import Line, Piece
from figures.lines import SMALL_HEAD, head, thin_arrow
from figures.plane import Point, direction

Vector = tuple[float, float, float]

AZIMUTH, ELEVATION = radians(25), radians(22)
X: Vector = (1.0, 0.0, 0.0)
Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)
EYE: Vector = (cos(ELEVATION) * cos(AZIMUTH), cos(ELEVATION) * sin(AZIMUTH), sin(ELEVATION))


def plus(start: Vector, *moves: tuple[float, Vector]) -> Vector:
    """A point moved by multiples of vectors."""
    x, y, z = start
    for share, (dx, dy, dz) in moves:
        x, y, z = x + share * dx, y + share * dy, z + share * dz
    return (x, y, z)


def dot(one: Vector, other: Vector) -> float:
    """The scalar product."""
    return sum(a * b for a, b in zip(one, other, strict=True))


def cross(one: Vector, other: Vector) -> Vector:
    """The vector product."""
    (a, b, c), (d, e, f) = one, other
    return (b * f - c * e, c * d - a * f, a * e - b * d)


def seen(at: Vector) -> Point:
    """Where a point in space stands on the sheet (orthographic projection along the eye's direction)."""
    x, y, z = at
    across = -x * sin(AZIMUTH) + y * cos(AZIMUTH)
    depth = x * cos(AZIMUTH) + y * sin(AZIMUTH)
    return complex(across, z * cos(ELEVATION) - depth * sin(ELEVATION))


def turn(first: Vector, second: Vector, angle: float) -> Vector:
    """The direction at an angle (radians) from ``first`` towards ``second``, two unit vectors at a right angle."""
    return plus((0.0, 0.0, 0.0), (cos(angle), first), (sin(angle), second))


def spatial_arc(centre: Vector, radius: float, first: Vector, second: Vector, end: float) -> tuple[Piece, ...]:
    """A thin arc with a head in the plane of two unit vectors, from ``first`` through an angle towards ``second``."""
    count = max(8, ceil(abs(end) * radius / 6))
    points = [seen(plus(centre, (radius, turn(first, second, end * i / count)))) for i in range(count + 1)]
    near = next((p for p in reversed(points) if abs(p - points[-1]) >= SMALL_HEAD[0]), points[0])
    return (Line("f-thin", tuple(points[:-1])), head(points[-1], direction(near, points[-1]), "thin", SMALL_HEAD))


def arrow(start: Vector, along: Vector, length: float) -> tuple[Piece, ...]:
    """An axis with its sense."""
    return thin_arrow(seen(start), seen(plus(start, (length, along))))


def cylinder(centre: Vector, along: Vector, length: float, radius: float) -> tuple[Piece, ...]:
    """A revolute joint: a cylinder about its axis, the end turned to the eye drawn last."""
    side = Z if hypot(along[0], along[1]) > 0.5 else X
    other = cross(along, side)
    return _bar(centre, along, length, [(radius, turn(side, other, 2 * pi * i / 32)) for i in range(32)])


def sleeve(centre: Vector, along: Vector, level: Vector, length: float, width: float) -> tuple[Piece, ...]:
    """A prismatic joint: a square block along its guide, one edge level, the end turned to the eye drawn last."""
    corners = (turn(level, cross(along, level), pi / 4 + pi / 2 * i) for i in range(4))
    return _bar(centre, along, length, [(width / 2**0.5, corner) for corner in corners])


def _bar(centre: Vector, along: Vector, length: float, section: list[tuple[float, Vector]]) -> tuple[Piece, ...]:
    rim = [plus((0.0, 0.0, 0.0), point) for point in section]
    half = length / 2 if dot(along, EYE) > 0 else -length / 2
    near, far = plus(centre, (half, along)), plus(centre, (-half, along))
    cap = [seen(plus(near, (1, point))) for point in rim]
    back = [seen(plus(far, (1, point))) for point in rim]
    return (Line("f-body", _hull(cap + back), closed=True), Line("f-o", tuple(cap), closed=True))


def _hull(points: list[Point]) -> tuple[Point, ...]:
    """The convex outline of points, counter-clockwise (Andrew's monotone chain)."""
    ordered = sorted(points, key=lambda p: (round(p.real, 6), round(p.imag, 6)))
    return tuple(_chain(ordered)[:-1] + _chain(ordered[::-1])[:-1])


def _chain(points: list[Point]) -> list[Point]:
    chain: list[Point] = []
    for point in points:
        while len(chain) > 1 and _turns_right(chain[-2], chain[-1], point):
            chain.pop()
        chain.append(point)
    return chain


def _turns_right(first: Point, second: Point, third: Point) -> bool:
    way = (second - first).conjugate() * (third - second)
    return atan2(way.imag, way.real) <= 1e-9
