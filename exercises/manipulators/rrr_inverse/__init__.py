"""Inverse position task of the RRR group: every q that carries M to a point (domain DH-25, direct task DH-15).

Angles in radians inside. q1 about the vertical axis from x, q2 up from the level, q3 bends link 3 down from link 2;
the direct task is x = rho cos q1, y = rho sin q1 with rho = L2 cos q2 + L3 cos(q2 - q3), and
z = L1 + L2 sin q2 + L3 sin(q2 - q3). Facing M (rho > 0) or turned away from it (rho < 0), bent down or up: four ways.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, radians, remainder

from exercises.exercise import Draw, Exercise, Mistake, Steps, Values, given
from graders import Integer, Quantity, Set
from mechanics import rod_groups

LENGTHS = range(200, 601, 20)  # mm
TURNS = [a for a in range(-170, 180, 5) if 15 < a % 90 < 75]  # of the first joint, degrees
LIFTS = [a for a in range(-30, 76, 5) if a]
BENDS = [a for a in range(25, 126, 5) if a != 90]
NEAR = 0.1  # no coordinate of M is shorter, m
Branches = tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class Givens:
    L1: float = given(0.2, 0.6)  # height of the second joint, m
    L2: float = given(0.2, 0.6)  # link 2, m
    L3: float = given(0.2, 0.6)  # link 3 to the point M, m
    x: float = given(-1.2, 1.2)  # M in base axes, m
    y: float = given(-1.2, 1.2)
    z: float = given(-1.2, 1.8)


def draw(rng: Draw) -> Givens:
    """Draw the arm in whole degrees and print M to the millimetre, away from the axes and from full reach."""
    L1, L2, L3 = (length / 1000 for length in rng.sample(LENGTHS, 3))
    q = [radians(rng.pick(degrees)) for degrees in (TURNS, LIFTS, BENDS)]
    x, y, z = (round(c, 3) for c in rod_groups.direct("RRR", {"L1": L1, "L2": L2, "L3": L3}, q))
    if min(map(abs, (x, y, z, z - L1))) < NEAR:
        rng.reject()
    return Givens(L1, L2, L3, x, y, z)


def oracle(givens: Givens) -> Values:
    """The same branches by half angles."""
    lengths = {"L1": givens.L1, "L2": givens.L2, "L3": givens.L3}
    q = rod_groups.inverse("RRR", lengths, (givens.x, givens.y, givens.z))
    return {"c3": cos(q[0][2]), "q": q, "n": float(len(q))}


def branches(phi: float, epsilon: float, beta: float, theta3: float) -> Branches:
    """List the branches: facing M and turned away, in each bent down and up."""
    facing = [(phi, epsilon + beta, theta3), (phi, epsilon - beta, -theta3)]
    away = [(phi + pi, pi - epsilon + beta, theta3), (phi + pi, pi - epsilon - beta, -theta3)]
    return tuple(tuple(remainder(angle, 2 * pi) for angle in branch) for branch in facing + away)


def bent_down(phi: float, epsilon: float, beta: float, theta3: float) -> Branches:
    """List the branches with the bend down only."""
    return (
        (phi, epsilon + beta, theta3),
        (remainder(phi + pi, 2 * pi), remainder(pi - epsilon + beta, 2 * pi), theta3),
    )


def facing_only(phi: float, epsilon: float, beta: float, theta3: float) -> Branches:
    """List the branches that face M."""
    return (phi, epsilon + beta, theta3), (phi, epsilon - beta, -theta3)


def lost_quadrant(givens: Givens) -> Steps:
    """Behind the base, where x < 0, the arc tangent of y/x points the other way."""
    return {"phi": "atan(y/x)"} if givens.x < 0 else {}


EXERCISE = Exercise(
    systems=("DH-25",),
    givens=Givens,
    draw=draw,
    steps={
        "rho": "sqrt(x^2 + y^2)",
        "h": "z - L1",
        "c3": "(rho^2 + h^2 - L2^2 - L3^2)/(2*L2*L3)",
        "theta3": "acos(c3)",
        "beta": "atan2(L3*sin(theta3); L2 + L3*c3)",
        "epsilon": "atan2(h; rho)",
        "phi": "atan2(y; x)",
        "q": branches,
        "n": lambda q: float(len(q)),
    },
    oracle=oracle,
    answers={
        "c3": Quantity("1", rtol=0.005, atol=0.0005),
        "q": Set(("deg", "deg", "deg"), names=("q1", "q2", "q3"), rtol=0.005, atol=radians(0.2), weight=4),
        "n": Integer(),
    },
    mistakes={
        "bend_down_only": Mistake(q=bent_down),
        "facing_only": Mistake(q=facing_only),
        "base_forgotten": Mistake(h="z"),
        "inner_angle": Mistake(c3="(L2^2 + L3^2 - rho^2 - h^2)/(2*L2*L3)"),
        "correction_sign": Mistake(beta="atan2(-L3*sin(theta3); L2 + L3*c3)"),
        "lost_quadrant": Mistake(lost_quadrant),
    },
    minutes=40,
)
