"""Crank with a rocking slide: against closure, Newton's method, differences and its dead position."""

from __future__ import annotations

from math import cos, inf, nan, pi, sin

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics.errors import SingularError
from mechanics.inverted_slider import solve
from mechanics.linkage import LinkageMotion
from mechanics.newton_linkages import inverted_slider_motion
from mechanics.planar import Marker
from tests.depth import amount
from tests.mechanics.motions import moved_apart, off_slopes, turned_apart

quick = settings(max_examples=amount(10, 30), deadline=None)
rates = st.floats(-20, 20)


@quick
@given(l1=st.floats(0.05, 1), angle=st.floats(-7, 7), omega=rates, epsilon=rates, pivot=st.tuples(rates, rates))
def test_closed_form_closes_and_agrees_with_newton(
    l1: float, angle: float, omega: float, epsilon: float, pivot: tuple[float, float]
) -> None:
    pivot = (pivot[0] / 20, pivot[1] / 20)
    try:
        closed = solve(l1, angle, omega, epsilon, pivot, 0.3)
    except SingularError:
        assume(False)
    assume(closed.singular.measure > 0.05)
    phi, s = closed.pos["phi"], closed.pos["s"]
    assert pivot[0] + s * cos(phi) == pytest.approx(l1 * cos(angle), abs=1e-12)
    assert pivot[1] + s * sin(phi) == pytest.approx(l1 * sin(angle), abs=1e-12)
    newton = inverted_slider_motion(l1, angle, omega, epsilon, pivot)
    assert turned_apart(closed, "phi", newton, 3) + moved_apart(closed, "P", newton, Marker(3, 0.3)) == []


@pytest.mark.parametrize("epsilon", [-3.0, 0.0, 5.0])
@pytest.mark.parametrize("angle", [0.3, 2.0, 4.5])
def test_rates_are_the_slopes_of_what_is_earlier_and_later(angle: float, epsilon: float) -> None:
    def at(t: float) -> LinkageMotion:
        return solve(0.15, angle + 2 * t + epsilon * t * t / 2, 2 + epsilon * t, epsilon, (0.1, -0.4), 0.2)

    assert off_slopes(at) == []


def test_the_slide_is_longest_and_the_measure_one_where_the_crank_points_away() -> None:
    found = solve(0.15, pi / 2, 1.0, guide_pivot=(0.0, -0.4))
    assert found.singular.measure == pytest.approx(1)
    assert (found.pos["s"], found.vel["s"]) == pytest.approx((0.55, 0))
    assert found.vel["phi"] == pytest.approx(0.15 / 0.55)


def test_the_crank_pin_on_the_guide_pivot_is_a_dead_position() -> None:
    with pytest.raises(SingularError, match="crank pin on the guide pivot at 0 rad"):
        solve(0.1, 0.0, 1.0, guide_pivot=(0.1, 0.0))


def test_half_a_turn_is_given_as_plus_pi() -> None:
    assert solve(0.1, 0.0, guide_pivot=(0.5, 0.0)).pos["phi"] == pi
    assert solve(0.1, -1e-45, guide_pivot=(0.5, 0.0)).pos["phi"] == pi


@pytest.mark.parametrize(
    ("name", "value"),
    [("l1", 0.0), ("l1", nan), ("alpha1", inf), ("omega1", nan), ("epsilon1", inf), ("guide_point_distance", nan)],
)
def test_impossible_values_are_refused_by_name(name: str, value: float) -> None:
    values = {"l1": 0.1, "alpha1": 0.3} | {name: value}
    with pytest.raises(ValueError, match=name):
        solve(**values)  # type: ignore[arg-type]


def test_a_pivot_that_is_not_finite_is_refused() -> None:
    with pytest.raises(ValueError, match="guide_pivot y"):
        solve(0.1, 0.3, guide_pivot=(0.0, nan))
