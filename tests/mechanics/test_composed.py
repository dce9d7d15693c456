"""Composed sections against quadrature over their width, and against the plain sections they may amount to."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics import frame
from mechanics.beam import Beam, Force, Support, solve
from mechanics.composed import Block, Composed, Disc, Part, box, i_section, t_section
from mechanics.section import Circle, Rectangle, Ring
from tests.mechanics.test_section import integrate

sizes = st.integers(10, 200).map(lambda n: n / 1000)
SECTIONS = [
    i_section(0.1, 0.2, 0.0085, 0.0056),
    t_section(0.12, 0.1, 0.015, 0.01),
    box(0.1, 0.2, 0.004, 0.006),
    Composed((Block(0.1, 0.15, 0.075), Disc(0.06, 0.05, hole=True))),
    Composed((Disc(0.1, 0.0), Disc(0.06, 0.01, hole=True), Block(0.02, 0.1, 0.09))),
    Composed((Block(0.08, 0.02, 0.3), Disc(0.05, 0.265), Block(0.01, 0.24, 0.12), Block(0.06, 0.02, -0.01))),
]


def integral(section: Composed, f: Callable[[float], float], low: float, high: float) -> float:
    """Over the height above the neutral axis, from edge to edge, since the width jumps there."""
    edges = {part.y + side * part.half - section.centroid for part in section.parts for side in (-1, 0, 1)}
    inner = sorted({low, high, *(y for y in edges if low < y < high)})
    return sum(
        integrate(lambda y: f(y) * section.width(section.centroid + y), a + 1e-13, b - 1e-13)
        for a, b in pairwise(inner)
    )


@pytest.mark.parametrize("section", SECTIONS)
def test_the_properties_are_integrals_of_the_width(section: Composed) -> None:
    low, high = -section.bottom, section.top
    assert section.area == pytest.approx(integral(section, lambda y: 1.0, low, high), rel=1e-8)
    assert integral(section, lambda y: y, low, high) == pytest.approx(0, abs=1e-8 * section.area * (high - low))
    assert section.second_moment == pytest.approx(integral(section, lambda y: y * y, low, high), rel=1e-8)
    assert section.first_moment == pytest.approx(integral(section, lambda y: y, 0.0, high), rel=1e-8)
    assert section.first_moment == pytest.approx(-integral(section, lambda y: y, low, 0.0), rel=1e-8)
    assert section.section_modulus == pytest.approx(min(section.moduli)) == min(section.moduli)


@given(b=sizes, h=sizes, share=st.integers(1, 9), y=st.integers(-5, 5).map(float))
def test_blocks_that_make_up_a_rectangle_are_one(b: float, h: float, share: int, y: float) -> None:
    low = h * share / 10
    section = Composed((Block(b, low, y + low / 2), Block(b, h - low, y + (low + h) / 2)))
    plain = Rectangle(b, h)
    assert section.centroid == pytest.approx(y + h / 2, rel=1e-12, abs=1e-12)
    for name in ("area", "second_moment", "section_modulus", "first_moment", "neutral_width"):
        assert getattr(section, name) == pytest.approx(getattr(plain, name), rel=1e-9), name


@given(D=sizes, share=st.integers(1, 9))
def test_a_disc_with_a_bore_is_a_ring(D: float, share: int) -> None:
    section, ring = Composed((Disc(D, 3.0), Disc(D * share / 10, 3.0, hole=True))), Ring(D, D * share / 10)
    for name in ("area", "second_moment", "section_modulus", "first_moment", "neutral_width"):
        assert getattr(section, name) == pytest.approx(getattr(ring, name), rel=1e-9), name
    assert Composed((Disc(D, 0.0),)).first_moment == pytest.approx(Circle(D).first_moment, rel=1e-12)


@given(b=sizes, h=sizes, wall=st.integers(1, 4), flange=st.integers(1, 4))
def test_a_box_is_a_rectangle_less_a_rectangle(b: float, h: float, wall: int, flange: int) -> None:
    section = box(b, h, b * wall / 10, h * flange / 10)
    outer, inner = Rectangle(b, h), Rectangle(b - b * wall / 5, h - h * flange / 5)
    assert section.area == pytest.approx(outer.area - inner.area, rel=1e-12)
    assert section.second_moment == pytest.approx(outer.second_moment - inner.second_moment, rel=1e-12)
    assert section.first_moment == pytest.approx(outer.first_moment - inner.first_moment, rel=1e-12)


def test_a_thin_box_keeps_its_digits() -> None:
    wall = 1e-9
    assert box(1.0, 1.0, wall, wall).second_moment == pytest.approx(2 * wall * (1 / 12 + 1 / 4), rel=1e-8)


@pytest.mark.parametrize("section", SECTIONS)
def test_a_beam_of_it_bends_as_by_the_stiffness_method(section: Composed) -> None:
    made = Beam(2.0, 2.1e11, (Support(0.0), Support(2.0)), (Force(0.7, -5000.0),), section=section)
    found, other = solve(made), frame.solve_beam(made)
    assert other.second_moment == pytest.approx(section.second_moment, rel=1e-12)
    assert found.v_extreme == pytest.approx(other.extreme_deflection()[1], rel=1e-9)
    assert found.sigma_max == pytest.approx(abs(other.normal_stress(0.7, max(section.top, section.bottom))), rel=1e-9)
    shear = integral(section, lambda y: y, 0.0, section.top) / section.second_moment
    assert found.tau_max == pytest.approx(found.V_abs_max * shear / section.neutral_width, rel=1e-8)


def test_at_a_step_of_the_width_the_narrower_side_counts() -> None:
    section = Composed((Block(0.1, 0.02, 0.01), Block(0.02, 0.1, -0.05)))
    edge = Composed((Block(0.1, 0.02, 0.01), Block(0.02, 0.02 * 5**0.5, -0.01 * 5**0.5)))
    assert edge.centroid == pytest.approx(0, abs=1e-15) and edge.neutral_width == 0.02
    assert section.centroid < -0.01 and section.neutral_width == 0.02


@pytest.mark.parametrize(
    ("parts", "said"),
    [
        ((), "at least one solid part"),
        ((Block(1, 1, 0, hole=True),), "at least one solid part"),
        ((Block(0.1, 0.1, 0), Block(0.2, 0.05, 0, hole=True)), "wider than the material"),
        ((Block(0.1, 0.1, 0), Disc(0.11, 0, hole=True)), "wider than the material"),
        ((Block(0.1, 0.1, 0), Disc(0.02, 0.2, hole=True)), "wider than the material"),
        ((Block(0.1, 0.1, 0), Block(0.1, 0.1, 0, hole=True)), "area of the section"),
        ((Block(0.1, 0.1, 0), Block(0.1, 0.1, 1)), "neutral axis"),
    ],
)
def test_what_is_no_section_is_refused(parts: tuple[Part, ...], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        Composed(parts)


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Block(0.0, 1.0, 0.0), "width b = 0.0 m"),
        (lambda: Block(1.0, float("nan"), 0.0), "height h = nan m"),
        (lambda: Disc(-1.0, 0.0), "diameter d = -1.0 m"),
        (lambda: Disc(1.0, float("inf")), "y = inf m"),
        (lambda: i_section(0.1, 0.2, 0.1, 0.01), "less two flanges = 0.0 m"),
        (lambda: i_section(0.1, 0.2, 0.01, 0.2), "web = 0.2 m"),
        (lambda: i_section(0.1, 0.2, -0.01, 0.02), "height h = -0.01 m"),
        (lambda: t_section(0.1, 0.2, 0.3, 0.01), "less the flange"),
        (lambda: box(0.1, 0.2, 0.06, 0.01), "web = 0.12 m"),
        (lambda: box(0.1, 0.2, 0.0, 0.01), "wall = 0.0 m"),
    ],
)
def test_impossible_sizes_are_named(make: Callable[[], object], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        make()
