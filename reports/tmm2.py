"""The report of laboratory TMM-2 (domain RP-1, RP-2): thirteen sections, headings as on the form.

Before grading it holds the student's data, the scheme and the givens, and ruled space for the rest. On request the
student's own graded answers stand in the sections. No reference value ever does.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from exercises import catalogue, solving
from exercises.exercise import Variant
from exercises.grading import preview
from exercises.presenting import Presented, presented
from graders import AnswerSyntaxError, Verdict
from graders.language import Tree
from graders.language.mathml import mathml_of, symbol_mathml
from graders.polygon.drawn import Drawn
from graders.words import comma, printed_unit
from reports.answers import before_answer
from reports.document import (
    Beside,
    Block,
    Document,
    Drawing,
    Facts,
    Formula,
    Heading,
    Line,
    Paragraph,
    Ruled,
    Table,
    from_html,
    in_rows,
    line_from_html,
)  # fmt: skip
from reports.motion import own_motion, plots
from reports.words import Words, words

ROOM = {4: 3, 9: 7, 11: 10, 12: 11, 13: 7}  # lines of ruled space in the sections
SQUARED = {5: 7, 7: 3, 8: 6, 10: 13}


class NoReport(ValueError):
    """The exercise is no laboratory with a TMM-2 report."""


@dataclass(frozen=True, slots=True)
class Person:
    """Who hands the report in."""

    name: str = ""
    group: str = ""


@dataclass(frozen=True, slots=True)
class HandedIn:
    """A graded submission: answers as typed, their outcomes, and the receipt."""

    answers: Mapping[str, str]
    outcomes: Mapping[str, str] = field(default_factory=dict)
    receipt: str = ""
    received: str = ""
    digest: str = ""
    score: float | None = None


def tmm2(variant: Variant, language: str, person: Person, code: str, handed: HandedIn | None = None) -> Document:
    """Make the report of a variant.

    Args:
        variant: The student's variant.
        language: pl, en or ru.
        person: Name and group; what is missing is left to be written by hand.
        code: How the variant is named to the student: its seed in practice, an opaque code in a task set.
        handed: The submission whose answers fill the sections; none for the skeleton.

    Raises:
        NoReport: The exercise has no TMM-2 report.
    """
    exercise = catalogue.load(variant.exercise).exercise
    if not exercise.report:
        raise NoReport(variant.exercise)
    said, shown = words(language)["tmm2"], presented(variant, language)
    drawn = typed_polygon(variant, handed.answers.get("polygon", "")) if handed else None
    sheet = _Sheet(variant, language, person, handed, drawn, shown, said)
    head = ((said["manipulator"], shown.title), (said["variant"], code), (said["version"], str(variant.version)))
    blocks: list[Block] = [Paragraph((said["topic"],)), Facts(head)]
    for number, heading in said["sections"].items():
        blocks += [Heading(f"{number}. {heading}"), *sheet.section(int(number), exercise.report.get(int(number), ()))]
    blocks += sheet.receipt()
    return Document(said["title"], said["exercise"], language, tuple(blocks), f"{shown.title}, {code}")


@dataclass(frozen=True, slots=True)
class _Sheet:
    """One report in the making."""

    variant: Variant
    language: str
    person: Person
    handed: HandedIn | None
    drawn: Drawn | None  # the student's polygon, if one was typed that can be read
    shown: Presented
    said: Words

    def section(self, number: int, answers: tuple[str, ...]) -> Iterator[Block]:
        match number:
            case 1:
                yield from _written(self.person.name)
            case 2:
                yield from _written(self.person.group)
            case 3:
                yield Ruled(1)
            case 5:
                yield from self._drawings()
            case 6:
                yield from self._data()
            case 7 if self.drawn is not None:
                yield from self._equations([closure.tree for closure in self.drawn.closures])
            case 8 if self.drawn is not None:
                yield from self._equations([projection.tree for projection in self.drawn.equations])
            case _ if self.handed is not None and answers:
                for name in answers:
                    yield from self._answer(name, self.said["sections"][str(number)])
                if number == 12:
                    yield from self._plots()
            case _:
                yield Ruled(SQUARED[number], squared=True) if number in SQUARED else Ruled(ROOM[number])

    def _drawings(self) -> Iterator[Block]:
        scheme = Drawing(self.shown.picture.svg, self.shown.title, 0.42) if self.shown.picture else None
        own = self.drawn and catalogue.load(self.variant.exercise).polygon(
            self.variant.givens, self.said["sections"]["5"], [(v.label, v.start, v.end) for v in self.drawn.vectors]
        )
        polygon = Drawing(own.svg, self.said["sections"]["5"], 0.5) if own else None
        if scheme is not None and polygon is not None:
            yield Beside((replace(scheme, width=0.46), replace(polygon, width=0.46)))
            return
        yield from (one for one in (scheme, polygon) if one is not None)
        if polygon is None:
            yield Ruled(SQUARED[5], squared=True)

    def _data(self) -> Iterator[Block]:
        """The geometry in words, the givens as a table, the conventions."""
        yield next(from_html(self.shown.statement_html))
        cells: list[Line] = [_given(*given) for given in self.shown.data]
        cells += [("",)] * (len(cells) % 2)
        yield Table((), tuple(zip(cells[::2], cells[1::2], strict=True)))
        yield Paragraph((self.said["conventions"],), quiet=True)

    def _equations(self, trees: Sequence[Tree]) -> Iterator[Block]:
        """Equations of the polygon, one a line, with the outcome behind the last."""
        for at, tree in enumerate(trees, 1):
            formula = Formula(mathml_of(tree, comma(self.language)))
            yield Paragraph((formula,), aside=self._outcome("polygon") if at == len(trees) else "")

    def _plots(self) -> Iterator[Block]:
        """What is plotted of the last node, as it follows from the student's own projections."""
        for name, moved in (own_motion(self.variant, self.drawn) if self.drawn else {}).items():
            before, after = self.said["plots"].split("{name}")
            title = f"{before}{name}{after}"
            yield Drawing(plots(name, moved, self.variant, title, self.language).svg, title, 0.72)
            yield Paragraph((before, Formula(symbol_mathml(name)), after), quiet=True)

    def _answer(self, name: str, heading: str) -> Iterator[Block]:
        """What is asked unless the heading says it, what was typed as it was understood, and how it was judged."""
        assert self.handed is not None
        field_, text = self.shown.answers[name], self.handed.answers.get(name, "")
        says = field_.prompt_text.rstrip(":") == heading.rstrip(":")
        prompt = () if says else before_answer(line_from_html(field_.prompt_html))
        if not text.strip():
            yield Paragraph((*prompt, self.said["unanswered"]), quiet=True)
            return
        *lines, last = _understood(self.variant, name, text, self.language)
        lines[:0] = [prompt] if lines and prompt else []
        yield from (Paragraph(line) for line in lines)
        yield Paragraph(last if lines else (*prompt, *last), aside=self._outcome(name))

    def _outcome(self, name: str) -> str:
        assert self.handed is not None
        outcome = self.handed.outcomes.get(name)
        return words(self.language)["outcomes"][outcome] if outcome else ""

    def receipt(self) -> Iterator[Block]:
        """The receipt of what was handed in."""
        if self.handed is None or not self.handed.receipt:
            return
        score = "" if self.handed.score is None else f"{100 * self.handed.score:.0f} %"
        keys = ("number", "received", "digest", "score")
        values = (self.handed.receipt, self.handed.received, self.handed.digest, score)
        yield Heading(self.said["receipt"])
        yield Facts(tuple((self.said[key], value) for key, value in zip(keys, values, strict=True)))
        yield Paragraph((self.said["own"],), quiet=True)


def typed_polygon(variant: Variant, text: str) -> Drawn | None:
    """Read a student's polygon, if one was typed that can be read."""
    solved = solving.solved(variant)
    if not text.strip():
        return None
    try:
        drawn = solved.answers["polygon"].parse(text, solved.symbols("polygon"))
    except AnswerSyntaxError:
        return None
    return drawn if isinstance(drawn, Drawn) else None


def _given(name: str, symbol: str, value: str) -> Line:
    """Write a given as the name, the symbol and the value."""
    return (*line_from_html(name), ": ", Formula(symbol), f" = {value}")


def _written(text: str) -> Iterator[Block]:
    yield Paragraph((text,)) if text.strip() else Ruled(1)


def _understood(variant: Variant, name: str, text: str, language: str) -> list[Line]:
    """Give an answer as it was read, line by line; what could not be read, or is a text, stands as typed."""
    echo = preview(variant, name, text, comma(language))
    if isinstance(echo, Verdict) or not echo.mathml:
        return [(text.strip(),)]
    unit = printed_unit(echo.unit or "", language)
    formulas = [Formula(mathml) for mathml in in_rows(echo.mathml)]
    return [(formula, unit if unit in ("", "°") else f" {unit}") for formula in formulas]
