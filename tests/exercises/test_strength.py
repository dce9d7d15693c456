"""What the beam and the shaft promise beyond the contract of every exercise."""

from __future__ import annotations

from itertools import pairwise

import pytest

from exercises import variants
from exercises.solving import Solved, solve
from exercises.strength import simple_beam
from exercises.strength._beam.members import (
    Clockwise,
    Counterclockwise,
    Couple,
    Force,
    InsetA,
    InsetB,
    LeftEnd,
    Load,
    RightEnd,
    Support,
    Uniform,
)
from exercises.strength.simple_beam.diagram import extreme_place, extremes
from exercises.strength.stepped_shaft.lines import inner_torques
from exercises.strength.stepped_shaft.parts import Against, Along
from mechanics import members
from tests.depth import amount

SEEDS = range(amount(4, 12))


def beam(*loads: Load, supports: tuple[Support, ...]) -> simple_beam.Givens:
    return simple_beam.Givens(supports, loads, L=4.0, b=0.06, h=0.12, E=2.1e11, x_K=1.0)


def test_m_before_and_behind_a_couple_are_both_seen() -> None:
    found = extremes((0.0, 4.0), (-250.0, 250.0), [members.Moment(3.0, -1000.0)])
    assert [M for x, M in found if x == 3.0] == pytest.approx([-750.0, 250.0])


def test_where_the_shear_force_keeps_its_sign_m_grows_to_the_right_end() -> None:
    assert extreme_place(beam(supports=(InsetA(1.0), RightEnd())), 100.0, 100.0) == 4.0


def test_the_place_follows_a_wrong_reaction() -> None:
    givens = beam(Uniform(1000.0, 0.0, 4.0), supports=(LeftEnd(), RightEnd()))
    assert extreme_place(givens, 1500.0, 2500.0) == pytest.approx(1.5)


def test_mirrored_beams_exchange_their_reactions_and_keep_the_deflection() -> None:
    one = beam(Force(3e3, 0.5), Uniform(2e3, 1.0, 2.0), Clockwise(1e3, 2.5), supports=(LeftEnd(), InsetB(3.2)))
    loads = (Counterclockwise(1e3, 1.5), Uniform(2e3, 2.0, 3.0), Force(3e3, 3.5))
    other = simple_beam.Givens((InsetA(0.8), RightEnd()), loads, L=4.0, b=0.06, h=0.12, E=2.1e11, x_K=3.0)
    left, right = (solve(simple_beam.EXERCISE, givens) for givens in (one, other))
    assert (left["R_A"], left["R_B"]) == pytest.approx((right["R_B"], right["R_A"]))
    assert left["v_K"] == pytest.approx(right["v_K"])


@pytest.mark.parametrize("seed", SEEDS)
def test_the_extreme_of_a_drawn_beam_is_clear_and_not_at_a_couple(seed: int) -> None:
    givens = variants.deal("simple_beam", seed).givens
    values = Solved(simple_beam.EXERCISE, variants.deal("simple_beam", seed)).values
    assert not simple_beam.degenerate(givens)
    assert all(load.a != values["x_M"] for load in givens.loads if isinstance(load, Couple))
    assert isinstance(values["sigma_max"], float) and 50e6 < values["sigma_max"] < 150e6


@pytest.mark.parametrize("seed", SEEDS)
def test_neighbours_of_a_drawn_shaft_differ_and_its_torques_turn_both_ways(seed: int) -> None:
    givens = variants.deal("stepped_shaft", seed).givens
    outer = [segment.part().D for segment in givens.segments]
    assert all(one != other for one, other in pairwise(outer))
    assert len({type(torque) for torque in givens.torques}) == 2


@pytest.mark.parametrize("wall", ["left", "right"])
def test_the_torque_at_the_wall_balances_the_loads(wall: str) -> None:
    torques = (Along(300.0), Against(500.0), Along(100.0))
    held = inner_torques(torques, wall)
    assert (held[0] if wall == "left" else -held[-1]) == pytest.approx(-100.0)
