"""A cycle of the slider-crank as a table: position, velocity and acceleration of the slider (domain VP-2).

Angles counter-clockwise from OX, radians inside; the crank turns steadily, omega1 < 0 when it turns clockwise. The
assembly whose slider lies towards +X.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, radians

from exercises.exercise import Draw, Exercise, Mistake, Steps, Values, given, option
from exercises.linkages.slider_crank_cycle.cycle import ROWS, cycle, long_rod, steady_rod
from graders import Quantity, Series
from graders.cycle.table import Column
from mechanics import planar

COLUMNS = (
    Column("t", "s"),
    Column("alpha", "deg"),
    Column("x", "mm"),
    Column("v", "m/s", rate_of="x"),
    Column("a", "m/s^2", rate_of="v"),
)


@dataclass(frozen=True, slots=True)
class Givens:
    l1: float = given(0.03, 0.1)  # crank, m
    l2: float = given(0.07, 0.5)  # connecting rod, m
    n: float = given(60, 1500)  # turns of the crank in a minute
    alpha0: float = given(0, 2 * pi)  # crank angle at t = 0, rad
    sense: str = option("counterclockwise", "clockwise")


def draw(rng: Draw) -> Givens:
    """Draw whole millimetres and degrees; the rod is 2.5 to 5 times as long as the crank."""
    crank = rng.pick(range(30, 101, 5))
    rod = 5 * round(crank * rng.pick((25, 30, 35, 40, 45, 50)) / 50)
    turns = rng.pick(range(60, 1501, 30))
    start = radians(rng.pick([a for a in range(30, 360, 30) if a % 90]))  # on the axes alpha2 or omega2 is zero
    return Givens(crank / 1000, rod / 1000, turns, start, rng.pick(("counterclockwise", "clockwise")))


def oracle(givens: Givens) -> Values:
    """The same names by another way: Newton's method on the closure at each row, not formulas (4)-(13)."""
    omega1 = 2 * pi * givens.n / 60 * (1 if givens.sense == "counterclockwise" else -1)
    turn = 2 * pi / abs(omega1)
    times = [turn * k / ROWS for k in range(ROWS + 1)]
    found = [planar.slider_crank(givens.l1, givens.l2, givens.alpha0 + omega1 * t, omega1) for t in times]
    rows = [
        (t, givens.alpha0 + omega1 * t, one.slider, one.slider_speed, one.slider_acceleration)
        for t, one in zip(times, found, strict=True)
    ]
    first, farthest = found[0], planar.slider_crank(givens.l1, givens.l2, 0.0, 0.0).slider
    return {
        "omega1": omega1,
        "T": turn,
        "H": farthest - planar.slider_crank(givens.l1, givens.l2, pi, 0.0).slider,
        "x_0": first.slider,
        "a_0": first.slider_acceleration,
        "cycle": tuple(rows),
    }


def sign(givens: Givens) -> str:
    """Give the sign of the angular velocity."""
    return "" if givens.sense == "counterclockwise" else "-"


def steps(givens: Givens) -> Steps:
    """Speed and length of the cycle, the motion at its start by formulas, then row by row."""
    return {
        "omega1": f"{sign(givens)}2*pi*n/60",
        "T": "2*pi/abs(omega1)",
        "H": "2*l1",
        "alpha2": "-asin(l1*sin(alpha0)/l2)",  # (4)
        "x_0": "l1*cos(alpha0) + l2*cos(alpha2)",  # (5)
        "omega2": "-l1*omega1*cos(alpha0)/(l2*cos(alpha2))",  # (8)
        "v_0": "-l1*omega1*sin(alpha0) - l2*omega2*sin(alpha2)",  # (9)
        "epsilon2": "(l1*omega1^2*sin(alpha0) + l2*omega2^2*sin(alpha2))/(l2*cos(alpha2))",  # (12)
        "a_0": "-l1*omega1^2*cos(alpha0) - l2*(omega2^2*cos(alpha2) + epsilon2*sin(alpha2))",  # (13)
        "cycle": lambda l1, l2, alpha0, omega1, T: cycle(l1, l2, alpha0, omega1, T),
    }


EXERCISE: Exercise[Givens] = Exercise(
    systems=("VP-2",),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers={
        "omega1": Quantity("rad/s", rtol=0.005),
        "T": Quantity("s", rtol=0.005),
        "H": Quantity("mm", rtol=0.005),
        "cycle": Series(COLUMNS, abscissae=2, weight=3),
    },
    mistakes={
        "turns_as_radians": Mistake(lambda givens: {"omega1": f"{sign(givens)}n"}),
        "sixty_forgotten": Mistake(lambda givens: {"omega1": f"{sign(givens)}2*pi*n"}),
        "turns_a_second": Mistake(lambda givens: {"omega1": f"{sign(givens)}n/60"}),
        "other_sense": Mistake(lambda givens: {"omega1": "-2*pi*n/60" if sign(givens) == "" else "2*pi*n/60"}),
        "radius_for_stroke": Mistake(H="l1"),
        "rod_for_stroke": Mistake(H="2*l2"),
        "sum_for_stroke": Mistake(H="l1 + l2"),
        "start_at_zero": Mistake(cycle=lambda l1, l2, omega1, T: cycle(l1, l2, 0.0, omega1, T)),
        "long_rod": Mistake(cycle=lambda l1, l2, alpha0, omega1, T: long_rod(l1, l2, alpha0, omega1, T)),
        "steady_rod": Mistake(cycle=lambda l1, l2, alpha0, omega1, T: steady_rod(l1, l2, alpha0, omega1, T)),
    },
    minutes=40,
)
