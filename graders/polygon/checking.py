"""The verdict on a polygon: vectors, closure, both projections and unknowns, each a fifth of the score."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from math import pi, remainder

from graders.language.doubles import UndefinedError
from graders.language.tree import Name, names
from graders.polygon.drawn import Axis, Drawn, Equation
from graders.polygon.jets import Trio, jet
from graders.polygon.mechanism import Mechanism, State
from graders.polygon.naming import CLOSE, Named, Shape, Trios, mixed, name, other_angles
from graders.polygon.trials import PAIRS, Residual, diagnose, free_rows, parts_of, proportional, total, truth, values
from graders.polygon.walks import Walk, Walked, links, rank, walk
from graders.verdict import RIGHT, UNDECIDED, Code, Flaw, Flaws, Verdict, wrong

PARTS = 5  # vectors, closure, x, y, unknowns
SEARCHED = 2  # flaws after which two slips in one equation are looked for no more
MEASURES = 50  # other measures of angles that are tried in one polygon
AXES: tuple[Axis, ...] = ("x", "y")


@dataclass(slots=True)
class Judged:
    """A polygon with all that was found about it."""

    drawn: Drawn
    mechanism: Mechanism
    named: Named
    walked: Walked
    free: list[dict[str, Trio]]
    satisfied: dict[Equation, bool] = field(default_factory=dict)  # true, or true to the student's own closure
    flaws: list[Flaw] = field(default_factory=list)
    undecided: bool = False
    residuals: dict[Equation, Residual] = field(init=False)
    numbers: list[dict[str, float]] = field(init=False)  # the values of all names at all states

    def __post_init__(self) -> None:
        self.residuals = {equation: Residual(equation.difference) for equation in self.drawn.equations}
        self.numbers = [{name_: trio[0] for name_, trio in row.items()} for row in self.named.rows]

    def true(self, equation: Equation) -> bool | None:
        """Tell whether an equation holds at all states."""
        return truth(self.residuals[equation], self.numbers)

    @property
    def flawed(self) -> bool:
        """Tell whether vectors or closure are not right."""
        return bool(self.named.flaws or self.walked.flaws)

    def place(self, equation: Equation) -> str:
        """Name an equation: its axis, and the number of its polygon where there are several."""
        return equation.axis + (str(equation.loop) if self.mechanism.loops > 1 else "")

    def closure(self, loop: int) -> tuple[Walk | None, Walk | None]:
        """Give the closure of a polygon as typed, and as it closes."""
        at = loop - 1 if loop <= len(self.walked.own) else 0
        return (self.walked.own[at], self.walked.mended[at]) if self.walked.own else (None, None)


def states_of(mechanism: Mechanism) -> tuple[State, ...]:
    """Give the true states; raises ValueError when there are fewer than sixteen."""
    states = mechanism.states()
    if len(states) < 16:
        raise ValueError(f"{len(states)} true states are too few to judge a polygon")
    return states


@lru_cache(maxsize=64)
def judge(drawn: Drawn, mechanism: Mechanism) -> Judged:
    """Check vectors, closures and projections of a polygon; what was found is kept for the judges beside it."""
    named = name(drawn, states_of(mechanism))
    named.flaws = [*links(drawn, mechanism), *named.flaws]
    named.place(mechanism.places)
    judged = Judged(drawn, mechanism, named, walk(drawn, mechanism), free_rows(named, drawn.names, mechanism.derived))
    for equation in drawn.equations:
        judged.satisfied[equation] = _satisfied(judged, equation)
    _angles_of_another_kind(judged)
    for equation in drawn.equations:
        _diagnose(judged, equation)
    return judged


@lru_cache(maxsize=64)
def verdict(drawn: Drawn, mechanism: Mechanism) -> Verdict:
    """Judge a polygon."""
    judged = judge(drawn, mechanism.alone())
    flaws = [*judged.named.flaws, *judged.walked.flaws, *judged.flaws]
    flaws += _missing(judged)
    unknown, share = _unknowns(judged)
    flaws += unknown
    if not flaws and not judged.undecided:
        flaws += _undetermined(judged)
    if not flaws:
        return UNDECIDED if judged.undecided else RIGHT
    loops = mechanism.loops
    lost = {flaw.subject for flaw in judged.named.flaws}
    score = sum(v.label not in lost for v in drawn.vectors) / len(drawn.vectors) + judged.walked.right + share
    for axis in AXES:
        score += min(loops, sum(judged.satisfied[e] for e in drawn.equations if e.axis == axis)) / loops
    return graded(score / PARTS - (1 / PARTS if flaws[-1].code is Code.NOT_DETERMINED else 0.0), flaws)


def graded(score: float, flaws: Sequence[Flaw]) -> Verdict:
    """Make the verdict of an answer with flaws: the first of them names it, where there is any credit."""
    found = Flaws(tuple(dict.fromkeys(flaws)))
    return Verdict(round(score, 6), flaws[0].code, found) if score > 1e-9 else wrong(Code.WRONG, found)


def _satisfied(judged: Judged, equation: Equation) -> bool:
    """Tell whether an equation is true, or the projection of the student's own closure where that is not right."""
    found = judged.true(equation)
    judged.undecided = judged.undecided or found is None
    if found is None or (found and not _swapped(judged, equation)):
        return True
    return not found and judged.flawed and _own(judged, equation)


def _projection(judged: Judged, walked: Walk | None, axis: Axis) -> tuple[float, ...] | None:
    parts = parts_of(judged.drawn, walked, axis, 0, judged.free) if walked else None
    return total(parts) if parts else None


def _own(judged: Judged, equation: Equation) -> bool:
    typed = values(equation.difference, judged.free)
    return proportional(_projection(judged, judged.closure(equation.loop)[0], equation.axis), typed)


def _swapped(judged: Judged, equation: Equation) -> bool:
    typed = values(equation.difference, judged.free)
    walked = judged.closure(equation.loop)[1]
    other = AXES[equation.axis == "x"]
    return proportional(_projection(judged, walked, other), typed) and not proportional(
        _projection(judged, walked, equation.axis), typed
    )


def _angles_of_another_kind(judged: Judged) -> None:
    """Find a free angle that makes all projections true when it is measured otherwise than from +X."""
    false = [e for e, satisfied in judged.satisfied.items() if not satisfied and not _swapped(judged, e)]
    if not false:
        return
    tries = 0
    for own, (label, what) in judged.named.owners.items():
        concerned = [residual for residual in judged.residuals.values() if own in residual.inputs]
        covered = all(own in judged.residuals[e].inputs for e in false)
        if what != "angle" or not covered or not isinstance(judged.drawn.vector(label).angle, Name):
            continue
        for code, trios in _measured_otherwise(judged, own, label):
            tries += 1
            if all(truth(residual, _replaced(judged.numbers, own, trios)) for residual in concerned):
                judged.named.flaws.append(Flaw(code, label))
                judged.satisfied.update(dict.fromkeys(false, True))
                return
        if tries > MEASURES:
            return


def _replaced(rows: Iterable[Mapping[str, float]], own: str, trios: Trios) -> Iterator[dict[str, float]]:
    for row, trio in zip(rows, trios, strict=True):
        yield {**row, own: trio[0]}


def _measured_otherwise(judged: Judged, own: str, label: str) -> list[tuple[Code, Trios]]:
    """Give the other measures of an angle; one flipped sign is a slip where the name is of the task's family."""
    states = judged.named.states
    angles = Shape.of(judged.drawn.vector(label), states).angles
    others = [Shape.of(v, states).angles for v in judged.drawn.vectors if v.label != label]
    others = [trios for trios in others if any(abs(remainder(trio[0], pi)) > CLOSE for trio in trios)]
    measures = [(Code.INTERIOR_ANGLE, trios) for trios in other_angles(angles, others)]
    families = {given.rstrip("0123456789_") for given in states[0].names}
    kept = measures[2:] if own.rstrip("0123456789_") in families else measures
    return [(Code.REVERSED_ANGLE, mixed(angles, 1.0, pi)), *kept]


def _diagnose(judged: Judged, equation: Equation) -> None:
    """Name what is wrong with a projection that is not satisfied."""
    if judged.satisfied[equation]:
        return
    place = judged.place(equation)
    if judged.true(equation):
        judged.flaws.append(Flaw(Code.SWAPPED_PROJECTIONS, "", place))
        return
    typed = values(equation.difference, judged.free)
    own, mended = judged.closure(equation.loop)
    walks = [walked for walked in ((mended,) if own == mended else (mended, own)) if walked]
    terms = [parts_of(judged.drawn, walked, equation.axis, 0, judged.free) for walked in walks]
    for pairs in dict.fromkeys((0, PAIRS if len(judged.flaws) < SEARCHED else 0)):  # one slip explains more than two
        for parts in terms:
            found = diagnose(typed, parts, place, pairs)
            if found:
                judged.flaws += found
                return
    judged.flaws.append(Flaw(Code.WRONG_PROJECTION, "", place))


def _missing(judged: Judged) -> list[Flaw]:
    """Name the projections that are not there."""
    found = []
    for axis in AXES:
        count = sum(equation.axis == axis for equation in judged.drawn.equations)
        if count < judged.mechanism.loops:
            found.append(Flaw(Code.NO_PROJECTION, "", axis))
    return found


def _unknowns(judged: Judged) -> tuple[list[Flaw], float]:
    """Compare the list of unknowns with what changes and is not given; the share of the list that is right."""
    expected, listed, named = _sought(judged), judged.drawn.unknowns, judged.named.unknowns(judged.drawn)
    if listed is None:
        return [Flaw(Code.NO_UNKNOWNS)], 0.0
    missing = [Flaw(Code.UNKNOWN_MISSING, unknown) for unknown in expected if unknown not in listed]
    extra = [Flaw(Code.UNKNOWN_EXTRA, unknown) for unknown in listed if unknown not in (*expected, *named)]
    return missing + extra, max(0.0, 1 - (len(missing) + len(extra)) / max(1, len(expected)))


def _sought(judged: Judged) -> tuple[str, ...]:
    """Give the unknowns of the vectors; where projections name coordinates of nodes, those and what else they hold.

    A vector from A to D that is projected as x_D and y_D leaves its length and angle to be found from these.
    """
    own = judged.named.unknowns(judged.drawn)
    used = {name_ for equation in judged.drawn.equations for name_ in names(equation.difference)}
    placed = [place for place, _, _ in judged.mechanism.places if place in used - judged.named.owners.keys()]
    return (*(name_ for name_ in own if name_ in used), *placed) if placed else own


def _undetermined(judged: Judged) -> list[Flaw]:
    """Demand that the equations determine the unknowns: the rank of their derivatives by these."""
    unknowns, reached = _sought(judged), 0
    for row in judged.named.rows[:4]:
        reached = max(reached, rank(slopes(e, row, unknowns) for e in judged.drawn.equations))
    return [] if reached == len(unknowns) else [Flaw(Code.NOT_DETERMINED, ", ".join(unknowns))]


def slopes(equation: Equation, row: Mapping[str, Trio], unknowns: Sequence[str]) -> dict[str, float]:
    """Give the derivatives of an equation by the unknowns at one state."""
    still = {name_: (trio[0], 0.0, 0.0) for name_, trio in row.items()}
    found = {}
    for unknown in unknowns:
        try:
            found[unknown] = jet(equation.difference, still | {unknown: (row[unknown][0], 1.0, 0.0)})[1]
        except UndefinedError:
            return {}
    return found
