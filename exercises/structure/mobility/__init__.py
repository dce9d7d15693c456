"""Mobility of a drawn planar mechanism by counting links and pairs (domain STR-3, STR-4, STR-6).

n counts the moving links; p5 the pairs of one freedom, p4 those of two; a joint of m links counts as m - 1 pairs.
The formulas are asked for beside the numbers: a small number that is off by one does not tell why.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, sin

from exercises.exercise import Answers, Draw, Exercise, Steps, Values, option
from exercises.structure.mobility.layout import Side, lay_out
from exercises.structure.mobility.parts import (
    Dyad,
    DyadType,
    Part,
    Place,
    Start,
    Strut,
    Triad,
    counts,
    summed,
)
from exercises.structure.mobility.slips import COUNTED, IN_FORMULAS
from graders import Choice, Domain, Expression, Integer
from mechanics import mobility

DYADS: tuple[DyadType, ...] = ("rocker_down", "rocker_up", "slider_level", "slider_upright", "swing")
PLACES: tuple[Place, ...] = ("joint", "link")
SIZE = 100.0  # units of the sheet to a metre of the oracle


@dataclass(frozen=True, slots=True)
class Givens:
    parts: tuple[Start | Dyad | Triad | Strut, ...]  # in the order in which they are put together
    side: Side = option("left", "right")  # where the mechanism starts on the sheet


def draw(rng: Draw) -> Givens:
    """Draw what starts the motion, two or three dyads, and perhaps a part that adds or takes a freedom."""
    parts: list[Part] = [Start(rng.pick(("crank", "crank", "cam", "roller", "gears")))]
    for number in range(rng.pick((2, 2, 3, 3, 3, 3, 3, 3))):
        parts.append(Dyad(rng.pick(DYADS), rng.pick(PLACES) if number else "link"))
        if two_blocks(parts):
            rng.reject()
    last = rng.pick(("none", "none", "triad", "triad", "strut"))
    if last == "triad":
        parts.append(Triad(rng.pick(("down", "up")), rng.pick(PLACES)))
    elif last == "strut":
        parts.append(Strut(rng.pick(PLACES)))
    return Givens(tuple(parts), rng.pick(("left", "right")))


def two_blocks(parts: Sequence[Part]) -> bool:
    """Tell whether the last part puts a second block on the pin of a slider."""
    before, last = parts[-2:]
    blocks = isinstance(before, Dyad) and counts(before).guides and before.type != "swing"
    return bool(blocks) and last == Dyad("swing", "joint")


def needs(W: float) -> str:
    """Tell how many drives a mechanism of this mobility needs."""
    return "rigid" if W < 1 else "one" if W < 2 else "two"


def oracle(givens: Givens) -> Values:
    """The same names by another way: the drawn mechanism is moved, its constraints are ranked, its graph is walked."""
    sheet = lay_out(givens.parts, givens.side)
    joints = [
        mobility.Joint(
            node.kind,
            tuple(node.links),
            (node.at.real / SIZE, node.at.imag / SIZE),
            None if node.kind == "R" else _direction(node.angle),
        )
        for node in sheet.nodes
    ]
    found = mobility.plane([str(link) for link in range(sheet.count + 1)], joints)
    assert found.true is not None
    useful = found.true - (sheet.shape == "roller")
    return {
        "n": float(found.moving),
        "p5": float(found.classes.get(5, 0)),
        "p4": float(found.classes.get(4, 0)),
        "F": float(found.true),
        "W": float(useful),
        "k": float(found.loops),
        "drives": needs(useful),
    }


def _direction(angle: float) -> tuple[float, float]:
    return cos(angle), sin(angle)


def steps(givens: Givens) -> Steps:
    """Count part by part; then the formulas."""
    spins = sum(counts(part).spins for part in givens.parts)
    return {
        "n": summed(givens.parts, "links"),
        "p5": summed(givens.parts, "p5"),
        "p4": summed(givens.parts, "contacts"),
        "F": "3*n - 2*p5 - p4",  # STR-3
        "W": f"F - {spins}" if spins else "F",  # STR-4
        "k": "p5 + p4 - (n + 1) + 1",  # STR-6
        "drives": needs,
    }


def answers(givens: Givens) -> Answers:
    """The local mobility is asked for where a roller has one."""
    roller = any(counts(part).spins for part in givens.parts)
    return {
        "n": Integer(),
        "p5": Integer(),
        "p4": Integer(),
        "F_formula": Expression("F", called="W"),
        "F": Integer(),
        **({"W": Integer()} if roller else {}),
        "k_formula": Expression("k"),
        "k": Integer(),
        "drives": Choice(("rigid", "one", "two")),
    }


def ranges(givens: Givens) -> dict[str, Domain]:
    """Give the numbers for which the formulas have to hold; without contacts p4 may be left out."""
    pairs = {"p4": Domain(0, 4, True)} if any(counts(part).contacts for part in givens.parts) else {}
    return {"n": Domain(1, 20, True), "p5": Domain(1, 30, True), **pairs}


EXERCISE = Exercise(
    systems=("STR-3", "STR-4", "STR-6"),
    version=2,
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers=answers,
    mistakes={**COUNTED, **IN_FORMULAS},
    counts=ranges,
    minutes=10,
)
