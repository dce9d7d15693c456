"""Judge of a Denavit-Hartenberg table: any choice of frames that stand on the joint axes and keep the tool point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from typing import Any, ClassVar

from graders.chain.frames import Convention
from graders.chain.motion import Agreement, Motion, agreement
from graders.chain.slips import flaw, judged
from graders.chain.table import FINE, Table, rounded
from graders.formulas import place_of
from graders.judge import Echo, Samples
from graders.kinds.matrix import read_grid
from graders.language.doubles import UndefinedError
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.mathml import mathml_of
from graders.language.symbols import Symbols
from graders.language.text import text_of
from graders.language.tree import Binary, Grid, Index, Name, Number, Relation, Tree, Unary, children, names, walk
from graders.verdict import RIGHT, UNDECIDED, Code, Flaws, Verdict, wrong

COLUMNS = 4
WRITTEN = (Code.TABLE_DEGREES, Code.TABLE_ROUNDED, Code.TABLE_COLUMNS, Code.TABLE_ROWS)  # the frames are well chosen
WRITTEN_CREDIT = 0.5
PI = Name("pi")


@dataclass(frozen=True, slots=True)
class DHTable:
    """A table of rows theta, d, a, alpha in the joint variables q1 ... qn and the lengths of the task.

    It is right when each frame is fixed to its link, each z axis stands on its joint axis, and the last frame keeps
    the printed tool point (or is the printed frame), at every state of the motion it is judged against. What is left
    free is free: the senses of axes, where a frame stands on parallel axes, whole turns, how an entry is written.
    The score of a table with a slip is the share of its leading rows that are right.

    Args:
        joints: The joints as a word over R and P.
        convention: Standard (distal) or modified (proximal, Craig), as the task says.
        step: The step asked for; empty for the step named like the answer.
        weight: Share in the score.
    """

    joints: str
    convention: Convention = "standard"
    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "dh_table"
    symbolic: ClassVar[bool] = True
    free: ClassVar[bool] = True  # later answers are solved from a right table too: it may choose other frames

    @property
    def variables(self) -> tuple[str, ...]:
        """Give the names of the joint variables."""
        return tuple(f"q{i}" for i in range(1, len(self.joints) + 1))

    def parse(self, text: str, symbols: Symbols) -> Table:
        """Read `[[q1; L1; 0; pi/2]; …]`, or a row a line without brackets; raises AnswerSyntaxError."""
        tree = _read(text, symbols)
        for entry in children(tree):
            if any(isinstance(node, Grid | Index | Relation) for node in walk(entry)):
                raise AnswerSyntaxError(Reason.NOT_AN_EXPRESSION, 0, text_of(entry)[:20])
        forbidden = sorted(names(tree) - symbols.names)
        if forbidden:
            raise AnswerSyntaxError(Reason.FORBIDDEN_NAME, place_of(forbidden[0], text), forbidden[0])
        return Table(tree)

    def check(self, answer: Table, reference: Motion) -> Verdict:
        """Compare frames with links at every state; name the slip of a table that is not right."""
        if not self._fits(answer):
            return wrong(Code.WRONG_SHAPE)
        try:
            exact, agreed = self._agreement(answer, reference)
            if exact:
                return UNDECIDED if self._turns(answer) else RIGHT
            if answer.unsure(reference.names, reference.points):
                return UNDECIDED
            found = flaw(judged(answer, reference, self.joints, self.convention, self.variables), agreed)
        except UndefinedError:
            return wrong(Code.UNDEFINED)
        complete = min(agreed.rows, len(self.joints) - 1)
        score = max(complete / len(self.joints), WRITTEN_CREDIT if found.code in WRITTEN else 0.0)
        return Verdict(score, found.code, Flaws((found,))) if score else wrong(Code.WRONG, Flaws((found,)))

    def _turns(self, answer: Table) -> bool:
        """Tell whether an entry may be another formula between the states, as no right table needs to be."""
        return any(names(node) & set(self.variables) for node in answer.turning)

    def _fits(self, answer: Table) -> bool:
        return len(answer.rows) == len(self.joints) and len(answer.rows[0]) == COLUMNS

    def _agreement(self, answer: Table, reference: Motion) -> tuple[bool, Agreement]:
        """Compare as typed, then with angles rounded to four decimals read as what they stand for."""
        found, whole = Agreement(0, False), Agreement(len(self.joints), True)
        for table in dict.fromkeys((answer, answer.angles(rounded(FINE)))):
            found = agreement(table.at(reference.names, reference.points), reference, self.joints, self.convention)
            if found == whole:
                break
        return found == whole, found

    def show(self, reference: Motion) -> str:
        """Give a right table."""
        return reference.table

    def samples(self, reference: Motion) -> Samples:
        """Give texts that must be judged right, wrong and unreadable; right ones in other frames too."""
        table = self.parse(reference.table, Symbols(reference.names))
        others = [text_of(Grid(rows)) for rows in other_frames(table.rows, self.convention)]
        still = tuple((*row[:3], Number("0")) for row in table.rows)
        named = zip(self.variables, table.rows, strict=True)
        fixed = tuple(tuple(Number("0") if name in names(e) else e for e in row) for name, row in named)
        bad = [fixed, table.rows[:1], *([still] if still != table.rows else [])]  # parallel axes have no turns about x
        unread = ("", "[[q1; 2", "3", "[[zz; 0; 0; 0]]", "[[q1 = 2; 0; 0; 0]]")
        return Samples((reference.table, *others), tuple(text_of(Grid(rows)) for rows in bad), unread)

    def echo(self, answer: Table, comma: bool = False) -> Echo:
        """Say which table was read."""
        return Echo(mathml_of(answer.tree, comma), text_of(answer.tree))

    def carried(self, answer: Table) -> Tree | None:
        """Give the table itself: pair matrices follow from it at any values of the symbols."""
        return answer.angles(rounded(FINE)).tree if self._fits(answer) else None

    def apart(self, one: Motion, other: Motion) -> float:
        """Two tables describe the same motion, or are far apart."""
        if one == other:
            return 0.0
        table = self.parse(other.table, Symbols(other.names))
        return 0.0 if self.check(table, one) is RIGHT else inf

    def describe(self) -> Mapping[str, Any]:
        """Give the shape, the convention and the joints."""
        return {"rows": len(self.joints), "columns": COLUMNS, "convention": self.convention, "joints": self.joints}


def _read(text: str, symbols: Symbols) -> Grid:
    """Read a matrix; lines without brackets are its rows."""
    lines = text.strip().split("\n")
    if len(lines) < 2 or "[" in text or "\\begin" in text:
        return read_grid(text, symbols)
    try:
        return read_grid("[[" + "],[".join(lines) + "]]", symbols)
    except AnswerSyntaxError as error:
        lead = len(text) - len(text.lstrip())
        before, place = 0, error.position - 2
        while before < len(lines) - 1 and place > len(lines[before]):
            place -= len(lines[before]) + 3
            before += 1
        place = max(0, place) + sum(len(line) + 1 for line in lines[:before]) + lead
        raise error.moved(min(place, len(text))) from None


Entries = tuple[tuple[Tree, ...], ...]


def other_frames(rows: Entries, convention: Convention) -> list[Entries]:
    """Give tables of the same chain: all x but the last turned round, all z but the last, both, a whole turn more."""
    turned, flipped = rows, rows
    for at in range(len(rows) - 1):
        turned, flipped = x_turned(turned, at, convention), z_turned(flipped, at, convention)
    both = flipped
    for at in range(len(rows) - 1):
        both = x_turned(both, at, convention)
    theta, d, a, alpha = rows[0]
    around = ((_plus(theta, Binary("*", Number("2"), PI)), d, a, alpha), *rows[1:])
    return [turned, flipped, both, around]


def x_turned(rows: Entries, at: int, convention: Convention) -> Entries:
    """Turn a frame half round about its z: the next row begins half a turn further."""
    (theta, d, a, alpha), (theta_2, d_2, a_2, alpha_2) = rows[at : at + 2]
    if convention == "standard":
        pair = (_plus(theta, PI), d, _minus(a), _minus(alpha)), (_plus(theta_2, PI), d_2, a_2, alpha_2)
    else:
        pair = (_plus(theta, PI), d, a, alpha), (_plus(theta_2, PI), d_2, _minus(a_2), _minus(alpha_2))
    return (*rows[:at], *pair, *rows[at + 2 :])


def z_turned(rows: Entries, at: int, convention: Convention) -> Entries:
    """Turn a frame half round about its x: what is measured about and along its z changes sign."""
    (theta, d, a, alpha), (theta_2, d_2, a_2, alpha_2) = rows[at : at + 2]
    if convention == "standard":
        pair = (theta, d, a, _plus(alpha, PI)), (_minus(theta_2), _minus(d_2), a_2, _plus(alpha_2, PI))
    else:
        pair = (_minus(theta), _minus(d), a, _plus(alpha, PI)), (theta_2, d_2, a_2, _plus(alpha_2, PI))
    return (*rows[:at], *pair, *rows[at + 2 :])


def _plus(one: Tree, other: Tree) -> Tree:
    return Binary("+", one, other)


def _minus(tree: Tree) -> Tree:
    return Unary("-", tree)
