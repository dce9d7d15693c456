"""R. L. Norton, Design of Machinery, 5th edition, McGraw-Hill 2012, examples 4-1, 4-2, 6-7 and 7-1.

Four-bar with crank 40, coupler 120, rocker 80 and frame 100 mm at 40 degrees, driven at 25 rad/s and 15 rad/s^2;
slider-crank with crank 40, rod 120 and offset -20 mm at 60 degrees. Norton's rod angle is that of the vector from the
slider to the crank pin.
"""

from __future__ import annotations

from math import degrees, pi, radians

import pytest

from mechanics import four_bar, newton_linkages, slider_crank
from mechanics.four_bar import Mode
from mechanics.linkage import principal
from mechanics.slider_crank import Branch

BARS = (0.04, 0.12, 0.08, 0.1)


@pytest.mark.parametrize(
    ("mode", "coupler", "rocker"), [("C_left_of_BD", 20.298, 57.325), ("C_right_of_BD", -60.98, -98.01)]
)
def test_both_circuits_of_example_4_1(mode: Mode, coupler: float, rocker: float) -> None:
    found = four_bar.position(*BARS, radians(40), mode)
    assert degrees(found.coupler_angle) == pytest.approx(coupler, abs=6e-3)
    assert degrees(found.rocker_angle) == pytest.approx(rocker, abs=6e-3)
    bodies = newton_linkages.four_bar_motion(*BARS, radians(40), 25.0, 15.0, mode)
    assert degrees(principal(bodies.poses[3][2])) == pytest.approx(rocker, abs=6e-3)


def test_angular_velocities_of_example_6_7_and_accelerations_of_example_7_1() -> None:
    found = four_bar.solve(*BARS, radians(40), 25.0, 15.0)
    assert (found.vel["alpha2"], found.vel["alpha3"]) == pytest.approx((-4.121, 6.998), abs=5e-4)
    assert (found.acc["alpha2"], found.acc["alpha3"]) == pytest.approx((296.089, 470.134), abs=6e-4)


@pytest.mark.parametrize(
    ("branch", "angle", "slider"), [("slider_right", 152.91, 126.84), ("slider_left", 27.09, -86.84)]
)
def test_both_circuits_of_example_4_2(branch: Branch, angle: float, slider: float) -> None:
    found = slider_crank.position(0.04, 0.12, radians(60), -0.02, branch)
    assert degrees(principal(found.rod_angle + pi)) == pytest.approx(angle, abs=5e-3)
    assert 1e3 * found.slider == pytest.approx(slider, abs=5e-3)
