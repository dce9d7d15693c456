"""TMM-2, manipulator OOP: polygon, derivatives, velocity and acceleration of the gripper (domain VP-6, RP-2).

Nodes A, B (revolutes), C (slide), D (gripper). Theta1 from +X; Theta2 from the direction of AB or from +X, as the task
says; the slide runs along BC or across it, to the right. Angles counter-clockwise, radians inside.
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
    Side("l_BC", "alpha2", "omega3", "epsilon3"),
    Side("h3", "alpha3", "omega3", "epsilon3", slides=True),
)
ELBOW = Elbow("Theta1", "Theta2", "alpha2")


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
    measured: str = option(*MEASURED)
    slide: str = option("along", "across")


def slid(givens: Givens, link: str) -> str:
    """Write the direction of the slide on a link."""
    return link if givens.slide == "along" else f"{link} - pi/2"


def steps(givens: Givens) -> Steps:
    """Directions of the links, then all that follows from the polygon."""
    link = ELBOW.turned(givens.measured == "relative")
    return _arm.steps({"alpha2": link["alpha2"], "alpha3": slid(givens, "alpha2"), **link}, SIDES)


def arm(givens: Givens) -> Arm:
    """Give the arm as bodies: 1 AB, 2 BC with the guide, 3 the rod of the slide with the gripper."""
    datum, turn = int(givens.measured == "relative"), 0.0 if givens.slide == "along" else -pi / 2
    return Arm((
        Pair("turn", "Theta1"), Pair("turn", "Theta2", "l_AB", datum), Pair("slide", "h3", "l_BC", turn=turn),
    ))  # fmt: skip


EXERCISE = Laboratory(
    systems=("VP-6", "RP-2"),
    givens=Givens,
    joints="RRP",
    slides=("along", "across"),
    elbow=ELBOW,
    steps=steps,
    arm=arm,
    sides=lambda _: SIDES,
    doubled="l_AB",
    mistakes={
        "slide_along_the_first_link": Mistake(lambda g: {"alpha3": slid(g, "Theta1")}),
    },
).exercise()
