"""The general planar mechanism: against closed forms, differences, and mechanisms that the formulas do not know."""

from __future__ import annotations

from cmath import exp
from math import atan2, cos, degrees, hypot, inf, nan, pi, radians, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import planar, slider_crank
from mechanics.errors import AssemblyError, SingularError
from mechanics.newton_linkages import four_bar_joints
from mechanics.planar import Driver, Joint, Marker, Motion, Prismatic, Revolute
from mechanics.slider_crank import Branch
from tests.depth import amount

lengths = st.floats(0.02, 2)
angles = st.floats(-10, 10)
rates = st.floats(-30, 30)
branches: st.SearchStrategy[Branch] = st.sampled_from(["slider_right", "slider_left"])


@settings(max_examples=amount(13, 40), deadline=None)
@given(
    crank=lengths,
    ratio=st.floats(1.4, 10),
    angle=angles,
    omega=rates,
    epsilon=rates,
    shift=st.floats(-0.3, 0.3),
    branch=branches,
)
def test_newton_agrees_with_the_closed_form(
    crank: float, ratio: float, angle: float, omega: float, epsilon: float, shift: float, branch: Branch
) -> None:
    rod, offset = crank * ratio, crank * shift
    newton = planar.slider_crank(crank, rod, angle, omega, epsilon, offset, branch)
    closed = slider_crank.solve(crank, rod, angle, omega, epsilon, offset, branch)
    assert cos(newton.rod_angle - closed.pos["alpha2"]) == pytest.approx(1, abs=1e-12)
    assert newton.slider == pytest.approx(closed.pos["slider_x"], rel=1e-9, abs=1e-12)
    scale = 1 + omega**2 + abs(epsilon)
    assert newton.rod_speed == pytest.approx(closed.vel["alpha2"], rel=1e-9, abs=1e-11 * scale)
    assert newton.slider_speed == pytest.approx(closed.vel["slider_x"], rel=1e-9, abs=1e-11 * scale)
    assert newton.rod_acceleration == pytest.approx(closed.acc["alpha2"], rel=1e-9, abs=1e-11 * scale)
    assert newton.slider_acceleration == pytest.approx(closed.acc["slider_x"], rel=1e-9, abs=1e-11 * scale)


def test_a_point_of_the_rod_moves_as_in_the_closed_form() -> None:
    motion = planar.slider_crank_motion(0.1, 0.3, 0.8, 20.0, 50.0, 0.02)
    closed = slider_crank.solve(0.1, 0.3, 0.8, 20.0, 50.0, 0.02, point_S_fraction_of_l2=0.4)
    place, velocity, acceleration = motion.point(Marker(2, 0.12))
    assert place == pytest.approx((closed.pos["S_x"], closed.pos["S_y"]))
    assert velocity == pytest.approx((closed.vel["S_x"], closed.vel["S_y"]))
    assert acceleration == pytest.approx((closed.acc["S_x"], closed.acc["S_y"]))


def _four_bar(time: float) -> Motion:
    """VP-4: crank, coupler, rocker, driven at a constant angular acceleration from the published state."""
    l1, l2, l3, l4 = 0.1, 0.26, 0.22, 0.3
    angle = radians(60) + 12 * time - 4 * time**2
    joints: list[Joint] = [
        Revolute(Marker(0), Marker(1)),
        Revolute(Marker(1, l1), Marker(2)),
        Revolute(Marker(2, l2), Marker(3, l3)),
        Revolute(Marker(0, l4), Marker(3)),
        Driver("turn", Marker(0), Marker(1), angle, 12 - 8 * time, -8.0),
    ]
    return planar.solve(joints, [(0, 0, angle), (0.05, 0.09, 0.5), (l4, 0, 1.7)])


def test_published_four_bar_holds() -> None:
    motion = _four_bar(0.0)
    assert [degrees(pose[2]) for pose in motion.poses[2:]] == pytest.approx([30.47575, 96.76635], abs=1e-5)
    assert [rate[2] for rate in motion.rates[2:]] == pytest.approx([-3.017217, 2.935742], rel=1e-6)
    assert [rate[2] for rate in motion.accelerations[2:]] == pytest.approx([46.50221, 68.21388], rel=1e-6)


def _rocking_slide(time: float) -> Motion:
    """VP-1: crank on a slide that turns about a pivot below; the slide's guide is carried by a moving body."""
    l0, l1 = 0.4, 0.15
    angle, omega = radians(30) + 10 * time + 2 * time**2, 10 + 4 * time
    joints: list[Joint] = [
        Revolute(Marker(0, 0, l0), Marker(1)),
        Revolute(Marker(1, l1), Marker(2)),
        Revolute(Marker(0), Marker(3)),
        Prismatic(Marker(3), Marker(2)),
        Driver("turn", Marker(0), Marker(1), angle, omega, 4.0),
    ]
    return planar.solve(joints, [(0, l0, angle), (0.1, 0.5, 1.3), (0, 0, 1.3)])


def test_published_rocking_slide_holds() -> None:
    motion = _rocking_slide(0.0)
    (x, y, angle), (vx, vy, omega), (ax, ay, epsilon) = motion.poses[2], motion.rates[2], motion.accelerations[2]
    length, speed = hypot(x, y), vx * cos(angle) + vy * sin(angle)
    assert length == pytest.approx(0.4924429, rel=1e-6)
    assert degrees(angle) == pytest.approx(74.70466, abs=1e-5)
    assert speed == pytest.approx(1.055179, rel=1e-6)
    assert omega == pytest.approx(2.164948, rel=1e-6)
    assert ax * cos(angle) + ay * sin(angle) + length * omega**2 == pytest.approx(-7.930983, rel=1e-6)
    assert epsilon == pytest.approx(13.01555, rel=1e-6)


def _actuator(time: float) -> Motion:
    """VP-9 mirrored: A and C on the frame, a slide of growing length between A and B, a lever CB."""
    length, rate, acceleration = 0.6 + 0.05 * time + 0.005 * time**2, 0.05 + 0.01 * time, 0.01
    joints: list[Joint] = [
        Revolute(Marker(0), Marker(1)),
        Prismatic(Marker(1), Marker(2)),
        Revolute(Marker(2), Marker(3, 0.5)),
        Revolute(Marker(0, 0.8), Marker(3)),
        Driver("slide", Marker(1), Marker(2), length, rate, acceleration),
    ]
    return planar.solve(joints, [(0, 0, 0.6), (0.5, 0.4, 0.6), (0.8, 0, 2.3)])


def test_published_linear_drive_holds() -> None:
    motion = _actuator(0.0)
    assert degrees(motion.poses[1][2]) == pytest.approx(38.62483, abs=1e-5)
    assert 180 - degrees(motion.poses[3][2]) == pytest.approx(48.50918, abs=1e-5)
    assert -motion.rates[3][2] == pytest.approx(0.1001252, rel=1e-6)
    assert -motion.accelerations[3][2] == pytest.approx(0.01950225, rel=1e-6)


@pytest.mark.parametrize("mechanism", [_four_bar, _rocking_slide, _actuator])
@pytest.mark.parametrize("time", [0.0, 0.01, 0.03])
def test_rates_are_the_slopes_of_positions_and_rates(mechanism: object, time: float) -> None:
    assert callable(mechanism)
    h = 1e-5
    before, now, after = (mechanism(time + k * h) for k in (-1, 0, 1))
    for marker in (Marker(1, 0.1, -0.2), Marker(2, 0.3, 0.1), Marker(3, -0.1, 0.2)):
        (earlier, v_earlier, _), (_, v, a), (later, v_later, _) = (s.point(marker) for s in (before, now, after))
        assert v == pytest.approx([(y - x) / (2 * h) for x, y in zip(earlier, later, strict=True)], rel=1e-6, abs=1e-6)
        slopes = [(y - x) / (2 * h) for x, y in zip(v_earlier, v_later, strict=True)]
        assert a == pytest.approx(slopes, rel=1e-6, abs=1e-5)


def test_a_slide_on_a_turning_link_has_coriolis_acceleration() -> None:
    joints: list[Joint] = [
        Revolute(Marker(0), Marker(1)),
        Driver("turn", Marker(0), Marker(1), 0.5, 2.0, 0.3),
        Prismatic(Marker(1, 0.4, 0.1, angle=0.7), Marker(2)),
        Driver("slide", Marker(1, 0.4, 0.1, angle=0.7), Marker(2), 0.25, 1.5, -0.2),
    ]
    motion = planar.solve(joints, [(0, 0, 0.4), (0.5, 0.5, 1.0)])
    base = complex(0.4, 0.1) * exp(0.5j)
    slide = exp(1.2j)
    place, velocity, acceleration = motion.point(Marker(2))
    r = base + 0.25 * slide
    assert complex(*place) == pytest.approx(r)
    assert complex(*velocity) == pytest.approx(2j * r + 1.5 * slide)
    assert complex(*acceleration) == pytest.approx((0.3j - 4) * r + (2 * 2j * 1.5 - 0.2) * slide)


def test_the_guess_chooses_the_assembly() -> None:
    right = planar.slider_crank(0.1, 0.3, 1.0, 2.0)
    left = planar.slider_crank(0.1, 0.3, 1.0, 2.0, branch="slider_left")
    assert right.slider > 0.1 * cos(1.0) > left.slider
    assert cos(right.rod_angle) == pytest.approx(-cos(left.rod_angle))


def test_a_second_turn_of_the_crank_repeats_the_first() -> None:
    once, twice = (planar.slider_crank(0.1, 0.3, 1.0 + turn, 2.0) for turn in (0.0, 2 * pi))
    assert (once.slider, once.rod_angle) == pytest.approx((twice.slider, twice.rod_angle), rel=1e-12)
    assert atan2(sin(once.rod_angle), cos(once.rod_angle)) == pytest.approx(once.rod_angle)


def test_short_rod_cannot_be_assembled() -> None:
    with pytest.raises(AssemblyError, match="cannot be assembled"):
        planar.slider_crank(0.13, 0.05, pi / 2, 1.0)


def test_two_points_that_never_meet_cannot_be_assembled() -> None:
    joints: list[Joint] = [
        Revolute(Marker(0), Marker(1)),
        Driver("slide", Marker(0, 5.0), Marker(1, 1.0), 0.0),
    ]
    with pytest.raises(AssemblyError, match="stay"):
        planar.solve(joints, [(0, 0, 0.3)])


def _arm_reaching(x: float, guess: float) -> Motion:
    """An arm of 1 m whose tip is driven to an abscissa."""
    joints: list[Joint] = [Revolute(Marker(0), Marker(1)), Driver("slide", Marker(0), Marker(1, 1.0), x, 0.5)]
    return planar.solve(joints, [(0, 0, guess)])


@pytest.mark.parametrize(
    ("bars", "angle", "guess"),
    [
        (
            (0.19338991806459402, 0.012742942418480022, 1.3030204160239092, 1.124076479574071),
            9.281025310673364,
            1.9594737928750157,
        ),
        (
            (0.10647568432836879, 0.11445968664051645, 1.2963149550321853, 1.2874041771697997),
            6.409660715561877,
            0.20537074622319934,
        ),
    ],
)
def test_the_last_step_near_a_dead_position_does_not_open_the_joints_again(
    bars: tuple[float, float, float, float], angle: float, guess: float
) -> None:
    joints = four_bar_joints(*bars, angle, 1.0, 0.0)
    pin = (bars[0] * cos(angle), bars[0] * sin(angle))
    poses = planar.assemble(joints, [(0, 0, angle), (*pin, guess), (bars[3], 0, guess + 1)])
    gaps = [row.residual for joint in joints for row in joint.rows(poses, [planar.FRAME] * 4)]
    assert gaps == pytest.approx([0.0] * 9, abs=2e-11)


def test_an_arm_driven_by_its_tip_turns_to_the_arc_cosine() -> None:
    motion = _arm_reaching(0.3, 1.0)
    assert cos(motion.poses[1][2]) == pytest.approx(0.3)
    assert motion.rates[1][2] == pytest.approx(-0.5 / sin(motion.poses[1][2]))


def test_a_guess_that_cannot_be_left_is_not_an_assembly() -> None:
    with pytest.raises(AssemblyError, match=r"from this guess: its joints stay 0\.7"):
        _arm_reaching(0.3, 0.0)


def test_a_stretched_arm_driven_by_its_tip_is_a_dead_position() -> None:
    with pytest.raises(SingularError, match="dead position"):
        _arm_reaching(1.0, 0.0)


def test_rod_perpendicular_to_the_guide_is_a_dead_position() -> None:
    with pytest.raises(SingularError, match="dead position"):
        planar.slider_crank(0.1, 0.1, pi / 2, 1.0)


def test_a_missing_driver_is_refused() -> None:
    with pytest.raises(ValueError, match="2 equations of joints and drivers for 3 coordinates"):
        planar.solve([Revolute(Marker(0), Marker(1))], [(0, 0, 0)])


@pytest.mark.parametrize(
    ("place", "name"), [(0, "l1"), (1, "l2"), (2, "alpha1"), (3, "omega1"), (4, "eps1"), (5, "offset")]
)
@pytest.mark.parametrize("value", [nan, inf])
def test_values_that_are_not_finite_are_refused_by_name(place: int, name: str, value: float) -> None:
    values = [0.1, 0.3, 0.5, 1.0, 1.0, 0.0]
    values[place] = value
    with pytest.raises(ValueError, match=name):
        planar.slider_crank(*values)  # type: ignore[arg-type]


def test_an_unknown_branch_and_a_guess_that_is_not_finite_are_refused() -> None:
    with pytest.raises(ValueError, match="branch"):
        planar.slider_crank(0.1, 0.3, 0.5, 1.0, branch="up")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="guess phi of body 1"):
        planar.solve([], [(0, 0, nan)])
