"""Six-bar and two-loop linkages: against Newton's method on all bodies, differences, closure over a cycle, limits."""

from __future__ import annotations

from math import cos, hypot, inf, nan, pi, sin

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics import four_bar, six_bar, two_loop
from mechanics.errors import AssemblyError, SingularError
from mechanics.four_bar import Mode
from mechanics.linkage import LinkageMotion
from mechanics.newton_linkages import six_bar_motion, two_loop_motion
from mechanics.planar import Marker
from mechanics.six_bar import DyadMode
from mechanics.slider_crank import Branch
from tests.depth import amount
from tests.mechanics.motions import moved_apart, off_slopes, turned_apart

quick = settings(max_examples=amount(8, 20), deadline=None)
BARS = (0.1, 0.26, 0.22, 0.3)
modes: st.SearchStrategy[Mode] = st.sampled_from(["C_left_of_BD", "C_right_of_BD"])
dyad_modes: st.SearchStrategy[DyadMode] = st.sampled_from(["Q_left_of_PG", "Q_right_of_PG"])
branches: st.SearchStrategy[Branch] = st.sampled_from(["slider_right", "slider_left"])
rates = st.floats(-20, 20)


@quick
@given(angle=st.floats(-4, 4), omega=rates, epsilon=rates, mode=modes, dyad_mode=dyad_modes, g=st.floats(0.35, 0.45))
def test_six_bar_agrees_with_newton(
    angle: float, omega: float, epsilon: float, mode: Mode, dyad_mode: DyadMode, g: float
) -> None:
    point, pivot, dyad = (0.12, 0.06), (g, 0.2), (0.3, 0.28)
    closed = six_bar.solve(*BARS, angle, pivot, *dyad, omega, epsilon, mode, point, dyad_mode)
    assume(closed.singular.measure > 0.1)
    newton = six_bar_motion(BARS, angle, omega, epsilon, point, pivot, dyad, mode, dyad_mode)
    for name, body in (("alpha2", 2), ("alpha3", 3), ("alpha5", 4), ("alpha6", 5)):
        assert turned_apart(closed, name, newton, body) == []
    assert (
        moved_apart(closed, "P", newton, Marker(2, *point)) + moved_apart(closed, "Q", newton, Marker(5, dyad[1])) == []
    )


@quick
@given(angle=st.floats(-4, 4), omega=rates, epsilon=rates, mode=modes, branch=branches)
def test_two_loop_agrees_with_newton(angle: float, omega: float, epsilon: float, mode: Mode, branch: Branch) -> None:
    closed = two_loop.solve(*BARS, 0.35, 0.05, angle, omega, epsilon, mode, branch)
    assume(closed.singular.measure > 0.1)
    newton = two_loop_motion(BARS, 0.35, 0.05, angle, omega, epsilon, mode, branch)
    for name, body in (("alpha2", 2), ("alpha3", 3), ("alpha5", 4)):
        assert turned_apart(closed, name, newton, body) == []
    for values, found in zip(closed[:3], (newton.poses, newton.rates, newton.accelerations), strict=True):
        assert found[5][0] == pytest.approx(values["s6"], rel=1e-7, abs=1e-8)


@pytest.mark.parametrize("angle", [0.5, 2.5, 5.0])
def test_rates_are_the_slopes_of_what_is_earlier_and_later(angle: float) -> None:
    def crank(t: float) -> tuple[float, float, float]:
        return angle + 3 * t - t * t, 3 - 2 * t, -2.0

    def six(t: float) -> LinkageMotion:
        alpha1, omega1, epsilon1 = crank(t)
        return six_bar.solve(*BARS, alpha1, (0.4, 0.2), 0.3, 0.28, omega1, epsilon1, coupler_point=(0.12, 0.06))

    assert off_slopes(six) + off_slopes(lambda t: two_loop.solve(*BARS, 0.35, 0.05, *crank(t))) == []


@pytest.mark.parametrize("dyad_mode", ["Q_left_of_PG", "Q_right_of_PG"])
def test_both_loops_close_over_a_full_cycle_on_the_side_asked_for(dyad_mode: DyadMode) -> None:
    gx, gy, l5, l6 = 0.4, 0.2, 0.3, 0.28
    for k in range(360):
        angle = 2 * pi * k / 360
        at = six_bar.solve(*BARS, angle, (gx, gy), l5, l6, coupler_point=(0.12, 0.06), dyad_mode=dyad_mode).pos
        qx, qy = at["P_x"] + l5 * cos(at["alpha5"]), at["P_y"] + l5 * sin(at["alpha5"])
        assert hypot(qx - gx - l6 * cos(at["alpha6"]), qy - gy - l6 * sin(at["alpha6"])) < 1e-14
        assert (qx, qy) == pytest.approx((at["Q_x"], at["Q_y"]), abs=1e-14)
        side = (gx - at["P_x"]) * (qy - at["P_y"]) - (gy - at["P_y"]) * (qx - at["P_x"])
        assert (side > 0) == (dyad_mode == "Q_left_of_PG")
        slide = two_loop.solve(*BARS, 0.35, 0.05, angle).pos
        rocker = (BARS[2] * cos(slide["alpha3"]), BARS[2] * sin(slide["alpha3"]))
        assert BARS[3] + rocker[0] + 0.35 * cos(slide["alpha5"]) == pytest.approx(slide["s6"], abs=1e-14)
        assert rocker[1] + 0.35 * sin(slide["alpha5"]) == pytest.approx(0.05, abs=1e-14)


def test_a_dyad_that_cannot_reach_is_refused_with_its_names_and_the_gap() -> None:
    with pytest.raises(AssemblyError, match=r"P and G are .* too far for link l5 0\.1 m and link l6 0\.1 m"):
        six_bar.solve(*BARS, 1.0, (2.0, 0.0), 0.1, 0.1)
    with pytest.raises(AssemblyError, match="cannot reach the guide"):
        two_loop.solve(*BARS, 0.05, 0.5, 1.0)


def test_links_in_line_are_a_dead_position_with_its_name() -> None:
    P = four_bar.solve(*BARS, 1.0).pos
    far = hypot(P["P_x"] - 1.0, P["P_y"])
    with pytest.raises(SingularError, match="links 5 and 6 in line at 1 rad"):
        six_bar.solve(*BARS, 1.0, (1.0, 0.0), far / 2, far / 2, 1.0)


def test_the_measure_is_that_of_the_group_nearest_to_its_dead_position() -> None:
    base = four_bar.solve(*BARS, 1.0).singular
    assert six_bar.solve(*BARS, 1.0, (0.35, 0.05), 0.2, 0.22).singular == base
    near = six_bar.solve(*BARS, 1.0, (0.45, 0.05), 0.2, 0.2).singular
    assert near.name == six_bar.DEAD_NAME and near.measure < base.measure


@pytest.mark.parametrize(
    ("name", "value"), [("l5", 0.0), ("l6", nan), ("l1", inf), ("omega1", nan), ("dyad_mode", "up"), ("mode", "up")]
)
def test_impossible_values_are_refused_by_name(name: str, value: object) -> None:
    names = ("l1", "l2", "l3", "l4", "alpha1")
    values: dict[str, object] = dict(zip(names, (*BARS, 1.0), strict=True))
    values |= {"dyad_pivot": (0.4, 0.2), "l5": 0.3, "l6": 0.28} | {name: value}
    with pytest.raises(ValueError, match=name):
        six_bar.solve(**values)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="dyad pivot y"):
        six_bar.solve(*BARS, 1.0, (0.0, nan), 0.3, 0.3)


def test_two_loop_refuses_its_own_values_by_name() -> None:
    with pytest.raises(ValueError, match="bar l5"):
        two_loop.solve(*BARS, 0.0, 0.05, 1.0)
    with pytest.raises(ValueError, match="h6"):
        two_loop.solve(*BARS, 0.35, inf, 1.0)
