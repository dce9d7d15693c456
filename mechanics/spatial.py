"""Pairs in space: how far two bodies that were displaced from the drawn position violate them, and the slopes of that.

A body is displaced by a translation and then a rotation vector about the origin, six coordinates (m, rad). Each gap
of a pair is one of three kinds, written in axes fixed to the first body: a shift along an axis, a right angle between
axes of the two bodies, the advance of a screw.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin
from typing import Any, TypeAlias

from mechanics.vectors import Vector, cross, dot, times, unit

Rotation: TypeAlias = tuple[Vector, Vector, Vector]  # rows
Gap: TypeAlias = tuple[float, list[float]]  # value, slopes by translation and turn of one body, then of the other

SMALL = 1e-9  # rad, below which a rotation is taken as linear
STILL = (0.0,) * 6
TILT = (("e", "u"), ("f", "u"))  # right angles that keep the axes u of both bodies parallel
SQUARES = {"R": TILT, "P": (*TILT, ("e", "f")), "C": TILT, "H": TILT, "U": (("u", "v"),), "E": TILT, "L": (("u", "e"),)}
SHIFTS = {"R": "efu", "P": "ef", "C": "ef", "H": "ef", "U": "efu", "S": "efu", "E": "u", "L": "u", "B": "u"}


@dataclass(frozen=True, slots=True)
class SpatialPair:
    """A pair between two bodies by their numbers, its place and axes in the drawn position."""

    kind: str  # a key of `structure.CLASSES`
    one: int
    other: int
    place: Vector
    axes: dict[str, Vector]  # u along the axis, e and f across, v the second axis of a universal joint
    pitch: float = 0.0  # advance of a screw in one turn


def spatial_pair(
    kind: str,
    bodies: tuple[int, int],
    place: Vector,
    direction: Vector | None,
    second: Vector | None = None,
    pitch: float = 0.0,
) -> SpatialPair:
    """Build a pair with unit axes; a direction of None stands for +Z, a second axis of None for one across."""
    u = unit(direction or (0.0, 0.0, 1.0))
    _, farthest = min((abs(u[0]), (1.0, 0.0, 0.0)), (abs(u[1]), (0.0, 1.0, 0.0)), (abs(u[2]), (0.0, 0.0, 1.0)))
    e = unit(cross(u, farthest))
    axes = {"u": u, "e": e, "f": cross(u, e), "v": unit(second) if second else e}
    return SpatialPair(kind, *bodies, place, axes, pitch)


def closure(pairs: Sequence[SpatialPair], bodies: int, at: Sequence[float]) -> tuple[Any, Any]:
    """Give the gaps ``(m,)`` of all pairs and their slopes ``(m, 6 bodies)``; the frame is body 0 and has none.

    Args:
        pairs: The pairs.
        bodies: Number of moving bodies.
        at: Coordinates of the bodies 1, 2, …, six each.
    """
    import numpy as np

    twists = [STILL, *(tuple(map(float, at[6 * i : 6 * i + 6])) for i in range(bodies))]
    rotations = [_rotation(twist[3:]) for twist in twists]
    found = [(pair, gap) for pair in pairs for gap in _gaps(pair, twists, rotations)]
    slopes = np.zeros((len(found), 6 * bodies + 6))
    for row, (pair, (_, slope)) in enumerate(found):
        slopes[row, 6 * pair.one : 6 * pair.one + 6] += slope[:6]
        slopes[row, 6 * pair.other : 6 * pair.other + 6] += slope[6:]
    for body, twist in enumerate(twists):
        turn = slice(6 * body + 3, 6 * body + 6)
        slopes[:, turn] = slopes[:, turn] @ np.array(_turn_rates(twist[3:]))
    return np.array([gap for _, (gap, _) in found]), slopes[:, 6:]


def _gaps(pair: SpatialPair, twists: Sequence[Sequence[float]], rotations: Sequence[Rotation]) -> list[Gap]:
    ra, rb = rotations[pair.one], rotations[pair.other]
    here, there = ({name: times(r, axis) for name, axis in pair.axes.items()} for r in (ra, rb))
    arm, other_arm = times(ra, pair.place), times(rb, pair.place)
    reach = _sum(_sum(other_arm, twists[pair.other]), twists[pair.one], -1.0)  # from the first body's origin
    shift = _sum(reach, arm, -1.0)
    along = [_along(here[name], shift, reach, other_arm) for name in SHIFTS[pair.kind]]
    drawn = dot(pair.axes["u"], pair.axes["v"]) if pair.kind == "U" else 0.0
    square = [_square(here[a], there[b], drawn) for a, b in SQUARES.get(pair.kind, ())]
    if pair.kind == "H":
        advance = _along(here["u"], shift, reach, other_arm)
        square.append(_screwed(advance, here, there["e"], pair.pitch / (2 * pi)))
    return along + square


def _along(n: Vector, shift: Vector, reach: Vector, other_arm: Vector) -> Gap:
    """The shift of the other body along an axis n of the first."""
    one, other = cross(n, reach), cross(other_arm, n)
    return dot(n, shift), [-n[0], -n[1], -n[2], *one, *n, *other]


def _square(a: Vector, b: Vector, drawn: float) -> Gap:
    """The cosine between an axis of the first body and one of the other, less the drawn one."""
    turn = cross(a, b)
    return dot(a, b) - drawn, [0.0, 0.0, 0.0, *turn, 0.0, 0.0, 0.0, -turn[0], -turn[1], -turn[2]]


def _screwed(advance: Gap, here: dict[str, Vector], e: Vector, lead: float) -> Gap:
    """The advance along the axis less what the turn demands; the slope of the turn holds where the axes agree."""
    gap, slopes = advance
    turned = [lead * component for component in here["u"]]
    for i in range(3):
        slopes[3 + i] += turned[i]
        slopes[9 + i] -= turned[i]
    return gap - lead * atan2(dot(here["f"], e), dot(here["e"], e)), slopes


def _rotation(vector: Sequence[float]) -> Rotation:
    """Give the rotation matrix of a rotation vector (Rodrigues)."""
    angle = hypot(*vector)
    first, second = (sin(angle) / angle, (1 - cos(angle)) / angle**2) if angle > SMALL else (1.0, 0.5)
    return _series(vector, first, second)


def _turn_rates(vector: Sequence[float]) -> Rotation:
    """Give the matrix that makes an angular velocity of the rates of a rotation vector (left Jacobian of SO(3))."""
    angle = hypot(*vector)
    if angle < 1e-4:
        return _series(vector, 0.5, 1 / 6)
    return _series(vector, (1 - cos(angle)) / angle**2, (angle - sin(angle)) / angle**3)


def _series(vector: Sequence[float], first: float, second: float) -> Rotation:
    """I + first [v] + second [v]^2 with the cross-product matrix [v]."""
    x, y, z = vector
    return (
        (1 - second * (y * y + z * z), second * x * y - first * z, second * x * z + first * y),
        (second * x * y + first * z, 1 - second * (x * x + z * z), second * y * z - first * x),
        (second * x * z - first * y, second * y * z + first * x, 1 - second * (x * x + y * y)),
    )


def _sum(a: Vector, b: Sequence[float], sign: float = 1.0) -> Vector:
    return a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]
