"""Shear-force and bending-moment diagrams of a beam with drawn supports and loads (domain SM-11).

x from the left end, reactions positive up, V = sum of the upward forces left of x, sagging moment positive.
"""

from __future__ import annotations

from dataclasses import dataclass

from exercises.exercise import Answers, Draw, Exercise, Mistake, Steps, Values, each, given
from exercises.strength._beam import members as kinds
from exercises.strength._beam.lines import added, reaction
from exercises.strength._beam.members import Load, Support, places, structure
from exercises.strength.beam_diagrams import slips
from exercises.strength.beam_diagrams.curves import curves
from graders import Diagram, Quantity
from mechanics import beam, frame

SUPPORTS = ("span", "overhangs", "overhangs", "wall A", "wall B")


@dataclass(frozen=True, slots=True)
class Givens:
    supports: tuple[Support, ...]  # A and B, or one wall
    loads: tuple[Load, ...]  # in the order of their places
    L: float = given(3, 7)  # length, m


def draw(rng: Draw) -> Givens:
    """Draw supports, then three or four loads at whole parts of the length."""
    part, parts = rng.pick((3, 4, 5)), rng.pick(range(10, 15))  # dm
    supports = drawn_supports(rng, rng.pick(SUPPORTS), part, parts)
    held = {round(x * 10 / part) for x in places(Givens(supports, (), part * parts / 10))}
    free = [i for i in range(parts + 1) if i not in held and (len(held) == 1 or 0 < i < parts)]
    at = [part * i / 10 for i in rng.sample(free, 5)]
    givens = Givens(supports, drawn_loads(rng, at), part * parts / 10)
    return rng.reject() if degenerate(givens) else givens


def drawn_supports(rng: Draw, kind: str, part: int, parts: int) -> tuple[Support, ...]:
    """Draw two supports, with an overhang on one side or on both, or take a wall."""
    if kind.startswith("wall"):
        return (kinds.ClampedLeft() if kind == "wall A" else kinds.ClampedRight(),)
    left, right = rng.pick(((0, 3), (0, 2), (2, 0), (3, 0), (2, 2))) if kind == "overhangs" else (0, 0)
    return (
        kinds.InsetA(part * left / 10) if left else kinds.LeftEnd(),
        kinds.InsetB(part * (parts - right) / 10) if right else kinds.RightEnd(),
    )


def drawn_loads(rng: Draw, at: list[float]) -> tuple[Load, ...]:
    """Draw a uniform load and two or three others; named from left to right."""
    start, end = sorted(at[:2])
    found: list[Load] = [kinds.Uniform(1e3 * rng.pick(range(2, 11)), start, end)]
    others = (kinds.Force, kinds.Lift, kinds.Clockwise, kinds.Counterclockwise)
    for x, kind in zip(at[2:], (kinds.Force, *rng.sample((*others, None), 2)), strict=True):
        if kind is not None:
            found.append(kind(1e3 * rng.pick(range(2, 16)), x))
    return tuple(sorted(found, key=lambda load: load.a))


def degenerate(givens: Givens) -> bool:
    """Tell whether an overhang is idle, or a reaction, a jump, a bend or a change of sign too small to be seen."""
    solved, held = beam.solve(structure(givens)), places(givens)
    V, M = solved.V_abs_max, solved.M_abs_max
    ends = [x for load in givens.loads for x in (load.a, getattr(load, "c", load.a))]
    least = [load.F for load in givens.loads if isinstance(load, kinds.Force | kinds.Lift)]
    least += [abs(one.Fy) for one in solved.reactions]
    walls = [
        abs(one.M) for one, support in zip(solved.reactions, givens.supports, strict=True) if support.holds == "fixed"
    ]
    corners = [(abs(one.V), abs(one.M)) for one in solved.pieces]
    corners += [(abs(one.shear(one.x2 - one.x1)), abs(one.moment(one.x2 - one.x1))) for one in solved.pieces]
    return (
        (len(held) == 2 and (0 < held[0] < min(ends) or max(ends) < held[1] < givens.L))
        or min(least) < max(600, 0.1 * V)
        or min(walls, default=M) < max(1e3, 0.1 * M)
        or any(load.M < 0.1 * M for load in givens.loads if isinstance(load, kinds.Couple))
        or any(load.c - load.a < givens.L / 5 for load in givens.loads if isinstance(load, kinds.Uniform))
        or any(load.q * (load.c - load.a) ** 2 < 0.4 * M for load in givens.loads if isinstance(load, kinds.Uniform))
        or any(1e-9 * V < shear < 0.03 * V or 1e-9 * M < moment < 0.03 * M for shear, moment in corners)
    )


def oracle(givens: Givens) -> Values:
    """The same names by the stiffness method: displacements of nodes first, then the forces of each element."""
    solved = frame.solve_beam(structure(givens))
    values: dict[str, float | tuple[tuple[float, ...], ...]] = {
        "V": tuple((one.x1, one.x2, one.forces[0], one.w1, 0.0) for one in solved.elements),
        "M": tuple((one.x1, one.x2, -one.forces[1], one.forces[0], one.w1 / 2) for one in solved.elements),
    }
    for support, found in zip(givens.supports, solved.reactions, strict=True):
        values[f"R_{support.name}"] = found.Fy
        if support.holds == "fixed":
            values[f"M_{support.name}"] = solved.moment(found.x)
    return values


def steps(givens: Givens) -> Steps:
    """Reactions from the equilibrium of the whole beam, then V and M from the left end on."""
    return {**reactions(givens), **curves(givens, structure(givens).loads)}


def reactions(givens: Givens) -> Steps:
    """Two reactions, or the reaction of the wall and the bending moment beside it."""
    total = added(each(givens.loads, lambda load: load.total))
    match givens.supports:
        case (kinds.ClampedLeft(),):
            return {"R_A": total, "M_A": added(each(givens.loads, lambda load: load.turn, "0"))}
        case (kinds.ClampedRight(),):
            return {"R_B": total, "M_B": f"-({added(each(givens.loads, lambda load: load.turn, 'L'))})"}
        case _:
            return {"R_A": reaction(givens), "R_B": f"{total} - R_A"}


def answers(givens: Givens) -> Answers:
    """The reactions, then both diagrams."""
    asked = {name: Quantity("kN" if name[0] == "R" else "kN*m", rtol=0.005, atol=5.0) for name in reactions(givens)}
    return {**asked, "V": Diagram("kN", "V", weight=2), "M": Diagram("kN*m", "M", weight=2)}


EXERCISE: Exercise[Givens] = Exercise(
    systems=("SM-11",),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers=answers,
    mistakes={
        "lever_half_beam": Mistake(slips.half_beam),
        "couple_sense": Mistake(slips.couple_sense),
        "reactions_exchanged": Mistake(slips.reactions_exchanged),
        "resultant_drawn": Mistake(slips.resultant_drawn),
        "couple_jump_lost": Mistake(slips.couple_jump_lost),
        "wall_moment_lost": Mistake(slips.wall_moment_lost),
        "opposite_shear": Mistake(slips.opposite_shear),
        "opposite_moment": Mistake(slips.opposite_moment),
    },
    minutes=40,
)
