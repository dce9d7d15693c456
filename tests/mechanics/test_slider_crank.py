"""Closed form against closure, differences, published numbers; and against Newton's method in test_planar."""

from __future__ import annotations

from math import asin, cos, inf, nan, pi, radians, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import planar, slider_crank
from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import LinkageMotion
from mechanics.slider_crank import Branch, dead_positions, position, solve, stroke, turning_points
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)

lengths = st.floats(0.02, 2)
angles = st.floats(-10, 10)
branches: st.SearchStrategy[Branch] = st.sampled_from(["slider_right", "slider_left"])


@quick
@given(crank=lengths, ratio=st.floats(1.4, 10), angle=angles, shift=st.floats(-0.3, 0.3), branch=branches)
def test_polygon_closes(crank: float, ratio: float, angle: float, shift: float, branch: Branch) -> None:
    rod, offset = crank * ratio, crank * shift
    found = position(crank, rod, angle, offset, branch)
    assert crank * cos(angle) + rod * cos(found.rod_angle) == pytest.approx(found.slider, abs=1e-12)
    assert crank * sin(angle) + rod * sin(found.rod_angle) == pytest.approx(offset, abs=1e-12)
    assert (cos(found.rod_angle) > 0) == (branch == "slider_right")
    assert -pi < found.rod_angle <= pi


VP_2 = {"alpha2": -0.2159367698, "l3": 0.3696372768, "omega2": -5.228386435, "v3": -1.621649421}
VP_2 |= {"eps2": 68.67543205, "p3": -37.45169684}
VP_3 = {"alpha2": radians(-2.728073144), "l3": 0.3762644466, "omega2": -5.112757373, "v3": -1.35857906}
VP_3 |= {"eps2": 71.77478169, "p3": -40.66405957}


@pytest.mark.parametrize(("offset", "published"), [(0.0, VP_2), (0.05, VP_3)], ids=["VP-2", "VP-3"])
def test_published_examples_hold(offset: float, published: dict[str, float]) -> None:
    motion = solve(l1=0.1, l2=0.3, alpha1=radians(40), omega1=20, epsilon1=50, offset=offset)
    found = {
        "alpha2": motion.pos["alpha2"],
        "l3": motion.pos["slider_x"],
        "omega2": motion.vel["alpha2"],
        "v3": motion.vel["slider_x"],
        "eps2": motion.acc["alpha2"],
        "p3": motion.acc["slider_x"],
    }
    assert found == pytest.approx(published, rel=1e-9)


def test_published_stroke_of_the_offset_slider_crank_holds() -> None:
    assert stroke(0.1, 0.3, 0.05) == pytest.approx(0.2032135293, rel=1e-9)


def test_stroke_is_the_range_found_by_turning_the_crank() -> None:
    places = [position(0.1, 0.3, 2 * pi * i / 20000, 0.05).slider for i in range(20000)]
    assert stroke(0.1, 0.3, 0.05) == pytest.approx(max(places) - min(places), abs=1e-7)


@quick
@given(crank=lengths, ratio=st.floats(1, 10))
def test_stroke_of_the_centric_slider_crank_is_two_cranks(crank: float, ratio: float) -> None:
    assert stroke(crank, crank * ratio) == pytest.approx(2 * crank)


def _state(time: float, epsilon: float, branch: Branch) -> LinkageMotion:
    angle, omega = 0.7 + 3 * time + epsilon * time**2 / 2, 3 + epsilon * time
    return solve(0.2, 0.55, angle, omega, epsilon, 0.06, branch, point_S_fraction_of_l2=0.3)


@quick
@given(time=st.floats(-2, 2), epsilon=st.floats(-4, 4), branch=branches)
def test_rates_are_the_slopes_of_positions_and_rates(time: float, epsilon: float, branch: Branch) -> None:
    h = 1e-5
    before, now, after = (_state(time + k * h, epsilon, branch) for k in (-1, 0, 1))
    for name in ("alpha2", "slider_x", "S_x", "S_y"):
        turned = after.pos[name] - before.pos[name]
        slope = ((turned + pi) % (2 * pi) - pi) / (2 * h) if name == "alpha2" else turned / (2 * h)
        assert now.vel[name] == pytest.approx(slope, rel=1e-6, abs=1e-6)
        assert now.acc[name] == pytest.approx((after.vel[name] - before.vel[name]) / (2 * h), rel=1e-6, abs=1e-6)


def test_the_point_runs_from_crank_pin_to_slider() -> None:
    pin, end = (solve(0.1, 0.3, 1.0, 2.0, 3.0, point_S_fraction_of_l2=k) for k in (0.0, 1.0))
    assert (pin.pos["S_x"], pin.pos["S_y"]) == pytest.approx((0.1 * cos(1.0), 0.1 * sin(1.0)))
    for of_end in (end.pos, end.vel, end.acc):
        assert of_end["S_x"] == of_end["slider_x"]
        assert of_end["S_y"] == pytest.approx(0, abs=1e-14)


def test_the_measure_is_one_where_the_rod_lies_along_the_guide() -> None:
    assert solve(0.1, 0.3, 0.0).singular.measure == 1
    assert solve(0.1, 0.3, asin(0.5), offset=0.05).singular.measure == 1


def test_the_measure_falls_towards_the_dead_position() -> None:
    measures = [solve(0.1, 0.1001, radians(angle)).singular.measure for angle in (0, 40, 80, 89)]
    assert measures == sorted(measures, reverse=True)
    assert measures[-1] < 0.05


def test_rod_perpendicular_to_the_guide_has_a_position_but_no_rates() -> None:
    assert position(0.1, 0.1, pi / 2).rod_angle == pytest.approx(-pi / 2)
    with pytest.raises(SingularError, match="perpendicular"):
        solve(0.1, 0.1, pi / 2, 1.0)


def test_half_a_turn_is_given_as_plus_pi() -> None:
    for angle in (0.0, 1e-45, -1e-45):
        assert position(0.1, 0.3, angle, branch="slider_left").rod_angle == pi


def test_short_rod_cannot_be_assembled() -> None:
    with pytest.raises(AssemblyError, match=r"rod 0\.05 m cannot reach the guide at 1\.5708 rad: 0\.08 m are missing"):
        position(crank=0.13, rod=0.05, crank_angle=pi / 2)


def test_a_crank_that_cannot_turn_fully_has_no_stroke() -> None:
    with pytest.raises(AssemblyError, match=r"0\.02 m too short"):
        stroke(0.1, 0.13, -0.05)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("l1", 0.0),
        ("l1", nan),
        ("l2", -0.3),
        ("l2", inf),
        ("alpha1", nan),
        ("offset", inf),
        ("omega1", nan),
        ("epsilon1", inf),
        ("point_S_fraction_of_l2", nan),
        ("branch", "up"),
    ],
)
def test_impossible_values_are_refused_by_name(name: str, value: float | str) -> None:
    values: dict[str, object] = {"l1": 0.1, "l2": 0.3, "alpha1": 0.5} | {name: value}
    with pytest.raises(ValueError, match=name):
        solve(**values)  # type: ignore[arg-type]


def test_stroke_refuses_an_offset_that_is_not_finite() -> None:
    with pytest.raises(ValueError, match="offset"):
        stroke(0.1, 0.3, nan)


def test_position_is_known_to_the_last_digits_near_the_dead_position() -> None:
    found = slider_crank.position(1.0, 1.0 + 1e-10, pi / 2)
    assert found.slider == pytest.approx((2e-10) ** 0.5, rel=1e-5)


@pytest.mark.parametrize(
    ("crank", "rod", "offset", "dead"),
    [
        (0.2, 0.3, 0.1, [-pi / 2]),
        (0.3, 0.2, 0.1, [pi + asin(1 / 3) - 2 * pi, -asin(1 / 3), pi / 2]),
        (0.1, 0.1, 0.0, [-pi / 2, pi / 2]),
        (0.1, 0.3, 0.0, []),
    ],
)
def test_a_dead_position_that_is_just_reached_is_one(
    crank: float, rod: float, offset: float, dead: list[float]
) -> None:
    """Printed lengths that add up but for a rounding: 0.1 + 0.2 is not 0.3, 0.1 - 0.3 not -0.2."""
    found = dead_positions(crank, rod, offset)
    assert found == pytest.approx(dead, abs=1e-12)
    for angle in found:
        assert abs(abs(position(crank, rod, angle, offset).rod_angle) - pi / 2) < 1e-6


def test_an_infinite_crank_angle_is_refused_by_name() -> None:
    with pytest.raises(ValueError, match="crank angle alpha1 = inf rad must be finite"):
        position(0.1, 0.3, inf)


@pytest.mark.parametrize(
    ("crank", "rod", "offset"), [(0.1, 0.3, 0.05), (0.1, 0.3, -0.2), (0.08, 0.2, 0.0), (0.1, 0.3, 0.2)]
)
def test_the_slider_turns_round_where_it_is_said(crank: float, rod: float, offset: float) -> None:
    """By Newton's method on the bodies, and against all positions of a turn."""
    far, near = turning_points(crank, rod, offset)
    scanned = [position(crank, rod, radians(k / 10), offset).slider for k in range(3600)]
    for angle, extreme in ((far, max(scanned)), (near, min(scanned))):
        assert position(crank, rod, angle, offset).slider == pytest.approx(extreme, abs=1e-6)
        if abs(offset) < rod - crank - 1e-9:  # else the rod is square to the guide there
            assert planar.slider_crank(crank, rod, angle, 1.0, offset=offset).slider_speed == pytest.approx(0, abs=1e-9)
    apart = position(crank, rod, far, offset).slider - position(crank, rod, near, offset).slider
    assert apart == pytest.approx(stroke(crank, rod, offset))


def test_an_offset_slider_returns_quicker_and_a_centric_one_does_not() -> None:
    far, near = turning_points(0.1, 0.3, 0.05)
    assert near - far == pytest.approx(pi + asin(0.05 / 0.2) - asin(0.05 / 0.4))
    far, near = turning_points(0.1, 0.3)
    assert near - far == pytest.approx(pi)


def test_a_slider_without_two_turning_points_is_refused() -> None:
    with pytest.raises(AssemblyError, match="cannot turn fully"):
        turning_points(0.1, 0.3, 0.21)
    with pytest.raises(SingularError, match="may point anywhere"):
        turning_points(0.1, 0.1)
