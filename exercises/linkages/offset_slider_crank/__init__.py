"""Offset slider-crank: the equation of its position, one position and velocity, the stroke, the full turn (VP-3).

Angles counter-clockwise from OX, radians inside; the guide lies at y = h above the pivot of the crank, the slider on
the side of +X. The rod angle is that of the vector from B to C.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, cos, pi, radians, sin

from exercises.exercise import Draw, Exercise, Mistake, Values, given
from graders import Equation, Inequality, Quantity

ANGLES = [a for a in range(20, 346, 5) if a % 90 not in (0, 45)]
SLOPE = 4.0  # least angle of the rod, degrees
DEAD = 0.3  # least speed of the slider, of that of the crank pin
DEAD_POSITIONS = (0.2, pi + 0.2)  # near them the search for the ends of the stroke begins
STEPS = 6
FURTHEST = 0.8  # no slider is further from A, m


@dataclass(frozen=True, slots=True)
class Givens:
    l1: float = given(0.05, 0.12)  # crank AB, m
    l2: float = given(0.13, 0.6)  # connecting rod BC, m
    h: float = given(0.01, 0.09)  # height of the guide over A, m
    alpha1: float = given(0, 2 * pi)  # crank angle from OX, rad
    omega1: float = given(5, 40)  # crank angular velocity, rad/s


def draw(rng: Draw) -> Givens:
    """Draw whole millimetres and degrees; the crank turns fully, rod and slider are far from special positions."""
    crank = rng.pick(range(60, 111, 5))
    offset = 5 * rng.pick(range(crank // 12, crank * 4 // 25 + 1))
    rod = crank + offset + 5 * rng.pick(range(crank // 5, crank * 2 // 5))
    drawn = Givens(crank / 1000, rod / 1000, offset / 1000, radians(rng.pick(ANGLES)), rng.pick(range(6, 36)))
    slope = asin((drawn.h - drawn.l1 * sin(drawn.alpha1)) / drawn.l2)
    speed = sin(slope - drawn.alpha1) / cos(slope)  # of the slider, over that of the crank pin
    if abs(slope) < radians(SLOPE) or abs(speed) < DEAD:
        rng.reject()
    return drawn


def oracle(givens: Givens) -> Values:
    """The same names by another way: three bodies by Newton's method, its ends of the stroke, the tightest pose."""
    from mechanics import planar  # grading does without it

    g = givens
    motion = planar.slider_crank(g.l1, g.l2, g.alpha1, g.omega1, offset=g.h)
    far, near = (_end(g, start) for start in DEAD_POSITIONS)
    return {
        "c": min(g.l2 - abs(g.h - g.l1 * sin(radians(angle))) for angle in range(0, 360, 5)),
        "l3": motion.slider,
        "alpha2": motion.rod_angle,
        "omega2": motion.rod_speed,
        "v3": motion.slider_speed,
        "H": far - near,
    }


def _end(g: Givens, angle: float) -> float:
    """Find where the slider turns round: its velocity is zero there, its acceleration is the slope of that."""
    from mechanics import planar

    for _ in range(STEPS):
        motion = planar.slider_crank(g.l1, g.l2, angle, 1.0, offset=g.h)
        angle -= motion.slider_speed / motion.slider_acceleration
    return planar.slider_crank(g.l1, g.l2, angle, 1.0, offset=g.h).slider


EXERCISE = Exercise(
    systems=("VP-3",),
    version=3,
    givens=Givens,
    draw=draw,
    steps={
        "c": "l2 - l1 - h",
        "l3": "l1*cos(alpha1) + sqrt(l2^2 - (h - l1*sin(alpha1))^2)",
        "alpha2": "asin((h - l1*sin(alpha1))/l2)",
        "omega2": "-l1*omega1*cos(alpha1)/(l2*cos(alpha2))",
        "v3": "-l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2)",
        "H": "sqrt((l2 + l1)^2 - h^2) - sqrt((l2 - l1)^2 - h^2)",
    },
    oracle=oracle,
    answers={
        "turning": Inequality("l1 + h <= l2", step="c"),
        "position": Equation(
            step="l3",
            span=(-FURTHEST, FURTHEST),
            equation="(l3 - l1*cos(alpha1))^2 + (h - l1*sin(alpha1))^2 = l2^2",
            branch=True,  # the slider is on the side of +X, so the greater root alone is right as well
        ),
        "l3": Quantity("mm", rtol=0.005),
        "alpha2": Quantity("deg", rtol=0.005),
        "v3": Quantity("m/s", rtol=0.005),
        "H": Quantity("mm", rtol=0.005),
    },
    mistakes={
        "guide_below": Mistake(h="-h"),
        "offset_forgotten": Mistake(h="0*h"),
        "other_assembly": Mistake(l3="l1*cos(alpha1) - sqrt(l2^2 - (h - l1*sin(alpha1))^2)"),
        "rod_reversed": Mistake(alpha2="asin((l1*sin(alpha1) - h)/l2)"),
        "rod_term_lost": Mistake(v3="-l1*omega1*sin(alpha1)"),
        "rod_speed_lost_minus": Mistake(omega2="l1*omega1*cos(alpha1)/(l2*cos(alpha2))"),
        "stroke_of_the_centric": Mistake(H="2*l1"),
        "legs_for_hypotenuse": Mistake(H="sqrt((l2 + l1)^2 + h^2) - sqrt((l2 - l1)^2 + h^2)"),
        "degrees_as_radians": Mistake(alpha1="alpha1*180/pi"),
    },
)
