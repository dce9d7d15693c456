"""Stepped shaft fixed at one end: torques, stress, twist, required diameter (domain SM-7, SM-8, SM-9).

x to the right, torques and rotations positive about +x; T in a section is the sum of the torques to its right, the
wall included.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import radians

from exercises.exercise import Answers, Draw, Exercise, Mistake, Steps, Values, given, option
from exercises.strength.stepped_shaft import lines
from exercises.strength.stepped_shaft.parts import Against, Along, Segment, Solid, Torque, Tube, structure
from graders import Choice, Expression, Quantity
from mechanics import frame, shaft
from mechanics.torsion_frame import polar_moment

SOLID = [(d, 0) for d in range(25, 96, 5)]  # mm
TUBES = [(D, d) for D in range(50, 96, 5) for d in range(20, 46, 5) if 0.4 <= d / D <= 0.8]  # mm


@dataclass(frozen=True, slots=True)
class Givens:
    segments: tuple[Segment, ...]  # from left to right
    torques: tuple[Torque, ...]  # at the end of each segment away from the wall
    wall: str = option("left", "right")
    G: float = given(4e10, 8.1e10)  # shear modulus, Pa
    tau_adm: float = given(3e7, 8e7)  # allowable stress, Pa
    theta_adm: float = given(0.004, 0.03)  # allowable twist, rad/m


def draw(rng: Draw) -> Givens:
    """Draw torques of both senses, then segments that they load well, no two neighbours of one diameter."""
    count, wall = rng.pick((2, 3, 3, 4)), rng.pick(("left", "right"))
    torques = tuple(drawn_torque(rng) for _ in range(count))
    segments: list[Segment] = []
    taken = 0
    for T in lines.inner_torques(torques, wall):
        sizes = TUBES if rng.below(3) == 0 else SOLID
        fitting = [(D, d) for D, d in sizes if taken != D and 0.02 < lines.stress(T, D, d) < 0.07]  # 20 to 70 MPa
        if not fitting:
            rng.reject()
        taken, bore = rng.pick(fitting)
        length = rng.pick(range(20, 81, 5)) / 100
        segments.append(Tube(length, taken / 1000, bore / 1000) if bore else Solid(length, taken / 1000))
    G, tau_adm = 1e9 * rng.pick((40, 78, 80, 81)), 1e6 * rng.pick((30, 40, 50, 60, 80))
    theta_adm = radians(rng.pick((0.25, 0.5, 0.75, 1, 1.25, 1.5)))
    givens = Givens(tuple(segments), torques, wall, G, tau_adm, theta_adm)
    return rng.reject() if degenerate(givens) else givens


def drawn_torque(rng: Draw) -> Torque:
    """Draw a torque of 100 to 1000 N m."""
    M = 50.0 * rng.pick(range(2, 21))
    return Along(M) if rng.below(2) else Against(M)


def degenerate(givens: Givens) -> bool:
    """Tell whether all torques turn one way, the twists nearly cancel, or neither design condition clearly governs."""
    solved = shaft.solve(structure(givens))
    twists = [piece.twist for piece in solved.pieces]
    design = solved.design
    assert design and design.D_strength and design.D_stiffness
    return (
        len({type(torque) for torque in givens.torques}) == 1
        or abs(sum(twists)) < max(0.005, 0.2 * sum(map(abs, twists)))
        or abs(design.D_strength / design.D_stiffness - 1) < 0.03
    )


def oracle(givens: Givens) -> Values:
    """The same names by the stiffness method; diameters sought until a condition just holds, J summed over rings."""
    solved = frame.solve_shaft(structure(givens))
    T = abs(solved.extreme_torque()[1])
    d_tau = least(lambda d: T * d / 2 / polar_moment(d, 0) / givens.tau_adm)
    d_theta = least(lambda d: T / givens.G / polar_moment(d, 0) / givens.theta_adm)
    return {
        **{f"T{i}": torque for i, torque in enumerate(solved.torques, 1)},
        "tau_max": max(solved.stresses),
        "phi": solved.rotations[-1 if givens.wall == "left" else 0],
        "d_tau": d_tau,
        "d_theta": d_theta,
        "governs": "strength" if d_tau > d_theta else "stiffness",
    }


def least(use: Callable[[float], float]) -> float:
    """Halve the range of diameters, in metres, until the use of what is allowed is one."""
    low, high = 0.001, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if use(middle) > 1 else (low, middle)
    return high


def steps(givens: Givens) -> Steps:
    """Sections from the free end to the wall, stress and twist of each segment, then the two design conditions."""
    return {
        **lines.summed(givens, lines.acting(givens)),
        **lines.per_segment(givens, "J", lambda segment: segment.J),
        **lines.per_segment(givens, "W", lambda segment: segment.W),
        **lines.per_segment(givens, "tau", lambda segment: "abs(T{i})/W{i}"),
        "tau_max": lines.largest(givens, "tau{i}"),
        "phi": lines.twist(givens),
        "T_max": lines.largest(givens, "abs(T{i})"),
        "d_tau": "root(16*T_max/(pi*tau_adm); 3)",
        "d_theta": "root(32*T_max/(pi*G*theta_adm); 4)",
        "governs": lambda d_tau, d_theta: "strength" if d_tau > d_theta else "stiffness",
    }


def answers(givens: Givens) -> Answers:
    """The torques are asked for in the order of solving."""
    return {
        **{f"T{i}": Quantity("N*m", rtol=0.005, atol=0.2) for i in lines.order(givens)},
        "tau_max": Quantity("MPa", rtol=0.01),
        "phi_formula": Expression(step="phi"),
        "phi": Quantity("deg", rtol=0.01, atol=radians(0.002)),
        "d_tau": Quantity("mm", rtol=0.005),
        "d_theta": Quantity("mm", rtol=0.005),
        "governs": Choice(("strength", "stiffness")),
    }


EXERCISE = Exercise(
    systems=("SM-7", "SM-8", "SM-9"),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers=answers,
    mistakes={
        "external_read": Mistake(lines.read_as_inner),
        "senses_ignored": Mistake(lines.unsigned_torques),
        "radius_for_diameter": Mistake(lambda givens: lines.moduli(givens, lines.by_radius)),
        "axial_moduli": Mistake(lambda givens: lines.moduli(givens, lambda line: line + "/2")),
        "difference_of_moduli": Mistake(lines.difference),
        "bores_ignored": Mistake(lines.bores_ignored),
        "moment_for_modulus": Mistake(lambda givens: lines.per_segment(givens, "W", lambda segment: segment.J)),
        "modulus_for_moment": Mistake(lambda givens: lines.per_segment(givens, "J", lambda segment: segment.W)),
        "unsigned_twist": Mistake(lines.unsigned_twist),
        "largest_load": Mistake(lines.largest_load),
        "degrees_for_radians": Mistake(theta_adm="theta_adm*180/pi"),
        "bending_diameter": Mistake(d_tau="root(32*T_max/(pi*tau_adm); 3)"),
        "smaller_diameter": Mistake(governs=lambda d_tau, d_theta: "strength" if d_tau < d_theta else "stiffness"),
    },
    minutes=40,
)
