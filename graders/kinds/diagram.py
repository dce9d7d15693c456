"""Judge of a diagram of an internal force, or of any curve of numbers along a bar."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.judge import Echo, Samples
from graders.language import parse_line
from graders.language.symbols import Symbols
from graders.profile.drawn import Axes, Part, is_table, read_parts, read_table
from graders.profile.echoes import echoed
from graders.profile.marks import Comparison, compare, idle_share
from graders.profile.polynomial import NotPolynomialError
from graders.profile.stretches import Profile, Rows, Stretch, highest, inner_places, ordinates_of, profile_of, rows_of
from graders.remarks import Remarks
from graders.units import read_unit
from graders.verdict import RIGHT, Code, Verdict, wrong

READABLE = 6  # digits of a number read out of a table
ROUNDING = 1e-12  # of the largest ordinate: what is smaller comes from adding up loads


@dataclass(frozen=True, slots=True)
class Drawn:
    """A diagram as typed: pieces to be laid over the span, or the stretches of a table."""

    parts: tuple[Part, ...]
    table: Profile

    def over(self, first: float, last: float) -> Profile:
        """Give the typed curve over a span, in SI units."""
        return self.table or tuple(one for part in self.parts for one in part.stretches(first, last))


@dataclass(frozen=True, slots=True)
class Diagram:
    """A curve along a bar: pieces `0 .. 1,5: 4*x - x^2`, one formula with brackets, or a table of ordinates.

    The reference is a matrix with a row `start, end, c0, c1, ...` a stretch, the c's being the coefficients of powers
    of the distance from its start (SI units).

    Args:
        unit: The unit of the ordinates, in which bare numbers are read.
        quantity: What is drawn: N, T, V or M, or another letter.
        x_unit: The unit of places.
        rtol: Tolerance of an ordinate over the largest ordinate of the diagram.
        step: The step asked for; empty for the step named like the answer.
        weight: Share in the score.
        opposite_credit: Score for a diagram that is right but for the sign convention.
        x: The name of the variable.
    """

    unit: str
    quantity: str = "M"
    x_unit: str = "m"
    rtol: float = 0.01
    step: str = ""
    weight: float = 1.0
    opposite_credit: float = 0.5
    x: str = "x"
    kind: ClassVar[str] = "diagram"
    symbolic: ClassVar[bool] = False

    def parse(self, text: str, symbols: Symbols) -> Drawn:
        """Read pieces `0 .. 1,5: 4*x`, one formula with brackets, or rows `x; left; right`; AnswerSyntaxError."""
        if is_table(text):
            return Drawn((), read_table(text, self._axes))
        return Drawn(read_parts(text, self._axes), ())

    @property
    def _axes(self) -> Axes:
        return Axes(self.x, self.x_unit, self.unit)

    def check(self, answer: Drawn, reference: Rows) -> Verdict:
        """Judge each mark for itself; the credit is counted from that of a diagram left at zero."""
        true = profile_of(reference)
        try:
            drawn = answer.over(true[0].start, true[-1].end)
        except NotPolynomialError:
            return wrong(Code.UNDEFINED)
        seen = compare(drawn, true, self.rtol)
        if seen.right:
            return RIGHT
        return self._whole(drawn, true) or self._partly(seen, idle_share(true, self.rtol))

    def _whole(self, drawn: Profile, true: Profile) -> Verdict | None:
        """Recognise a diagram that is right but for its sign or for a power of ten."""
        if compare(_scaled(drawn, -1.0), true, self.rtol).right:
            return Verdict(self.opposite_credit, Code.OPPOSITE_CONVENTION)
        height, true_height = highest(drawn), highest(true)
        power = round(math.log10(height / true_height)) if height and true_height else 0
        if power and abs(power) <= 12 and compare(_scaled(drawn, 10.0**-power), true, self.rtol).right:
            return wrong(Code.FACTOR_OF_TEN)
        return None

    def _partly(self, seen: Comparison, idle: float) -> Verdict:
        marks = seen.marks()
        places = read_unit(self.x_unit).factor
        flaws = tuple(mark.flaws[0].in_unit(places, self.x_unit) for mark in marks if mark.flaws)
        remarks = Remarks(sum(mark.share == 1 for mark in marks), len(marks), flaws)
        score = max(0.0, round((seen.share - idle) / (1 - idle), 6)) if idle < 1 else 0.0
        return Verdict(score, Code.SOME_MARKS, remarks) if score else wrong(Code.NO_MARKS, remarks)

    def show(self, reference: Rows) -> str:
        """Write the pieces as a student could type them, a line each."""
        return "\n".join(self._lines(profile_of(reference)))

    def _lines(self, profile: Sequence[Stretch]) -> list[str]:
        place = read_unit(self.x_unit).factor
        formulas = self._formulas(profile, 10)
        return [
            f"{one.start / place:.8g} .. {one.end / place:.8g}: {formula}"
            for one, formula in zip(profile, formulas, strict=True)
        ]

    def _formulas(self, profile: Sequence[Stretch], digits: int) -> list[str]:
        place, factor, least = read_unit(self.x_unit).factor, read_unit(self.unit).factor, ROUNDING * highest(profile)
        return [_typed(one, self.x, place, factor, least, digits) for one in profile]

    def samples(self, reference: Rows) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        profile = profile_of(reference)
        lines = self._lines(profile)
        comma = "; ".join(line.replace(".", ",").replace(",,", "..").replace(" .. ", " … ") for line in lines)
        off = _scaled(profile, 3.0)
        wrong_ones = ("\n".join(self._lines(off)), "\n".join(self._lines(_scaled(profile, -1.0))), f"0*{self.x}")
        return Samples((self.show(reference), comma), wrong_ones, ("", "0 .. : 3", "0 .. 1", f"0 .. 1: {self.x} +"))

    def echo(self, answer: Drawn, comma: bool = False) -> Echo:
        """Say which pieces were read."""
        place, stretches = read_unit(self.x_unit).factor, answer.table or answer.parts
        trees = [part.tree for part in answer.parts] or list(map(parse_line, self._formulas(answer.table, READABLE)))
        return echoed([_head(one, place) for one in stretches], trees, comma, self.unit)

    def rows(self, answer: Drawn, span: float | None) -> list[list[float | None]] | None:
        """Give the curve as rows of the table at the field, in its units.

        Args:
            answer: The diagram as read.
            span: Where a formula without a range ends, in metres; None where that is not given.

        Returns:
            Place, ordinate left and right of it and half-way to the next; None for a curve that no table holds.
        """
        if span is None and not answer.table and any(part.start is None for part in answer.parts):
            return None
        try:
            found = ordinates_of(answer.over(0.0, span or 1.0))
        except NotPolynomialError:
            return None
        if found is None:
            return None
        place, factor = read_unit(self.x_unit).factor, read_unit(self.unit).factor
        return [[x / place, *(_in_unit(one, factor) for one in ordinates)] for x, *ordinates in found]

    def carried(self, answer: Drawn) -> Rows | None:
        """Give the typed curve where it names its own span."""
        if not answer.table and any(part.start is None for part in answer.parts):
            return None
        try:
            return rows_of(answer.over(0.0, 1.0))
        except NotPolynomialError:
            return None

    def apart(self, one: Rows, other: Rows) -> float:
        """Give the largest difference of two curves in tolerances; infinite where their spans differ."""
        a, b = profile_of(one), profile_of(other)
        if (a[0].start, a[-1].end) != (b[0].start, b[-1].end):
            return math.inf
        seen = compare(a, b, 1.0)
        scale = self.rtol * max(highest(a), highest(b))
        differences = [
            abs(pair.true.at(x) - pair.drawn.at(x))
            for pair in seen.pairs
            if pair.drawn is not None
            for x in inner_places(pair.true.start, pair.true.end)
        ]
        return max(differences) / scale if scale else 0.0

    def describe(self) -> Mapping[str, Any]:
        """Give what is drawn, its units and its tolerance."""
        return {"unit": self.unit, "x_unit": self.x_unit, "quantity": self.quantity, "largest": self.rtol}


def _head(part: Part | Stretch, place: float) -> str:
    if part.start is None or part.end is None:
        return ""
    return f"{part.start / place:.6g} .. {part.end / place:.6g}"


def _in_unit(ordinate: float | None, factor: float) -> float | None:
    return None if ordinate is None else float(f"{ordinate / factor:.10g}")


def _scaled(profile: Profile, factor: float) -> Profile:
    return tuple(one.scaled(factor) for one in profile)


def _typed(one: Stretch, x: str, place: float, factor: float, least: float, digits: int) -> str:
    """Write a stretch by powers of the distance from its start, without what is never greater than the least."""
    start = one.start / place
    distance = f"({x} - {start:.8g})" if start > 0 else f"({x} + {-start:.8g})" if start < 0 else x
    seen = [(c, power) for power, c in enumerate(one.curve) if abs(c) * (one.end - one.start) ** power > least]
    kept = [(c * place**power / factor, power) for c, power in seen] or [(0.0, 0)]
    text = " + ".join(f"{c:.{digits}g}" + _power(distance, power) for c, power in kept)
    return text.replace("+ -", "- ")


def _power(distance: str, power: int) -> str:
    return "" if power == 0 else f"*{distance}" if power == 1 else f"*{distance}^{power}"
