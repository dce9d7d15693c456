"""Mobility of a drawn planar mechanism by counting links and pairs (domain STR-3, STR-4, STR-6).

n counts the moving links; p5 the pairs of one freedom, p4 those of two; a joint of m links counts as m - 1 pairs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, sin

from exercises.exercise import Answers, Draw, Exercise, Mistake, Steps, Values, option
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
    double_joints,
    summed,
)
from graders import Choice, Integer
from mechanics import mobility

DYADS: tuple[DyadType, ...] = ("rocker_down", "rocker_up", "slider_level", "slider_upright", "swing")
PLACES: tuple[Place, ...] = ("joint", "link")
FRAME_PAIRS = {"cam": 2, "roller": 2, "gears": 2}  # of a part by its type, else one
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
        "F": Integer(weight=2),
        **({"W": Integer()} if roller else {}),
        "k": Integer(),
        "drives": Choice(("rigid", "one", "two")),
    }


def joint_once(givens: Givens) -> Steps:
    """A joint of three links counted as one pair."""
    double = double_joints(givens.parts)
    return {"p5": f"{summed(givens.parts, 'p5')} - {double}"} if double else {}


def slider_forgotten(givens: Givens) -> Steps:
    """The slider not taken for a link."""
    sliders = sum(counts(part).guides for part in givens.parts)
    return {"n": f"{summed(givens.parts, 'links')} - {sliders}"} if sliders else {}


def guide_forgotten(givens: Givens) -> Steps:
    """The pair of slider and guide forgotten."""
    return {"p5": summed(givens.parts, "revolutes")} if any(counts(part).guides for part in givens.parts) else {}


def frame_joints_forgotten(givens: Givens) -> Steps:
    """The joints on the frame left out."""
    pivots = sum(FRAME_PAIRS.get(getattr(part, "type", "strut"), 1) for part in givens.parts)
    return {"p5": f"{summed(givens.parts, 'p5')} - {pivots}"}


def contact_as_joint(givens: Givens) -> Steps:
    """The contact of teeth or of a cam taken for a pair of one freedom."""
    if not any(counts(part).contacts for part in givens.parts):
        return {}
    return {"p5": f"{summed(givens.parts, 'p5')} + 1", "p4": "0"}


def contact_forgotten(givens: Givens) -> Steps:
    """The contact not seen as a pair."""
    return {"p4": "0"} if any(counts(part).contacts for part in givens.parts) else {}


def contact_as_both(givens: Givens) -> Steps:
    """The contact counted in both classes."""
    return {"p5": f"{summed(givens.parts, 'p5')} + 1"} if any(counts(part).contacts for part in givens.parts) else {}


def contact_left_out(givens: Givens) -> Steps:
    """The contact counted, but not in the formula."""
    return {"F": "3*n - 2*p5"} if any(counts(part).contacts for part in givens.parts) else {}


def contact_doubled(givens: Givens) -> Steps:
    """A contact takes two freedoms in the formula."""
    return {"F": "3*n - 2*p5 - 2*p4"} if any(counts(part).contacts for part in givens.parts) else {}


def roller_kept(givens: Givens) -> Steps:
    """The roller's own turn kept as a useful freedom."""
    return {"W": "F"} if any(counts(part).spins for part in givens.parts) else {}


EXERCISE = Exercise(
    systems=("STR-3", "STR-4", "STR-6"),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers=answers,
    mistakes={
        "frame_moves": Mistake(F="3*(n + 1) - 2*p5 - p4"),
        "frame_counted": Mistake(lambda givens: {"n": f"{summed(givens.parts, 'links')} + 1"}),
        "joint_takes_one": Mistake(F="3*n - p5 - p4"),
        "frame_taken_off": Mistake(F="3*(n - 1) - 2*p5 - p4"),
        "formula_of_space": Mistake(F="6*n - 5*p5 - 4*p4"),
        "joint_once": Mistake(joint_once),
        "slider_forgotten": Mistake(slider_forgotten),
        "guide_forgotten": Mistake(guide_forgotten),
        "frame_joints_forgotten": Mistake(frame_joints_forgotten),
        "contact_as_joint": Mistake(contact_as_joint),
        "contact_forgotten": Mistake(contact_forgotten),
        "contact_as_both": Mistake(contact_as_both),
        "contact_left_out": Mistake(contact_left_out),
        "contact_doubled": Mistake(contact_doubled),
        "roller_kept": Mistake(roller_kept),
        "loops_without_frame": Mistake(k="p5 + p4 - n + 1"),
        "one_loop_lost": Mistake(k="p5 + p4 - (n + 1)"),
    },
    minutes=10,
)
