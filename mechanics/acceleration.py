"""Accelerations of two points of one rigid link: decomposition and centre of accelerations (domain VM-5).

Plane motion, a_B = a_A + epsilon k x AB - omega^2 AB. Metres, m/s^2, rad/s, rad/s^2, counter-clockwise positive.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2

from mechanics.checks import finite
from mechanics.drawing import Drawing, Line, Point, arrow, check
from mechanics.errors import SingularError


@dataclass(frozen=True, slots=True)
class Decomposition:
    """Translation with A, and the two parts of the rotation about A."""

    A: Point
    B: Point
    a_A: Point  # m/s^2
    normal: Point  # -omega^2 AB, from B towards A, m/s^2
    tangential: Point  # epsilon k x AB, perpendicular to AB, m/s^2
    a_B: Point  # m/s^2

    def drawing(self, scale: float) -> Drawing:
        """Draw a_A, the normal and the tangential part head to tail at B, and the sum; metres for 1 m/s^2."""
        carried = arrow("a_A at B", self.B, self.a_A, scale)
        inward = arrow("a_BA normal", carried.head, self.normal, scale)
        across = arrow("a_BA tangential", inward.head, self.tangential, scale)
        arrows = (arrow("a_A", self.A, self.a_A, scale), carried, inward, across, arrow("a_B", self.B, self.a_B, scale))
        return Drawing({"A": self.A, "B": self.B}, arrows, (Line("link", self.A, self.B),))


def decompose(A: Point, B: Point, a_A: Point, omega: float, epsilon: float) -> Decomposition:
    """Find the acceleration of B as that of A and the rotation about A.

    Args:
        A: Point whose acceleration is known, in metres.
        B: Another point of the link, in metres.
        a_A: Acceleration of A, in m/s^2.
        omega: Angular velocity of the link, in rad/s.
        epsilon: Angular acceleration of the link, in rad/s^2.

    Raises:
        ValueError: A value is not finite.
    """
    _check(A, a_A, omega, epsilon)
    check("m", B=B)
    dx, dy = B[0] - A[0], B[1] - A[1]
    normal, tangential = (-(omega**2) * dx, -(omega**2) * dy), (-epsilon * dy, epsilon * dx)
    a_B = (a_A[0] + normal[0] + tangential[0], a_A[1] + normal[1] + tangential[1])
    return Decomposition(A, B, a_A, normal, tangential, a_B)


@dataclass(frozen=True, slots=True)
class Centre:
    """The point of the link without acceleration."""

    Q: Point  # m
    angle: float  # mu, from the acceleration of any point P to the ray from P to Q, rad


def centre(A: Point, a_A: Point, omega: float, epsilon: float) -> Centre:
    """Find the centre of accelerations.

    Args:
        A: Point whose acceleration is known, in metres.
        a_A: Its acceleration, in m/s^2.
        omega: Angular velocity of the link, in rad/s.
        epsilon: Angular acceleration of the link, in rad/s^2.

    Raises:
        ValueError: A value is not finite.
        SingularError: The link is in pure translation: every point has the same acceleration.

    Source:
        Domain VM-5: Q = A + (omega^2 a_A + epsilon k x a_A)/(epsilon^2 + omega^4), tan mu = epsilon/omega^2.
    """
    _check(A, a_A, omega, epsilon)
    square = omega * omega
    divisor = epsilon * epsilon + square * square
    if not divisor:
        raise SingularError("omega = 0 and epsilon = 0: in pure translation there is no centre of accelerations")
    x = (square * a_A[0] - epsilon * a_A[1]) / divisor
    y = (epsilon * a_A[0] + square * a_A[1]) / divisor
    return Centre((A[0] + x, A[1] + y), atan2(epsilon, square))


def _check(A: Point, a_A: Point, omega: float, epsilon: float) -> None:
    check("m", A=A)
    check("m/s^2", a_A=a_A)
    finite("omega", omega, "rad/s")
    finite("epsilon", epsilon, "rad/s^2")
