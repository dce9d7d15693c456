"""Cardan joints against the vectors of the cross, finite differences, a scan of the turn, and the domain's numbers."""

from __future__ import annotations

from math import acos, atan2, cos, degrees, inf, nan, pi, radians, sin, tan

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import hooke_joint
from mechanics.errors import SingularError
from mechanics.linkage import principal
from tests.depth import amount

quick = settings(max_examples=amount(20, 60), deadline=None)
betas = st.floats(-1.4, 1.4)
angles = st.floats(-9, 9)
rates = st.floats(-50, 50)


@quick
@given(betas, angles)
def test_the_arms_of_the_cross_stay_perpendicular(beta: float, gamma1: float) -> None:
    """The first arm turns about X, the second about an axis turned by beta in the plane XY; Y is in the plane."""
    gamma2 = hooke_joint.solve(beta, gamma1).pos["gamma2"]
    first = (0.0, cos(gamma1), sin(gamma1))
    second = (sin(gamma2) * sin(beta), -sin(gamma2) * cos(beta), cos(gamma2))  # starts along Z
    assert sum(one * other for one, other in zip(first, second, strict=True)) == pytest.approx(0, abs=1e-12)


@quick
@given(betas, angles, rates, rates)
def test_rates_are_the_derivatives_of_the_angle(beta: float, gamma1: float, omega: float, epsilon: float) -> None:
    h = 1e-5
    found = hooke_joint.solve(beta, gamma1, omega, epsilon)
    before, after = (hooke_joint.solve(beta, gamma1 + step, 1.0) for step in (-h, h))
    ratio = (after.pos["gamma2"] - before.pos["gamma2"]) / (2 * h)
    slope = (after.vel["gamma2"] - before.vel["gamma2"]) / (2 * h)
    assert found.vel["gamma2"] == pytest.approx(ratio * omega, rel=1e-6, abs=1e-6)
    assert found.acc["gamma2"] == pytest.approx(slope * omega**2 + ratio * epsilon, rel=1e-5, abs=1e-3)


@quick
@given(betas, angles)
def test_the_driven_shaft_stays_in_the_half_turn_of_the_driving_one(beta: float, gamma1: float) -> None:
    gamma2 = hooke_joint.solve(beta, gamma1).pos["gamma2"]
    assert abs(gamma2 - gamma1) < pi / 2
    assert principal(gamma2 - atan2(sin(gamma1), cos(gamma1) * cos(beta))) == pytest.approx(0, abs=1e-12)


@quick
@given(betas, angles, st.integers(-2, 2))
def test_half_a_turn_repeats_the_motion(beta: float, gamma1: float, half: int) -> None:
    one, other = (hooke_joint.solve(beta, gamma1 + k * pi, 3.0) for k in (0, half))
    assert other.pos["gamma2"] - one.pos["gamma2"] == pytest.approx(half * pi, abs=1e-9)
    assert other.vel["gamma2"] == pytest.approx(one.vel["gamma2"], rel=1e-9)


def test_the_ratio_is_one_where_the_squared_tangent_is_the_cosine() -> None:
    beta = 0.6
    gamma1 = atan2(cos(beta) ** 0.5, 1)
    assert hooke_joint.solve(beta, gamma1, 1.0).vel["gamma2"] == pytest.approx(1, rel=1e-12)


@pytest.mark.parametrize("phase", [0.0, 0.4, pi / 2, 2.0])
@pytest.mark.parametrize(("beta1", "beta2"), [(0.5, 0.35), (0.5, 0.5), (0.0, 1.2)])
def test_the_range_of_a_double_joint_is_met_in_a_turn(beta1: float, beta2: float, phase: float) -> None:
    scanned = [
        hooke_joint.double(beta1, beta2, step * pi / 2000, 1.0, phase=phase).vel["gamma3"] for step in range(2000)
    ]
    found = hooke_joint.double_ratio_range(beta1, beta2, phase)
    assert (min(scanned), max(scanned)) == pytest.approx((found.least, found.greatest), rel=1e-5)
    assert found.least - 1e-12 <= min(scanned) and max(scanned) <= found.greatest + 1e-12


@quick
@given(betas, angles, rates, rates)
def test_equal_angles_in_phase_pass_the_motion_on_unchanged(
    beta: float, gamma1: float, omega: float, epsilon: float
) -> None:
    found = hooke_joint.double(beta, beta, gamma1, omega, epsilon)
    assert found.pos["gamma3"] == pytest.approx(gamma1, abs=1e-12)
    assert found.vel["gamma3"] == pytest.approx(omega, rel=1e-12)
    assert found.acc["gamma3"] == pytest.approx(epsilon, rel=1e-9, abs=1e-8 * omega**2)
    whole = hooke_joint.double_ratio_range(beta, beta)
    assert (whole.least, whole.greatest) == (1, 1)


@quick
@given(betas, betas, angles)
def test_aligned_forks_multiply_the_tangents(beta1: float, beta2: float, gamma1: float) -> None:
    gamma3 = hooke_joint.double(beta1, beta2, gamma1).pos["gamma3"]
    expected = atan2(sin(gamma1) * cos(beta2), cos(gamma1) * cos(beta1))
    assert principal(gamma3 - expected) == pytest.approx(0, abs=1e-12)


def test_a_joint_of_the_domain() -> None:
    """TR-7."""
    found = hooke_joint.solve(radians(30), radians(50), 100)
    assert degrees(found.pos["gamma2"]) == pytest.approx(53.99478518, rel=1e-9)
    assert tan(found.pos["gamma2"]) * cos(radians(30)) == pytest.approx(tan(radians(50)))
    assert found.singular.measure == pytest.approx(cos(radians(30)))
    assert acos(hooke_joint.ratio_range(radians(30)).least) == pytest.approx(radians(30))


@pytest.mark.parametrize("beta", [pi / 2, -pi / 2, 2.0])
def test_shafts_at_a_right_angle_cannot_turn(beta: float) -> None:
    with pytest.raises(SingularError, match="beta = "):
        hooke_joint.solve(beta, 0.3)


@pytest.mark.parametrize(
    ("values", "message"), [((nan, 0.0), "beta"), ((0.1, inf), "gamma1"), ((0.1, 0.0, nan), "omega1")]
)
def test_numbers_that_are_not_finite_are_refused_by_name(values: tuple[float, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        hooke_joint.solve(*values)
