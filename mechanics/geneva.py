"""Geneva drive (Maltese cross) with outer slots (domain TR-9).

The crank angle alpha1 is counted from the line of centres, the wheel angle phi from the same line in the sense in
which the wheel turns, opposite to the crank: both are zero where pin, crank pivot and wheel centre are in line.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, pi, sin, tan

from mechanics.checks import finite, positive
from mechanics.linkage import LinkageMotion, Singular, principal


@dataclass(frozen=True, slots=True)
class Geneva:
    """Dimensions of a drive and what follows from them.

    Raises:
        ValueError: Fewer than three slots, or a centre distance that is not positive and finite.
    """

    slots: int
    centre_distance: float  # a, m

    def __post_init__(self) -> None:
        if not isinstance(self.slots, int) or self.slots < 3:
            raise ValueError(f"slots = {self.slots} must be a whole number from 3")
        positive("centre_distance", self.centre_distance, "m")

    @property
    def lambda_(self) -> float:
        """Crank radius over centre distance, sin(pi/z)."""
        return sin(pi / self.slots)

    @property
    def crank(self) -> float:
        """Crank radius r1, m."""
        return self.centre_distance * self.lambda_

    @property
    def reach(self) -> float:
        """Radius r2 of the wheel at the mouths of its slots, m."""
        return self.centre_distance * cos(pi / self.slots)

    @property
    def engaged_within(self) -> float:
        """Crank angle theta0 on both sides of the line of centres within which the pin is in a slot, rad."""
        return pi / 2 - pi / self.slots

    @property
    def greatest_ratio(self) -> float:
        """Greatest omega2/omega1, on the line of centres."""
        return self.lambda_ / (1 - self.lambda_)

    @property
    def entry_acceleration(self) -> float:
        """Jump of |epsilon2|/omega1^2 where the pin enters or leaves, tan(pi/z)."""
        return tan(pi / self.slots)

    @property
    def motion_share(self) -> float:
        """Part of a turn of a crank with one pin in which the wheel moves, (z - 2)/(2z)."""
        return (self.slots - 2) / (2 * self.slots)

    @property
    def most_pins(self) -> int:
        """Greatest number of equally spaced pins, 2z/(z - 2) rounded down."""
        return 2 * self.slots // (self.slots - 2)


def solve(
    slots: int, centre_distance: float, alpha1: float, omega1: float = 0.0, epsilon1: float = 0.0
) -> LinkageMotion:
    """Solve angle, angular velocity and acceleration of the wheel; it rests while the pin is out of its slots.

    Args:
        slots: Number z of slots, from 3.
        centre_distance: Distance a of the pivots, in metres, positive.
        alpha1: Crank angle from the line of centres, in radians, any finite value.
        omega1: Crank angular velocity, in rad/s.
        epsilon1: Crank angular acceleration, in rad/s^2.

    Returns:
        ``phi`` of the slot that works in this turn, in [-pi/z, pi/z], and its rates. The measure is the ratio over
        its greatest value: 1 on the line of centres, 0 at entry and in the dwell.

    Raises:
        ValueError: Fewer than three slots, a distance that is not positive, or a value that is not finite.

    Source:
        Domain TR-9.
    """
    drive = Geneva(slots, centre_distance)
    finite("alpha1", alpha1, "rad")
    finite("omega1", omega1, "rad/s")
    finite("epsilon1", epsilon1, "rad/s^2")
    theta = principal(alpha1)
    if abs(theta) > drive.engaged_within:
        stop = pi / slots if theta > 0 else -pi / slots
        return LinkageMotion({"phi": stop}, {"phi": 0.0}, {"phi": 0.0}, Singular(0.0, "wheel at rest"))
    part, s, c = drive.lambda_, sin(theta), cos(theta)
    square = 1 - 2 * part * c + part**2
    ratio = part * (c - part) / square
    slope = -part * (1 - part**2) * s / square**2
    rates = {"phi": ratio * omega1}, {"phi": ratio * epsilon1 + slope * omega1**2}
    measure = max(0.0, min(1.0, ratio / drive.greatest_ratio))
    return LinkageMotion({"phi": atan2(part * s, 1 - part * c)}, *rates, Singular(measure, "wheel at rest"))
