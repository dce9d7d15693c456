"""Balancing: what is left after correction, a mass centre that rests, and the domain's examples."""

from __future__ import annotations

from cmath import rect
from math import cos, degrees, hypot, nan, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics import balancing
from mechanics.balancing import FourBarLinks, Plane, PointMass, balance, four_bar, opposite, three_points, two_points
from mechanics.planar import Driver, Marker, Revolute, solve
from mechanics.vectors import Vector

masses = st.lists(
    st.builds(PointMass, st.floats(0, 5), st.floats(0.01, 0.5), st.floats(-7, 7), st.floats(-1, 1)),
    min_size=1,
    max_size=6,
)


@given(masses, st.floats(-1, 0), st.floats(0.1, 1))
def test_two_planes_leave_no_force_and_no_couple(rotor: list[PointMass], x_I: float, x_II: float) -> None:
    planes = (Plane(x_I, 0.1), Plane(x_II, 0.2))
    found = balance(rotor, planes)
    added = [rect(c.mr, c.angle) for c in found.corrections]
    size = sum(abs(mass.unbalance) for mass in rotor) * 30 + 1e-12
    assert abs(sum(m.unbalance for m in rotor) + sum(added)) <= 1e-12 * size
    couple = sum(m.x * m.unbalance for m in rotor) + sum(p.x * D for p, D in zip(planes, added, strict=True))
    assert abs(couple) <= 1e-12 * size
    assert found.residual_force <= 1e-12 * size and not found.static
    assert all(c.mr == pytest.approx(c.m * plane.r) for c, plane in zip(found.corrections, planes, strict=True))


def test_a_rotor_of_the_domain_in_two_planes() -> None:
    """BV-5."""
    data = zip((0.08, 0.05, 0.06), (0.12, 0.15, 0.1), (20, 140, 255), (0.1, 0.25, 0.4), strict=True)
    rotor = [PointMass(m, r, radians(angle), x) for m, r, angle, x in data]
    one, two = balance(rotor, (Plane(0, 0.15), Plane(0.5, 0.15))).corrections
    assert (one.m, degrees(one.angle) % 360) == pytest.approx((0.03730306795, 223.8737855), rel=1e-9)
    assert (two.m, degrees(two.angle)) == pytest.approx((0.01862194846, 34.18136706), rel=1e-9)
    stage = balance(rotor, (Plane(0.5, 0.15),))
    assert (stage.corrections[0].m, degrees(stage.corrections[0].angle) % 360) == pytest.approx(
        (0.01920457234, 233.2694501), rel=1e-9
    )
    assert stage.static and stage.residual_moment > 0


def test_a_disc_of_the_domain_in_one_plane() -> None:
    """BV-3: 32 g at 205 degrees; the couple about its own plane is nothing."""
    found = balance([PointMass(12, 0.0004, radians(25))], [Plane(0, 0.15)])
    assert (found.corrections[0].m, degrees(found.corrections[0].angle) % 360) == pytest.approx((0.032, 205))
    assert not found.static and opposite(radians(25)) == pytest.approx(radians(205 - 360))


def test_a_correction_straight_across_is_at_pi() -> None:
    """The angle of a correction is in (-pi, pi]: -pi, which a negative zero would give, is none."""
    assert balance([PointMass(1, 0.1, 0.0)], [Plane(0, 0.1)]).corrections[0].angle == pi


@given(masses, st.floats(-100, 100).filter(lambda omega: abs(omega) > 1e-100 or not omega), st.floats(-5, 5))
def test_the_bearings_feel_the_inertia_forces_of_the_turning_masses(
    rotor: list[PointMass], omega: float, turn: float
) -> None:
    places = [(m.x, m.r * cos(m.angle + turn), m.r * sin(m.angle + turn)) for m in rotor]
    inward = [(0.0, -(omega**2) * y, -(omega**2) * z) for _, y, z in places]
    force, moment = balancing.inertia_forces([m.m for m in rotor], places, inward)
    found = balancing.unbalance(rotor, omega)
    size = 1e-9 * omega**2 * (1 + sum(abs(m.unbalance) for m in rotor))
    assert found.force == pytest.approx(hypot(*force), rel=1e-9, abs=size)
    assert found.moment == pytest.approx(hypot(*moment), rel=1e-9, abs=size)
    assert moment[0] == pytest.approx(0, abs=size)


vectors = st.tuples(*[st.floats(-9, 9)] * 3)


@given(st.lists(st.tuples(st.floats(0, 9), vectors, vectors), max_size=5), vectors)
def test_inertia_forces_move_to_another_point_as_a_system_of_forces_does(
    points: list[tuple[float, Vector, Vector]], shift: Vector
) -> None:
    m, r, a = ([point[i] for point in points] for i in range(3))
    moved = [tuple(np.subtract(place, shift)) for place in r]
    force, moment = balancing.inertia_forces(m, r, a)  # type: ignore[arg-type]
    other_force, other_moment = balancing.inertia_forces(m, moved, a)  # type: ignore[arg-type]
    assert force == pytest.approx(other_force)
    assert moment == pytest.approx(np.add(other_moment, np.cross(shift, force)), abs=1e-9)


def test_the_inertia_force_of_what_brakes_points_ahead() -> None:
    force, moment = balancing.inertia_forces([2.0], [(0.0, 0.5, 0.0)], [(-3.0, 0.0, 0.0)])
    assert force == (6.0, 0.0, 0.0) and moment == (0.0, 0.0, -3.0)  # above the origin it turns clockwise


@pytest.mark.parametrize(
    ("rotor", "x_S", "kind"),
    [
        ([PointMass(0.2, 0.05, 0.7, 0.1), PointMass(0.1, 0.1, 0.7 + pi, 0.1)], 0.4, "balanced"),  # left of x_S
        ([PointMass(1, 0.1, 0), PointMass(1, 0.1, pi)], 0.0, "balanced"),
        ([PointMass(1, 0.1, 0)], 0.0, "static"),
        ([PointMass(1, 0.1, 0, 0.3)], 0.3, "static"),
        ([PointMass(1, 0.1, 0, 0.3)], 0.0, "dynamic"),
        ([PointMass(1, 0.1, 0, 0.3), PointMass(1, 0.1, pi, -0.2)], 0.0, "moment"),
        ([], 0.0, "balanced"),
    ],
)
def test_the_class_of_an_unbalance(rotor: list[PointMass], x_S: float, kind: str) -> None:
    assert balancing.unbalance(rotor, 5.0, x_S).kind == kind


def test_static_unbalance_of_the_domain() -> None:
    """BV-2, BV-4."""
    found = balancing.unbalance([PointMass(12, 0.0004, 1.0)], 3000 * pi / 30)
    assert (abs(found.static), found.force) == pytest.approx((0.0048, 473.7410113), rel=1e-9)
    first, second = balancing.shared_by_planes(0.0048, 0.1, 0.25)
    assert (first / 0.15, second / 0.12) == pytest.approx((0.02285714286, 0.01142857143), rel=1e-9)
    assert first + second == pytest.approx(0.0048) and first * 0.1 == pytest.approx(second * 0.25)


def test_masses_that_stand_for_a_link() -> None:
    """BV-6: mass, centre, and for three points the inertia are restored."""
    two, three = two_points(1.2, 0.12, 0.18, 0.009), three_points(1.2, 0.12, 0.18, 0.009)
    assert (two.m_A, two.m_B, two.defect) == pytest.approx((0.72, 0.48, -0.01692))
    assert (three.m_A, three.m_B, three.m_S) == pytest.approx((0.25, 0.1666666667, 0.7833333333))
    for found in (two, three):
        assert found.m_A + found.m_B + found.m_S == pytest.approx(1.2)
        assert found.m_A * 0.12 == pytest.approx(found.m_B * 0.18)
    assert three.m_A * 0.12**2 + three.m_B * 0.18**2 == pytest.approx(0.009)


def test_the_centre_of_a_balanced_four_bar_rests_over_a_turn() -> None:
    """BV-7, moved as a general planar mechanism."""
    links = FourBarLinks(0.1, 0.26, 0.22, 0.3, 0.5, 1.0, 0.8, 0.04, 0.12, 0.1)
    found = four_bar(links, 0.08, 0.1)
    assert (found.m1k, found.m2k) == pytest.approx((0.9230769231, 1.815384615), rel=1e-9)
    assert (found.m_I, found.m_II, found.x_S) == pytest.approx((1.961538462, 3.076923077, 0.1832061069), rel=1e-9)
    guess = [(0.0, 0.0, 0.0), (0.1, 0.0, 0.8), (0.3, 0.0, 1.6)]
    for step in range(24):
        turn = step * pi / 12
        motion = solve(
            [
                Revolute(Marker(0), Marker(1)),
                Revolute(Marker(1, 0.1), Marker(2)),
                Revolute(Marker(2, 0.26), Marker(3, 0.22)),
                Revolute(Marker(0, 0.3), Marker(3)),
                Driver("turn", Marker(0), Marker(1), turn),
            ],
            guess,
        )
        guess = list(motion.poses[1:])
        carried = [(0.5, Marker(1, 0.04)), (found.m1k, Marker(1, -0.08)), (1.0, Marker(2, 0.12)), (0.8, Marker(3, 0.1))]
        carried.append((found.m2k, Marker(3, -0.1)))
        total = sum(m for m, _ in carried)
        centre = [sum(m * motion.point(at)[0][axis] for m, at in carried) / total for axis in (0, 1)]
        assert centre == pytest.approx([found.x_S, 0], abs=1e-12)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: PointMass(-1, 1, 0), "not be negative"),
        (lambda: PointMass(1, nan, 0), "mass: r"),
        (lambda: Plane(0, 0), "plane: r"),
        (lambda: balance([], [Plane(0, 1)]), "nothing to balance"),
        (lambda: balance([PointMass(1, 1, 0)], []), "0 planes"),
        (lambda: balance([PointMass(1, 1, 0)], [Plane(1, 1), Plane(1, 1)]), "must be apart"),
        (lambda: two_points(1, 0, 1), "l_AS"),
        (lambda: three_points(1, 1, 1, 0), "J_S"),
        (lambda: FourBarLinks(0, 1, 1, 1, 1, 1, 1, 0, 0, 0), "l1"),
        (lambda: balancing.shared_by_planes(1, 0, 1), "l_I"),
        (lambda: FourBarLinks(1, 1, 1, 1, 1, -1, 1, 0, 0, 0), "m2 = -1 kg"),
        (lambda: FourBarLinks(1, 1, 1, 1, 0, 0, 0, 0, 0, 0), "without mass"),
        (lambda: four_bar(FourBarLinks(1, 1, 1, 1, 1, 1, 1, -9, 0, -9), 1, 1), "leave no mass"),
        (lambda: balancing.unbalance([], nan), "omega"),
        (lambda: balancing.inertia_forces([1], [], []), "1 masses, 0 places"),
        (lambda: balancing.inertia_forces([nan], [(0, 0, 0)], [(0, 0, 0)]), "must be finite"),
    ],
)
def test_impossible_numbers_are_refused_by_name(make: object, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        make()  # type: ignore[operator]


def test_masses_too_small_for_their_figures_leave_no_couple() -> None:
    found = balance([PointMass(2.2250738585e-313, 0.01, 0.0, 0.0)], (Plane(-1.0, 0.1), Plane(1.0, 0.2)))
    assert not found.static and found.residual_moment == 0.0
