"""Beam on two supports with drawn loads and overhangs (domain SM-11, SM-12, SM-14).

x from the left end, reactions and deflection positive up, sagging moment positive.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

from exercises.exercise import Draw, Exercise, Mistake, Steps, Values, each, given
from exercises.strength._beam import members as kinds
from exercises.strength._beam.lines import added, half_beam, other_reaction, reaction, slipped, supported, whole_length
from exercises.strength._beam.members import Load, Support, drawn_loads, places, structure
from exercises.strength.simple_beam.diagram import extreme_place, extremes
from exercises.strength.simple_beam.lines import elastic_line
from graders import Expression, Quantity
from mechanics import beam, frame, members
from mechanics.section import Rectangle

SECTIONS = [(b, h) for b in range(40, 161, 10) for h in range(b + 20, 3 * b, 10) if h != 2 * b]  # mm


@dataclass(frozen=True, slots=True)
class Givens:
    supports: tuple[Support, ...]  # A and B
    loads: tuple[Load, ...]  # in the order of their places
    L: float = given(3, 7)  # length, m
    b: float = given(0.04, 0.16)  # width of the section, m
    h: float = given(0.06, 0.5)  # height of the section, m
    E: float = given(7e10, 2.1e11)  # Young's modulus, Pa
    x_K: float = given(0.2, 7)  # place of the point K, m


def built(givens: Givens) -> members.Beam:
    """Give the same beam to the solvers."""
    return structure(givens, givens.E, Rectangle(givens.b, givens.h))


def draw(rng: Draw) -> Givens:
    """Draw supports and loads at whole parts of the length, then a section that they load well."""
    part, parts = rng.pick((3, 4, 5)), rng.pick(range(10, 15))  # dm
    left, right = rng.pick((0, 0, 2, 3)), parts - rng.pick((0, 0, 2, 3))
    at = [part * i / 10 for i in rng.sample([i for i in range(1, parts) if i not in (left, right)], 5)]
    givens = Givens(
        supports=(
            kinds.InsetA(part * left / 10) if left else kinds.LeftEnd(),
            kinds.InsetB(part * right / 10) if right < parts else kinds.RightEnd(),
        ),
        loads=drawn_loads(rng, at),
        L=part * parts / 10,
        b=0.1,
        h=0.2,
        E=1e9 * rng.pick((70, 200, 205, 210)),
        x_K=at[4],
    )
    M = beam.solve(built(givens)).M_abs_max
    fitting = [(b, h) for b, h in SECTIONS if 0.05 < 6 * M / (b * h * h) < 0.15]  # 50 to 150 MPa
    if not fitting:
        rng.reject()
    width, height = rng.pick(fitting)
    givens = replace(givens, b=width / 1000, h=height / 1000)
    return rng.reject() if degenerate(givens) else givens


def degenerate(givens: Givens) -> bool:
    """Tell whether an overhang is idle, q, a reaction, V or the deflection small, or the extreme of M not one place."""
    solved, (A, B) = beam.solve(built(givens)), places(givens)
    ends = [x for load in givens.loads for x in (load.a, getattr(load, "c", load.a))]
    reactions = [reaction.Fy for reaction in solved.reactions]
    between = sorted({A, B, *(x for x in ends if A < x < B)})
    found = extremes((A, B), reactions, built(givens).loads)
    near = {x for x, M in found if abs(M) > 0.95 * solved.M_abs_max}
    return (
        0 < A < min(ends)
        or max(ends) < B < givens.L
        or any(load.c - load.a < givens.L / 6 for load in givens.loads if isinstance(load, kinds.Uniform))
        or min(map(abs, reactions)) < max(600, 0.1 * solved.V_abs_max)
        or any(abs(solved.at((x1 + x2) / 2).V) < 0.02 * solved.V_abs_max for x1, x2 in pairwise(between))
        or len(near) != 1
        or any(load.a in near for load in givens.loads if isinstance(load, kinds.Couple))
        or abs(solved.at(givens.x_K).v) < max(5e-4, 0.3 * abs(solved.v_extreme))
    )


def oracle(givens: Givens) -> Values:
    """The same names by the stiffness method: displacements of nodes first, then forces, not steps R_A to v_K."""
    solved = frame.solve_beam(built(givens))
    x_M, M_max = solved.extreme_moment()
    return {
        "R_A": solved.reactions[0].Fy,
        "R_B": solved.reactions[1].Fy,
        "x_M": x_M,
        "M_max": M_max,
        "sigma_max": abs(solved.normal_stress(x_M, givens.h / 2)),
        "v_K": solved.deflection(givens.x_K),
    }


def steps(givens: Givens) -> Steps:
    """Moments about B, the sum of forces, the place where V changes sign and M there, stress, elastic line."""
    return {
        "R_A": reaction(givens),
        "R_B": f"{added(each(givens.loads, lambda load: load.total))} - R_A",
        "x_M": lambda R_A, R_B: extreme_place(givens, R_A, R_B),
        "M_max": added(each(givens, lambda member: member.moment, "x_M")),
        "W": "b*h^2/6",
        "sigma_max": "abs(M_max)/W",
        "I": "b*h^3/12",
        **elastic_line(givens),
    }


EXERCISE: Exercise[Givens] = Exercise(
    systems=("SM-11", "SM-12", "SM-14"),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers={
        "R_A_formula": Expression(step="R_A"),
        "R_A": Quantity("kN", rtol=0.005, atol=5),
        "R_B": Quantity("kN", rtol=0.005, atol=5),
        "x_M": Quantity("m", rtol=0.005, atol=0.001),
        "M_max": Quantity("kN*m", rtol=0.005),
        "sigma_max": Quantity("MPa", rtol=0.01),
        "v_K": Quantity("mm", rtol=0.01, atol=5e-6),
    },
    mistakes={
        "lever_half_beam": Mistake(half_beam),
        "couple_sense": Mistake(lambda givens: slipped(givens, kinds.OPPOSITE)),
        "reactions_exchanged": Mistake(other_reaction),
        "equal_reactions": Mistake(lambda givens: {"R_A": f"({added(each(givens.loads, lambda p: p.total))})/2"}),
        "whole_length": Mistake(whole_length),
        "middle": Mistake(lambda givens: {"x_M": "({} + {})/2".format(*supported(givens))}),
        "section_exchanged": Mistake(W="h*b^2/6", I="h*b^3/12"),
        "half_height_lost": Mistake(W="b*h^2/12"),
        "moment_for_modulus": Mistake(W="b*h^3/12"),
        "clamped": Mistake(C="0"),
        "positive_down": Mistake(lambda givens: {"v_K": f"-({elastic_line(givens)['v_K']})"}),
    },
    minutes=40,
)
