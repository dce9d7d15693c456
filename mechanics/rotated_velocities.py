"""The method of rotated velocities: every velocity turned by +90 degrees and drawn at its point (domain VM-6).

In one scale k the ends of a link's rotated velocities make a figure parallel to the link, 1 - k omega times as large;
the lines through the rotated velocities meet in the instant centre. Metres, m/s; k in metres for 1 m/s.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from math import cos, sin

from mechanics import instant_centre
from mechanics.checks import finite, positive
from mechanics.drawing import Arrow, Drawing, Line, Point, check
from mechanics.errors import SingularError

PARALLEL = 1e-12  # sine between two lines below which they do not meet


@dataclass(frozen=True, slots=True)
class Rotated:
    """Points of a link, the ends of their rotated velocities, and the ratio of the two figures."""

    points: Mapping[str, Point]  # m
    ends: Mapping[str, Point]  # m
    ratio: float  # 1 - k omega; 0 where all ends fall together
    S: Point | None  # m; none in translation

    def drawing(self) -> Drawing:
        """Draw the rotated velocities and the sides of the figure of their ends."""
        arrows = tuple(Arrow(f"v_{name} rotated", point, self.ends[name]) for name, point in self.points.items())
        sides = tuple(Line(f"{a}{b}", self.ends[a], self.ends[b]) for a, b in pairwise(self.points))
        centre = {} if self.S is None else {"S": self.S}
        return Drawing({**self.points, **centre}, arrows, sides)


def rotate(A: Point, B: Point, v_A: Point, v_B: Point, scale: float) -> Rotated:
    """Turn the velocities of two points of a link and draw them.

    Args:
        A: A point of the link, in metres.
        B: Another, in metres.
        v_A: Velocity of A, in m/s.
        v_B: Velocity of B, in m/s.
        scale: k, metres drawn for 1 m/s, positive.

    Raises:
        ValueError: A value is not finite, the scale not positive, the points coincide, or the velocities would
            stretch the link.
    """
    positive("scale", scale, "m per m/s")
    turning = instant_centre.of_velocities(A, B, v_A, v_B)
    ends = {"A": _end(A, v_A, scale), "B": _end(B, v_B, scale)}
    return Rotated({"A": A, "B": B}, ends, 1 - scale * turning.omega, turning.S)


def by_parallel(A: Point, B: Point, v_A: Point, beta: float, scale: float) -> Point:
    """Find the velocity of B, whose direction is known: the end of its rotated velocity lies on the parallel to AB.

    Args:
        A: Point whose velocity is known, in metres.
        B: Another point of the link, in metres.
        v_A: Velocity of A, in m/s.
        beta: Direction of the velocity of B from +X, in radians.
        scale: k, metres drawn for 1 m/s, positive.

    Returns:
        The velocity of B, turned back, in m/s.

    Raises:
        ValueError: A value is not finite, or the scale not positive.
        SingularError: The rotated velocity of B lies along AB, parallel to the parallel.
    """
    positive("scale", scale, "m per m/s")
    check("m", A=A, B=B)
    check("m/s", v_A=v_A)
    finite("beta", beta, "rad")
    end_A, (ux, uy) = _end(A, v_A, scale), (-sin(beta), cos(beta))
    dx, dy = B[0] - A[0], B[1] - A[1]
    across = ux * dy - uy * dx
    if abs(across) <= PARALLEL * (abs(dx) + abs(dy)):
        raise SingularError(
            f"v_B at {beta:g} rad is perpendicular to AB: its rotated velocity does not cut the parallel"
        )
    reach = ((end_A[0] - B[0]) * dy - (end_A[1] - B[1]) * dx) / across
    return reach / scale * cos(beta), reach / scale * sin(beta)


def _end(point: Point, v: Point, scale: float) -> Point:
    return point[0] - scale * v[1], point[1] + scale * v[0]
