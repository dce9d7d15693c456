"""Train of gears on fixed parallel axes: ratio, speed, torque, the wheel of a coaxial train (domain TR-3, TR-4).

The ratio u = n_in/n_out, the speed n_out and the torque M_out are positive in the sense of the input shaft.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from exercises.exercise import Answers, Draw, Exercise, Mistake, Steps, Values, given
from exercises.transmissions.gear_train import slips
from exercises.transmissions.gear_train.wheels import (
    Coaxial,
    Coupled,
    Input,
    Mesh,
    Wheel,
    coaxial_line,
    each_mesh,
    kinds,
)
from graders import Choice, Expression, Integer, Quantity
from mechanics import gear_train, willis

RPM = pi / 30  # rad/s
# e, i: in external or internal mesh with the wheel before; +: on its shaft; E, I: back on the first axis, teeth sought
SHAPES = (
    "e+e", "e+i", "i+e", "ee", "ei", "e+E", "e+I", "e+E", "e+I", "e+e+e", "ee+e", "e+ee", "e+e+i", "ee+i", "e+ei",
    "e+e+e+e", "ee+e+e", "e+ee+e", "ee+ee", "e+e+e+i", "e+ee+i",
)  # fmt: skip
PINIONS, IDLERS, GEARS, RINGS = range(17, 31), range(22, 46), range(32, 73), range(75, 121)


@dataclass(frozen=True, slots=True)
class Givens:
    wheels: tuple[Wheel, ...]  # in the order of the flow of power
    n_in: float = given(50, 400)  # speed of the input shaft, rad/s
    M_in: float = given(5, 60)  # torque on the input shaft, N*m
    eta: float = given(0.9, 1)  # efficiency of each mesh


def draw(rng: Draw) -> Givens:
    """Draw the shape of the train, then its teeth, speed and torque."""
    shape = rng.pick(SHAPES)
    wheels = [Input(rng.pick(PINIONS)), *(wheel(rng, *marks) for marks in zip(shape, shape[1:] + ".", strict=True))]
    speed = rng.pick((720, 750, 960, 1000, 1440, 1450, 1500, 2900, 2950))
    return Givens(tuple(wheels), speed * RPM, rng.pick(range(5, 61)), rng.pick(range(94, 99)) / 100)


def wheel(rng: Draw, mark: str, following: str) -> Wheel:
    """Draw one wheel of a shape; one that another meshes with is an idler."""
    match mark:
        case "+":
            return Coupled(rng.pick(PINIONS))
        case "e":
            return Mesh(rng.pick(IDLERS if following in "ei" else GEARS), "external")
        case "i":
            return Mesh(rng.pick(RINGS), "internal")
        case _:
            return Coaxial("external" if mark == "E" else "internal")


def teeth(givens: Givens) -> list[int]:
    """List the teeth of all wheels; the sought ones from equal distances of the axes."""
    z = [one.z for one in givens.wheels if not isinstance(one, Coaxial)]
    last = givens.wheels[-1]
    if isinstance(last, Coaxial):
        z.append(willis.coaxial_wheel(willis.Stage(z[0], z[1], kinds(givens.wheels)[0]), z[2], last.type))
    return z


def speeds(givens: Givens) -> gear_train.Speeds:
    """Solve the equations of all meshes for the speeds of the shafts, numbered from 0."""
    z, meshes = teeth(givens), list[gear_train.Mesh]()
    for at, one in enumerate(givens.wheels):
        if isinstance(one, Mesh | Coaxial):
            shaft = len(meshes)
            meshes.append(gear_train.Mesh(f"{shaft}", f"{shaft + 1}", z[at - 1], z[at], one.type))
    shafts = tuple(f"{shaft}" for shaft in range(len(meshes) + 1))
    return gear_train.solve(gear_train.Train(shafts, tuple(meshes), (), {"0": givens.n_in}, shafts[-1]))


def oracle(givens: Givens) -> Values:
    """The same names by another way: linear equations of the meshes, and the balance of power."""
    *_, n_out = speeds(givens).omega.values()
    power = givens.M_in * givens.n_in * givens.eta ** len(kinds(givens.wheels))
    unknown = {"z4": teeth(givens)[3]} if isinstance(givens.wheels[-1], Coaxial) else {}
    return {
        **unknown,
        "u": givens.n_in / n_out,
        "sense": "same" if n_out > 0 else "opposite",
        "n_out": n_out,
        "M_out": power / n_out,
    }


def sense(u: float) -> str:
    """Tell the sense of the output shaft."""
    return "same" if u > 0 else "opposite"


def steps(givens: Givens) -> Steps:
    """Teeth from the equal distances of the axes, the product of the ratios, speed, and torque with all losses."""
    return {
        **coaxial_line(givens.wheels, kinds(givens.wheels)[-1]),
        "u": "*".join(each_mesh(givens.wheels, lambda mesh: mesh.ratio)),
        "sense": sense,
        "n_out": "n_in/u",
        "M_out": f"M_in*u*eta^{len(kinds(givens.wheels))}",
    }


def answers(givens: Givens) -> Answers:
    """The teeth are asked for in a coaxial train only."""
    return {
        **({"z4": Integer()} if isinstance(givens.wheels[-1], Coaxial) else {}),
        "u_formula": Expression(step="u"),
        "u": Quantity("1", rtol=0.005),
        "sense": Choice(("same", "opposite")),
        "n_out": Quantity("rpm", rtol=0.005),
        "M_out": Quantity("N*m", rtol=0.005),
    }


EXERCISE = Exercise(
    systems=("TR-3", "TR-4"),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers=answers,
    mistakes={
        "ratio_inverted": Mistake(slips.ratio_inverted),
        "last_inverted": Mistake(slips.last_inverted),
        "sum_of_ratios": Mistake(slips.sum_of_ratios),
        "ends_only": Mistake(slips.ends_only),
        "sign_by_wheels": Mistake(slips.sign_by_wheels),
        "internal_as_external": Mistake(slips.internal_as_external),
        "axes_apart": Mistake(slips.axes_apart),
        "losses_in_speed": Mistake(n_out="n_in/u*eta"),
        "efficiency_once": Mistake(M_out="M_in*u*eta"),
        "torque_divided": Mistake(slips.torque_divided),
    },
    minutes=15,
)
