"""Rack and pinion (domain TR-1): the pitch circle rolls on the rack, so a point of the rack moves by radius times turn.

Turns and angular velocities counter-clockwise positive; travel along the rack positive for a positive turn.
"""

from __future__ import annotations

from dataclasses import dataclass

from mechanics.checks import count, positive


@dataclass(frozen=True, slots=True)
class Rack:
    """A rack driven by a pinion on a member of a train.

    Raises:
        ValueError: The teeth are no whole positive number, or the module is not positive and finite.
    """

    pinion_on: str
    pinion_z: int
    module_mm: float  # mm

    def __post_init__(self) -> None:
        count("pinion_z", self.pinion_z)
        positive("module_mm", self.module_mm, "mm")

    @property
    def radius(self) -> float:
        """Pitch radius r1 = m z1/2, in metres."""
        return self.module_mm * self.pinion_z / 2000

    def speed(self, omega: float) -> float:
        """Give v2 = r1 omega1, in m/s."""
        return self.radius * omega

    def travel(self, turn: float) -> float:
        """Give s2 = r1 phi, in metres, for a turn in radians."""
        return self.radius * turn
