"""Bars by equilibrium and compatibility, against the stiffness method and the domain's examples."""

from __future__ import annotations

from math import inf, nan, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.axial_frame import solve_bar
from mechanics.bar import AxialForce, Bar, BarSegment, required_diameter, solve

STEEL = 2.1e11
# lengths and places on a grid: the second way loses digits in an element of 1e-12 m
segments = st.lists(
    st.builds(
        BarSegment,
        st.integers(2, 32).map(lambda n: n / 16),
        st.floats(1e-5, 1e-3),
        st.floats(5e10, 3e11),
        st.floats(0, 3e-5),
        st.floats(-80, 80),
        st.floats(-5e4, 5e4),
    ),
    min_size=1,
    max_size=4,
)
pushes = st.lists(st.tuples(st.integers(0, 16).map(lambda n: n / 16), st.floats(-1e5, 1e5)), max_size=4)


def made(parts: list[BarSegment], loads: list[tuple[float, float]], support: str, gap: float) -> Bar:
    length = sum(part.L for part in parts)
    forces = tuple(AxialForce(share * length, F) for share, F in loads)
    return Bar(tuple(parts), forces, support, gap if support == "fixed_gap" else None)  # type: ignore[arg-type]


@settings(deadline=None)
@given(segments, pushes, st.sampled_from(["fixed_free", "free_fixed", "fixed_fixed", "fixed_gap"]), st.floats(0, 2e-3))
def test_a_bar_is_the_same_by_both_ways(
    parts: list[BarSegment], loads: list[tuple[float, float]], support: str, gap: float
) -> None:
    bar = made(parts, loads, support, gap)
    found, frame = solve(bar), solve_bar(bar)
    force = 1.0 + sum(abs(F) for _, F in loads) + sum(abs(p.q) * p.L + abs(p.E * p.A * p.alpha * p.dT) for p in parts)
    moved = 1e-9 + sum(force / (p.E * p.A) * p.L for p in parts)
    assert (found.reactions.left, found.reactions.right) == pytest.approx(frame.reactions, abs=1e-9 * force)
    assert [shift.u for shift in found.u] == pytest.approx(frame.u, abs=1e-9 * moved)
    for piece, (N1, N2) in zip(found.pieces, frame.ends, strict=True):
        assert pytest.approx((N1, N2), abs=1e-8 * force) == (piece.N1, piece.N2)
    assert bool(found.gap_closed) == frame.closed


@given(segments, pushes)
def test_a_bar_is_in_equilibrium(parts: list[BarSegment], loads: list[tuple[float, float]]) -> None:
    found = solve(made(parts, loads, "fixed_fixed", 0))
    total = sum(F for _, F in loads) + sum(part.q * part.L for part in parts)
    assert found.reactions.left + found.reactions.right + total == pytest.approx(0, abs=1e-6)
    assert found.u[0].u == 0 and found.u[-1].u == pytest.approx(0, abs=1e-12)


def test_a_stepped_bar_of_the_domain() -> None:
    """SM-3: forces from the fixed end 30, -50, 40 kN."""
    parts = [BarSegment(length, area, STEEL) for length, area in ((0.4, 4e-4), (0.5, 6e-4), (0.3, 3e-4))]
    forces = tuple(AxialForce(x, F) for x, F in ((0.4, 30e3), (0.9, -50e3), (1.2, 40e3)))
    found = solve(Bar(tuple(parts), forces))
    assert [piece.N1 for piece in found.pieces] == pytest.approx([20e3, -10e3, 40e3])
    assert [piece.sigma1 for piece in found.pieces] == pytest.approx([5e7, -1.666667e7, 1.333333e8], rel=1e-6)
    assert found.u[-1].u == pytest.approx(0.0002460317, rel=1e-6)
    assert found.sigma_abs_max == pytest.approx(1.333333e8, rel=1e-6)


def test_a_bar_between_two_walls_of_the_domain() -> None:
    """SM-4: P = 60 kN at the joint; heated by 40 K with the domain's force."""
    cold = solve(
        Bar((BarSegment(0.5, 5e-4, STEEL), BarSegment(0.9, 8e-4, STEEL)), (AxialForce(0.5, 60e3),), "fixed_fixed")
    )
    assert [piece.N1 for piece in cold.pieces] == pytest.approx([31764.71, -28235.29], rel=1e-6)
    assert cold.u[1].u == pytest.approx(0.0001512605, rel=1e-6)
    hot = [BarSegment(0.5, 5e-4, STEEL, 1.2e-5, 40), BarSegment(0.9, 8e-4, STEEL, 1.2e-5, 40)]
    warm = solve(Bar(tuple(hot), (), "fixed_fixed"))
    assert (
        warm.pieces[0].N1 == warm.pieces[1].N1 == pytest.approx(-12e-6 * 40 * 1.4 / (0.5 / 5e-4 + 0.9 / 8e-4) * STEEL)
    )


def test_a_gap_that_stays_open_gives_no_reaction() -> None:
    part = (BarSegment(0.8, 4e-4, STEEL, 1.2e-5, 30),)
    stays = solve(Bar(part, (), "fixed_gap", 0.0005))
    assert (stays.gap_closed, stays.reactions.right) == (False, 0.0)
    shuts = solve(Bar(part, (AxialForce(0.8, 60e3),), "fixed_gap", 0.0005))
    assert shuts.gap_closed and shuts.u[-1].u == pytest.approx(0.0005) and shuts.reactions.right < 0


def test_the_required_diameter_of_the_domain() -> None:
    """SM-2: 25 kN at 160 MPa."""
    assert required_diameter(25e3, 160e6) == pytest.approx(0.01410474, rel=1e-6)
    assert 4 * 25e3 / (pi * required_diameter(-25e3, 160e6) ** 2) == pytest.approx(160e6)


def test_a_place_a_rounding_away_from_an_end_is_that_end() -> None:
    parts = (BarSegment(0.1, 1e-4, STEEL), BarSegment(0.2, 1e-4, STEEL))
    assert len(solve(Bar(parts, (AxialForce(0.3, 1.0),))).pieces) == 2


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: BarSegment(0, 1e-4, STEEL), "L = 0 m"),
        (lambda: BarSegment(1, 1e-4, nan), "E = nan Pa"),
        (lambda: BarSegment(1, 1e-4, STEEL, dT=inf), "dT"),
        (lambda: Bar(()), "at least one segment"),
        (lambda: Bar((BarSegment(1, 1e-4, STEEL),), (AxialForce(2, 1),)), "0 .. 1"),
        (lambda: Bar((BarSegment(1, 1e-4, STEEL),), support="hung"), "must be one of"),  # type: ignore[arg-type]
        (lambda: Bar((BarSegment(1, 1e-4, STEEL),), gap_right=0.1), "gap_right"),
        (lambda: Bar((BarSegment(1, 1e-4, STEEL),), support="fixed_gap"), "gap_right"),
        (lambda: Bar((BarSegment(1, 1e-4, STEEL),), support="fixed_gap", gap_right=-1), "not negative"),
        (lambda: required_diameter(1, 0), "sigma_allow"),
        (lambda: BarSegment(1, 1e-300, 1e-300), "axial stiffness E A = 0.0 N"),
        (lambda: solve(Bar((BarSegment(1, 1e-200, 1e-100),), (AxialForce(1, 1e300),))), "range of floats"),
    ],
)
def test_impossible_bars_are_refused_by_name(make: object, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        make()  # type: ignore[operator]


def test_a_bar_longer_than_any_number_is_refused() -> None:
    with pytest.raises(ValueError, match="length of the bar = inf m must be positive and finite"):
        Bar((BarSegment(1e308, 1e-4, 2e11), BarSegment(1e308, 1e-4, 2e11)))
