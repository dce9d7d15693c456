"""Section properties against quadrature over the width, and the published torsion example."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import pi, sqrt

import numpy as np
import pytest

from mechanics.section import Circle, Rectangle, Ring

Width = Callable[[float], float]


def chord(d: float, y: float) -> float:
    return 2 * sqrt(max(d * d / 4 - y * y, 0.0))


def integrate(f: Callable[[float], float], a: float, b: float) -> float:
    """Gauss-Legendre after y = a + (b - a) sin^2 t, which takes the root off a round edge."""
    nodes, weights = np.polynomial.legendre.leggauss(60)
    t = (nodes + 1) * pi / 4
    y = a + (b - a) * np.sin(t) ** 2
    return float(sum(w * f(float(p)) * (b - a) * np.sin(2 * q) * pi / 4 for w, p, q in zip(weights, y, t, strict=True)))


CASES: list[tuple[Rectangle | Circle | Ring, Width, list[float]]] = [
    (Rectangle(0.06, 0.12), lambda y: 0.06, [0.0, 0.06]),
    (Circle(0.05), lambda y: chord(0.05, y), [0.0, 0.025]),
    (Ring(0.08, 0.05), lambda y: chord(0.08, y) - chord(0.05, y), [0.0, 0.025, 0.04]),
    (Ring(0.08), lambda y: chord(0.08, y), [0.0, 0.04]),
]


@pytest.mark.parametrize(("section", "width", "heights"), CASES)
def test_bending_properties_are_integrals_of_the_width(
    section: Rectangle | Circle | Ring, width: Width, heights: list[float]
) -> None:
    def over_half(f: Callable[[float], float]) -> float:
        return sum(integrate(f, a, b) for a, b in pairwise(heights))

    assert section.area == pytest.approx(2 * over_half(width), rel=1e-10)
    assert section.first_moment == pytest.approx(over_half(lambda y: y * width(y)), rel=1e-10)
    assert section.second_moment == pytest.approx(2 * over_half(lambda y: y * y * width(y)), rel=1e-10)
    assert section.section_modulus == pytest.approx(section.second_moment / heights[-1], rel=1e-12)
    assert section.neutral_width == pytest.approx(width(0.0), rel=1e-12)


@pytest.mark.parametrize(("section", "radii"), [(Circle(0.05), (0.0, 0.025)), (Ring(0.08, 0.05), (0.025, 0.04))])
def test_torsion_properties_are_integrals_over_the_radius(section: Circle | Ring, radii: tuple[float, float]) -> None:
    polar = integrate(lambda r: 2 * pi * r**3, *radii)
    assert section.torsion_constant == pytest.approx(polar, rel=1e-12)
    assert section.torsion_modulus == pytest.approx(polar / radii[1], rel=1e-12)


def test_sm_7_polar_properties() -> None:
    assert Circle(0.05).torsion_constant == pytest.approx(6.135923152e-07, rel=1e-9)
    assert Circle(0.05).torsion_modulus == pytest.approx(2.454369261e-05, rel=1e-9)
    assert Ring(0.05, 0.03).torsion_constant == pytest.approx(5.340707511e-07, rel=1e-9)


def test_sm_12_section_of_sixty_by_one_hundred_and_twenty() -> None:
    section = Rectangle(0.06, 0.12)
    assert (section.second_moment, section.section_modulus) == pytest.approx((8.64e-06, 0.000144), rel=1e-12)
    assert Circle(0.07985890849).section_modulus == pytest.approx(5e-05, rel=1e-9)


def test_thin_ring_keeps_its_digits() -> None:
    wall = 1e-9
    ring = Ring(1.0, 1.0 - 2 * wall)
    assert ring.torsion_constant == pytest.approx(2 * pi * 0.5**3 * wall, rel=1e-7)
