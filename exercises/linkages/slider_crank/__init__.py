"""Slider-crank by the vector-polygon method (laboratory sheet TMM-2, section 2; domain VP-2).

Angles counter-clockwise from OX, radians inside. The assembly whose slider lies towards +X.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, radians

from exercises.exercise import Draw, Exercise, Mistake, Values, given
from graders import Expression, Quantity

ANGLES = [a for a in range(20, 161, 5) if a not in (45, 90, 135)]  # 45: sin = cos; 90: omega2 = 0


@dataclass(frozen=True, slots=True)
class Givens:
    l1: float = given(0.04, 0.12)  # crank, m
    l2: float = given(0.1, 0.6)  # connecting rod, m
    alpha1: float = given(0, 2 * pi)  # crank angle from OX, rad
    omega1: float = given(5, 40)  # crank angular velocity, rad/s


def draw(rng: Draw) -> Givens:
    """Draw whole millimetres and degrees: the student solves the printed numbers."""
    crank = rng.pick(range(40, 121, 5))
    rod = crank * rng.pick((3, 4, 5)) - rng.pick(range(0, 20, 5))  # always longer than the crank
    return Givens(crank / 1000, rod / 1000, radians(rng.pick(ANGLES)), rng.pick(range(5, 41)))


def oracle(givens: Givens) -> Values:
    """The same names by another way: Newton's method on the closure, not steps (4)-(9)."""
    from mechanics import planar  # grading does without it

    motion = planar.slider_crank(givens.l1, givens.l2, givens.alpha1, givens.omega1)
    return {
        "alpha2": motion.rod_angle,
        "l3": motion.slider,
        "omega2": motion.rod_speed,
        "v3": motion.slider_speed,
    }


EXERCISE = Exercise(
    systems=("VP-2",),
    givens=Givens,
    draw=draw,
    steps={
        "alpha2": "-asin(l1*sin(alpha1)/l2)",  # (4)
        "l3": "l1*cos(alpha1) + l2*cos(alpha2)",  # (5)
        "omega2": "-l1*omega1*cos(alpha1)/(l2*cos(alpha2))",  # (8)
        "v3": "-l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2)",  # (9)
    },
    oracle=oracle,
    answers={
        "alpha2": Quantity("deg", rtol=0.005),
        "l3": Quantity("mm", rtol=0.005),
        "omega2_formula": Expression(step="omega2", rates=("alpha2_d",)),
        "omega2": Quantity("rad/s", rtol=0.005),
        "v3": Quantity("m/s", rtol=0.005),
    },
    mistakes={
        "lost_minus": Mistake(alpha2="asin(l1*sin(alpha1)/l2)"),
        "other_arc": Mistake(alpha2="pi + asin(l1*sin(alpha1)/l2)"),
        "sine_for_cosine": Mistake(omega2="-l1*omega1*sin(alpha1)/(l2*cos(alpha2))"),
        "degrees_as_radians": Mistake(alpha1="alpha1*180/pi"),
        "speed_lost_minus": Mistake(omega2="l1*omega1*cos(alpha1)/(l2*cos(alpha2))"),
        "rod_term_lost": Mistake(v3="-l1*omega1*sin(alpha1)"),
        "speed_of_the_pin": Mistake(v3="l1*omega1"),
    },
)
