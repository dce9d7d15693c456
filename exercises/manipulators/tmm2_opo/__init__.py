"""TMM-2, manipulator OPO: polygon, derivatives, velocity and acceleration of the gripper (domain VP-7, RP-2).

Nodes A (revolute), B (slide), C (revolute), D (gripper). Theta1 from +X; the slide runs along AB or across it, to the
left; Theta3 from the direction of AB or from +X, as the task says. Angles counter-clockwise, radians inside.
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

SIDES: Sides = (
    Side("l_AB", "Theta1", "Theta1_d", "Theta1_dd"),
    Side("h2", "alpha2", "Theta1_d", "Theta1_dd", slides=True),
    Side("l_CD", "alpha3", "omega3", "epsilon3"),
)
ELBOW = Elbow("Theta1", "Theta3", "alpha3")


@dataclass(frozen=True, slots=True)
class Givens:
    l_AB: float = given(0.2, 0.8)  # link 1, m
    l_CD: float = given(0.2, 0.8)  # last link, m
    h2: float = given(0.05, 0.5)  # travel of the slide, m
    Theta1: float = given(-pi, pi)  # rad
    Theta3: float = given(-pi, pi)  # rad
    Theta1_d: float = given(-2, 2)  # rad/s
    h2_d: float = given(-0.5, 0.5)  # m/s
    Theta3_d: float = given(-2, 2)  # rad/s
    Theta1_dd: float = given(-3, 3)  # rad/s^2
    h2_dd: float = given(-1, 1)  # m/s^2
    Theta3_dd: float = given(-3, 3)  # rad/s^2
    measured: str = option(*MEASURED)
    slide: str = option("along", "across")


def slid(givens: Givens, link: str) -> str:
    """Write the direction of the slide on a link."""
    return link if givens.slide == "along" else f"{link} + pi/2"


def steps(givens: Givens) -> Steps:
    """Directions of slide and last link, then all that follows from the polygon."""
    return _arm.steps({"alpha2": slid(givens, "Theta1"), **ELBOW.turned(givens.measured == "relative")}, SIDES)


def arm(givens: Givens) -> Arm:
    """Give the arm as bodies: 1 AB with the guide, 2 the rod of the slide, 3 CD with the gripper."""
    datum, turn = int(givens.measured == "relative"), 0.0 if givens.slide == "along" else pi / 2
    pairs = Pair("turn", "Theta1"), Pair("slide", "h2", "l_AB", turn=turn), Pair("turn", "Theta3", datum=datum)
    return Arm(pairs, tip="l_CD")


EXERCISE = Laboratory(
    systems=("VP-7", "RP-2"),
    givens=Givens,
    joints="RPR",
    slides=("along", "across"),
    elbow=ELBOW,
    steps=steps,
    arm=arm,
    sides=lambda _: SIDES,
    doubled="l_AB",
    mistakes={
        "slide_turned_with_the_last_link": Mistake(lambda g: {"alpha2": slid(g, "Theta1 + Theta3")}),
    },
).exercise()
