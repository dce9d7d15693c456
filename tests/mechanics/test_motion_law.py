"""Laws of drives against quadrature, differences and limits; finite differences against exact derivatives."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import cos, inf, nan, pi, sin

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics import finite_differences, four_bar, slider_crank, transfer
from mechanics.errors import SingularError
from mechanics.motion_law import constant_output, drive_law, fastest_extension
from mechanics.transfer import Transfer
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)
sizes = st.floats(0.05, 5)


@quick
@given(travel=st.floats(-5, 5), v_max=sizes, a_max=sizes, start=st.floats(0, 1))
def test_the_law_covers_its_travel_within_its_limits(travel: float, v_max: float, a_max: float, start: float) -> None:
    assume(abs(travel) > 1e-3)
    law = drive_law(travel, v_max, a_max, start * v_max)
    states, sign = [state for _, state in law.table(200)], 1 if travel > 0 else -1
    assert (states[0].q, states[-1].q) == pytest.approx((0, travel), abs=1e-12)
    assert (states[0].q_dot, states[-1].q_dot) == pytest.approx((sign * law.v_start,) * 2, abs=1e-12)
    assert max(abs(state.q_dot) for state in states) <= v_max * (1 + 1e-12)
    assert max(abs(state.q_ddot) for state in states) <= a_max * (1 + 1e-12)
    ends = (0.0, law.t_acc, law.t_total - law.t_acc, law.t_total)
    gained = [trapezia(lambda t: law.at(t).q_dot, *phase) for phase in pairwise(ends)]
    assert sum(gained) == pytest.approx(travel, rel=1e-5)
    won = [trapezia(lambda t: law.at(t).q_ddot, *phase) for phase in pairwise(ends)]
    change = sign * (law.v_peak - law.v_start)
    assert won == pytest.approx([change, 0, -change], rel=1e-3, abs=1e-9)


def trapezia(rate: Callable[[float], float], start: float, end: float, steps: int = 100) -> float:
    """Integrate over one phase; its ends, where rounding may fall into the next, are taken just inside."""
    width = (end - start) / steps
    inner = sum(rate(start + i * width) for i in range(1, steps))
    return width * (inner + (rate(start + 1e-9 * width) + rate(end - 1e-9 * width)) / 2)


@quick
@given(travel=sizes, v_max=sizes, a_max=sizes, share=st.floats(0.01, 0.99))
def test_rates_are_slopes_of_the_travel(travel: float, v_max: float, a_max: float, share: float) -> None:
    law = drive_law(travel, v_max, a_max)
    h, t = 1e-5 * law.t_total, share * law.t_total
    before, now, after = law.at(t - h), law.at(t), law.at(t + h)
    assert now.q_dot == pytest.approx((after.q - before.q) / (2 * h), rel=1e-4, abs=1e-5 * v_max)
    assert now.q_ddot == pytest.approx((after.q_dot - before.q_dot) / (2 * h), rel=1e-3, abs=2e-4 * a_max)


@quick
@given(travel=sizes, v_max=sizes, a_max=sizes)
def test_a_travel_is_too_short_exactly_below_the_limit(travel: float, v_max: float, a_max: float) -> None:
    limit = pi * v_max**2 / (2 * a_max)  # v_max t_acc
    assume(abs(travel / limit - 1) > 1e-9)
    law = drive_law(travel, v_max, a_max)
    assert (law.t_cruise > 1e-12 * law.t_total) == (travel > limit)
    if travel > limit:
        assert law.v_peak == v_max
        assert law.t_total == pytest.approx(travel / v_max + law.t_acc)
    else:
        assert law.at(law.t_total / 2).q_dot == pytest.approx(law.v_peak) and law.v_peak <= v_max


def test_running_at_its_largest_speed_all_the_way_is_a_steady_motion() -> None:
    law = drive_law(3.0, 1.5, 2.0, v_start=1.5)
    assert (law.t_acc, law.t_total) == (0, 2)
    for t in (0.0, 0.7, 2.0):
        assert law.at(t).q == pytest.approx(1.5 * t) and law.at(t).q_ddot == 0


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ((0.0, 1.0, 1.0), r"\|travel\| = 0.0"),
        ((nan, 1.0, 1.0), r"\|travel\|"),
        ((1.0, 0.0, 1.0), "v_max"),
        ((1.0, 1.0, inf), "a_max"),
        ((1.0, 1.0, 1.0, 1.1), "v_start = 1.1 must lie in 0"),
        ((1.0, 1.0, 1.0, -0.1), "v_start"),
    ],
)
def test_a_law_that_cannot_be_is_refused(values: tuple[float, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        drive_law(*values)


def test_a_time_outside_the_travel_is_refused() -> None:
    law = drive_law(1.0, 1.0, 1.0)
    for t in (-0.1, law.t_total + 0.1, nan):
        with pytest.raises(ValueError, match="must lie in 0"):
            law.at(t)
    with pytest.raises(ValueError, match="at least 1"):
        law.table(0)


@quick
@given(AC=sizes, BC=sizes, beta=st.floats(-7, 7), omega=st.floats(-5, 5))
def test_the_drive_follows_from_a_steady_turn(AC: float, BC: float, beta: float, omega: float) -> None:
    assume(abs(sin(beta / 2)) > 0.05)
    h = 1e-5
    before, now, after = (constant_output(AC, BC, beta + omega * k * h, omega) for k in (-1, 0, 1))
    B = AC - BC * cos(beta), BC * sin(beta)
    assert now.length == pytest.approx((B[0] ** 2 + B[1] ** 2) ** 0.5)
    assert now.rate == pytest.approx((after.length - before.length) / (2 * h), abs=1e-6 * (1 + abs(omega)) * AC)
    assert now.acceleration == pytest.approx((after.rate - before.rate) / (2 * h), rel=1e-4, abs=1e-4)


@quick
@given(AC=sizes, BC=sizes)
def test_no_angle_makes_the_drive_faster_than_the_fastest(AC: float, BC: float) -> None:
    assume(abs(AC / BC - 1) > 0.01)
    beta, speed = fastest_extension(AC, BC, -2.0)
    assert abs(constant_output(AC, BC, beta, -2.0).rate) == pytest.approx(speed)
    assert all(abs(constant_output(AC, BC, k * pi / 90, -2.0).rate) <= speed + 1e-9 for k in range(1, 90))


def test_a_drive_of_no_length_is_refused() -> None:
    with pytest.raises(SingularError, match="no direction"):
        constant_output(0.5, 0.5, 0.0, 1.0)
    with pytest.raises(ValueError, match="AC"):
        constant_output(0.0, 0.5, 0.1, 1.0)
    with pytest.raises(ValueError, match="omega"):
        fastest_extension(1.0, 0.5, inf)


def cubic(t: float) -> float:
    return 1 + 2 * t - 3 * t**2 + 4 * t**3


def test_central_differences_err_by_the_square_of_the_step() -> None:
    errors = []
    for tau in (0.1, 0.05):
        samples = [cubic(0.5 + k * tau) for k in range(-2, 3)]
        rates, bends = finite_differences.first(samples, tau), finite_differences.second(samples, tau)
        assert bends[1] == pytest.approx(-6 + 24 * 0.5)  # exact for a cubic
        errors.append([rates[2] - (2 - 6 * 0.5 + 12 * 0.25), rates[0] - slope(0.5 - 2 * tau)])
        assert rates[4] - slope(0.5 + 2 * tau) == pytest.approx(errors[-1][1])
    for coarse, fine in zip(*errors, strict=True):
        assert coarse / fine == pytest.approx(4)


def slope(t: float) -> float:
    return 2 - 6 * t + 12 * t**2


@quick
@given(st.tuples(*[st.floats(-5, 5)] * 3), st.floats(0.01, 2))
def test_differences_of_a_parabola_are_exact(coefficients: tuple[float, float, float], tau: float) -> None:
    a, b, c = coefficients
    times = [k * tau for k in range(6)]
    samples = [a + b * t + c * t**2 for t in times]
    assert finite_differences.first(samples, tau) == pytest.approx([b + 2 * c * t for t in times], abs=1e-10)
    assert finite_differences.second(samples, tau) == pytest.approx([2 * c] * 4, abs=1e-9)


def test_a_link_that_turns_about_two_axes_adds_squares() -> None:
    found = finite_differences.coupling_link([0.0, 0.3, 0.6, 0.9], [0.0, 0.4, 0.8, 1.2], 0.1)
    assert found.omega == pytest.approx((5, 5))
    assert found.epsilon == pytest.approx((0, 0), abs=1e-12)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (([1.0, 2.0], [1.0, 2.0], 0.1), "2 samples"),
        (([1.0, 2.0, nan], [1.0, 2.0, 3.0], 0.1), r"samples\[2\]"),
        (([1.0, 2.0, 3.0], [1.0, 2.0, 3.0], 0.0), "tau = 0.0 s"),
        (([1.0, 2.0, 3.0], [1.0, 2.0, 3.0, 4.0], 0.1), "3 samples and beta 4"),
    ],
)
def test_samples_that_say_nothing_are_refused(values: tuple[list[float], list[float], float], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        finite_differences.coupling_link(*values)


@quick
@given(st.floats(-3, 3), st.floats(-20, 20), st.floats(-50, 50))
def test_transfer_functions_and_rates_of_the_driver_give_the_motion(angle: float, rate: float, second: float) -> None:
    for unit, motion in (
        (slider_crank.solve(0.1, 0.3, angle, 1.0), slider_crank.solve(0.1, 0.3, angle, rate, second)),
        (
            four_bar.solve(0.1, 0.4, 0.3, 0.35, angle, omega1=1.0),
            four_bar.solve(0.1, 0.4, 0.3, 0.35, angle, omega1=rate, epsilon1=second),
        ),
    ):
        for name, one in transfer.of_unit_motion(unit).items():
            assert one.rate(rate) == pytest.approx(motion.vel[name], rel=1e-9, abs=1e-10)
            assert one.acceleration(rate, second) == pytest.approx(motion.acc[name], rel=1e-9, abs=1e-9)


def test_a_gear_before_the_driver_counts_once_and_squared() -> None:
    assert Transfer(2.0, 5.0).behind(-1 / 3) == Transfer(-2 / 3, pytest.approx(5 / 9))  # type: ignore[arg-type]
