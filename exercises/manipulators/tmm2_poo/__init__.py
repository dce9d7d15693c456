"""TMM-2, manipulator POO: polygon, derivatives, velocity and acceleration of the gripper (domain VP-8, RP-2).

The base slides from A to B along x or y; B and C are revolutes, D the gripper. Theta2 from +X; Theta3 from the
direction of BC or from +X, as the task says. Angles counter-clockwise, radians inside.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from exercises.exercise import Mistake, Steps, given, option
from exercises.manipulators import _arm
from exercises.manipulators._arm import Side, Sides
from exercises.manipulators._arm.laboratory import MEASURED, Elbow, Laboratory
from exercises.manipulators._arm.motion import Arm
from figures.machine import Pair

LINKS = (Side("l_BC", "Theta2", "Theta2_d", "Theta2_dd"), Side("l_CD", "alpha3", "omega3", "epsilon3"))
SIDES: dict[str, Sides] = {
    "horizontal": (Side("h1", "0", slides=True), *LINKS),
    "vertical": (Side("h1", "pi/2", slides=True), *LINKS),
}
WITH_THE_LINK: dict[str, Sides] = {  # the slide taken to turn with BC
    "horizontal": (Side("h1", "Theta2", slides=True), *LINKS),
    "vertical": (Side("h1", "(Theta2 + pi/2)", slides=True), *LINKS),
}
ELBOW = Elbow("Theta2", "Theta3", "alpha3")


@dataclass(frozen=True, slots=True)
class Givens:
    l_BC: float = given(0.2, 0.8)  # link 2, m
    l_CD: float = given(0.2, 0.8)  # last link, m
    h1: float = given(0.05, 0.5)  # travel of the base, m
    Theta2: float = given(-pi, pi)  # rad
    Theta3: float = given(-pi, pi)  # rad
    h1_d: float = given(-0.5, 0.5)  # m/s
    Theta2_d: float = given(-2, 2)  # rad/s
    Theta3_d: float = given(-2, 2)  # rad/s
    h1_dd: float = given(-1, 1)  # m/s^2
    Theta2_dd: float = given(-3, 3)  # rad/s^2
    Theta3_dd: float = given(-3, 3)  # rad/s^2
    measured: str = option(*MEASURED)
    slide: str = option("vertical", "horizontal")


def steps(givens: Givens) -> Steps:
    """Direction of the last link, then all that follows from the polygon."""
    return _arm.steps(ELBOW.turned(givens.measured == "relative"), SIDES[givens.slide])


def arm(givens: Givens) -> Arm:
    """Give the arm as bodies: 1 the slide, 2 BC, 3 CD with the gripper."""
    turn, datum = 0.0 if givens.slide == "horizontal" else pi / 2, 2 if givens.measured == "relative" else 0
    return Arm((Pair("slide", "h1", turn=turn), Pair("turn", "Theta2"), Pair("turn", "Theta3", "l_BC", datum)), "l_CD")


def slide_turned(givens: Givens) -> Steps:
    """The direction of the slide turned with link BC."""
    sides = WITH_THE_LINK[givens.slide]
    return {"x_D": _arm.place(sides, "x"), "y_D": _arm.place(sides, "y"), **_arm.gripper(sides)}


def coriolis_invented(givens: Givens) -> Steps:
    """A Coriolis term of a slide that does not turn."""
    own = _arm.gripper(SIDES[givens.slide])
    return {
        "a_x": f"{own['a_x']} - 2*h1_d*Theta2_d*sin(Theta2)",
        "a_y": f"{own['a_y']} + 2*h1_d*Theta2_d*cos(Theta2)",
    }


def push_lost(givens: Givens) -> Steps:
    """The acceleration of the slide left out."""
    own = _arm.gripper(SIDES[givens.slide], ("pushing",))
    return {"a_x": own["a_x"], "a_y": own["a_y"]}


EXERCISE = Laboratory(
    systems=("VP-8", "RP-2"),
    givens=Givens,
    joints="PRR",
    slides=("vertical", "horizontal"),
    elbow=ELBOW,
    steps=steps,
    arm=arm,
    sides=lambda givens: SIDES[givens.slide],
    doubled="l_BC",
    mistakes={
        "slide_turned": Mistake(slide_turned),
        "coriolis_invented": Mistake(coriolis_invented),
        "push_lost": Mistake(push_lost),
    },
    carried=False,
).exercise()
