"""Gear pair, rack, screw, worm and bevel differential: rolling, power, and Willis by another way."""

from __future__ import annotations

from math import nan, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import gear_train, willis
from mechanics.bevel_differential import Differential
from mechanics.gear_pair import GearPair, output_moment
from mechanics.gear_train import Train
from mechanics.rack import Rack
from mechanics.screw import Screw
from mechanics.willis import Stage
from mechanics.worm import Worm
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)
teeth = st.integers(12, 120)
speeds = st.integers(-200, 200)


@quick
@given(teeth, teeth, st.floats(1e-4, 2e-2))
def test_pitch_circles_have_one_speed_where_they_touch(z1: int, z2: int, module: float) -> None:
    """The outer pair touches between the axes; in the ring both radii lie on one side."""
    pair = GearPair(z1, z2, module)
    r1, r2 = pair.radii
    assert r1 * 10 == pytest.approx(-r2 * 10 / float(pair.ratio))
    assert pair.centre_distance == pytest.approx(r1 + r2)
    assert pair.pitch * z1 == pytest.approx(2 * pi * r1)
    if z2 > z1:
        ring = GearPair(z1, z2, module, "internal")
        assert ring.centre_distance == pytest.approx(ring.radii[1] - ring.radii[0], abs=1e-12)
        assert ring.ratio == willis.fixed_axis_ratio([Stage(z1, z2, "internal")])


@quick
@given(teeth, st.floats(0.5, 20), st.floats(-50, 50))
def test_a_full_turn_of_the_pinion_moves_the_rack_by_all_its_teeth(z: int, module: float, omega: float) -> None:
    rack = Rack("1", z, module)
    assert rack.travel(2 * pi) == pytest.approx(z * pi * module / 1000)
    assert rack.speed(omega) == pytest.approx(rack.travel(omega))


@quick
@given(st.floats(1e-3, 5e-2), st.integers(1, 6), st.floats(1, 100), st.floats(1, 1e4), st.floats(0.05, 1))
def test_the_power_of_a_screw_arrives_less_its_losses(
    pitch: float, starts: int, omega: float, thrust: float, efficiency: float
) -> None:
    screw = Screw("1", pitch, starts)
    assert screw.moment(thrust, efficiency) * omega * efficiency == pytest.approx(-screw.speed(omega) * thrust)
    assert Screw("1", pitch, starts, "left").travel(2 * pi) == pytest.approx(pitch * starts)


@quick
@given(speeds, speeds, teeth)
def test_a_bevel_differential_is_a_willis_train_of_equal_wheels(left: int, right: int, z: int) -> None:
    """Seen from the carrier the sides turn alike and against each other, as over one outer mesh of equal wheels."""
    train = Train(("L", "R", "H"), input_omega={"L": left, "R": right}, differentials=(Differential("L", "R", "H"),))
    assert gear_train.solve(train).omega_exact["H"] == willis.third_speed([Stage(z, z)], first=left, last=right)


def test_a_worm_passes_one_start_a_tooth() -> None:
    assert Worm("1", 2, 60).ratio == 30


def test_moments_grow_with_the_ratio_and_lose_at_each_stage() -> None:
    """Power: M_out omega_out = eta^2 M_in omega_in."""
    assert output_moment(10, 6, 0.9, 2) / 6 == pytest.approx(10 * 0.81)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: GearPair(0, 20, 0.002), "z1 = 0"),
        (lambda: GearPair(20, 20, nan), "module"),
        (lambda: GearPair(20, 40, 0.002, "bevel"), "mesh type 'bevel'"),  # type: ignore[arg-type]
        (lambda: GearPair(40, 20, 0.002, "internal"), "a ring of 20 teeth cannot hold a pinion of 40"),
        (lambda: Screw("1", 0.01).moment(nan), "thrust"),
        (lambda: Screw("1", 0.01).moment(1, 1.2), "efficiency = 1.2"),
        (lambda: output_moment(nan, 2), "moment"),
        (lambda: output_moment(1, 2, 0), "efficiency = 0"),
        (lambda: output_moment(1, 2, 1, 0), "stages = 0"),
    ],
)
def test_impossible_stages_are_refused_by_name(make: object, message: str) -> None:
    assert callable(make)
    with pytest.raises(ValueError, match=message):
        make()
