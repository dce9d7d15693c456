"""Screw and nut (domain TR-2). The nut is kept from turning.

The angular velocity is positive along +x by the right-hand rule; a right-handed thread then drives the nut along -x.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Literal, get_args

from mechanics.checks import count, finite, positive

Hand = Literal["right", "left"]


@dataclass(frozen=True, slots=True)
class Screw:
    """A screw on a member of a train.

    Raises:
        ValueError: The pitch is not positive and finite, the starts no whole positive number, or the hand unknown.
    """

    on: str
    pitch: float  # m
    starts: int = 1
    hand: Hand = "right"

    def __post_init__(self) -> None:
        positive("pitch", self.pitch, "m")
        count("starts", self.starts)
        if self.hand not in get_args(Hand):
            raise ValueError(f"hand {self.hand!r} must be right or left")

    @property
    def lead(self) -> float:
        """Travel of the nut in a full turn, pitch times starts, in metres."""
        return self.pitch * self.starts

    def speed(self, omega: float) -> float:
        """Give the speed of the nut, -lead omega/2 pi for a right hand, in m/s."""
        along = self.lead * omega / (2 * pi)
        return -along if self.hand == "right" else along

    def travel(self, turn: float) -> float:
        """Give the travel of the nut for a turn in radians, in metres, with the sign of `speed`."""
        return self.speed(turn)

    def moment(self, thrust: float, efficiency: float = 1.0) -> float:
        """Find the moment that drives the screw against a thrust.

        Args:
            thrust: Axial force F against the motion, in newtons.
            efficiency: Part eta of the power that arrives, above 0 and at most 1.

        Returns:
            M = F p k/(2 pi eta), in N m.

        Raises:
            ValueError: The thrust is not finite or the efficiency not in (0, 1].

        Source:
            Domain TR-2: eta M omega = F v.
        """
        finite("thrust", thrust, "N")
        if not 0 < efficiency <= 1:
            raise ValueError(f"efficiency = {efficiency} must be above 0 and at most 1")
        return thrust * self.lead / (2 * pi * efficiency)
