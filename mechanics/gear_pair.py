"""A pair of spur gears of one module (domain TR-3): pitch circles that roll on one another.

Ratios u12 = omega1/omega2 are positive for the same sense of rotation (internal mesh).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import pi
from typing import Literal, get_args

from mechanics.checks import count, finite, positive

MeshType = Literal["external", "internal"]


@dataclass(frozen=True, slots=True)
class GearPair:
    """Teeth, module and kind of mesh; in an internal mesh wheel 2 is the ring.

    Raises:
        ValueError: Teeth are no whole positive numbers, the module is not positive and finite, the kind is unknown,
            or a ring is not larger than its pinion.
    """

    z1: int
    z2: int
    module: float  # m
    type: MeshType = "external"

    def __post_init__(self) -> None:
        count("z1", self.z1)
        count("z2", self.z2)
        positive("module", self.module, "m")
        if self.type not in get_args(MeshType):
            raise ValueError(f"mesh type {self.type!r} must be external or internal")
        if self.type == "internal" and self.z2 <= self.z1:
            raise ValueError(f"a ring of {self.z2} teeth cannot hold a pinion of {self.z1}")

    @property
    def ratio(self) -> Fraction:
        """u12 = -z2/z1 external, +z2/z1 internal."""
        size = Fraction(self.z2, self.z1)
        return size if self.type == "internal" else -size

    @property
    def radii(self) -> tuple[float, float]:
        """Pitch radii r1 and r2 = m z/2, in metres."""
        return self.module * self.z1 / 2, self.module * self.z2 / 2

    @property
    def centre_distance(self) -> float:
        """m (z1 + z2)/2 external, m (z2 - z1)/2 internal, in metres."""
        teeth = self.z2 - self.z1 if self.type == "internal" else self.z1 + self.z2
        return self.module * teeth / 2

    @property
    def pitch(self) -> float:
        """Circular pitch p = pi m, in metres."""
        return pi * self.module


def output_moment(moment: float, ratio: float, efficiency: float = 1.0, stages: int = 1) -> float:
    """Give the moment at the output of a train, M u eta^stages, in N m (TR-4).

    Raises:
        ValueError: A value is not finite, the efficiency not in (0, 1], or the number of stages not positive.
    """
    finite("moment", moment, "N m")
    finite("ratio", ratio, "")
    count("stages", stages)
    if not 0 < efficiency <= 1:
        raise ValueError(f"efficiency = {efficiency} must be above 0 and at most 1")
    return moment * ratio * efficiency**stages
