"""Cross-sections in bending and torsion: areas, moments, moduli (SI).

Bending is about the horizontal axis through the centre; the neutral axis is that axis, since every section here is
symmetric about it. The polar quantities exist for round sections only: there the torsion constant is the polar moment.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from mechanics.checks import positive


@dataclass(frozen=True, slots=True)
class Rectangle:
    """A rectangle standing on its width."""

    b: float  # width, m
    h: float  # height, m

    def __post_init__(self) -> None:
        positive("width b", self.b, "m")
        positive("height h", self.h, "m")

    @property
    def area(self) -> float:
        """Area A = b h, m^2."""
        return self.b * self.h

    @property
    def second_moment(self) -> float:
        """Second moment of area I = b h^3/12, m^4 (SM-12)."""
        return self.b * self.h * self.h * self.h / 12

    @property
    def section_modulus(self) -> float:
        """Section modulus W = b h^2/6, m^3 (SM-12)."""
        return self.b * self.h * self.h / 6

    @property
    def first_moment(self) -> float:
        """First moment of the half above the neutral axis, Q = b h^2/8, m^3."""
        return self.b * self.h * self.h / 8

    @property
    def neutral_width(self) -> float:
        """Width of the material at the neutral axis, m."""
        return self.b


@dataclass(frozen=True, slots=True)
class Ring:
    """A round tube; a bore of zero is a full circle."""

    D: float  # outer diameter, m
    d: float = 0.0  # bore, m

    def __post_init__(self) -> None:
        positive("outer diameter D", self.D, "m")
        if not 0 <= self.d < self.D:
            raise ValueError(f"bore d = {self.d} m must be at least 0 and below the outer diameter D = {self.D} m")

    @property
    def area(self) -> float:
        """Area A = pi (D^2 - d^2)/4, m^2."""
        return pi * (self.D - self.d) * (self.D + self.d) / 4

    @property
    def torsion_constant(self) -> float:
        """Polar second moment J_p = pi (D^4 - d^4)/32, m^4 (SM-7)."""
        D, d = self.D, self.d
        return pi * (D - d) * (D + d) * (D * D + d * d) / 32

    @property
    def torsion_modulus(self) -> float:
        """Torsion modulus W_p = 2 J_p/D, m^3 (SM-7)."""
        return 2 * self.torsion_constant / self.D

    @property
    def second_moment(self) -> float:
        """Second moment of area I = J_p/2, m^4."""
        return self.torsion_constant / 2

    @property
    def section_modulus(self) -> float:
        """Section modulus W = 2 I/D, m^3."""
        return self.torsion_constant / self.D

    @property
    def first_moment(self) -> float:
        """First moment of the half above the neutral axis, Q = (D^3 - d^3)/12, m^3."""
        D, d = self.D, self.d
        return (D - d) * (D * D + D * d + d * d) / 12

    @property
    def neutral_width(self) -> float:
        """Width of the material at the neutral axis, both walls, m."""
        return self.D - self.d


@dataclass(frozen=True, slots=True)
class Circle:
    """A full circle."""

    d: float  # diameter, m

    def __post_init__(self) -> None:
        positive("diameter d", self.d, "m")

    @property
    def area(self) -> float:
        """Area A = pi d^2/4, m^2."""
        return pi * self.d * self.d / 4

    @property
    def torsion_constant(self) -> float:
        """Polar second moment J_p = pi d^4/32, m^4 (SM-7)."""
        return pi * self.d * self.d * self.d * self.d / 32

    @property
    def torsion_modulus(self) -> float:
        """Torsion modulus W_p = pi d^3/16, m^3 (SM-7)."""
        return pi * self.d * self.d * self.d / 16

    @property
    def second_moment(self) -> float:
        """Second moment of area I = pi d^4/64, m^4 (SM-12)."""
        return pi * self.d * self.d * self.d * self.d / 64

    @property
    def section_modulus(self) -> float:
        """Section modulus W = pi d^3/32, m^3 (SM-12)."""
        return pi * self.d * self.d * self.d / 32

    @property
    def first_moment(self) -> float:
        """First moment of the half above the neutral axis, Q = d^3/12, m^3."""
        return self.d * self.d * self.d / 12

    @property
    def neutral_width(self) -> float:
        """Width of the material at the neutral axis, m."""
        return self.d


Section = Rectangle | Circle | Ring
