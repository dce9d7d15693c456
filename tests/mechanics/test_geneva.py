"""Geneva drives against the geometry of the pin, finite differences, and the limits of a turn."""

from __future__ import annotations

from math import atan2, cos, hypot, nan, pi, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import geneva
from mechanics.geneva import Geneva
from mechanics.linkage import LinkageMotion
from tests.depth import amount

quick = settings(max_examples=amount(20, 60), deadline=None)
drives = st.builds(Geneva, st.integers(3, 20), st.floats(0.01, 2))
shares = st.floats(-0.999, 0.999)


@quick
@given(drives, shares)
def test_the_slot_points_at_the_pin(drive: Geneva, share: float) -> None:
    theta = share * drive.engaged_within
    x, y = drive.crank * cos(theta) - drive.centre_distance, drive.crank * sin(theta)  # from the wheel centre
    phi = geneva.solve(drive.slots, drive.centre_distance, theta).pos["phi"]
    assert phi == pytest.approx(atan2(y, -x), abs=1e-12)
    assert hypot(x, y) <= drive.reach * (1 + 1e-12)


@quick
@given(drives, st.floats(-0.99, 0.99), st.floats(-20, 20), st.floats(-20, 20))
def test_rates_are_the_derivatives_of_the_angle(drive: Geneva, share: float, omega: float, epsilon: float) -> None:
    h, theta = 1e-6, share * drive.engaged_within

    def at(alpha1: float, *rates: float) -> LinkageMotion:
        return geneva.solve(drive.slots, drive.centre_distance, alpha1, *rates)

    found, before, after = at(theta, omega, epsilon), at(theta - h, 1.0), at(theta + h, 1.0)
    ratio = (after.pos["phi"] - before.pos["phi"]) / (2 * h)
    slope = (after.vel["phi"] - before.vel["phi"]) / (2 * h)
    assert found.vel["phi"] == pytest.approx(ratio * omega, rel=1e-5, abs=1e-6)
    assert found.acc["phi"] == pytest.approx(slope * omega**2 + ratio * epsilon, rel=1e-4, abs=1e-3)


@quick
@given(drives)
def test_the_pin_enters_square_to_the_slot_with_the_wheel_at_rest(drive: Geneva) -> None:
    entry = geneva.solve(drive.slots, 1.0, -drive.engaged_within * (1 - 1e-12), 7.0)
    assert entry.pos["phi"] == pytest.approx(-pi / drive.slots)
    assert entry.vel["phi"] == pytest.approx(0, abs=1e-9)
    assert entry.acc["phi"] == pytest.approx(49 * drive.entry_acceleration, rel=1e-9)
    assert entry.singular.measure == pytest.approx(0, abs=1e-9)
    assert drive.crank**2 + drive.reach**2 == pytest.approx(drive.centre_distance**2)


@quick
@given(drives, st.floats(1.0001, 1.9))
def test_the_wheel_rests_while_the_pin_is_out(drive: Geneva, share: float) -> None:
    theta = drive.engaged_within * share
    dwell = geneva.solve(drive.slots, 1.0, min(theta, pi), 5.0, 2.0)
    assert (dwell.pos["phi"], dwell.vel["phi"], dwell.acc["phi"]) == (pi / drive.slots, 0, 0)
    assert geneva.solve(drive.slots, 1.0, -min(theta, 3.1)).pos["phi"] == -pi / drive.slots


@quick
@given(drives)
def test_the_line_of_centres_has_the_greatest_ratio(drive: Geneva) -> None:
    middle = geneva.solve(drive.slots, 1.0, 4 * pi, 1.0)
    assert middle.vel["phi"] == pytest.approx(drive.greatest_ratio, rel=1e-9)
    assert middle.singular.measure == pytest.approx(1)
    assert drive.motion_share == pytest.approx(drive.engaged_within / pi)
    assert drive.most_pins * drive.motion_share <= 1 + 1e-12 < (drive.most_pins + 1) * drive.motion_share + 1e-9


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ((2, 1.0, 0.0), "slots = 2"),
        ((4, 0.0, 0.0), "centre_distance"),
        ((4, 1.0, nan), "alpha1"),
        ((4, 1.0, 0.0, nan), "omega1"),
    ],
)
def test_impossible_drives_are_refused_by_name(values: tuple[float, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        geneva.solve(*values)  # type: ignore[arg-type]
