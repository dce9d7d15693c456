"""A mechanism along its driver: it keeps its assembly, returns after a turn, and stops at the known dead positions."""

from __future__ import annotations

from math import acos, cos, pi, sin

import pytest

from mechanics import four_bar, slider_crank
from mechanics.cycle import follow
from mechanics.errors import AssemblyError
from mechanics.four_bar import Mode
from mechanics.newton_linkages import four_bar_joints, four_bar_motion
from mechanics.planar import Driver, Joint, Marker, Prismatic, Revolute

BARS = (0.1, 0.26, 0.22, 0.3)
TURN = [2 * pi * k / 36 for k in range(37)]


@pytest.mark.parametrize("mode", ["C_left_of_BD", "C_right_of_BD"])
def test_the_assembly_is_kept_and_closes_over_a_full_cycle(mode: Mode) -> None:
    start = four_bar_motion(*BARS, 0.0, 2.0, mode=mode)
    course = follow(lambda angle: four_bar_joints(*BARS, angle, 2.0, 0.0), TURN, start.poses[1:])
    assert course.dead is None
    for angle, motion in zip(TURN, course.motions, strict=True):
        closed = four_bar.solve(*BARS, angle, 2.0, 0.0, mode)
        for body, name in ((2, "alpha2"), (3, "alpha3")):
            assert cos(motion.poses[body][2] - closed.pos[name]) == pytest.approx(1, abs=1e-15)
        (end_2, _, _), (end_3, _, _) = motion.point(Marker(2, BARS[1])), motion.point(Marker(3, BARS[2]))
        assert end_2 == pytest.approx(end_3, abs=1e-14)
    first, last = course.motions[0], course.motions[-1]
    assert [pose[2] for pose in last.poses[2:]] == pytest.approx([pose[2] for pose in first.poses[2:]])


def test_a_rocker_driven_stops_at_its_dead_position() -> None:
    bars = (0.26, 0.1, 0.22, 0.3)
    near, far = four_bar.dead_positions(*bars)
    assert far == pytest.approx(acos((0.26**2 + 0.3**2 - 0.32**2) / (2 * 0.26 * 0.3)))
    start = four_bar_motion(*bars, 0.6, 1.0)
    for direction, dead in ((1, far), (-1, near)):
        values = [0.6 + direction * k * 0.1 for k in range(20)]
        course = follow(lambda angle: four_bar_joints(*bars, angle, 1.0, 0.0), values, start.poses[1:])
        assert course.dead == pytest.approx(dead, abs=1e-8)
        assert len(course.motions) == sum(abs(value - 0.6) < abs(dead - 0.6) for value in values)
        measures = [motion.singular.measure for motion in course.motions]
        assert 0 < measures[-1] < 1


def test_a_short_rod_stops_where_it_is_perpendicular_to_the_guide() -> None:
    def joints(angle: float) -> list[Joint]:
        return [
            Revolute(Marker(0), Marker(1)),
            Revolute(Marker(1, 0.2), Marker(2)),
            Revolute(Marker(2, 0.15), Marker(3)),
            Prismatic(Marker(0, 0.0, 0.03), Marker(3)),
            Driver("turn", Marker(0), Marker(1), angle, 1.0),
        ]

    course = follow(joints, [0.1 * k for k in range(30)], [(0, 0, 0), (0.2, 0, 0), (0.35, 0.03, 0)])
    dead = [angle for angle in slider_crank.dead_positions(0.2, 0.15, 0.03) if angle > 0]
    assert course.dead == pytest.approx(min(dead), abs=1e-8)
    assert sin(min(dead)) == pytest.approx((0.03 + 0.15) / 0.2)


def test_a_mechanism_that_does_not_close_at_the_start_is_refused() -> None:
    with pytest.raises(AssemblyError):
        follow(lambda angle: four_bar_joints(0.1, 0.1, 0.1, 0.9, angle, 1.0, 0.0), TURN, [(0, 0, 0)] * 3)


def test_the_measure_of_a_mechanism_falls_to_zero_at_its_dead_position() -> None:
    bars = (0.26, 0.1, 0.22, 0.3)
    dead = four_bar.dead_positions(*bars)[1]
    measures = [four_bar_motion(*bars, dead - away, 1.0).singular.measure for away in (1e-1, 1e-3, 1e-5)]
    assert measures[0] > 5 * measures[1] > 25 * measures[2]
