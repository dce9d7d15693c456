"""Four-bar linkage: both assemblies, then velocity and acceleration of one (domain VP-4).

Angles counter-clockwise from OX, radians inside: alpha2 is that of the vector BC, alpha3 that of DC. The frame's pivots
are A = (0, 0) and D = (l4, 0). In the first assembly C lies on the left of the way from B to D, so that
sin(alpha3 - alpha2) > 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, radians, sin

from exercises.exercise import Draw, Exercise, Mistake, Value, Values, given
from graders import Quantity, Set
from mechanics import four_bar
from mechanics.errors import SingularError
from mechanics.newton_linkages import four_bar_motion
from mechanics.planar import Motion

ANGLES = [a for a in range(20, 341, 5) if a % 90 not in (0, 45)]
TRANSMISSION = 0.5  # least sine of the angle between coupler and rocker
CANCELLED = 0.25  # a sum that is smaller than this part of its terms is lost in the rounding of earlier answers


@dataclass(frozen=True, slots=True)
class Givens:
    l1: float = given(0.04, 0.15)  # crank AB, m
    l2: float = given(0.1, 0.6)  # coupler BC, m
    l3: float = given(0.1, 0.6)  # rocker DC, m
    l4: float = given(0.1, 0.9)  # frame AD, m
    alpha1: float = given(0, 2 * pi)  # crank angle from OX, rad
    omega1: float = given(2, 40)  # crank angular velocity, rad/s
    epsilon1: float = given(-200, 200)  # crank angular acceleration, rad/s^2


def draw(rng: Draw) -> Givens:
    """Draw a crank-rocker in whole millimetres and degrees, far from its dead positions."""
    crank = rng.pick(range(50, 121, 5))
    coupler, rocker = (crank * rng.pick((5, 6, 7, 8)) // 2 + rng.pick(range(0, 41, 5)) for _ in range(2))
    low, high = abs(coupler - rocker) + crank, coupler + rocker - crank  # Grashof: the crank turns fully
    frame = 5 * rng.pick(range((low + 20) // 5 + 1, (high - 20) // 5))
    angle = radians(rng.pick(ANGLES))
    epsilon = rng.pick((-1, 1)) * rng.pick(range(10, 151, 5))
    drawn = Givens(crank / 1000, coupler / 1000, rocker / 1000, frame / 1000, angle, rng.pick(range(4, 31)), epsilon)
    if _delicate(drawn):
        rng.reject()
    return drawn


def _delicate(g: Givens) -> bool:
    """Tell whether coupler and rocker are nearly in line, or a result is the small difference of large terms."""
    state = g.l1, g.l2, g.l3, g.l4, g.alpha1, g.omega1, g.epsilon1
    alpha2, alpha3, omega2, omega3, epsilon2, epsilon3 = four_bar.motion(*state)
    angles = alpha2, alpha3, *four_bar.motion(*state, "C_right_of_BD")[:2]
    if sin(alpha3 - alpha2) < TRANSMISSION or max(map(abs, angles)) > 2.8:
        return True
    terms = (g.l1 * g.epsilon1, g.l1 * g.omega1**2, g.l2 * omega2**2, g.l3 * omega3**2)
    turned = (alpha3 - g.alpha1, alpha2 - g.alpha1)
    size2 = sum(
        map(abs, (terms[0] * sin(turned[0]), terms[1] * cos(turned[0]), terms[2] * cos(alpha3 - alpha2), terms[3]))
    )
    size3 = sum(
        map(abs, (terms[0] * sin(turned[1]), terms[1] * cos(turned[1]), terms[3] * cos(alpha3 - alpha2), terms[2]))
    )
    return (
        min(abs(sin(angle)) for angle in turned) < CANCELLED
        or abs(epsilon2 * g.l2 * sin(alpha3 - alpha2)) < CANCELLED * size2
        or abs(epsilon3 * g.l3 * sin(alpha3 - alpha2)) < CANCELLED * size3
    )


def _motions(g: Givens) -> tuple[Motion, Motion]:
    bars = g.l1, g.l2, g.l3, g.l4
    try:
        left = four_bar_motion(*bars, g.alpha1, g.omega1, g.epsilon1)
        return left, four_bar_motion(*bars, g.alpha1, g.omega1, g.epsilon1, "C_right_of_BD")
    except SingularError as error:
        raise ArithmeticError("the draw is far from dead positions") from error


def _turning(motion: Motion, body: int) -> tuple[float, float, float]:
    """Give a body's angle in one turn, its angular velocity and acceleration."""
    angle = (motion.poses[body][2] + pi) % (2 * pi) - pi
    return angle, motion.rates[body][2], motion.accelerations[body][2]


def oracle(givens: Givens) -> Values:
    """The same names by another way: Newton's method on three bodies, linear equations for the rates."""
    first, second = _motions(givens)
    coupler, rocker = _turning(first, 2), _turning(first, 3)
    return {
        "assemblies": ((coupler[0], rocker[0]), (_turning(second, 2)[0], _turning(second, 3)[0])),
        "alpha2": coupler[0],
        "alpha3": rocker[0],
        "omega2": coupler[1],
        "omega3": rocker[1],
        "epsilon2": coupler[2],
        "epsilon3": rocker[2],
    }


def first_assembly(assemblies: tuple[tuple[float, float], ...]) -> tuple[float, float]:
    """Choose the assembly with C on the left of BD."""
    return next((row for row in assemblies if sin(row[1] - row[0]) > 0), assemblies[0])


def coupler_angle(assemblies: Value) -> float:
    """Give alpha2 of the first assembly."""
    return first_assembly(assemblies)[0]  # type: ignore[arg-type]


def rocker_angle(assemblies: Value) -> float:
    """Give alpha3 of the first assembly."""
    return first_assembly(assemblies)[1]  # type: ignore[arg-type]


ROCKER = "atan2(l1*sin(alpha1) + l2*sin({0}); l1*cos(alpha1) + l2*cos({0}) - l4)"
WITHOUT_CRANK = "atan2(l2*sin({0}); l2*cos({0}) - l4)"
WITHOUT_FRAME = "atan2(l1*sin(alpha1) + l2*sin({0}); l1*cos(alpha1) + l2*cos({0}))"
SIDES = {  # the closure differentiated twice, times the directions of rocker and coupler
    "epsilon2": "-(l1*epsilon1*sin(alpha3 - alpha1) - l1*omega1^2*cos(alpha3 - alpha1)"
    " - l2*omega2^2*cos(alpha3 - alpha2) + l3*omega3^2)/(l2*sin(alpha3 - alpha2))",
    "epsilon3": "-(l1*epsilon1*sin(alpha2 - alpha1) - l1*omega1^2*cos(alpha2 - alpha1) - l2*omega2^2"
    " + l3*omega3^2*cos(alpha3 - alpha2))/(l3*sin(alpha3 - alpha2))",
}


def _rocker(line: str) -> Mistake[Givens]:
    """The same slip in the rocker's angle of both assemblies."""
    return Mistake(alpha31=line.format("alpha21"), alpha32=line.format("alpha22"))


def _without(*terms: str) -> dict[str, str]:
    """Lose terms in both acceleration lines."""
    lines = {}
    for name, line in SIDES.items():
        for term in terms:
            line = line.replace(term, term + "*0")
        lines[name] = line
    return lines


EXERCISE = Exercise(
    systems=("VP-4",),
    version=2,
    givens=Givens,
    draw=draw,
    steps={
        "f": "sqrt((l4 - l1*cos(alpha1))^2 + (l1*sin(alpha1))^2)",
        "gamma": "atan2(-l1*sin(alpha1); l4 - l1*cos(alpha1))",
        "delta": "acos((l2^2 + f^2 - l3^2)/(2*l2*f))",
        "alpha21": "gamma + delta",
        "alpha22": "gamma - delta",
        "alpha31": ROCKER.format("alpha21"),
        "alpha32": ROCKER.format("alpha22"),
        "assemblies": "[[alpha21, alpha31], [alpha22, alpha32]]",
        "alpha2": coupler_angle,
        "alpha3": rocker_angle,
        "omega2": "-l1*omega1*sin(alpha3 - alpha1)/(l2*sin(alpha3 - alpha2))",
        "omega3": "l1*omega1*sin(alpha1 - alpha2)/(l3*sin(alpha3 - alpha2))",
        **SIDES,
    },
    oracle=oracle,
    answers={
        "assemblies": Set(("deg", "deg"), names=("alpha2", "alpha3"), rtol=0.005, atol=radians(0.1), weight=2.0),
        "omega2": Quantity("rad/s", rtol=0.01),
        "omega3": Quantity("rad/s", rtol=0.01),
        "epsilon2": Quantity("rad/s^2", rtol=0.02),
        "epsilon3": Quantity("rad/s^2", rtol=0.02),
    },
    mistakes={
        "diagonal_forgotten": Mistake(gamma="0"),
        "crank_side": Mistake(
            f="sqrt((l4 + l1*cos(alpha1))^2 + (l1*sin(alpha1))^2)", gamma="atan2(-l1*sin(alpha1); l4 + l1*cos(alpha1))"
        ),
        "rocker_reversed": _rocker(f"{ROCKER} + pi"),
        "crank_forgotten": _rocker(WITHOUT_CRANK),
        "frame_forgotten": _rocker(WITHOUT_FRAME),
        "degrees_as_radians": Mistake(alpha1="alpha1*180/pi"),
        "other_assembly": Mistake(
            alpha2=lambda assemblies: assemblies[1][0],
            alpha3=lambda assemblies: assemblies[1][1],
        ),
        "wrong_difference": Mistake(omega3="l1*omega1*sin(alpha1 - alpha3)/(l3*sin(alpha3 - alpha2))"),
        "rocker_sign": Mistake(omega3="-l1*omega1*sin(alpha1 - alpha2)/(l3*sin(alpha3 - alpha2))"),
        "centripetal_lost": Mistake(**_without("omega1^2", "omega2^2", "omega3^2")),
        "crank_taken_as_steady": Mistake(**_without("epsilon1")),
    },
)
