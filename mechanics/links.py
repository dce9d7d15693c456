"""Links of a serial chain: what they weigh, and how the motion of one gives that of the next (domain DH-8).

The step knows no axes: it holds in base axes as in those of a link, as long as all its vectors are in the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.checks import finite
from mechanics.dh import Convention, JointType
from mechanics.vectors import ZERO, Matrix, Vector, add, check_vector, cross, scaled

ROUNDING = 1e-9  # how far an inertia tensor may be from symmetric and from positive, of its largest entry


@dataclass(frozen=True, slots=True)
class LinkMass:
    """Mass, centre and inertia of one link, constant in its own frame.

    Raises:
        ValueError: The mass is negative, a value not finite, or the tensor not symmetric or with a negative moment.
    """

    mass: float  # kg
    centre: Vector  # centre of mass in the frame of the link, m
    inertia: Matrix  # about the centre of mass in link axes, products with minus, kg m^2, (3, 3)

    def __post_init__(self) -> None:
        if not 0 <= self.mass < float("inf"):
            raise ValueError(f"mass = {self.mass} kg must be finite and not negative")
        check_vector("centre of mass", self.centre, "m")
        check_inertia(self.inertia)


def check_inertia(tensor: Sequence[Sequence[float]]) -> None:
    """Refuse an inertia tensor that is not a symmetric 3 x 3 matrix without negative moments.

    Raises:
        ValueError: Names what is wrong.
    """
    if len(tensor) != 3 or any(len(row) != 3 for row in tensor):
        raise ValueError("an inertia tensor has 3 rows of 3 values")
    for row in tensor:
        for value in row:
            finite("inertia", value, "kg m^2")
    size = max(abs(value) for row in tensor for value in row) or 1.0
    (a, f, e), (g, b, d), (h, i, c) = ([value / size for value in row] for row in tensor)
    if max(abs(f - g), abs(e - h), abs(d - i)) > ROUNDING:
        raise ValueError("an inertia tensor is symmetric")
    minors = b * c - d * d, a * c - e * e, a * b - f * f
    determinant = a * minors[0] - f * (f * c - d * e) + e * (f * d - b * e)
    if min(a, b, c) < 0 or min(*minors, determinant) < -ROUNDING:
        raise ValueError("an inertia tensor has no negative moment of inertia about any axis")


@dataclass(frozen=True, slots=True)
class LinkMotion:
    """Motion of a link and of the origin of its frame."""

    omega: Vector  # rad/s
    epsilon: Vector  # rad/s^2
    v: Vector  # m/s
    a: Vector  # m/s^2

    def point(self, arm: Vector) -> tuple[Vector, Vector]:
        """Velocity and acceleration of the point of the link at an arm (m) from the origin."""
        return add(self.v, cross(self.omega, arm)), add(self.a, _carried(self.omega, self.epsilon, arm))


REST = LinkMotion(ZERO, ZERO, ZERO, ZERO)


def next_motion(
    before: LinkMotion, joint: JointType, convention: Convention, shift: Vector, rate: Vector, acceleration: Vector
) -> LinkMotion:
    """Step from one link to the next.

    Args:
        before: Motion of the link before.
        joint: "R" or "P".
        convention: Where the shift sits: in the next link (standard) or in the link before (modified).
        shift: From the origin of the link before to that of the next, in metres.
        rate: Joint axis times the rate of its variable.
        acceleration: Joint axis times the second rate of its variable.

    Source:
        Domain DH-8; behind a slide, 2 omega x rate is the Coriolis acceleration.
    """
    omega, epsilon = before.omega, before.epsilon
    if joint == "R":
        omega, epsilon = add(omega, rate), add(epsilon, add(acceleration, cross(omega, rate)))
    v, a = before.v, before.a
    if joint == "P":
        v, a = add(v, rate), add(a, add(acceleration, scaled(2, cross(omega, rate))))
    held = (omega, epsilon) if convention == "standard" else (before.omega, before.epsilon)
    return LinkMotion(omega, epsilon, add(v, cross(held[0], shift)), add(a, _carried(*held, shift)))


def _carried(omega: Vector, epsilon: Vector, arm: Vector) -> Vector:
    return add(cross(epsilon, arm), cross(omega, cross(omega, arm)))


@dataclass(frozen=True, slots=True)
class Drives:
    """What each joint has to give, and the whole action of each link on the next."""

    tau: tuple[float, ...]  # of each drive, N m (turn) or N (slide)
    forces: tuple[Vector, ...]  # of link i - 1 on link i, N
    moments: tuple[Vector, ...]  # of link i - 1 on link i about a point of the axis of joint i, N m


@dataclass(frozen=True, slots=True)
class ToolLoad:
    """What the tool exerts on its surroundings, at the origin of the last frame.

    Raises:
        ValueError: A vector has another length than 3, or a value is not finite.
    """

    force: Vector = ZERO  # N
    moment: Vector = ZERO  # N m

    def __post_init__(self) -> None:
        check_vector("tool force", self.force, "N")
        check_vector("tool moment", self.moment, "N m")


FREE = ToolLoad()
