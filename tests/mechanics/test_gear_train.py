"""Gear trains: the exact system against rolling pitch circles, inversion, and published numbers."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import inf, nan, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import gear_train, willis
from mechanics.bevel_differential import Differential
from mechanics.errors import TrainError
from mechanics.gear_pair import MeshType
from mechanics.gear_train import Mesh, Train
from mechanics.rack import Rack
from mechanics.screw import Hand, Screw
from mechanics.willis import Stage
from mechanics.worm import Worm
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)

teeth = st.integers(12, 120)
kinds: st.SearchStrategy[MeshType] = st.sampled_from(["external", "internal"])
stages = st.builds(Stage, teeth, teeth, kinds)
speeds = st.integers(-200, 200)

SUN_RING = Train(
    members=("1", "2", "3", "H"),
    meshes=(Mesh("1", "2", 20, 25, "external", "H"), Mesh("2", "3", 25, 70, "internal", "H")),
    fixed=("3",),
    input_omega={"1": 100},
    output="H",
)


def in_a_row(drawn: list[Stage], carrier: str | None = None) -> Train:
    """Shafts 0 .. n, a mesh between each two; on a carrier H where one is named."""
    shafts = tuple(str(i) for i in range(len(drawn) + 1))
    meshes = tuple(
        Mesh(shafts[i], shafts[i + 1], s.driving_z, s.driven_z, s.type, carrier) for i, s in enumerate(drawn)
    )
    return Train(shafts if carrier is None else (*shafts, carrier), meshes)


def exact_ratio(train: Train) -> Fraction:
    ratio = gear_train.solve(train).ratio
    assert ratio is not None
    return ratio.exact


@quick
@given(st.lists(stages, min_size=1, max_size=6))
def test_fixed_axes_agree_with_the_pitch_point_chain(drawn: list[Stage]) -> None:
    train = replace(in_a_row(drawn), input_omega={"0": 10}, output=str(len(drawn)))
    assert exact_ratio(train) == willis.fixed_axis_ratio(drawn)


@quick
@given(st.lists(stages, min_size=2, max_size=5), st.sampled_from(["first", "last"]))
def test_planetary_trains_agree_with_inversion(drawn: list[Stage], fixed: str) -> None:
    last = str(len(drawn))
    still, driven = ("0", last) if fixed == "first" else (last, "0")
    train = replace(in_a_row(drawn, "H"), fixed=(still,), input_omega={"H": 7}, output=driven)
    ratio = gear_train.solve(train).ratio
    expected = willis.planetary_ratio(drawn, fixed)  # type: ignore[arg-type]
    assert (ratio.exact if ratio else 0) == (1 / expected if expected else 0)


@quick
@given(st.lists(stages, min_size=2, max_size=4), speeds, speeds)
def test_differentials_agree_with_the_willis_identity(drawn: list[Stage], first: int, last: int) -> None:
    end = str(len(drawn))
    if willis.fixed_axis_ratio(drawn) == 1:
        return
    found = gear_train.solve(replace(in_a_row(drawn, "H"), input_omega={"0": first, end: last})).omega_exact
    assert found["H"] == willis.third_speed(drawn, first=first, last=last)
    assert found["0"] == willis.third_speed(drawn, last=last, carrier=found["H"])
    assert found[end] == willis.third_speed(drawn, first=first, carrier=found["H"])


@quick
@given(teeth, teeth, speeds, speeds)
def test_circles_roll_without_slip_at_every_pitch_point(sun: int, planet: int, first: int, last: int) -> None:
    ring = sun + 2 * planet
    meshes = (Mesh("1", "2", sun, planet, "external", "H"), Mesh("2", "3", planet, ring, "internal", "H"))
    found = gear_train.solve(Train(("1", "2", "3", "H"), meshes, input_omega={"1": first, "3": last})).omega_exact
    centre_speed = found["H"] * (sun + planet)
    assert found["1"] * sun == centre_speed - found["2"] * planet
    assert found["3"] * ring == centre_speed + found["2"] * planet


@quick
@given(st.lists(stages, min_size=1, max_size=4), speeds, st.integers(-9, 9))
def test_speeds_are_proportional_to_the_input(drawn: list[Stage], speed: int, factor: int) -> None:
    train = in_a_row(drawn)
    once, more = (gear_train.solve(replace(train, input_omega={"0": k * speed})).omega_exact for k in (1, factor))
    assert {name: factor * omega for name, omega in once.items()} == more


def test_published_gear_pair_holds() -> None:
    pair = Train(("1", "2"), (Mesh("1", "2", 18, 45),), input_omega={"1": 1450}, output="2")
    found = gear_train.solve(pair)
    assert found.ratio is not None
    assert (found.ratio.of, found.ratio.value) == ("omega_1/omega_2", -2.5)  # TR-3
    assert found.omega == {"1": 1450.0, "2": -580.0}
    assert exact_ratio(replace(pair, meshes=(Mesh("1", "2", 18, 45, "internal"),))) == Fraction(5, 2)


@pytest.mark.parametrize(("z3", "kind", "ratio"), [(45, "external", 6), (75, "internal", -10)])
def test_published_two_stage_trains_hold(z3: int, kind: MeshType, ratio: int) -> None:
    meshes = (Mesh("1", "2", 20, 40), Mesh("2", "3", 15, z3, kind))
    assert exact_ratio(Train(("1", "2", "3"), meshes, input_omega={"1": 10}, output="3")) == ratio  # TR-4


BLOCK = Train(
    members=("1", "2", "3", "H"),
    meshes=(Mesh("1", "2", 51, 50, "external", "H"), Mesh("2", "3", 49, 52, "external", "H")),
    fixed=("1",),
    input_omega={"3": 1},
    output="H",
)


def test_published_planetary_trains_hold() -> None:
    assert float(exact_ratio(BLOCK)) == pytest.approx(0.03884615385)  # TR-5
    assert float(exact_ratio(replace(BLOCK, input_omega={"H": 1}, output="3"))) == pytest.approx(25.74257426)
    assert exact_ratio(SUN_RING) == Fraction(9, 2)
    sun_fixed = replace(SUN_RING, fixed=("1",), input_omega={"3": 1})
    assert float(exact_ratio(sun_fixed)) == pytest.approx(1.285714286)
    omega = gear_train.solve(SUN_RING).omega_exact
    assert omega["2"] / omega["H"] == Fraction(-9, 5)


def test_published_differentials_hold() -> None:
    found = gear_train.solve(replace(SUN_RING, fixed=(), input_omega={"1": 100, "3": -10}))
    assert found.omega["H"] == pytest.approx(14.44444444)  # TR-6
    bevel = Train(("L", "R", "H"), differentials=(Differential("L", "R", "H"),), input_omega={"L": 4, "R": 9})
    assert gear_train.solve(bevel).omega_exact["H"] == Fraction(13, 2)


def test_published_rack_holds() -> None:
    train = Train(("1",), input_omega={"1": 8}, output="rack", rack=Rack("1", 24, 2.5))
    assert gear_train.solve(train).v == pytest.approx(0.240)  # TR-1
    assert gear_train.solve(train).ratio is None


@pytest.mark.parametrize(("hand", "sense"), [("right", -1), ("left", 1)])
def test_published_screw_holds(hand: Hand, sense: int) -> None:
    train = Train(("1",), input_omega={"1": 25}, output="nut", screw=Screw("1", 0.004, 2, hand))
    assert gear_train.solve(train).v == pytest.approx(sense * 0.03183098862)  # TR-2
    travel = gear_train.solve(replace(train, input_omega={"1": 10})).v
    assert travel == pytest.approx(sense * 0.01273239545)


def test_a_worm_gives_the_modulus_of_the_whole_ratio() -> None:
    meshes = (Mesh("1", "2", 20, 50),)
    train = Train(("1", "2"), meshes, input_omega={"1": 30}, output="wheel", worm=Worm("2", 2, 60))
    found = gear_train.solve(train).ratio
    assert found is not None
    assert (found.of, found.exact) == ("omega_1/omega_wheel", Fraction(75))
    assert gear_train.solve(replace(train, output="2")).ratio == gear_train.Ratio("omega_1/omega_2", Fraction(-5, 2))


def test_decimal_inputs_are_taken_as_printed() -> None:
    pair = Train(("1", "2"), (Mesh("1", "2", 30, 10),), input_omega={"1": 0.1})
    assert gear_train.solve(pair).omega_exact == {"1": Fraction(1, 10), "2": Fraction(-3, 10)}


def test_a_member_at_rest_has_no_ratio() -> None:
    assert gear_train.solve(replace(SUN_RING, output="3")).ratio is None
    assert gear_train.solve(replace(SUN_RING, output=None)).ratio is None
    assert gear_train.solve(replace(SUN_RING, input_omega={"1": 0})).ratio is None
    still = Train(("1", "2"), fixed=("2",), input_omega={"1": 3}, output="wheel", worm=Worm("2", 1, 40))
    assert gear_train.solve(still).ratio is None


def test_planets_that_repeat_one_another_contradict_nothing() -> None:
    twin = (Mesh("1", "2b", 20, 25, "external", "H"), Mesh("2b", "3", 25, 70, "internal", "H"))
    train = replace(SUN_RING, members=(*SUN_RING.members, "2b"), meshes=SUN_RING.meshes + twin)
    assert exact_ratio(train) == Fraction(9, 2)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"fixed": ()}, "the motion of 2, 3, H is not determined"),
        ({"members": ("1", "2", "3", "H", "idle")}, "the motion of idle is not determined"),
        ({"input_omega": {}}, "the motion of 1, 2, H is not determined"),
        ({"input_omega": {"1": 100, "2": 3}}, "the input omega of 2 = 3 rad/s contradicts"),
        ({"input_omega": {"3": 1, "1": 100}}, "the input omega of 3 = 1 rad/s contradicts"),
        ({"fixed": ("3", "H")}, "the input omega of 1 = 100 rad/s contradicts"),
    ],
)
def test_too_few_or_contradictory_conditions_are_named(changes: dict[str, object], message: str) -> None:
    with pytest.raises(TrainError, match=message):
        gear_train.solve(replace(SUN_RING, **changes))  # type: ignore[arg-type]


def test_wheels_that_lock_one_another_cannot_be_driven() -> None:
    ring = (Mesh("1", "2", 20, 20), Mesh("2", "3", 20, 20), Mesh("3", "1", 20, 20))
    with pytest.raises(TrainError, match="the input omega of 1"):
        gear_train.solve(Train(("1", "2", "3"), ring, input_omega={"1": 5}))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"members": ("1", "2", "3", "H", "1")}, "name one twice"),
        ({"fixed": ("5",)}, "fixed names 5"),
        ({"input_omega": {"5": 1}}, "input_omega names 5"),
        ({"input_omega": {"1": nan}}, "input_omega of 1 = nan rad/s"),
        ({"input_omega": {"1": inf}}, "must be finite"),
        ({"output": "5"}, "output names 5"),
        ({"output": "rack"}, "output names rack"),
        ({"meshes": (Mesh("1", "5", 20, 20),)}, "the mesh 1-5 names 5"),
        ({"meshes": (Mesh("1", "2", 20, 20, "external", "K"),)}, "the mesh 1-2 names K"),
        ({"differentials": (Differential("1", "2", "K"),)}, "the differential 1-2 names K"),
        ({"rack": Rack("5", 20, 2.0)}, "the stage of the rack names 5"),
        ({"members": ("1", "2", "3", "H", "nut"), "screw": Screw("1", 0.01)}, "nut is both"),
    ],
)
def test_names_that_do_not_fit_are_refused(changes: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        replace(SUN_RING, **changes)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Mesh("1", "2", 0, 20), "za of the mesh 1-2 = 0"),
        (lambda: Mesh("1", "2", 20, 20.5), "zb of the mesh 1-2 = 20.5"),  # type: ignore[arg-type]
        (lambda: Mesh("1", "2", 20, 20, "bevel"), "mesh type 'bevel'"),  # type: ignore[arg-type]
        (lambda: Mesh("1", "1", 20, 20), "the mesh 1-1 names a member twice"),
        (lambda: Mesh("1", "2", 20, 20, "external", "2"), "a member twice"),
        (lambda: Differential("1", "2", "1"), "a member twice"),
        (lambda: Rack("1", 20, 0.0), "module_mm"),
        (lambda: Rack("1", 0, 2.0), "pinion_z"),
        (lambda: Screw("1", nan), "pitch"),
        (lambda: Screw("1", 0.01, 0), "starts"),
        (lambda: Screw("1", 0.01, 1, "up"), "hand 'up'"),  # type: ignore[arg-type]
        (lambda: Worm("1", 0, 40), "worm_starts"),
        (lambda: Worm("1", 1, -40), "wheel_z"),
    ],
)
def test_impossible_parts_are_refused(make: object, message: str) -> None:
    assert callable(make)
    with pytest.raises(ValueError, match=message):
        make()


def test_a_full_turn_moves_the_nut_by_one_lead() -> None:
    train = Train(("1",), input_omega={"1": 2 * pi}, output="nut", screw=Screw("1", 0.006, 3, "left"))
    assert gear_train.solve(train).v == pytest.approx(0.018)
