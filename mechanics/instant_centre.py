"""The instant centre of a rigid link: the point without velocity, about which all others turn (domain VM-2).

Metres, m/s, rad/s; omega counter-clockwise positive. In translation the centre is at infinity: there is none.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, hypot, sin

from mechanics import velocity
from mechanics.checks import finite
from mechanics.drawing import Drawing, Line, Point, arrow, check
from mechanics.errors import SingularError

PARALLEL = 1e-12  # sine between two normals below which they do not meet
STILL = 1e-12  # of the velocities over the distance: an omega below is none


@dataclass(frozen=True, slots=True)
class Turning:
    """A link that turns about S; without S it is in translation and all points move as A does."""

    A: Point
    B: Point
    v_A: Point  # m/s
    v_B: Point  # m/s
    omega: float  # rad/s
    S: Point | None  # m

    def velocity(self, C: Point) -> Point:
        """Give the velocity of any point of the link, in m/s."""
        if self.S is None:
            return self.v_A
        return -self.omega * (C[1] - self.S[1]), self.omega * (C[0] - self.S[0])

    def drawing(self, scale: float) -> Drawing:
        """Draw the velocities and the normals that meet in S; scale in metres for 1 m/s."""
        arrows = (arrow("v_A", self.A, self.v_A, scale), arrow("v_B", self.B, self.v_B, scale))
        points = {"A": self.A, "B": self.B}
        if self.S is None:
            return Drawing(points, arrows)
        normals = (Line("normal at A", self.A, self.S), Line("normal at B", self.B, self.S))
        return Drawing({**points, "S": self.S}, arrows, normals)


def of_velocities(A: Point, B: Point, v_A: Point, v_B: Point) -> Turning:
    """Find the instant centre from two velocities.

    Args:
        A: A point of the link, in metres.
        B: Another, in metres.
        v_A: Velocity of A, in m/s.
        v_B: Velocity of B, in m/s.

    Raises:
        ValueError: A value is not finite, the points coincide, or the velocities would stretch the link.

    Source:
        Domain VM-2: omega = [(B - A) x (v_B - v_A)]/|AB|^2, S = A + (-v_Ay, v_Ax)/omega.
    """
    omega = velocity.angular_velocity(A, B, v_A, v_B)
    apart = hypot(B[0] - A[0], B[1] - A[1])
    if abs(omega) * apart <= STILL * max(hypot(*v_A), hypot(*v_B)):
        return Turning(A, B, v_A, v_B, 0.0, None)
    return Turning(A, B, v_A, v_B, omega, (A[0] - v_A[1] / omega, A[1] + v_A[0] / omega))


def of_directions(A: Point, B: Point, alpha: float, beta: float) -> Point:
    """Find the instant centre where the normals to two known directions meet, in metres.

    Args:
        A: A point of the link, in metres.
        B: Another, in metres.
        alpha: Direction of the velocity of A from +X, in radians.
        beta: Direction of the velocity of B from +X, in radians.

    Raises:
        ValueError: A value is not finite.
        SingularError: The directions are parallel: the normals do not meet, or are one line.
    """
    check("m", A=A, B=B)
    finite("alpha", alpha, "rad")
    finite("beta", beta, "rad")
    across = sin(beta - alpha)
    if abs(across) < PARALLEL:
        raise SingularError("the two velocities are parallel: their normals do not meet in one point")
    way = ((B[0] - A[0]) * cos(beta) + (B[1] - A[1]) * sin(beta)) / across
    return A[0] - way * sin(alpha), A[1] + way * cos(alpha)
