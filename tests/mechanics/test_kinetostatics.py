"""Reactions of the slider-crank against eight equations at once, the balance of power, and Newton's laws."""

from __future__ import annotations

from math import nan, pi, tan

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import force_equations, kinetostatics, reduction, slider_crank
from mechanics.errors import AssemblyError, SingularError
from mechanics.kinetostatics import SliderCrank, free_bodies, solve
from mechanics.slider_crank import Branch
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)
branches: st.SearchStrategy[Branch] = st.sampled_from(["slider_right", "slider_left"])
masses, inertias, shares = st.floats(0, 5), st.floats(0, 0.1), st.floats(-0.5, 1.5)
machines = st.builds(
    SliderCrank, st.floats(0.05, 0.2), st.floats(0.3, 0.8), masses, masses, masses, inertias, inertias,
    st.floats(-1000, 1000), shares, shares, st.floats(-0.05, 0.05), branches,
)  # fmt: skip
states = st.tuples(st.floats(-10, 10), st.floats(-40, 40), st.floats(-200, 200))


@quick
@given(machines, states)
def test_group_by_group_agrees_with_eight_equations_at_once(
    machine: SliderCrank, state: tuple[float, float, float]
) -> None:
    found, at_once = solve(machine, *state), force_equations.solve(free_bodies(machine, *state))
    for name in ("R01", "R12", "R23"):
        assert getattr(found, name) == pytest.approx(getattr(at_once, name), rel=1e-9, abs=1e-7)
    for name in ("N03", "M1"):
        assert getattr(found, name) == pytest.approx(getattr(at_once, name), rel=1e-9, abs=1e-7)


@quick
@given(machines, states)
def test_the_drive_gives_what_the_reduced_machine_needs(
    machine: SliderCrank, state: tuple[float, float, float]
) -> None:
    alpha1, omega1, epsilon1 = state
    pin = slider_crank.solve(machine.l1, machine.l2, alpha1, 1.0, 0.0, machine.offset, machine.branch, 0.0)
    weight = -machine.m1 * machine.g * machine.S1 * pin.vel["S_y"]
    reduced = reduction.slider_crank_machine(
        machine.l1,
        machine.l2,
        alpha1,
        machine.offset,
        machine.branch,
        machine.S2,
        m2=machine.m2,
        m3=machine.m3,
        J1=machine.J_S1 + machine.m1 * (machine.S1 * machine.l1) ** 2,
        J2=machine.J_S2,
        F3_x=machine.F3_x,
        M1=weight,
        gravity=machine.g,
    )
    needed = reduced.J * epsilon1 + reduced.dJ * omega1**2 / 2 - reduced.M
    drive = solve(machine, *state).M1
    assert drive == pytest.approx(needed, rel=1e-8, abs=1e-7)


@quick
@given(machines, states)
def test_the_frame_carries_the_momentum_of_all_links(machine: SliderCrank, state: tuple[float, float, float]) -> None:
    found, bodies = solve(machine, *state), free_bodies(machine, *state)
    across, up = (sum(link.force[axis] for link in bodies) for axis in (0, 1))
    assert found.R01[0] + across == pytest.approx(0, abs=1e-7)
    assert found.R01[1] + found.N03 + up == pytest.approx(0, abs=1e-7)


def test_a_massless_machine_at_rest_is_held_by_statics() -> None:
    found = solve(SliderCrank(0.1, 0.3, F3_x=-300.0), 0.7, 0.0)
    rod = slider_crank.position(0.1, 0.3, 0.7).rod_angle
    assert found.R23[1] / found.R23[0] == pytest.approx(tan(rod))  # along the rod
    assert found.R12 == found.R23 == found.R01
    power = slider_crank.solve(0.1, 0.3, 0.7, 1.0).vel["slider_x"] * -300.0
    drive = found.M1
    assert drive == pytest.approx(-power)
    assert rod < 0 < found.N03


def test_a_rod_across_the_guide_and_a_short_one_are_refused() -> None:
    with pytest.raises(SingularError, match="perpendicular"):
        solve(SliderCrank(0.1, 0.1), pi / 2, 1.0)
    with pytest.raises(AssemblyError, match="cannot reach"):
        solve(SliderCrank(0.2, 0.1), pi / 2, 1.0)


def test_what_no_machine_has_is_refused_by_name() -> None:
    with pytest.raises(ValueError, match=r"m2 = -1\.0 kg must"):
        SliderCrank(0.1, 0.3, m2=-1.0)
    with pytest.raises(ValueError, match="J_S1 = nan"):
        SliderCrank(0.1, 0.3, J_S1=nan)
    with pytest.raises(ValueError, match="F3_x = nan N must"):
        SliderCrank(0.1, 0.3, F3_x=nan)
    with pytest.raises(ValueError, match="omega1"):
        kinetostatics.solve(SliderCrank(0.1, 0.3), 0.1, nan)
