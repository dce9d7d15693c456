"""The state of stress in a point: on any plane, principal, Mohr's circles (domain SM-15).

Stresses in pascals, tension positive. On a plane with the outer normal n the traction is p = S n; sigma_n > 0 pulls.
In the plane x, y: tau_xy > 0 turns the face x towards +y, and the angle of a principal direction is counter-clockwise
from +x. On Mohr's circle a plane turned by alpha is turned by 2 alpha.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin, sqrt

from mechanics import tensor
from mechanics.checks import finite
from mechanics.tensor import Matrix
from mechanics.vectors import Vector


@dataclass(frozen=True, slots=True)
class Traction:
    """What acts on one plane."""

    p: Vector  # on x, y, z, Pa
    normal: float  # sigma_n, Pa
    shear: float  # magnitude tau_n, Pa


@dataclass(frozen=True, slots=True)
class StressState:
    """A symmetric stress tensor, (3, 3), rows and columns x, y, z.

    Raises:
        ValueError: It is not of three rows of three, not finite, or not symmetric.
    """

    components: Matrix  # Pa

    def __post_init__(self) -> None:
        object.__setattr__(self, "components", tensor.symmetric(self.components, "stress", "Pa"))

    @property
    def invariants(self) -> Vector:
        """I1 (Pa), I2 (Pa^2), I3 (Pa^3): the coefficients of s^3 - I1 s^2 + I2 s - I3 = 0."""
        return tensor.invariants(self.components)

    @property
    def principal(self) -> Vector:
        """Principal stresses, largest first, Pa."""
        return tensor.principal(self.components)[0]

    @property
    def directions(self) -> Matrix:
        """Principal directions as rows, in the order of the stresses; a right-handed set."""
        return tensor.principal(self.components)[1]

    @property
    def tau_max(self) -> float:
        """Largest shear stress of all planes, (s1 - s3)/2, Pa."""
        largest, _, smallest = self.principal
        return (largest - smallest) / 2

    @property
    def von_mises(self) -> float:
        """Equivalent stress of Huber, von Mises and Hencky, Pa."""
        s1, s2, s3 = self.principal
        return sqrt(((s1 - s2) ** 2 + (s2 - s3) ** 2 + (s3 - s1) ** 2) / 2)

    @property
    def tresca(self) -> float:
        """Equivalent stress of Tresca, s1 - s3, Pa."""
        return 2 * self.tau_max

    @property
    def circles(self) -> tuple[tuple[float, float], ...]:
        """Mohr's three circles as centre and radius (Pa): the outer one, that of s1 and s2, that of s2 and s3."""
        s1, s2, s3 = self.principal
        return tuple(((high + low) / 2, (high - low) / 2) for high, low in ((s1, s3), (s1, s2), (s2, s3)))

    def on(self, normal: Sequence[float]) -> Traction:
        """Return the traction on a plane with an outer normal of any length.

        Raises:
            ValueError: The normal is not of three components, not finite, or zero.
        """
        n = tensor.unit(normal)
        x, y, z = (tensor.dot(row, n) for row in self.components)
        along = tensor.dot((x, y, z), n)
        across = hypot(x - along * n[0], y - along * n[1], z - along * n[2])
        return Traction((x, y, z), along, across)


@dataclass(frozen=True, slots=True)
class PlaneStress:
    """A state of stress in the plane x, y."""

    x: float  # sigma_x, Pa
    y: float  # sigma_y, Pa
    xy: float  # tau_xy, Pa

    def __post_init__(self) -> None:
        for name, value in (("sigma_x", self.x), ("sigma_y", self.y), ("tau_xy", self.xy)):
            finite(name, value, "Pa")

    @property
    def centre(self) -> float:
        """Centre of Mohr's circle, Pa."""
        return (self.x + self.y) / 2

    @property
    def radius(self) -> float:
        """Radius of Mohr's circle, the largest shear stress of planes normal to x, y, Pa."""
        return hypot((self.x - self.y) / 2, self.xy)

    @property
    def principal(self) -> tuple[float, float]:
        """Principal stresses in the plane, larger first, Pa."""
        return self.centre + self.radius, self.centre - self.radius

    @property
    def angle(self) -> float:
        """Direction of the larger principal stress from +x, rad, in (-pi/2, pi/2]: tan 2a = 2 tau/(sx - sy)."""
        found = atan2(2 * self.xy, self.x - self.y) / 2
        return found if found > -pi / 2 else pi / 2

    def turned(self, angle: float) -> PlaneStress:
        """Return the components on axes turned counter-clockwise by an angle (rad)."""
        half, c, s = (self.x - self.y) / 2, cos(2 * angle), sin(2 * angle)
        along, across = half * c + self.xy * s, self.xy * c - half * s
        return PlaneStress(self.centre + along, self.centre - along, across)
