"""Differentiated equations: read, understood name by name, checked against the motion and the student's polygon."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import Symbols
from graders.language.tree import Name, Relation, Tree, names
from graders.polygon import keywords
from graders.polygon.checking import SEARCHED, Judged, graded, judge, slopes
from graders.polygon.drawn import Axis, Drawn, Equation
from graders.polygon.jets import Trio
from graders.polygon.lines import Line, fields_of, folded, lines_of
from graders.polygon.mechanism import Mechanism
from graders.polygon.naming import CLOSE, Named
from graders.polygon.reading import MAX_EQUATIONS, axis_of, declare, equation_of, loop_of, numbered, read_polygon
from graders.polygon.trials import PAIRS, Residual, diagnose, free_rows, parts_of, proportional, truth, values
from graders.polygon.walks import rank
from graders.verdict import FOLLOWED, RIGHT, UNDECIDED, Code, Flaw, Verdict

FAMILIES = {  # the usual letters of rates: of an angle or of a length, once or twice
    "omega": ("angle", 1), "w": ("angle", 1), "epsilon": ("angle", 2), "eps": ("angle", 2),
    "v": ("length", 1), "V": ("length", 1), "a": ("length", 2), "A": ("length", 2), "p": ("length", 2),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Differentiated:
    """Equations of rates as read, and what was said of their names: `omega2 = alpha2_d`."""

    equations: tuple[Equation, ...]
    said: tuple[tuple[str, str], ...] = ()


def read_rates(text: str, symbols: Symbols) -> Differentiated:
    """Read differentiated equations: `x: …`, `y: …`, and where needed `omega2 = alpha2_d`.

    Raises:
        AnswerSyntaxError: A line that is no equation, a name that cannot be read.
    """
    lines = [one for line in lines_of(text) for one in _stated(line)]
    if not lines:
        raise AnswerSyntaxError(Reason.EMPTY, 0)
    declared = declare([line.body for line in lines], symbols, rates=True)
    equations: list[tuple[Axis, int, Relation]] = []
    said = []
    for line in lines:
        tree = equation_of(line.body, declared)
        left, right = tree.sides
        if not axis_of(line.label.text) and isinstance(left, Name) and isinstance(right, Name):
            said.append((left.name, right.name) if "_d" in right.name else (right.name, left.name))
        else:
            equations.append((axis_of(line.label.text), loop_of(line.label), tree))
    if len(equations) > MAX_EQUATIONS:
        raise lines[MAX_EQUATIONS].body.error(Reason.TOO_LONG)
    if not equations:
        raise lines[0].body.error(Reason.NOT_AN_EQUATION)
    return Differentiated(numbered(equations), tuple(said))


def _stated(line: Line) -> list[Line]:
    """Cut `rates: omega2 = alpha2_d; v3 = l3_d` into its equations."""
    if {folded(word) for word in line.label.text.split()} & keywords.RATES:
        return [Line(line.label, field_) for field_ in fields_of(line.body)]
    if line.label.text and not axis_of(line.label.text):
        raise line.label.error(Reason.NOT_A_LINE)
    return [line]


@dataclass(slots=True)
class _Meaning:
    """What the names in the student's equations are the rates of."""

    named: Named
    said: Mapping[str, str]
    unknowns: tuple[str, ...]
    places: tuple[str, ...]
    ties: dict[str, tuple[str, int]] = field(init=False)

    def __post_init__(self) -> None:
        self.ties = _ties(self.named)

    def of(self, name: str, depth: int = 0) -> tuple[str, int] | None:
        """Give the polygon's name and how often it is differentiated, None where it is not clear."""
        if depth > 4:
            return None
        found = self.of(self.said[name], depth + 1) if name in self.said else None
        if found:
            return found
        if name in self.ties:
            return self.ties[name]
        if name in self.named.rows[0]:
            return name, 0
        for ending, order in (("_dd", 2), ("_d", 1)):
            if name.endswith(ending):
                found = self.of(name.removesuffix(ending), depth + 1)
                return (found[0], found[1] + order) if found and found[1] + order <= 2 else None
        return self._usual(name)

    def _usual(self, name: str) -> tuple[str, int] | None:
        """Understand `omega2`, `eps2`, `v3`: by the figure behind the letter, or where only one rate can be meant."""
        letter, index = _indexed(name)
        close = letter not in FAMILIES  # what stands below is typed beside: `Vx`, `vDx`
        if close:
            letter, index = name[:1], name[1:]
        what, order = FAMILIES.get(letter, ("", 0))
        fitting = [own for own in self.unknowns if self.named.owners[own][1] == what]
        same = [own for own in fitting if index and index in _below(own)]
        placed = [own for own in self.places if what == "length" and index and index in _below(own)]
        chosen = next((one for one in (same, placed) if len(one) == 1), [] if close else fitting)
        return (chosen[0], order) if len(chosen) == 1 else None


def _either_way(said: Sequence[tuple[str, str]]) -> dict[str, str]:
    """Give what was said of names; `W = omega2` says of either that it is the other."""
    return {other: name for name, other in said} | dict(said)


def _indexed(name: str) -> tuple[str, str]:
    """Split a name into its letter and what stands below it."""
    letter, mark, index = name.partition("_")
    stem = letter.rstrip("0123456789")
    return stem, index if mark else letter[len(stem) :]


def _below(own: str) -> tuple[str, ...]:
    """Give what may stand below the letter of a rate: `v_D`, `v_x`, `v_xD` and `v_Dx` are rates of `x_D`."""
    letter, index = _indexed(own)
    return (index, letter, letter + index, index + letter)


def _ties(named: Named) -> dict[str, tuple[str, int]]:
    """Find the givens that are rates of others: omega1 of alpha1."""
    found: dict[str, tuple[str, int]] = {}
    given = {name: named.of(name) for name in named.states[0].names}
    for name, own in given.items():
        for other, trios in given.items():
            for order in (1, 2):
                rates = [trio[order] for trio in trios]
                alike = all(abs(a[0] - b) <= CLOSE * abs(b) and b for a, b in zip(own, rates, strict=True))
                if other != name and alike and name not in found:
                    found[name] = (other, order)
    return {name: _root(found, *tie) for name, tie in found.items()}


def _root(ties: Mapping[str, tuple[str, int]], name: str, order: int) -> tuple[str, int]:
    """Follow epsilon1 over omega1 to alpha1."""
    if name in ties:
        other, more = ties[name]
        return other, order + more
    return name, order


@lru_cache(maxsize=64)
def _model(polygon: str, nodes: tuple[str, ...], given: tuple[str, ...]) -> Drawn:
    return read_polygon(polygon, Symbols(given), nodes)


@lru_cache(maxsize=64)
def verdict(answer: Differentiated, mechanism: Mechanism, order: int) -> Verdict:
    """Judge velocity (order 1) or acceleration equations (order 2)."""
    given = tuple(mechanism.states()[0].names)
    drawn = mechanism.own or _model(mechanism.polygon, mechanism.nodes, given)
    judged, places = judge(drawn, mechanism.alone()), tuple(name for name, _, _ in mechanism.places)
    check = _Check(
        judged,
        _Meaning(judged.named, _either_way(answer.said), judged.named.unknowns(drawn), places),
        order,
    )
    outcomes = [check.equation(equation) for equation in answer.equations]
    flaws = [*check.flaws, *_missing(answer, judged)]
    right = sum(outcome is not False for outcome in outcomes)
    wanted = max(2 * mechanism.loops, len(outcomes))
    if not flaws and None in outcomes:
        return UNDECIDED
    followed = outcomes.count("followed")
    if not flaws and (followed > len(check.followed) or not (followed or check.determined(answer.equations))):
        flaws.append(Flaw(Code.NOT_DETERMINED, ", ".join(check.meaning.unknowns)))
        right -= 1
    if flaws:
        return graded(right / wanted, flaws)
    return FOLLOWED if followed else RIGHT


def _missing(answer: Differentiated, judged: Judged) -> list[Flaw]:
    """Name the equations that are not there; without labels, the last ones."""
    missing = 2 * judged.mechanism.loops - len(answer.equations)
    found = []
    for axis in ("y", "x"):
        count = sum(e.axis == axis for e in answer.equations)
        while missing > 0 and count < judged.mechanism.loops:
            found.append(Flaw(Code.NO_PROJECTION, "", axis))
            count, missing = count + 1, missing - 1
    return found


@dataclass(slots=True)
class _Check:
    """The checks of one answer's equations."""

    judged: Judged
    meaning: _Meaning
    order: int
    flaws: list[Flaw] = field(default_factory=list)
    followed: set[int] = field(default_factory=set)  # the own projections whose rates were given
    rows: list[dict[str, Trio]] = field(init=False)

    def __post_init__(self) -> None:
        """Take free values and rates, those of the task's rates as they belong together."""
        self.rows = free_rows(self.judged.named, self.judged.drawn.names, self.judged.mechanism.derived)
        for row in self.rows:
            for name, (own, order) in self.meaning.ties.items():
                row[name] = (row[own][order], row[own][order + 1] if order < 2 else 0.0, 0.0)

    def equation(self, equation: Equation) -> bool | str | None:
        """Judge one equation: True, "followed", None where it is undecided, or False with its flaws noted."""
        meant = {name: self.meaning.of(name) for name in names(equation.tree)}
        place = self.judged.place(equation) if equation.axis else str(equation.loop)
        unclear = [name for name, found in sorted(meant.items()) if found is None]
        if unclear:
            self.flaws += [Flaw(Code.UNKNOWN_RATE, name) for name in unclear]
            return False
        known = {name: found for name, found in meant.items() if found}
        rows = [{name: row[own][order] for name, (own, order) in known.items()} for row in self.judged.named.rows]
        found = truth(Residual(equation.difference), rows)
        if found is not False and all(order <= self.order for _, order in known.values()):
            return found
        typed = self._free(equation.difference, known)
        if self._follows(typed):
            return "followed"
        self.flaws += self._slips(equation, typed, place) or [Flaw(Code.WRONG_RATES, "", place)]
        return False

    def _free(self, tree: Tree, known: Mapping[str, tuple[str, int]]) -> tuple[float, ...] | None:
        if any(own not in self.rows[0] for own, _ in known.values()):
            return None  # a coordinate that the polygon does not have: nothing to be freely chosen
        return values(
            tree, [{name: (row[own][order], 0.0, 0.0) for name, (own, order) in known.items()} for row in self.rows]
        )

    def _follows(self, typed: tuple[float, ...] | None) -> bool:
        """Tell whether it is the rate of one of the student's own projections that is not true itself."""
        if not self.judged.flawed and not self.judged.flaws:
            return False
        own = [values(line.difference, self.rows, self.order) for line in self.judged.drawn.equations]
        found = [at for at, line in enumerate(own) if proportional(line, typed)]
        self.followed.update(found)
        return bool(found)

    def _slips(self, equation: Equation, typed: tuple[float, ...] | None, place: str) -> list[Flaw]:
        axes: Sequence[Axis] = (equation.axis,) if equation.axis else ("x", "y")
        for axis in axes:
            _, walked = self.judged.closure(equation.loop if equation.axis else 1)
            parts = parts_of(self.judged.drawn, walked, axis, self.order, self.rows) if walked else None
            found = diagnose(typed, parts, place, PAIRS if len(self.flaws) < SEARCHED else 0)
            if found:
                return found
        return []

    def determined(self, equations: Sequence[Equation]) -> bool:
        """Tell whether the equations determine the rates of all unknowns, or of the coordinates the task names."""
        if self._determined(equations, self.meaning.unknowns):
            return True
        return bool(self.meaning.places) and self._determined(equations, self.meaning.places)

    def _determined(self, equations: Sequence[Equation], sought: Sequence[str]) -> bool:
        wanted = {(name, self.order) for name in sought}
        reached = 0
        for at in range(4):
            reached = max(reached, rank(self._slopes(e, at, wanted) for e in equations))
        return reached == len(wanted)

    def _slopes(self, equation: Equation, at: int, wanted: set[tuple[str, int]]) -> dict[str, float]:
        row: dict[str, Trio] = {}
        sought = {}
        for name in names(equation.tree):
            found = self.meaning.of(name)
            if found:
                row[name] = (self.judged.named.rows[at][found[0]][found[1]], 0.0, 0.0)
                sought.update({name: found} if found in wanted else {})
        return {sought[name][0]: slope for name, slope in slopes(equation, row, tuple(sought)).items()}
