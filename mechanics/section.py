"""Cross-sections in bending and torsion: areas, moments, moduli (SI; domain SM-7, SM-12).

Bending is about the horizontal axis through the centroid, which is the neutral axis; it halves the sections of this
module, those of `composed` it does not. The torsion constant stands where it is exact: for round sections it is the
polar moment, for the rectangle Saint-Venant's series.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cosh, exp, pi

from mechanics.checks import positive
from mechanics.composed import Composed

_ODD_FIFTHS = 31 / 32 * 1.0369277551433699  # 1 + 1/3^5 + 1/5^5 + ... = 31/32 zeta(5)
_TERMS = range(1, 26, 2)  # of series that fall at least like exp(-pi n)


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

    @property
    def torsion_constant(self) -> float:
        """Torsion constant J, m^4.

        Source:
            Saint-Venant: Timoshenko, Goodier, Theory of Elasticity, 3rd ed., 1970, section 109, eq. (163):
            J = a c^3 (1/3 - 64 c/(pi^5 a) sum of tanh(n pi a/(2 c))/n^5 over odd n), a the longer side, c the shorter;
            here 1 - tanh(x) = 2/(exp(2x) + 1) is summed.
        """
        long, short = max(self.b, self.h), min(self.b, self.h)
        missing = sum(2 / n**5 * (fall := exp(-min(n * pi * long / short, 700.0))) / (1 + fall) for n in _TERMS)
        return long * short * short * short * (1 / 3 - 64 / pi**5 * short / long * (_ODD_FIFTHS - missing))

    @property
    def torsion_modulus(self) -> float:
        """Torsion modulus T/tau_max, m^3, with tau_max at the middle of the longer side (eq. (161) there)."""
        long, short = max(self.b, self.h), min(self.b, self.h)
        lost = sum(1 / n**2 / cosh(min(n * pi * long / short / 2, 700.0)) for n in _TERMS)
        return self.torsion_constant / (short * (1 - 8 / pi**2 * lost))


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


Section = Rectangle | Circle | Ring | Composed
