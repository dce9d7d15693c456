"""Reduced machines against energies, powers and a run step by step; inertia forces against point masses."""

from __future__ import annotations

from math import cos, nan, pi, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import inertia_force, reactions, reduction, slider_crank
from mechanics.errors import SingularError
from mechanics.reduction import Coordinate, Reduced, slider_crank_machine
from mechanics.slider_crank import Branch
from mechanics.transfer import Transfer
from mechanics.vectors import Vector, add, cross, scaled
from tests.depth import amount
from tests.mechanics.chains import vectors

quick = settings(max_examples=amount(13, 40), deadline=None)
angles, rates = st.floats(-10, 10), st.floats(-30, 30)
loads = st.floats(-500, 500)
MASSES = {"m2": 0.9, "m3": 1.5, "J1": 0.002, "J2": 0.007}


def machine(phi: float, F3_x: float = -300.0, M1: float = 20.0, branch: Branch = "slider_right") -> Reduced:
    return slider_crank_machine(0.1, 0.3, phi, 0.03, branch, 0.4, **MASSES, F3_x=F3_x, M1=M1, gravity=9.81)


branches: st.SearchStrategy[Branch] = st.sampled_from(["slider_right", "slider_left"])


@quick
@given(angles, rates, loads, loads, branches)
def test_reduction_keeps_energy_and_power(
    phi: float, omega: float, force: float, moment: float, branch: Branch
) -> None:
    found = machine(phi, force, moment, branch)
    v = slider_crank.solve(0.1, 0.3, phi, omega, 0.0, 0.03, branch, 0.4).vel
    links = 0.002 * omega**2 + 0.007 * v["alpha2"] ** 2 + 0.9 * (v["S_x"] ** 2 + v["S_y"] ** 2)
    assert found.energy(omega) == pytest.approx((links + 1.5 * v["slider_x"] ** 2) / 2)
    power = force * v["slider_x"] + moment * omega - 0.9 * 9.81 * v["S_y"]
    assert found.M * omega == pytest.approx(power, abs=1e-9)


@quick
@given(angles, branches)
def test_the_derivative_of_the_inertia_is_its_slope(phi: float, branch: Branch) -> None:
    h = 1e-6
    slope = (machine(phi + h, branch=branch).J - machine(phi - h, branch=branch).J) / (2 * h)
    assert machine(phi).J > 0.002
    assert machine(phi, branch=branch).dJ == pytest.approx(slope, abs=1e-7)


@quick
@given(angles, rates)
def test_the_acceleration_balances_the_powers_of_all_inertia_forces(phi: float, omega: float) -> None:
    found = machine(phi)
    epsilon = found.epsilon(omega)
    moved = slider_crank.solve(0.1, 0.3, phi, omega, epsilon, 0.03, "slider_right", 0.4)
    v, a = moved.vel, moved.acc
    inertia = 0.002 * epsilon * omega + 0.007 * a["alpha2"] * v["alpha2"] + 1.5 * a["slider_x"] * v["slider_x"]
    inertia += 0.9 * (a["S_x"] * v["S_x"] + a["S_y"] * v["S_y"])
    assert inertia == pytest.approx(found.M * omega, rel=1e-7, abs=1e-6)


def test_the_energy_form_is_the_differential_form_run_step_by_step() -> None:
    omega, step = 25.0, pi / 400

    def slope(phi: float, speed: float) -> float:
        return machine(phi).epsilon(speed) / speed

    for i in range(400):  # the method of Runge and Kutta
        phi = 0.3 + i * step
        first = slope(phi, omega)
        second = slope(phi + step / 2, omega + step / 2 * first)
        third = slope(phi + step / 2, omega + step / 2 * second)
        omega += step / 6 * (first + 2 * second + 2 * third + slope(phi + step, omega + step * third))
    assert reduction.speed_after(machine, 0.3, 0.3 + pi, 25.0) == pytest.approx(omega, rel=1e-8)


def test_a_machine_that_runs_back_keeps_its_sign() -> None:
    forth = reduction.speed_after(machine, 0.3, 1.3, 25.0)
    assert reduction.speed_after(machine, 1.3, 0.3, -forth) == pytest.approx(-25.0)


def test_work_is_the_integral_of_the_moment() -> None:
    swing = lambda phi: Reduced(1.0, 0.0, sin(3 * phi))  # noqa: E731
    assert reduction.work(swing, 0.2, 2.0) == pytest.approx((cos(0.6) - cos(6.0)) / 3, rel=1e-10)
    assert reduction.work(swing, 2.0, 0.2) == pytest.approx(-(cos(0.6) - cos(6.0)) / 3, rel=1e-10)


def test_a_machine_without_energy_stops_where_it_is_said() -> None:
    brake = Reduced(2.0, 0.0, -10.0)
    with pytest.raises(ValueError, match=r"stops before 0\.\d+ rad: .* J are missing"):
        reduction.speed_after(lambda phi: brake, 0.0, 1.0, 2.5)  # 6.25 J last 0.625 rad
    assert reduction.speed_after(lambda phi: brake, 0.0, 0.6, 2.5) == pytest.approx((2.5**2 - 6) ** 0.5)


def test_a_machine_stopped_half_way_is_not_said_to_arrive() -> None:
    hill = lambda phi: Reduced(1.0, 0.0, -10 * sin(phi))  # noqa: E731
    with pytest.raises(ValueError, match="stops before"):
        reduction.speed_after(hill, 0.0, 2 * pi, 5.0)  # needs 20 J at the top, has 12.5


def test_no_inertia_has_no_acceleration() -> None:
    with pytest.raises(SingularError, match="inertia is 0"):
        Reduced(0.0, 0.0, 1.0).epsilon(1.0)
    with pytest.raises(SingularError, match="inertia is 0"):
        reduction.speed_after(lambda phi: Reduced(0.0, 0.0, 1.0), 0.0, 1.0, 1.0)


def test_what_no_machine_has_is_refused_by_name() -> None:
    with pytest.raises(ValueError, match=r"inertia = -1\.0"):
        Coordinate(Transfer(1.0), -1.0)
    with pytest.raises(ValueError, match="load = nan"):
        Coordinate(Transfer(1.0), 1.0, nan)


@quick
@given(st.lists(st.tuples(st.floats(0.1, 2), vectors), min_size=1, max_size=4), vectors, vectors)
def test_the_inertia_moment_is_that_of_the_points_of_the_body(
    points: list[tuple[float, Vector]], omega: Vector, epsilon: Vector
) -> None:
    tensor = [[0.0] * 3 for _ in range(3)]
    moment = momentum = (0.0, 0.0, 0.0)
    for m, r in points:
        v, a = cross(omega, r), add(cross(epsilon, r), cross(omega, cross(omega, r)))
        momentum = add(momentum, cross(r, scaled(m, v)))
        moment = add(moment, cross(r, inertia_force.force(m, a)))
        for i in range(3):
            for j in range(3):
                tensor[i][j] += m * ((i == j) * sum(x * x for x in r) - r[i] * r[j])
    J = tuple(tuple(row) for row in tensor)
    assert inertia_force.momentum(J, omega) == pytest.approx(momentum, abs=1e-12)
    assert inertia_force.moment(J, omega, epsilon) == pytest.approx(moment, abs=1e-12)


def test_reactions_of_determinate_chains_leave_room_for_the_drives() -> None:
    four_bar, group = reactions.count(3, {5: 4}), reactions.count(2, {5: 3})
    assert (four_bar.equations, four_bar.reactions, four_bar.drives) == (9, 8, 1)
    assert group.determinate_group and not four_bar.determinate_group
    assert reactions.count(2, {5: 2, 4: 1}).drives == 1  # cam and follower
    assert reactions.count(6, {5: 6}, planar=False).drives == 6  # serial arm


def test_counts_that_cannot_be_are_refused() -> None:
    with pytest.raises(ValueError, match="class 3 is none of 4 to 5"):
        reactions.count(1, {3: 1})
    with pytest.raises(ValueError, match="class 6"):
        reactions.per_pair(6, planar=False)
    with pytest.raises(ValueError, match="-1 links"):
        reactions.count(-1, {5: 1})


def test_a_machine_that_does_not_turn_keeps_its_speed_and_its_sense() -> None:
    for omega in (25.0, -25.0):
        assert reduction.speed_after(machine, 0.3, 0.3, omega) == pytest.approx(omega)


@pytest.mark.parametrize(("end", "omega"), [(1.0, -2.5), (-1.0, 2.5), (1.0, nan)])
def test_a_speed_against_the_turn_is_refused(end: float, omega: float) -> None:
    with pytest.raises(ValueError, match=r"omega0 = .* rad/s must be finite and of the sense of the turn"):
        reduction.speed_after(machine, 0.0, end, omega)


@pytest.mark.parametrize("end", [1e9, nan, -1e300])
def test_work_is_not_summed_for_ever(end: float) -> None:
    with pytest.raises(ValueError, match="must be finite and at most 10000 rad"):
        reduction.work(machine, 0.0, end)


def test_inertias_beyond_the_range_of_floats_are_refused() -> None:
    for u in (1e155, nan):
        with pytest.raises(ValueError, match="range of floats"):
            reduction.reduce([Coordinate(Transfer(u, -1.0), 2.0), Coordinate(Transfer(1.0, 1.0), 1e308)])
