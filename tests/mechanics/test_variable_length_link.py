"""Triangle with a linear drive: against the triangle, Newton's method, differences and its dead positions."""

from __future__ import annotations

from math import cos, hypot, inf, nan, pi, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import LinkageMotion
from mechanics.newton_linkages import variable_length_link_motion
from mechanics.planar import Marker
from mechanics.variable_length_link import solve
from tests.depth import amount
from tests.mechanics.motions import moved_apart, off_slopes, turned_apart

lengths = st.floats(0.1, 1)
rates = st.floats(-2, 2)


@settings(max_examples=amount(10, 30), deadline=None)
@given(AC=lengths, BC=lengths, part=st.floats(0.05, 0.95), rate=rates, second=rates)
def test_closed_form_agrees_with_the_triangle_and_with_newton(
    AC: float, BC: float, part: float, rate: float, second: float
) -> None:
    low, high = abs(AC - BC), AC + BC
    length = low + part * (high - low)
    found = solve(AC, BC, length, rate, second)
    place = (found.pos["B_x"], found.pos["B_y"])
    assert hypot(*place) == pytest.approx(length)
    assert hypot(place[0] - AC, place[1]) == pytest.approx(BC)
    assert place == pytest.approx((length * cos(found.pos["alpha"]), length * sin(found.pos["alpha"])))
    newton = variable_length_link_motion(AC, BC, length, rate, second)
    assert turned_apart(found, "alpha", newton, 1) + moved_apart(found, "B", newton, Marker(2)) == []
    assert newton.rates[3][2] == pytest.approx(-found.vel["beta"], rel=1e-7)
    assert pi - newton.poses[3][2] == pytest.approx(found.pos["beta"], abs=1e-9)


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("length", [0.4, 0.6, 1.1])
def test_rates_are_the_slopes_of_what_is_earlier_and_later(length: float, mirrored: bool) -> None:
    def at(t: float) -> LinkageMotion:
        return solve(0.8, 0.5, length + 0.3 * t - 0.1 * t * t, 0.3 - 0.2 * t, -0.2, mirrored)

    assert off_slopes(at) == []


def test_the_mirror_image_has_the_same_angles_and_the_point_on_the_other_side() -> None:
    one, other = (solve(0.8, 0.5, 0.6, 0.05, 0.01, mirrored) for mirrored in (False, True))
    for values, mirror in zip(one[:3], other[:3], strict=True):
        assert (mirror["beta"], mirror["alpha"], mirror["B_y"]) == (values["beta"], values["alpha"], values["B_y"])
    assert other.pos["B_x"] == pytest.approx(0.8 - one.pos["B_x"])
    assert other.vel["B_x"] == pytest.approx(-one.vel["B_x"])


def test_a_right_angle_at_the_lever_is_farthest_from_the_dead_positions() -> None:
    found = solve(0.3, 0.4, 0.5, 1.0)
    assert found.singular.measure == pytest.approx(1)
    assert found.vel["beta"] == pytest.approx(0.5 / (0.3 * 0.4))


@pytest.mark.parametrize(("length", "word"), [(1.4, "too long"), (0.2, "too short")])
def test_lengths_that_make_no_triangle_are_refused_with_the_gap(length: float, word: str) -> None:
    with pytest.raises(AssemblyError, match=rf"{word}.*0\.1 m do not fit"):
        solve(0.8, 0.5, length)
    with pytest.raises(AssemblyError):
        variable_length_link_motion(0.8, 0.5, length, 0.1)


@pytest.mark.parametrize("length", [1.3, 0.3])
def test_three_points_in_line_are_a_dead_position(length: float) -> None:
    with pytest.raises(SingularError, match="in line"):
        solve(0.8, 0.5, length, 0.1)


@pytest.mark.parametrize(("name", "value"), [("AC", 0.0), ("BC", nan), ("l_AB", inf), ("dl_AB", nan), ("ddl_AB", inf)])
def test_impossible_values_are_refused_by_name(name: str, value: float) -> None:
    values = {"AC": 0.8, "BC": 0.5, "l_AB": 0.6} | {name: value}
    with pytest.raises(ValueError, match=name):
        solve(**values)  # type: ignore[arg-type]
