"""Initial parameters against the stiffness method, and compatibility against the chain of springs."""

from __future__ import annotations

from math import pi

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics import beam as beams_by_parameters
from mechanics import frame, shaft
from mechanics.beam import BeamResult
from mechanics.errors import UnbalancedError, UnstableError
from mechanics.frame import FrameBeam
from mechanics.members import Beam, Distributed, Force, Moment, Segment, Shaft, Support, Torque
from mechanics.section import Circle, Rectangle, Ring
from tests.depth import amount
from tests.mechanics.structures import beams, shafts

RTOL = 1e-8


def both(beam: Beam) -> tuple[BeamResult, FrameBeam]:
    try:
        oracle = frame.solve_beam(beam)
    except UnstableError:
        with pytest.raises(UnstableError, match="unstable beam"):
            beams_by_parameters.solve(beam)
        assume(False)
        raise
    return beams_by_parameters.solve(beam), oracle


def size(beam: Beam, found: BeamResult) -> tuple[float, float]:
    """Scales of force and moment: the reactions, and what loads and settlements (over a quarter of L) could take."""
    force = max(abs(reaction.Fy) + abs(reaction.M) / beam.L for reaction in found.reactions)
    force += sum(abs(support.settlement) for support in beam.supports) * beam.E * found.I / (beam.L / 4) ** 3
    for load in beam.loads:
        if isinstance(load, Force):
            force += abs(load.F)
        elif isinstance(load, Moment):
            force += abs(load.M) / beam.L
        else:
            force += (abs(load.w1) + abs(load.w2)) * (load.x2 - load.x1)
    return force, force * beam.L


@settings(max_examples=amount(10, 30))
@given(beams())
def test_reactions_agree(beam: Beam) -> None:
    found, oracle = both(beam)
    force, moment = size(beam, found)
    assert [reaction.x for reaction in found.reactions] == [reaction.x for reaction in oracle.reactions]
    for one, other in zip(found.reactions, oracle.reactions, strict=True):
        assert one.Fy == pytest.approx(other.Fy, rel=RTOL, abs=RTOL * force)
        assert pytest.approx(other.M, rel=RTOL, abs=RTOL * moment) == one.M


@settings(max_examples=amount(10, 30))
@given(beams(), st.floats(0, 1))
def test_samples_agree(beam: Beam, share: float) -> None:
    found, oracle = both(beam)
    force, moment = size(beam, found)
    sag = abs(found.v_extreme) + moment * beam.L**2 / beam.E / beam.second_moment
    x = beam.L * share
    sample = found.at(x)
    assert pytest.approx(oracle.shear(x), abs=RTOL * force) == sample.V
    assert pytest.approx(oracle.moment(x), abs=RTOL * moment) == sample.M
    assert sample.v == pytest.approx(oracle.deflection(x), abs=RTOL * sag)
    assert sample.theta == pytest.approx(oracle.slope(x), abs=RTOL * sag / beam.L)


@settings(max_examples=amount(10, 30))
@given(beams())
def test_extremes_agree(beam: Beam) -> None:
    found, oracle = both(beam)
    force, moment = size(beam, found)
    sag = abs(found.v_extreme) + moment * beam.L**2 / beam.E / beam.second_moment
    moments = [M for _, M in oracle.moments()]
    assert found.M_max == pytest.approx(max(moments), abs=RTOL * moment)
    assert found.M_min == pytest.approx(min(moments), abs=RTOL * moment)
    assert found.M_abs_max == pytest.approx(abs(oracle.extreme_moment()[1]), abs=RTOL * moment)
    assert found.V_abs_max == pytest.approx(abs(oracle.extreme_shear()[1]), abs=RTOL * force)
    assert abs(found.v_extreme) == pytest.approx(abs(oracle.extreme_deflection()[1]), abs=RTOL * sag)
    assert found.v_extreme == pytest.approx(oracle.deflection(found.x_v_extreme), abs=RTOL * sag)


@settings(max_examples=amount(10, 30))
@given(beams())
def test_nodes_of_the_frame_lie_on_the_elastic_line(beam: Beam) -> None:
    found, oracle = both(beam)
    _, moment = size(beam, found)
    sag = abs(found.v_extreme) + moment * beam.L**2 / beam.E / beam.second_moment
    for node in oracle.nodes:
        sample = found.at(node.x)
        assert sample.v == pytest.approx(node.v, abs=RTOL * sag)
        assert sample.theta == pytest.approx(node.theta_left if node.x else node.theta_right, abs=RTOL * sag / beam.L)


@settings(max_examples=amount(10, 30))
@given(beams())
def test_elements_of_the_frame_are_in_equilibrium(beam: Beam) -> None:
    found, oracle = both(beam)
    force, moment = size(beam, found)
    for element in oracle.elements:
        F1, M1, F2, M2 = element.forces
        assert element.shear(element.x2) == pytest.approx(-F2, abs=RTOL * force)
        assert element.moment(element.x2) == pytest.approx(M2, abs=RTOL * moment)
        assert element.moment(element.x1) == -M1
        assert element.shear(element.x1) == F1


@pytest.mark.parametrize(
    ("section", "second_moment"),
    [
        (Rectangle(0.06, 0.12), 8.64e-6),
        (Circle(0.05), pi * 0.05**4 / 64),
        (Ring(0.05, 0.03), pi * (0.05**4 - 0.03**4) / 64),
    ],
)
def test_frame_integrates_the_section_by_itself(section: Rectangle | Circle | Ring, second_moment: float) -> None:
    cantilever = Beam(2.0, 2.1e11, (Support(0.0, "fixed"),), (Force(2.0, -3000.0),), section=section)
    oracle = frame.solve_beam(cantilever)
    assert oracle.second_moment == pytest.approx(second_moment, rel=1e-14)
    assert oracle.normal_stress(0.0, 0.01) == pytest.approx(6000 * 0.01 / second_moment)


def test_places_a_rounding_apart_are_one_node() -> None:
    split = Beam(0.9, 2.1e11, (Support(0.0), Support(0.9)), (Force(0.3, -1e3), Force(0.1 + 0.2, -1e3)), I=1e-6)
    joined = Beam(0.9, 2.1e11, (Support(0.0), Support(0.9)), (Force(0.3, -2e3),), I=1e-6)
    assert len(frame.solve_beam(split).nodes) == 3
    assert frame.solve_beam(split).deflection(0.45) == pytest.approx(frame.solve_beam(joined).deflection(0.45))


def test_clamped_everywhere_is_solved_without_unknowns() -> None:
    clamped = Beam(
        2.0, 2.1e11, (Support(0.0, "fixed"), Support(2.0, "fixed")), (Distributed(0, 2, -600, -600),), I=1e-6
    )
    oracle = frame.solve_beam(clamped)
    assert pytest.approx(600 * 2**2 / 12) == oracle.reactions[0].M
    assert oracle.deflection(1.0) == pytest.approx(-600 * 2**4 / 384 / 2.1e5)


def test_shear_of_a_load_that_changes_sign_is_extreme_where_the_load_is_zero() -> None:
    swung = Beam(3.0, 2.1e11, (Support(3.0, "fixed"),), (Distributed(0.0, 3.0, 600.0, -1200.0),), I=1e-6)
    place, V = frame.solve_beam(swung).extreme_shear()
    assert (place, V) == pytest.approx((3.0, -900.0)) or (place, V) == pytest.approx((1.0, 300.0))
    assert max(abs(frame.solve_beam(swung).shear(x / 100)) for x in range(301)) == pytest.approx(abs(V))


@settings(max_examples=amount(10, 30))
@given(shafts())
def test_shafts_agree(given_shaft: Shaft) -> None:
    found, oracle = shaft.solve(given_shaft), frame.solve_shaft(given_shaft)
    T = max(1.0, found.T_abs_max)
    assert [piece.T for piece in found.pieces] == pytest.approx(list(oracle.torques), abs=RTOL * T)
    assert [piece.tau_max for piece in found.pieces] == pytest.approx(list(oracle.stresses), rel=RTOL, abs=1.0)
    turns = sum(abs(torque.T) for torque in given_shaft.torques)
    turns *= sum(piece.x2 - piece.x1 for piece in found.pieces) / (8e10 * min(oracle.polar_moments))
    assert [piece.twist for piece in found.pieces] == pytest.approx(list(oracle.twists), abs=RTOL * turns)
    assert [turn.phi for turn in found.phi] == pytest.approx(list(oracle.rotations), abs=RTOL * turns)
    assert (found.reactions.left, found.reactions.right) == pytest.approx(oracle.reactions, abs=RTOL * T)
    assert abs(oracle.extreme_torque()[1]) == pytest.approx(found.T_abs_max, abs=RTOL * T)


def test_twist_of_a_segment_joins_its_pieces() -> None:
    stepped = Shaft(8e10, (Segment(0.6, 0.05), Segment(0.4, 0.04)), (Torque(0.2, 100.0), Torque(1.0, 200.0)))
    oracle = frame.solve_shaft(stepped)
    J = pi * 0.05**4 / 32
    assert oracle.segment_twists[0] == pytest.approx((300 * 0.2 + 200 * 0.4) / 8e10 / J)
    assert oracle.rotation(0.1) == pytest.approx(300 * 0.1 / 8e10 / J)
    assert oracle.torque(0.2) == pytest.approx(300.0)
    assert oracle.torque(0.0) == pytest.approx(300.0)
    assert oracle.stress(0.3, 0.025) == pytest.approx(200 * 0.025 / J)
    with pytest.raises(ValueError, match=r"x = 1\.1 m must lie on the member"):
        oracle.torque(1.1)


def test_frame_refuses_a_free_shaft_out_of_balance() -> None:
    with pytest.raises(UnbalancedError, match="it takes -200"):
        frame.solve_shaft(Shaft(8e10, (Segment(1.0, 0.05),), (Torque(0.5, 200.0),), "free_free"))


def test_frame_refuses_a_mechanism() -> None:
    with pytest.raises(UnstableError, match="stiffness matrix is singular"):
        frame.solve_beam(Beam(2.0, 2.1e11, (Support(0.0), Support(2.0)), (Moment(0.5, 1.0),), (1.0,), I=1e-6))
