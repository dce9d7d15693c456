"""Four-bar linkage: closed form against closure, published numbers, Newton's method, differences and limits."""

from __future__ import annotations

from math import acos, cos, hypot, inf, isclose, nan, pi, radians, sin

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics import four_bar
from mechanics.errors import AssemblyError, SingularError
from mechanics.four_bar import Mode, assemblies, crank_turns, dead_positions, position, solve
from mechanics.linkage import LinkageMotion
from mechanics.newton_linkages import four_bar_motion
from mechanics.planar import Marker
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)
modes: st.SearchStrategy[Mode] = st.sampled_from(["C_left_of_BD", "C_right_of_BD"])
rates = st.floats(-30, 30)
VP_4 = (0.1, 0.26, 0.22, 0.3)


@st.composite
def turning(draw: st.DrawFn) -> tuple[float, float, float, float]:
    """Crank-rockers well away from the change point."""
    crank = draw(st.floats(0.03, 0.2))
    coupler, rocker = (crank * draw(st.floats(1.8, 4)) for _ in range(2))
    low, high = abs(coupler - rocker) + crank, coupler + rocker - crank
    return crank, coupler, rocker, low + (high - low) * draw(st.floats(0.15, 0.85))


@quick
@given(bars=turning(), angle=st.floats(-10, 10), mode=modes)
def test_polygon_closes_on_the_side_asked_for(
    bars: tuple[float, float, float, float], angle: float, mode: Mode
) -> None:
    l1, l2, l3, l4 = bars
    found = position(*bars, angle, mode)
    bx, by = l1 * cos(angle), l1 * sin(angle)
    cx, cy = bx + l2 * cos(found.coupler_angle), by + l2 * sin(found.coupler_angle)
    assert (cx, cy) == pytest.approx(
        (l4 + l3 * cos(found.rocker_angle), l3 * sin(found.rocker_angle)), abs=1e-12 * hypot(*bars) * 10
    )
    left = (l4 - bx) * (cy - by) + by * (cx - bx)
    assert (left > 0) == (mode == "C_left_of_BD")


@pytest.mark.parametrize(
    ("mode", "angles", "speeds", "accelerations"),
    [
        ("C_left_of_BD", (30.47575, 96.76635), (-3.017217, 2.935742), (46.50221, 68.21388)),
        ("C_right_of_BD", (-68.68896, -134.9796), None, None),
    ],
)
def test_the_published_example_holds(
    mode: Mode,
    angles: tuple[float, float],
    speeds: tuple[float, float] | None,
    accelerations: tuple[float, float] | None,
) -> None:
    motion = solve(*VP_4, radians(60), 12, -8, mode)
    assert (motion.pos["alpha2"], motion.pos["alpha3"]) == pytest.approx([radians(a) for a in angles], rel=1e-6)
    if speeds and accelerations:
        assert (motion.vel["alpha2"], motion.vel["alpha3"]) == pytest.approx(speeds, rel=1e-6)
        assert (motion.acc["alpha2"], motion.acc["alpha3"]) == pytest.approx(accelerations, rel=1e-6)


@quick
@given(bars=turning(), angle=st.floats(-7, 7), omega=rates, epsilon=rates, mode=modes)
def test_closed_form_agrees_with_newton(
    bars: tuple[float, float, float, float], angle: float, omega: float, epsilon: float, mode: Mode
) -> None:
    u, v = 0.4 * bars[1], 0.3 * bars[1]
    closed = solve(*bars, angle, omega, epsilon, mode, (u, v))
    assume(closed.singular.measure > 0.05)
    newton = four_bar_motion(*bars, angle, omega, epsilon, mode)
    for body, name in ((2, "alpha2"), (3, "alpha3")):
        turn = newton.poses[body][2] - closed.pos[name]
        assert isclose(cos(turn), 1, abs_tol=1e-12)
        assert newton.rates[body][2] == pytest.approx(closed.vel[name], rel=1e-8, abs=1e-8)
        assert newton.accelerations[body][2] == pytest.approx(closed.acc[name], rel=1e-7, abs=1e-6)
    place, speed, acceleration = newton.point(Marker(2, u, v))
    assert place == pytest.approx((closed.pos["P_x"], closed.pos["P_y"]), abs=1e-10)
    assert speed == pytest.approx((closed.vel["P_x"], closed.vel["P_y"]), rel=1e-8, abs=1e-8)
    assert acceleration == pytest.approx((closed.acc["P_x"], closed.acc["P_y"]), rel=1e-7, abs=1e-6)


@quick
@given(bars=turning(), angle=st.floats(-3, 3), epsilon=rates, mode=modes)
def test_rates_are_the_differences_of_positions_and_velocities(
    bars: tuple[float, float, float, float], angle: float, epsilon: float, mode: Mode
) -> None:
    omega, step = 3.0, 1e-5

    def at(t: float) -> LinkageMotion:
        turned = angle + omega * t + epsilon * t * t / 2
        return solve(*bars, turned, omega + epsilon * t, epsilon, mode, (0.05, 0.02))

    before, now, after = at(-step), at(0), at(step)
    assume(now.singular.measure > 0.2)
    for name in now.pos:
        moved = (after.pos[name] - before.pos[name] + pi) % (2 * pi) - pi
        assert moved / (2 * step) == pytest.approx(now.vel[name], rel=1e-5, abs=1e-4)
        assert (after.vel[name] - before.vel[name]) / (2 * step) == pytest.approx(now.acc[name], rel=1e-4, abs=1e-2)


def test_a_parallelogram_carries_its_coupler_without_turning() -> None:
    motion = solve(0.1, 0.3, 0.1, 0.3, 1.0, 5.0, 2.0, "C_left_of_BD", (0.1, 0.0))
    assert motion.pos["alpha2"] == pytest.approx(0, abs=1e-12)
    assert (motion.vel["alpha2"], motion.vel["alpha3"]) == pytest.approx((0, 5))
    assert (motion.acc["alpha2"], motion.acc["alpha3"]) == pytest.approx((0, 2), abs=1e-12)
    assert motion.vel["P_x"] == pytest.approx(-0.1 * 5 * sin(1.0))


def test_both_assemblies_mirror_one_another_in_the_diagonal() -> None:
    left, right = assemblies(*VP_4, radians(60))
    diagonal = radians(-19.1066)
    assert left.coupler_angle + right.coupler_angle == pytest.approx(2 * diagonal, abs=1e-5)


def test_the_measure_is_the_sine_between_coupler_and_rocker() -> None:
    motion = solve(*VP_4, 2.0, 1.0)
    assert motion.singular.measure == pytest.approx(abs(sin(motion.pos["alpha3"] - motion.pos["alpha2"])))
    assert motion.singular.name == four_bar.DEAD_NAME


def test_a_kite_folded_onto_its_frame_is_singular_not_out_of_reach() -> None:
    """B falls on D: coupler and rocker, of one length, may point anywhere; of two lengths they cannot meet."""
    for found in (position, solve):
        with pytest.raises(SingularError, match="B and D fall together"):
            found(0.2, 0.3, 0.3, 0.2, 0.0)
        with pytest.raises(AssemblyError, match=r"0\.1 m are missing"):
            found(0.2, 0.3, 0.4, 0.2, 0.0)


@pytest.mark.parametrize(("bars", "apart"), [((0.1, 0.1, 0.1, 0.5), "too far"), ((0.2, 0.5, 0.1, 0.3), "too near")])
def test_bars_that_cannot_meet_are_refused_with_their_distance(
    bars: tuple[float, float, float, float], apart: str
) -> None:
    with pytest.raises(AssemblyError, match=apart):
        position(*bars, 0.0)
    with pytest.raises(AssemblyError):
        four_bar_motion(*bars, 0.0, 1.0)


@pytest.mark.parametrize("place", range(5))
@pytest.mark.parametrize("value", [inf, nan])
def test_numbers_that_are_not_finite_are_refused(place: int, value: float) -> None:
    values = [*VP_4, 1.0]
    values[place] = value
    l1, l2, l3, l4, angle = values
    with pytest.raises(ValueError, match="finite"):
        position(l1, l2, l3, l4, angle)
    with pytest.raises(ValueError, match="finite"):
        four_bar_motion(l1, l2, l3, l4, angle, 1.0)


def test_rates_that_are_not_finite_are_refused() -> None:
    with pytest.raises(ValueError, match="omega1"):
        solve(*VP_4, 1.0, omega1=inf)
    with pytest.raises(ValueError, match="epsilon1"):
        solve(*VP_4, 1.0, epsilon1=inf)
    with pytest.raises(ValueError, match="coupler point"):
        solve(*VP_4, 1.0, coupler_point=(0.0, nan))


def test_an_unknown_mode_is_refused() -> None:
    with pytest.raises(ValueError, match="mode must be"):
        position(*VP_4, 1.0, "up")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="mode must be"):
        four_bar_motion(*VP_4, 1.0, 1.0, mode="up")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("bars", "turns"),
    [((0.1, 0.26, 0.22, 0.3), True), ((0.26, 0.1, 0.22, 0.3), False), ((0.3, 0.26, 0.22, 0.1), True)],
)
def test_a_crank_turns_fully_when_every_position_can_be_assembled(
    bars: tuple[float, float, float, float], turns: bool
) -> None:
    assert crank_turns(*bars) is turns
    reached = 0
    for k in range(360):
        try:
            position(*bars, radians(k))
        except AssemblyError:
            continue
        reached += 1
    assert (reached == 360) is turns


def test_stretched_bars_are_assembled_but_have_no_rates() -> None:
    bars = (0.1, 0.2, 0.2, 0.3)
    assert position(*bars, pi).coupler_angle == pytest.approx(0, abs=1e-6)
    with pytest.raises(SingularError, match="in line"):
        solve(*bars, pi, 1.0)


@pytest.mark.parametrize(
    ("bars", "dead"),
    [
        ((0.1, 0.2, 0.2, 0.3), [pi]),
        ((0.3, 0.2, 0.25, 0.15), [pi]),
        ((0.1, 0.3, 0.1, 0.3), [0.0, pi]),  # a parallelogram
        ((0.3, 0.4, 0.1, 0.6), [0.0, acos((0.3**2 + 0.6**2 - 0.5**2) / (2 * 0.3 * 0.6))]),
    ],
)
def test_a_change_point_is_a_dead_position_though_its_lengths_are_rounded(
    bars: tuple[float, float, float, float], dead: list[float]
) -> None:
    found = dead_positions(*bars)
    assert found == pytest.approx(dead, abs=1e-7)


def test_a_crank_that_just_passes_its_change_points_turns_fully() -> None:
    assert crank_turns(0.1, 0.15, 0.15, 0.2) and crank_turns(0.1, 0.2, 0.2, 0.3) and crank_turns(0.1, 0.3, 0.1, 0.3)
    assert not crank_turns(0.1, 0.2, 0.2, 0.3001)
    with pytest.raises(ValueError, match=r"rocker l3 = -0\.2 m must be positive"):
        crank_turns(0.1, 0.2, -0.2, 0.3)


def test_bars_beyond_the_range_of_floats_are_refused() -> None:
    for far in (1e155, 1e300):
        with pytest.raises(ValueError, match="range of floats"):
            position(0.2, 1.3, 0.3, far, 2.0)
