"""Judge of a function of the place along a bar, with Macaulay brackets or piece by piece."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.formulas import place_of, refuse_impulses
from graders.judge import Echo, Formula, Samples
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.piece import Piece
from graders.language.symbols import Symbols
from graders.language.text import text_of
from graders.language.tree import Grid, Index, Relation, Tree, names, walk
from graders.profile.bracketed import Differences, Part, Span, Tried, differences, tried
from graders.profile.echoes import echoed
from graders.profile.ranges import Ranged, read_formula, read_ranges
from graders.remarks import Remark, Remarks, Slip
from graders.verdict import RIGHT, UNDECIDED, Code, Verdict, wrong

MOST_PIECES = 16


@dataclass(frozen=True, slots=True)
class Function:
    """A function of the place in the symbols of the task: `R_A*x - F1*<x - a1>^1`, or pieces `0 .. a1: R_A*x`.

    It is right where it equals the step's formula on the whole span.

    Args:
        step: The step whose formula is asked for; the variable is one of the givens.
        places: Names of the givens at which a stretch may end, from left to right; the last is the end of the span,
            which starts at 0.
        x: The given that is the variable.
        constants: Whether constants of integration stand in it.
        weight: Share in the score.
    """

    step: str
    places: tuple[str, ...]
    x: str = "x"
    constants: bool = False
    weight: float = 1.0
    kind: ClassVar[str] = "function"
    symbolic: ClassVar[bool] = True

    def parse(self, text: str, symbols: Symbols) -> tuple[Part, ...]:
        """Read `R_A*x - F1*<x-a1>^1`, or pieces `0 .. a1: R_A*x`, a line each; raises AnswerSyntaxError."""
        return tuple(self._part(ranged, symbols) for ranged in read_ranges(text, MOST_PIECES))

    def _part(self, ranged: Ranged, symbols: Symbols) -> Part:
        start, end = (
            None if piece is None else _formula(piece, symbols, symbols.names - {self.x})
            for piece in (ranged.start, ranged.end)
        )
        return Part(start, end, _formula(ranged.body, symbols, symbols.names))

    def check(self, answer: tuple[Part, ...], reference: Formula) -> Verdict:
        """Judge by ball arithmetic on both sides of every place; what cannot be decided is kept for the lecturer."""
        from graders.equality import Finding

        beside = tried(answer, reference, Span(self.x, self.places))
        match beside.finding:
            case Finding.EQUAL:
                return RIGHT if beside.cut else UNDECIDED
            case Finding.DIFFERENT:
                return self._partly(beside, self._in_numbers(answer, reference))
            case Finding.UNDEFINED:
                return wrong(Code.UNDEFINED)
        return UNDECIDED

    def right(self, answer: tuple[Part, ...], reference: Formula) -> bool:
        """Tell whether it is the true function."""
        from graders.equality import Finding

        beside = tried(answer, reference, Span(self.x, self.places))
        return beside.finding is Finding.EQUAL and beside.cut

    def _partly(self, beside: Tried, numbers: bool) -> Verdict:
        """Count the stretches that are right; the first one alone earns nothing."""
        seen = differences(beside)
        if seen.opposite:
            return wrong(Code.OPPOSITE_SIGN)
        right = seen.right
        remarks = Remarks(sum(right), len(right), (self._remark(beside, seen, numbers),))
        score = max(0.0, round((sum(right) - 1) / (len(right) - 1), 6)) if len(right) > 1 else 0.0
        return Verdict(score, Code.SOME_MARKS, remarks) if score else wrong(Code.NO_MARKS, remarks)

    def _in_numbers(self, answer: tuple[Part, ...], reference: Formula) -> bool:
        """Tell whether numbers stand where the function asked for has symbols."""
        typed = frozenset[str]().union(*(names(part.body) for part in answer))
        return typed <= {self.x} < names(reference.tree)

    def _remark(self, beside: Tried, seen: Differences, numbers: bool) -> Remark:
        covering = {len(spot.parts) for spot in beside.spots}
        if covering != {1}:
            return Remark(Slip.NOT_COVERED if 0 in covering else Slip.COVERED_TWICE)
        if any(seen.right):
            return self._where(seen.right)
        if numbers:
            return Remark(Slip.NUMBERS)
        if seen.scaled:
            return Remark(Slip.FACTOR)
        if self.constants and seen.linear:
            return Remark(Slip.CONSTANT)
        return Remark(Slip.EVERYWHERE)

    def _where(self, right: list[bool]) -> Remark:
        """Name the place at which it begins or ceases to be right."""
        first = right.index(False)
        if not any(right[first:]):
            return Remark(Slip.FROM_HERE, name=self.places[first - 1])
        if all(right[right.index(True) :]):
            return Remark(Slip.OPEN_TOO_EARLY, name=self.places[right.index(True) - 1])
        before = self.places[first - 1] if first else "0"
        return Remark(Slip.STRETCH, name=f"{before} .. {self.places[first]}")

    def show(self, reference: Formula) -> str:
        """Write the function as a student could type it."""
        return text_of(reference.tree)

    def samples(self, reference: Formula) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        text, end = text_of(reference.tree), self.places[-1]
        halves = f"0 .. {end}/2: {text}\n{end}/2 .. {end}: {text}"
        right = (text, f"{self.step} = 2*({text})/2", halves)
        off = (f"-({text})", f"({text}) + 1e-9*({text})", f"0 .. {end}/2: {text}")
        return Samples(right, off, ("", f"({text}", "1 +", f"0 .. {end}", self.step))

    def echo(self, answer: tuple[Part, ...], comma: bool = False) -> Echo:
        """Show the function as it was read."""
        heads = [
            f"{text_of(part.start)} .. {text_of(part.end)}" if part.start is not None and part.end is not None else ""
            for part in answer
        ]
        return echoed(heads, [part.body for part in answer], comma)

    def carried(self, answer: tuple[Part, ...]) -> Tree | None:
        """Give the student's formula, if it is one for the whole span."""
        return answer[0].body if len(answer) == 1 else None

    def apart(self, one: Formula, other: Formula) -> float:
        """Two functions are equal or far apart."""
        from graders.equality import Finding

        beside = tried((Part(None, None, one.tree),), other, Span(self.x, self.places))
        return 0.0 if beside.finding is Finding.EQUAL else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give the variable and its range."""
        return {"variable": self.x, "span": f"0 .. {self.places[-1]}"}


def _formula(piece: Piece, symbols: Symbols, allowed: frozenset[str]) -> Tree:
    tree = read_formula(piece, symbols)
    if any(isinstance(node, Relation | Grid | Index) for node in walk(tree)):
        raise AnswerSyntaxError(Reason.NOT_AN_EXPRESSION, piece.place, piece.text[:20])
    piece.read(lambda text: refuse_impulses(tree, text))
    forbidden = sorted(names(tree) - allowed)
    if forbidden:
        place = piece.place + place_of(forbidden[0], piece.text)
        raise AnswerSyntaxError(Reason.FORBIDDEN_NAME, place, forbidden[0])
    return tree
