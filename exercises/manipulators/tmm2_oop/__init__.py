"""TMM-2, manipulator OOP: polygon, derivatives, velocity and acceleration of the gripper (domain VP-6, RP-2).

Nodes A, B (revolutes), C (slide), D (gripper). Theta1 from +X; Theta2 from the direction of AB or from +X, as the task
says; the slide runs along BC or across it, to the right. Angles counter-clockwise, radians inside.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from exercises.exercise import Draw, Exercise, Mistake, Steps, Values, given, option
from exercises.givens import numbers
from exercises.manipulators import _arm
from exercises.manipulators._arm import Side, Sides, motion
from exercises.manipulators._arm.drawing import accelerations, angles, clear, lengths, rates
from exercises.manipulators._arm.motion import Arm
from figures.machine import Machine, Pair
from graders import States
from graders.polygon.mechanism import Mechanism

SIDES: Sides = (
    Side("l_AB", "Theta1", "Theta1_d", "Theta1_dd"),
    Side("l_BC", "alpha2", "omega3", "epsilon3"),
    Side("h3", "alpha3", "omega3", "epsilon3", slides=True),
)


@dataclass(frozen=True, slots=True)
class Givens:
    l_AB: float = given(0.2, 0.8)  # link 1, m
    l_BC: float = given(0.2, 0.8)  # fixed part of link 2, m
    h3: float = given(0.05, 0.5)  # travel of the slide, m
    Theta1: float = given(-pi, pi)  # rad
    Theta2: float = given(-pi, pi)  # rad
    Theta1_d: float = given(-2, 2)  # rad/s
    Theta2_d: float = given(-2, 2)  # rad/s
    h3_d: float = given(-0.5, 0.5)  # m/s
    Theta1_dd: float = given(-3, 3)  # rad/s^2
    Theta2_dd: float = given(-3, 3)  # rad/s^2
    h3_dd: float = given(-1, 1)  # m/s^2
    measured: str = option("relative", "absolute")
    slide: str = option("along", "across")


def draw(rng: Draw) -> Givens:
    """Draw whole centimetres and degrees; no result is the small difference of large terms."""
    placed, kind = lengths(rng) + angles(rng), (rng.pick(("relative", "absolute")), rng.pick(("along", "across")))
    drawn = Givens(*placed, *rates(rng, "RRP"), *accelerations(rng, "RRP"), *kind)
    if not clear(numbers(drawn), steps(drawn), SIDES):
        rng.reject()
    return drawn


def turned(relative: bool) -> Steps:
    """Write direction and turning of link 2, where its coordinate is relative or not."""
    marks = {"alpha2": "", "omega3": "_d", "epsilon3": "_dd"}
    return {name: (f"Theta1{mark} + " if relative else "") + f"Theta2{mark}" for name, mark in marks.items()}


def slid(givens: Givens, link: str) -> str:
    """Write the direction of the slide on a link."""
    return link if givens.slide == "along" else f"{link} - pi/2"


def steps(givens: Givens) -> Steps:
    """Directions of the links, then all that follows from the polygon."""
    link = turned(givens.measured == "relative")
    return _arm.steps({"alpha2": link["alpha2"], "alpha3": slid(givens, "alpha2"), **link}, SIDES)


def arm(givens: Givens) -> Arm:
    """Give the arm as bodies: 1 AB, 2 BC with the guide, 3 the rod of the slide with the gripper."""
    datum, turn = int(givens.measured == "relative"), 0.0 if givens.slide == "along" else -pi / 2
    return Arm((
        Pair("turn", "Theta1"), Pair("turn", "Theta2", "l_AB", datum), Pair("slide", "h3", "l_BC", turn=turn),
    ))  # fmt: skip


def oracle(givens: Givens) -> Values:
    """The same names by another way: bodies and joints, Newton's method, linear equations for the rates."""
    return motion.oracle(arm(givens), numbers(givens), doubled="l_AB")


def judged_by(givens: Givens, values: Values, states: States) -> Mechanism:
    """Give the true motion at the drawn states."""
    return motion.mechanism(arm(givens), SIDES, steps(givens), states)


def machine(givens: Givens) -> Machine:
    """Give the arm as the page of the laboratory moves it."""
    return motion.machine(arm(givens), SIDES)


def rate_alone(givens: Givens) -> Steps:
    """The turning of link 2 taken from its own coordinate only."""
    return {"omega3": "Theta2_d", "epsilon3": "Theta2_dd"} if givens.measured == "relative" else {}


EXERCISE = Exercise(
    systems=("VP-6", "RP-2"),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers=_arm.answers(),
    references=_arm.references(judged_by),
    mistakes={
        "angle_of_the_other_kind": Mistake(lambda g: turned(g.measured != "relative")),
        "rate_alone": Mistake(rate_alone),
        "slide_along_the_first_link": Mistake(lambda g: {"alpha3": slid(g, "Theta1")}),
        "degrees_as_radians": Mistake(Theta1="Theta1*180/pi", Theta2="Theta2*180/pi"),
        **_arm.slips(lambda _: SIDES),
    },
    report=_arm.REPORT,
    machine=machine,
    minutes=90,
)
