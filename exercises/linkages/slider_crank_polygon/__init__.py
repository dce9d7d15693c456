"""Slider-crank: polygon, velocity and acceleration equations without a key (domain VP-1, VP-2).

Angles counter-clockwise from OX, radians inside. The assembly whose slider lies towards +X. Vectors and unknowns are
named by the student; what the task names keeps its meaning.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, radians, sin, sqrt

from exercises.exercise import Draw, Exercise, Mistake, Values, given
from exercises.linkages.slider_crank_polygon.motion import NODES, mechanism
from figures.machine import Drive, Link, Machine, Pair, Plotted
from graders import Polygon, Quantity, Rates, States
from graders.polygon.mechanism import Mechanism
from mechanics import planar, slider_crank

ANGLES = [a for a in range(20, 341, 5) if a % 90 not in (0, 5, 45, 85)]  # far from where an answer vanishes
SPANS = (0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.8, 1.0, 1.5)  # s
CANCELLED = 0.2  # a sum that is smaller than this part of its terms is lost in the rounding of earlier answers


@dataclass(frozen=True, slots=True)
class Givens:
    l1: float = given(0.04, 0.12)  # crank, m
    l2: float = given(0.1, 0.6)  # connecting rod, m
    alpha1: float = given(0, 2 * pi)  # crank angle from OX, rad
    omega1: float = given(5, 40)  # crank angular velocity, rad/s
    epsilon1: float = given(-200, 200)  # crank angular acceleration, rad/s^2


def draw(rng: Draw) -> Givens:
    """Draw whole millimetres and degrees: the student solves the printed numbers."""
    crank = rng.pick(range(40, 121, 5))
    rod = crank * rng.pick((3, 4, 5)) - rng.pick(range(0, 20, 5))
    omega = rng.pick(range(5, 41))
    epsilon = rng.pick((-1, 1)) * rng.pick(range(20, 201, 10))
    drawn = Givens(crank / 1000, rod / 1000, radians(rng.pick(ANGLES)), omega, epsilon)
    if _cancelled(drawn):
        rng.reject()
    return drawn


def _cancelled(g: Givens) -> bool:
    """Tell whether a result is the small difference of large terms."""
    alpha2, _, omega2, v3, epsilon2, a3 = slider_crank.motion(g.l1, g.l2, g.alpha1, g.omega1, g.epsilon1)
    turned, slid = sin(alpha2), cos(alpha2)
    pulls = [g.l1 * g.omega1**2, g.l1 * g.epsilon1, g.l2 * omega2**2, g.l2 * epsilon2]
    along = [pulls[0] * cos(g.alpha1), pulls[1] * sin(g.alpha1), pulls[2] * slid, pulls[3] * turned]
    across = [pulls[0] * sin(g.alpha1), pulls[1] * cos(g.alpha1), pulls[2] * turned]
    speeds = [g.l1 * g.omega1 * sin(g.alpha1), g.l2 * omega2 * turned]
    return (
        abs(a3) < CANCELLED * sum(map(abs, along))
        or abs(pulls[3] * slid) < CANCELLED * sum(map(abs, across))
        or abs(v3) < CANCELLED * sum(map(abs, speeds))
    )


def oracle(givens: Givens) -> Values:
    """The same names by another way: Newton's method on the closure, linear equations for the rates."""
    motion = planar.slider_crank(givens.l1, givens.l2, givens.alpha1, givens.omega1, givens.epsilon1)
    return {
        "alpha2": motion.rod_angle,
        "l3": motion.slider,
        "omega2": motion.rod_speed,
        "v3": motion.slider_speed,
        "epsilon2": motion.rod_acceleration,
        "a3": motion.slider_acceleration,
    }


def judged_by(givens: Givens, values: Values, states: States) -> Mechanism:
    """Give the true motion at the drawn states; it does not depend on this variant's numbers."""
    return mechanism(states)


def machine(givens: Givens) -> Machine:
    """Give the mechanism as the page of the laboratory moves it: about a turn of the crank at its growing speed."""
    gain = abs(givens.epsilon1)
    turn = 4 * pi / (givens.omega1 + sqrt(givens.omega1**2 + 4 * pi * gain))
    return Machine(
        drives=(Drive("alpha1", "omega1", "epsilon1"),),
        pairs=(Pair("turn", "alpha1"),),
        links=(Link("l1", "A", "B"), Link("l2", "B", "C")),
        plotted=(Plotted("x", "l3", "v3", "a3"),),
        span=next(span for span in SPANS if span >= turn),
        tip="l1",
        rod="l2",
    )


EXERCISE = Exercise(
    systems=("VP-1", "VP-2"),
    givens=Givens,
    draw=draw,
    steps={
        "alpha2": "-asin(l1*sin(alpha1)/l2)",  # (4)
        "l3": "l1*cos(alpha1) + l2*cos(alpha2)",  # (5)
        "omega2": "-l1*omega1*cos(alpha1)/(l2*cos(alpha2))",  # (8)
        "v3": "-l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2)",  # (9)
        "epsilon2": "(l1*(omega1^2*sin(alpha1) - epsilon1*cos(alpha1)) + l2*omega2^2*sin(alpha2))/(l2*cos(alpha2))",
        "a3": "-l1*(omega1^2*cos(alpha1) + epsilon1*sin(alpha1)) - l2*(omega2^2*cos(alpha2) + epsilon2*sin(alpha2))",
    },  # (12), (13)
    oracle=oracle,
    answers={
        "polygon": Polygon(NODES, step="alpha2", weight=3.0),
        "alpha2": Quantity("deg", rtol=0.005),
        "l3": Quantity("mm", rtol=0.005),
        "velocities": Rates("polygon", 1, step="alpha2", weight=2.0),
        "omega2": Quantity("rad/s", rtol=0.005),
        "v3": Quantity("m/s", rtol=0.005),
        "accelerations": Rates("polygon", 2, step="alpha2", weight=2.0),
        "epsilon2": Quantity("rad/s^2", rtol=0.01),
        "a3": Quantity("m/s^2", rtol=0.01),
    },
    report={
        7: ("polygon",),
        8: ("polygon",),
        9: ("alpha2", "l3"),
        10: ("velocities", "accelerations"),
        11: ("omega2", "epsilon2"),
        12: ("v3", "a3"),
    },
    machine=machine,
    references=dict.fromkeys(("polygon", "velocities", "accelerations"), judged_by),
    mistakes={
        "lost_minus": Mistake(alpha2="asin(l1*sin(alpha1)/l2)"),
        "degrees_as_radians": Mistake(alpha1="alpha1*180/pi"),
        "sine_for_cosine": Mistake(omega2="-l1*omega1*sin(alpha1)/(l2*cos(alpha2))"),
        "speed_lost_minus": Mistake(omega2="l1*omega1*cos(alpha1)/(l2*cos(alpha2))"),
        "rod_term_lost": Mistake(v3="-l1*omega1*sin(alpha1)"),
        "centripetal_lost": Mistake(epsilon2="-l1*epsilon1*cos(alpha1)/(l2*cos(alpha2))"),
        "crank_taken_as_steady": Mistake(
            epsilon2="(l1*omega1^2*sin(alpha1) + l2*omega2^2*sin(alpha2))/(l2*cos(alpha2))",
            a3="-l1*omega1^2*cos(alpha1) - l2*(omega2^2*cos(alpha2) + epsilon2*sin(alpha2))",
        ),
        "rod_taken_as_steady": Mistake(
            a3="-l1*(omega1^2*cos(alpha1) + epsilon1*sin(alpha1)) - l2*omega2^2*cos(alpha2)"
        ),
    },
)
