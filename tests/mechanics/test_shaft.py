"""Published shafts, closed forms, laws, and refusals."""

from __future__ import annotations

from math import pi, radians

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.errors import UnbalancedError
from mechanics.section import Circle, Ring
from mechanics.shaft import (
    Segment,
    Shaft,
    Torque,
    required_diameter_stiffness,
    required_diameter_strength,
    solve,
)
from tests.depth import amount
from tests.mechanics.structures import shafts

G = 8e10  # Pa


def test_sm_7_uniform_shaft() -> None:
    found = solve(Shaft(G, (Segment(1.5, 0.05),), (Torque(1.5, 500.0),)))
    piece = found.pieces[0]
    assert piece.tau_max == pytest.approx(20371832.72, rel=1e-9)
    assert (piece.twist_per_m, piece.twist) == pytest.approx((0.01018591636, 0.01527887454), rel=1e-9)
    assert found.phi[-1].phi == pytest.approx(radians(0.8754150267), rel=1e-9)
    hollow = solve(Shaft(G, (Segment(1.5, 0.05, 0.03),), (Torque(1.5, 500.0),)))
    assert hollow.tau_abs_max == pytest.approx(23405138.69, rel=1e-9)


@pytest.mark.parametrize(
    ("order", "torques", "largest"),
    [((200.0, -500.0, 300.0), [200.0, -300.0], 300.0), ((200.0, 300.0, -500.0), [200.0, 500.0], 500.0)],
)
def test_sm_8_torques_depend_on_the_order(order: tuple[float, ...], torques: list[float], largest: float) -> None:
    """SM-8 adds from the left; the sum of the torques to the right is that with its sign turned."""
    places = (0.0, 0.6, 1.4)
    segments = (Segment(0.6, 0.05), Segment(0.8, 0.05))
    found = solve(Shaft(G, segments, tuple(map(Torque, places, order)), "free_free"))
    assert [-piece.T for piece in found.pieces] == pytest.approx(torques)
    assert found.T_abs_max == pytest.approx(largest)
    assert (found.reactions.left, found.reactions.right, found.phi[0].phi) == (0.0, 0.0, 0.0)


def test_sm_8_total_twist() -> None:
    torques = (Torque(0.0, 200.0), Torque(0.6, -500.0), Torque(1.4, 300.0))
    found = solve(Shaft(G, (Segment(0.6, 0.05), Segment(0.8, 0.05)), torques, "free_free"))
    assert -found.phi[-1].phi == pytest.approx(-0.002444619926, rel=1e-9)


def test_sm_9_design() -> None:
    found = solve(Shaft(G, (Segment(1.0, 0.06),), (Torque(1.0, -500.0),), "fixed_free", 4e7, radians(0.5)))
    assert found.design is not None
    assert found.design.D_strength == pytest.approx(0.03992945425, rel=1e-9)
    assert found.design.D_stiffness == pytest.approx(0.05197065469, rel=1e-9)
    assert found.design.D_required == found.design.D_stiffness


def test_sm_10_shaft_between_two_clamps() -> None:
    found = solve(Shaft(G, (Segment(0.6, 0.04), Segment(0.9, 0.05)), (Torque(0.6, 800.0),), "fixed_fixed"))
    assert (found.reactions.left, found.reactions.right) == pytest.approx((-304.4598612, -495.5401388), rel=1e-9)
    assert [piece.T for piece in found.pieces] == pytest.approx([304.4598612, -495.5401388], rel=1e-9)
    assert [piece.tau_max for piece in found.pieces] == pytest.approx([24228145.95, 20190121.62], rel=1e-9)
    assert found.phi[1].phi == pytest.approx(0.00908555473, rel=1e-9)
    assert found.phi[2].phi == pytest.approx(0.0, abs=1e-15)


def test_fixed_right_end_is_where_the_rotation_is_zero() -> None:
    found = solve(Shaft(G, (Segment(0.5, 0.05), Segment(0.4, 0.04)), (Torque(0.0, 100.0),), "free_fixed"))
    assert (found.reactions.left, found.reactions.right) == (0.0, -100.0)
    assert found.phi[-1].phi == 0.0
    assert found.phi[0].phi == pytest.approx(
        100 / G * (0.5 / Circle(0.05).torsion_constant + 0.4 / (pi * 0.04**4 / 32))
    )


def test_torque_on_a_clamp_goes_straight_into_it() -> None:
    found = solve(Shaft(G, (Segment(1.0, 0.05),), (Torque(0.0, 70.0),)))
    assert (found.reactions.left, found.T_abs_max) == (-70.0, 0.0)


def test_torque_inside_a_segment_cuts_it() -> None:
    found = solve(Shaft(G, (Segment(1.0, 0.05), Segment(0.5, 0.04)), (Torque(0.25, 100.0), Torque(1.5, 50.0))))
    assert [(piece.x1, piece.x2, piece.D) for piece in found.pieces] == [
        (0.0, 0.25, 0.05),
        (0.25, 1.0, 0.05),
        (1.0, 1.5, 0.04),
    ]
    assert [piece.T for piece in found.pieces] == pytest.approx([150.0, 50.0, 50.0])


def test_uniform_shaft_between_clamps_is_sized_for_its_own_torques() -> None:
    """A stepped shaft draws torque to its thick part; the uniform one shares 600 N m as 400 and 200 by lengths."""
    stepped = Shaft(G, (Segment(0.3, 0.02), Segment(0.6, 0.06)), (Torque(0.3, 600.0),), "fixed_fixed", 6e7)
    found = solve(stepped)
    assert found.design is not None
    assert found.design.D_required == pytest.approx(required_diameter_strength(400.0, 6e7))
    assert found.T_abs_max > 1.4 * 400
    assert found.design.D_stiffness is None


def test_design_by_stiffness_alone_has_no_strength() -> None:
    found = solve(Shaft(G, (Segment(1.0, 0.06),), (Torque(1.0, 500.0),), theta_allow_rad_per_m=0.0087))
    assert found.design is not None
    assert (found.design.D_strength, found.design.D_required) == (None, found.design.D_stiffness)


def test_no_limit_gives_no_design() -> None:
    assert solve(Shaft(G, (Segment(1.0, 0.06),), (Torque(1.0, 500.0),))).design is None


@settings(max_examples=amount(13, 40))
@given(st.floats(1.0, 1e5), st.floats(0, 0.95))
def test_required_diameters_return_the_limits(torque: float, ratio: float) -> None:
    by_strength = required_diameter_strength(-torque, 6e7, ratio)
    strong = solve(Shaft(G, (Segment(1.0, by_strength, ratio * by_strength),), (Torque(1.0, torque),)))
    assert strong.tau_abs_max == pytest.approx(6e7)
    by_stiffness = required_diameter_stiffness(torque, G, 0.0087, ratio)
    stiff = solve(Shaft(G, (Segment(1.0, by_stiffness, ratio * by_stiffness),), (Torque(1.0, torque),)))
    assert stiff.pieces[0].twist_per_m == pytest.approx(0.0087)


@settings(max_examples=amount(13, 40))
@given(shafts())
def test_torques_and_reactions_cancel_and_jump_by_the_loads(shaft: Shaft) -> None:
    found = solve(shaft)
    scale = 1 + sum(abs(torque.T) for torque in shaft.torques)
    total = found.reactions.left + found.reactions.right + sum(torque.T for torque in shaft.torques)
    assert total == pytest.approx(0.0, abs=1e-12 * scale)
    left_of_first = -found.reactions.left - sum(torque.T for torque in shaft.torques if torque.x == 0)
    assert pytest.approx(left_of_first, abs=1e-12 * scale) == found.pieces[0].T


@settings(max_examples=amount(13, 40))
@given(shafts(support="fixed_fixed"))
def test_shaft_between_clamps_keeps_its_ends(shaft: Shaft) -> None:
    found = solve(shaft)
    loads = sum(abs(torque.T) for torque in shaft.torques)
    turns = loads * sum((piece.x2 - piece.x1) / G / Ring(piece.D, piece.d).torsion_constant for piece in found.pieces)
    assert found.phi[-1].phi == pytest.approx(0.0, abs=1e-12 * turns)


def test_free_shaft_out_of_balance_is_refused() -> None:
    with pytest.raises(UnbalancedError, match=r"their sum is 200\.0 N m"):
        solve(Shaft(G, (Segment(1.0, 0.05),), (Torque(0.0, -100.0), Torque(1.0, 300.0)), "free_free"))


def test_free_shaft_without_torques_is_at_rest() -> None:
    assert solve(Shaft(G, (Segment(1.0, 0.05),), (), "free_free")).T_abs_max == 0.0


@pytest.mark.parametrize(
    ("call", "reason"),
    [
        (lambda: required_diameter_strength(1.0, 0.0), r"tau_allow = 0\.0 Pa must be positive"),
        (lambda: required_diameter_strength(float("nan"), 1.0), "torque = nan N m must be finite"),
        (lambda: required_diameter_stiffness(1.0, 0.0, 1.0), r"shear modulus G = 0\.0 Pa"),
        (lambda: required_diameter_stiffness(1.0, 1.0, -1.0), r"theta_allow = -1\.0 rad/m"),
        (lambda: required_diameter_stiffness(1.0, 1.0, 1.0, 1.0), r"bore ratio 1\.0 must be at least 0 and below 1"),
        (lambda: solve(Shaft(G, (Segment(1.0, 1e-90),), ())), r"torsional stiffness G J_p = 0\.0 N m\^2"),
        (lambda: solve(Shaft(G, (Segment(1.0, 1e-60),), (Torque(1.0, 1e200),))), "range of floats"),
    ],
)
def test_impossible_size_is_refused_by_name(call: object, reason: str) -> None:
    assert callable(call)
    with pytest.raises(ValueError, match=reason):
        call()
