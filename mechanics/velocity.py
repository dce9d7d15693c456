"""Velocities of two points of one rigid link: the projection method and the decomposition (domain VM-1, VM-3).

Plane motion, v_B = v_A + omega k x AB with omega counter-clockwise positive. Metres, m/s, rad/s.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, hypot, sin

from mechanics.checks import finite
from mechanics.drawing import Drawing, Line, Point, arrow, check
from mechanics.errors import SingularError

ACROSS = 1e-12  # cosine between a direction and the link below which they are perpendicular
RIGID = 1e-6  # of the velocities: two projections that differ by less come from rounded numbers


@dataclass(frozen=True, slots=True)
class Projection:
    """What the projection method gives for the point B."""

    A: Point
    B: Point
    v_A: Point
    common: float  # projection of both velocities on AB, m/s
    v_B: Point  # m/s
    speed: float  # of B, positive along the given direction, m/s
    omega: float  # of the link, rad/s

    def drawing(self, scale: float) -> Drawing:
        """Draw both velocities with their projections on AB; scale in metres for 1 m/s."""
        (ax, ay), (bx, by) = self.A, self.B
        length = hypot(bx - ax, by - ay)
        along = (self.common * (bx - ax) / length, self.common * (by - ay) / length)
        at_A, at_B = arrow("v_A", self.A, self.v_A, scale), arrow("v_B", self.B, self.v_B, scale)
        on_A, on_B = arrow("v_A on AB", self.A, along, scale), arrow("v_B on AB", self.B, along, scale)
        normals = (Line("normal at A", at_A.head, on_A.head), Line("normal at B", at_B.head, on_B.head))
        return Drawing({"A": self.A, "B": self.B}, (at_A, at_B, on_A, on_B), normals)


def project(A: Point, B: Point, v_A: Point, beta: float) -> Projection:
    """Find the velocity of B, whose direction is known, from that of A.

    Args:
        A: Point whose velocity is known, in metres.
        B: Another point of the link, in metres.
        v_A: Velocity of A, in m/s.
        beta: Direction of the velocity of B from +X, in radians.

    Raises:
        ValueError: A value is not finite, or the points coincide.
        SingularError: The direction is perpendicular to AB: the method gives nothing.

    Source:
        Domain VM-1: v_A . u = v_B . u, u = (B - A)/|AB|.
    """
    dx, dy, length = _link(A, B)
    check("m/s", v_A=v_A)
    finite("beta", beta, "rad")
    c, s = cos(beta), sin(beta)
    share = (c * dx + s * dy) / length
    if abs(share) < ACROSS:
        raise SingularError(f"the direction {beta:g} rad of v_B is perpendicular to AB: its projection is zero")
    common = (v_A[0] * dx + v_A[1] * dy) / length
    speed = common / share
    v_B = (speed * c, speed * s)
    return Projection(A, B, v_A, common, v_B, speed, _turning(dx, dy, v_A, v_B))


@dataclass(frozen=True, slots=True)
class Decomposition:
    """Translation with A and rotation about A."""

    A: Point
    B: Point
    v_A: Point  # m/s
    v_BA: Point  # of B about A, perpendicular to AB, m/s
    v_B: Point  # m/s

    def drawing(self, scale: float) -> Drawing:
        """Draw v_A at both points, v_BA from its head at B, and the sum; scale in metres for 1 m/s."""
        carried = arrow("v_A at B", self.B, self.v_A, scale)
        about = arrow("v_BA", carried.head, self.v_BA, scale)
        arrows = (arrow("v_A", self.A, self.v_A, scale), carried, about, arrow("v_B", self.B, self.v_B, scale))
        return Drawing({"A": self.A, "B": self.B}, arrows, (Line("link", self.A, self.B),))


def decompose(A: Point, B: Point, v_A: Point, omega: float) -> Decomposition:
    """Find the velocity of B as that of A and the rotation about A.

    Args:
        A: Point whose velocity is known, in metres.
        B: Another point of the link, in metres.
        v_A: Velocity of A, in m/s.
        omega: Angular velocity of the link, in rad/s.

    Raises:
        ValueError: A value is not finite.

    Source:
        Domain VM-3: v_B = v_A + v_BA, v_BA = omega k x AB.
    """
    check("m", A=A, B=B)
    check("m/s", v_A=v_A)
    finite("omega", omega, "rad/s")
    v_BA = (-omega * (B[1] - A[1]), omega * (B[0] - A[0]))
    return Decomposition(A, B, v_A, v_BA, (v_A[0] + v_BA[0], v_A[1] + v_BA[1]))


def angular_velocity(A: Point, B: Point, v_A: Point, v_B: Point) -> float:
    """Find the angular velocity of a link in rad/s from the velocities (m/s) of two of its points (m).

    Raises:
        ValueError: A value is not finite, the points coincide, or the velocities would stretch the link.

    Source:
        Domain VM-2: omega = [(B - A) x (v_B - v_A)]/|AB|^2.
    """
    dx, dy, length = _link(A, B)
    check("m/s", v_A=v_A, v_B=v_B)
    stretch = ((v_B[0] - v_A[0]) * dx + (v_B[1] - v_A[1]) * dy) / length
    if abs(stretch) > RIGID * (hypot(*v_A) + hypot(*v_B)):
        raise ValueError(
            f"the projections of v_A and v_B on AB differ by {stretch:g} m/s: a rigid link does not stretch"
        )
    return _turning(dx, dy, v_A, v_B)


def _link(A: Point, B: Point) -> tuple[float, float, float]:
    check("m", A=A, B=B)
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    if not length:
        raise ValueError(f"A and B = {A} m are one point: they give no direction")
    return dx, dy, length


def _turning(dx: float, dy: float, v_A: Point, v_B: Point) -> float:
    return (dx * (v_B[1] - v_A[1]) - dy * (v_B[0] - v_A[0])) / (dx * dx + dy * dy)
