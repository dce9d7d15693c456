"""Deflection of a beam as a function of the place, with Macaulay brackets (domain SM-11, SM-14).

x from the support A at the left end, reactions and deflection positive up, sagging moment positive.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from exercises.exercise import Answers, Draw, Exercise, Mistake, Steps, Values, each, given
from exercises.strength._beam import members as kinds
from exercises.strength._beam.lines import added, half_beam, reaction, slipped
from exercises.strength._beam.members import Load, Support, drawn_loads, places, structure
from exercises.strength.beam_deflection import slips
from exercises.strength.beam_deflection.lines import bending, deflection
from exercises.strength.beam_deflection.sag import deepest, extremes
from graders import Function, Quantity
from mechanics import beam, frame


@dataclass(frozen=True, slots=True)
class Givens:
    supports: tuple[Support, ...]  # A at the left end, and B
    loads: tuple[Load, ...]  # in the order of their places
    L: float = given(3, 7)  # length, m
    EI: float = given(1e5, 5e7)  # bending stiffness, N m^2
    x: float = given(0.2, 7)  # the variable; its printed value is the place of the point K, m


def draw(rng: Draw) -> Givens:
    """Draw loads at whole parts of the length, then a stiffness at which the beam sags by a few hundredths of it."""
    part, parts = rng.pick((3, 4, 5)), rng.pick(range(10, 15))  # dm
    right = parts - rng.pick((0, 0, 2, 3))
    at = [part * i / 10 for i in rng.sample([i for i in range(1, parts) if i != right], 5)]
    givens = Givens(
        supports=(kinds.LeftEnd(), kinds.InsetB(part * right / 10) if right < parts else kinds.RightEnd()),
        loads=drawn_loads(rng, at),
        L=part * parts / 10,
        EI=1e6,
        x=at[4],
    )
    sag = abs(solved_by_parameters(givens).v_extreme) * givens.EI
    EI = 1e4 * round(sag / givens.L * rng.pick((250, 300, 400, 500)) / 1e4)
    givens = replace(givens, EI=max(EI, 1e5))
    return rng.reject() if degenerate(givens) else givens


def solved_by_parameters(givens: Givens) -> beam.BeamResult:
    """Solve the same beam by initial parameters."""
    return beam.solve(structure(givens, E=1.0, second_moment=givens.EI))


def degenerate(givens: Givens) -> bool:
    """Tell whether the overhang is idle, a reaction, C or the deflection at K small, or the sag not one place."""
    solved, B = solved_by_parameters(givens), places(givens)[1]
    ends = [x for load in givens.loads for x in (load.a, getattr(load, "c", load.a))]
    reactions = [one.Fy for one in solved.reactions]
    C = solved.at(0.0).theta * givens.EI
    heights = sorted(abs(v) for _, v in extremes(givens, reactions[0], reactions[1], C))
    return (
        max(ends) < B < givens.L
        or min(map(abs, reactions)) < max(600, 0.1 * solved.V_abs_max)
        or any(load.c - load.a < givens.L / 6 for load in givens.loads if isinstance(load, kinds.Uniform))
        or abs(solved.at(givens.x).v) < max(5e-4, 0.3 * abs(solved.v_extreme))
        or abs(C) < 0.1 * max(heights) / B
        or (len(heights) > 1 and heights[-2] > 0.9 * heights[-1])
        or abs(solved.at(givens.x).M) < 0.03 * solved.M_abs_max
    )


def oracle(givens: Givens) -> Values:
    """The same names by the stiffness method: displacements of nodes first, not the integrated moment."""
    solved = frame.solve_beam(structure(givens, E=1.0, second_moment=givens.EI))
    x_m, v_m = solved.extreme_deflection()
    return {
        "R_A": solved.reactions[0].Fy,
        "R_B": solved.reactions[1].Fy,
        "M": solved.moment(givens.x),
        "C": givens.EI * solved.slope(0.0),
        "v": solved.deflection(givens.x),
        "x_m": x_m,
        "v_m": v_m,
    }


def steps(givens: Givens) -> Steps:
    """EI v'' = M integrated twice; v = 0 at A leaves no second constant, v = 0 at B gives C."""
    B = givens.supports[1].place.replace("{i}", "2")
    return {
        "R_A": reaction(givens),
        "R_B": f"{added(each(givens.loads, lambda load: load.total))} - R_A",
        "M": bending(givens),
        "f_B": added(each(givens.supports[:1], lambda s: s.sag, B) + each(givens.loads, lambda load: load.sag, B)),
        "C": f"-f_B/{B}",
        "v": deflection(givens, "x"),
        "x_m": lambda R_A, R_B, C: deepest(givens, R_A, R_B, C),
        "v_m": deflection(givens, "x_m"),
    }


def stretch_ends(givens: Givens) -> tuple[str, ...]:
    """Name the places at which a stretch ends, from left to right."""
    found = [(load.a, f"a{i}") for i, load in enumerate(givens.loads, 1)]
    found += [(load.c, f"c{i}") for i, load in enumerate(givens.loads, 1) if isinstance(load, kinds.Uniform)]
    found += [(support.s, f"s{i}") for i, support in enumerate(givens.supports, 1) if isinstance(support, kinds.InsetB)]
    return (*(name for _, name in sorted(found)), "L")


def answers(givens: Givens) -> Answers:
    """Reaction, M(x), the constant, v(x), then numbers from it."""
    ends = stretch_ends(givens)
    return {
        "R_A": Quantity("kN", rtol=0.005, atol=5),
        "M": Function("M", ends),
        "C": Quantity("kN*m^2", rtol=0.005),
        "v": Function("v", ends, constants=True, weight=2),
        "v_K": Quantity("mm", rtol=0.01, atol=5e-6, step="v"),
        "x_m": Quantity("m", rtol=0.01, atol=0.005),
        "v_m": Quantity("mm", rtol=0.01, atol=5e-6),
    }


EXERCISE: Exercise[Givens] = Exercise(
    systems=("SM-11", "SM-14"),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers=answers,
    mistakes={
        "lever_half_beam": Mistake(half_beam),
        "couple_sense": Mistake(lambda givens: slipped(givens, kinds.OPPOSITE)),
        "open_brackets": Mistake(slips.open_brackets),
        "constant_lost": Mistake(C="0"),
        "constant_from_the_end": Mistake(slips.constant_from_the_end),
        "load_not_ended": Mistake(slips.load_not_ended),
        "middle": Mistake(slips.middle),
        "positive_down": Mistake(slips.positive_down),
    },
    minutes=45,
)
