"""Epicyclic train with one central wheel held: ratio by inversion of motion (Willis), speeds (domain TR-5).

Speeds are positive in the sense of the driving shaft; u0 is the ratio of the central wheels seen from the carrier.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Literal

from exercises.exercise import Draw, Exercise, Mistake, Steps, Values, given, option
from exercises.transmissions.planetary.wheels import Block, Outer, Planet, Ring, Sun, Wheel, inversion, stages
from graders import Choice, Expression, Quantity, Rational
from mechanics import gear_train, willis

RPM = pi / 30  # rad/s
PLANETS = 3
FASTEST = 6000 * RPM  # nothing turns faster: a train driven far above it from a wheel would lock itself
SUNS, PLANET_TEETH, RIMS = range(18, 49), range(17, 45), range(17, 61)


@dataclass(frozen=True, slots=True)
class Givens:
    wheels: tuple[Sun | Planet | Block | Outer | Ring, ...]  # in the order in which they mesh
    n_in: float = given(50, 400)  # speed of the driving shaft, rad/s
    held: Literal["first", "last"] = option("first", "last")
    driver: Literal["wheel", "carrier"] = option("wheel", "carrier")


def draw(rng: Draw) -> Givens:
    """Draw the kind of train, coaxial teeth clear of one another, held wheel and driver; nothing runs away."""
    train = rng.pick(("single", "single", "outer", "ring"))
    sun, planet = rng.pick(SUNS), rng.pick(PLANET_TEETH)
    wheels = single(rng, sun, planet) if train == "single" else block(rng, sun, planet, train == "ring")
    if not willis.planets_clear(sun, planet, PLANETS):
        rng.reject()
    speed = rng.pick((480, 600, 720, 750, 900, 960, 1000, 1440, 1450, 1500))
    givens = Givens(wheels, speed * RPM, rng.pick(("first", "last")), rng.pick(("wheel", "carrier")))
    return rng.reject() if fastest(givens) > FASTEST else givens


def fastest(givens: Givens) -> float:
    """Give the largest speed of free central wheel, carrier and planet, in rad/s."""
    ratio = float(willis.planetary_ratio(stages(givens.wheels), givens.held))
    wheel, carrier = (
        (givens.n_in, givens.n_in / ratio) if givens.driver == "wheel" else (givens.n_in * ratio, givens.n_in)
    )
    against = (0.0 if givens.held == "first" else wheel) - carrier  # of the first wheel
    planet = carrier - against * givens.wheels[0].z / givens.wheels[1].z
    return max(map(abs, (wheel, carrier, planet)))


def single(rng: Draw, sun: int, planet: int) -> tuple[Wheel, ...]:
    """One planet between sun and ring; three of them can be put in."""
    ring = sun + 2 * planet  # TR-5: coaxial
    if not willis.can_be_assembled(sun, ring, PLANETS):
        rng.reject()
    return Sun(sun), Planet(planet), Ring(ring)


def block(rng: Draw, sun: int, planet: int, internal: bool) -> tuple[Wheel, ...]:
    """A planet with two rims; the ratio seen from the carrier stays away from 1, where nothing is driven."""
    second = rng.pick(RIMS)
    last = sun + planet + second if internal else sun + planet - second
    if last < 17 or second == planet or (not internal and abs(planet * last - sun * second) < 0.05 * sun * second):
        rng.reject()
    if not willis.planets_clear(sun + planet - second, second, PLANETS):  # of one module: the axes are as far apart
        rng.reject()
    return Sun(sun), Planet(planet), Block(second), Ring(last) if internal else Outer(last)


def oracle(givens: Givens) -> Values:
    """The same names by another way: the linear equations of all meshes, solved in fractions."""
    first, last = stages(givens.wheels)
    meshes = tuple(
        gear_train.Mesh(a, b, stage.driving_z, stage.driven_z, stage.type, "H")
        for a, b, stage in (("1", "2", first), ("2", "n", last))
    )
    held, free = ("1", "n") if givens.held == "first" else ("n", "1")
    driver, driven = (free, "H") if givens.driver == "wheel" else ("H", free)
    found = gear_train.solve(gear_train.Train(("1", "2", "n", "H"), meshes, (held,), {driver: givens.n_in}, driven))
    turning = gear_train.solve(gear_train.Train(("1", "2", "n", "H"), meshes, ("H",), {"1": 1.0}, "n"))
    return {
        "u0": 1 / turning.omega["n"],
        "u": givens.n_in / found.omega[driven],
        "sense": sense(found.omega[driven]),
        "n_out": found.omega[driven],
        "n_2": found.omega["2"],
    }


def sense(u: float) -> str:
    """Tell the sense of the driven shaft."""
    return "same" if u > 0 else "opposite"


def to_carrier(givens: Givens) -> str:
    """Write the ratio of the free central wheel to the carrier (TR-5)."""
    return "1 - u0" if givens.held == "last" else "1 - 1/u0"


def ratio(givens: Givens, wheel_to_carrier: str) -> str:
    """Write the ratio of driver to driven."""
    return wheel_to_carrier if givens.driver == "wheel" else f"1/({wheel_to_carrier})"


def planet_speed(givens: Givens) -> str:
    """Write the speed of the planet: against the carrier it turns -z1/z2 times as fast as the first wheel."""
    carrier, wheel = ("n_out", "n_in") if givens.driver == "wheel" else ("n_in", "n_out")
    first = "0" if givens.held == "first" else wheel
    return f"{carrier} - z1/z2*({first} - {carrier})"


def steps(givens: Givens) -> Steps:
    """Ratio seen from the carrier, ratio with one wheel held, speeds."""
    return {
        "u0": inversion(givens.wheels),
        "u": ratio(givens, to_carrier(givens)),
        "sense": sense,
        "n_out": "n_in/u",
        "n_2": planet_speed(givens),
    }


def wrong_member_held(givens: Givens) -> Steps:
    """1 - u0 taken for 1 - 1/u0, or the other way round."""
    return {"u": ratio(givens, "1 - 1/u0" if givens.held == "last" else "1 - u0")}


def ratio_inverted(givens: Givens) -> Steps:
    """Driven over driver."""
    right = to_carrier(givens)
    return {"u": f"1/({right})" if givens.driver == "wheel" else right}


def fixed_axes(givens: Givens) -> Steps:
    """The carrier taken for fixed: the ratio seen from it given as the answer."""
    return {"u": ratio(givens, "u0" if givens.held == "last" else "1/u0")}


def internal_as_external(givens: Givens) -> Steps:
    """The sign of an internal mesh lost."""
    line = inversion(givens.wheels)
    return {"u0": line.removeprefix("-")} if line.startswith("-") else {}


def external_once(givens: Givens) -> Steps:
    """Two external meshes counted as one change of sense."""
    return {"u0": "-" + inversion(givens.wheels)} if isinstance(givens.wheels[-1], Outer) else {}


def of_single(line: str) -> Mistake[Givens]:
    """A slip that has no occasion where the planet has two rims."""

    def lines_of(givens: Givens) -> Steps:
        return {"u0": line} if len(givens.wheels) == 3 else {}

    return Mistake(lines_of)


def first_stage_lost(givens: Givens) -> Steps:
    """The stage of wheels 3 and 4 taken for the whole ratio."""
    last = givens.wheels[-1]
    return {"u0": "-z4/z3" if isinstance(last, Outer) else "z4/z3"} if len(givens.wheels) == 4 else {}


def fixed_reciprocal(givens: Givens) -> Steps:
    """The ratio seen from the carrier, and that upside down."""
    return {"u": ratio(givens, "u0" if givens.held == "first" else "1/u0")}


def planet_as_seen(givens: Givens) -> Steps:
    """The speed of the planet against the carrier given as its speed."""
    return {"n_2": "-z1/z2*(" + planet_speed(givens).partition("*(")[2]}


def carrier_forgotten(givens: Givens) -> Steps:
    """The planet taken to turn about an axis at rest, so that a first wheel at rest holds it."""
    first = "0" if givens.held == "first" else "n_in" if givens.driver == "wheel" else "n_out"
    return {"n_2": f"-z1/z2*{first}"}


EXERCISE = Exercise(
    systems=("TR-5",),
    version=3,
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers={
        "u0_formula": Expression(step="u0"),
        "u0": Rational(),
        "u": Rational(rtol=0.0005),
        "sense": Choice(("same", "opposite")),
        "n_out": Quantity("rpm", rtol=0.005),
        "n_2": Quantity("rpm", rtol=0.005),
    },
    mistakes={
        "wrong_member_held": Mistake(wrong_member_held),
        "ratio_inverted": Mistake(ratio_inverted),
        "fixed_axes": Mistake(fixed_axes),
        "internal_as_external": Mistake(internal_as_external),
        "external_once": Mistake(external_once),
        "one_mesh_only": Mistake(u0="-z2/z1"),
        "first_stage_lost": Mistake(first_stage_lost),
        "planet_kept": of_single("-z3/z2"),
        "planet_twice": of_single("-z3*z2/z1"),
        "sum_for_ratio": of_single("-(z3 + z1)/z1"),
        "fixed_reciprocal": Mistake(fixed_reciprocal),
        "by_u0": Mistake(n_out="n_in/u0"),
        "planet_as_seen": Mistake(planet_as_seen),
        "carrier_forgotten": Mistake(carrier_forgotten),
    },
    minutes=15,
)
