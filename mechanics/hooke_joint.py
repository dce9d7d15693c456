"""Cardan (Hooke's, universal) joint and the double Cardan shaft (domain TR-7, TR-8).

gamma1 is counted from the position in which the cross arm of the driving fork lies in the plane of the two shafts,
gamma2 from the position it then has; both in the sense of rotation. beta is the angle between the shafts, in radians.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin

from mechanics.checks import finite
from mechanics.errors import SingularError
from mechanics.linkage import LinkageMotion, Singular

SQUARE = "shafts at a right angle"
Angle = tuple[float, float, float]  # value (rad), rate (rad/s), acceleration (rad/s^2)


@dataclass(frozen=True, slots=True)
class Range:
    """Least and greatest ratio of the angular velocities, output over input, over a turn."""

    least: float
    greatest: float

    @property
    def nonuniformity(self) -> float:
        """The spread of the ratio (its mean over a turn is 1)."""
        return self.greatest - self.least


def solve(shaft_angle_beta: float, gamma1: float, omega1: float = 0.0, epsilon1: float = 0.0) -> LinkageMotion:
    """Solve angle, angular velocity and acceleration of the driven shaft of a Cardan joint.

    Args:
        shaft_angle_beta: Angle between the shafts, in radians, less than a right angle either way.
        gamma1: Angle of the driving shaft, in radians, any finite value.
        omega1: Its angular velocity, in rad/s.
        epsilon1: Its angular acceleration, in rad/s^2.

    Returns:
        ``gamma2`` and its rates; gamma2 is continuous and turns with gamma1, never a quarter turn away. The measure
        is cos beta, 0 for shafts at a right angle.

    Raises:
        ValueError: A value is not finite.
        SingularError: The shafts are at a right angle or beyond: the joint cannot turn.

    Source:
        Domain TR-7: tan gamma2 = tan gamma1/cos beta and its derivatives.
    """
    c = _cosine("beta", shaft_angle_beta)
    gamma2, omega2, epsilon2 = _turned(c, _driven(gamma1, omega1, epsilon1))
    return LinkageMotion({"gamma2": gamma2}, {"gamma2": omega2}, {"gamma2": epsilon2}, Singular(c, SQUARE))


def double(
    beta1: float, beta2: float, gamma1: float, omega1: float = 0.0, epsilon1: float = 0.0, phase: float = 0.0
) -> LinkageMotion:
    """Solve the motion of two Cardan joints with an intermediate shaft, all shafts in one plane.

    Args:
        beta1: Angle between the driving and the intermediate shaft, in radians, below a right angle.
        beta2: Angle between the intermediate and the driven shaft, in radians, below a right angle.
        gamma1: Angle of the driving shaft, in radians.
        omega1: Its angular velocity, in rad/s.
        epsilon1: Its angular acceleration, in rad/s^2.
        phase: Angle of the second fork of the intermediate shaft from the plane of its first, in radians.

    Returns:
        ``gamma2`` of the intermediate and ``gamma3`` of the driven shaft with their rates; the measure is the smaller
        of the cosines of the shaft angles.

    Raises:
        ValueError: A value is not finite.
        SingularError: Two shafts are at a right angle or beyond.

    Source:
        Domain TR-8; forks in one plane: tan gamma3 = tan gamma1 cos beta2/cos beta1.
    """
    first, second = _cosine("beta1", beta1), _cosine("beta2", beta2)
    finite("phase", phase, "rad")
    middle = _turned(first, _driven(gamma1, omega1, epsilon1))
    lead = pi / 2 + phase  # the second joint counts from its own driving fork, here square to the first driven one
    last = _turned(second, (middle[0] + lead, *middle[1:]))
    last = (last[0] - lead, *last[1:])
    pos, vel, acc = ({"gamma2": one, "gamma3": other} for one, other in zip(middle, last, strict=True))
    return LinkageMotion(pos, vel, acc, Singular(min(first, second), SQUARE))


def ratio_range(beta: float) -> Range:
    """Give the range of omega2/omega1 over a turn of one Cardan joint: cos beta .. 1/cos beta (TR-7)."""
    c = _cosine("beta", beta)
    return Range(c, 1 / c)


def double_ratio_range(beta1: float, beta2: float, phase: float = 0.0) -> Range:
    """Give the range of omega3/omega1 over a turn of a double Cardan shaft; arguments and errors as for `double`.

    Source:
        Domain TR-8, for any phase: the two joints map the direction (cos gamma1, sin gamma1) linearly, and the
        extremes are the condition number of that 2x2 matrix and its inverse. Equal angles in phase give 1 exactly.
    """
    one, two = _cosine("beta1", beta1), _cosine("beta2", beta2)
    finite("phase", phase, "rad")
    s, c = sin(phase), cos(phase)
    above = hypot(s * (1 + one * two), c * (one + two))
    below = hypot(s * (1 - one * two), c * (one - two))
    greatest = (above + below) ** 2 / (4 * one * two)
    return Range(1 / greatest, greatest)


def _cosine(name: str, beta: float) -> float:
    finite(name, beta, "rad")
    if not abs(beta) < pi / 2:
        raise SingularError(f"{name} = {beta:g} rad: a Cardan joint turns only below pi/2 rad between its shafts")
    return cos(beta)


def _driven(gamma1: float, omega1: float, epsilon1: float) -> Angle:
    finite("gamma1", gamma1, "rad")
    finite("omega1", omega1, "rad/s")
    finite("epsilon1", epsilon1, "rad/s^2")
    return gamma1, omega1, epsilon1


def _turned(c: float, driving: Angle) -> Angle:
    """Pass an angle and its rates through a joint with c = cos beta."""
    gamma, omega, epsilon = driving
    sine, cosine = sin(gamma), cos(gamma)
    square = sine**2 + (c * cosine) ** 2  # 1 - sin^2 beta cos^2 gamma1 without its cancellation
    ratio = c / square
    ahead = atan2((1 - c) * sine * cosine, sine**2 + c * cosine**2)  # gamma2 - gamma1, below a quarter turn
    slope = -c * (1 - c**2) * 2 * sine * cosine / square**2
    return gamma + ahead, ratio * omega, ratio * epsilon + slope * omega**2
