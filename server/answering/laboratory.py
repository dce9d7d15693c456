"""What the page of a laboratory shows beside the workspace: sections of the report, the machine, five positions."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Literal, TypeAlias

from exercises import catalogue
from exercises.exercise import Variant
from exercises.givens import numbers
from exercises.words import with_unit
from figures import strip
from figures.machine import Machine
from figures.picture import Picture
from graders.language.mathml import symbol_mathml
from graders.units import read_unit
from graders.words import decimal, printed_unit
from reports.tmm2 import typed_polygon
from reports.words import words
from server.answering.workspace import Line
from server.web.language import part, say

State: TypeAlias = Literal["open", "right", "partly", "wrong", "unreadable", "undecided", "fault"]
POSITIONS = 5
SHOWN_UNITS = {"turn": "deg", "slide": "m"}


@dataclass(frozen=True, slots=True)
class Section:
    """A section of the report on the page.

    Attributes:
        number: Its number on the form.
        heading: Its heading, as the form says it.
        lines: The answers that are typed here.
        shared: The section in which the answers that also fill this one are typed, 0 for none.
        judged: All answers that fill it.
    """

    number: int
    heading: str
    lines: tuple[Line, ...]
    shared: int
    judged: tuple[Line, ...]

    @property
    def right(self) -> int:
        """How many of its answers are right."""
        return self._count("right")

    def _count(self, outcome: str) -> int:
        return sum(line.verdict is not None and line.verdict.outcome == outcome for line in self.judged)

    @property
    def state(self) -> State:
        """How far it is: the worst of what was judged, and whether anything is left to do."""
        outcomes = [line.verdict.outcome for line in self.judged if line.verdict]
        if not outcomes:
            return "open"
        for state in ("fault", "unreadable", "wrong"):
            if state in outcomes and not (state == "wrong" and self.right):
                return state
        if len(outcomes) == len(self.judged) and set(outcomes) <= {"right", "undecided"}:
            return "undecided" if "undecided" in outcomes else "right"
        return "partly"

    @property
    def open(self) -> bool:
        """Whether there is something left to do in it."""
        return bool(self.lines) and self.state not in ("right", "undecided")


def sections(variant: Variant, laid: Sequence[Line], language: str) -> tuple[Section, ...]:
    """Sort the answers of a laboratory into the thirteen sections of the form."""
    report, lines = catalogue.load(variant.exercise).exercise.report, {line.field.name: line for line in laid}
    first: dict[str, int] = {}
    found = []
    for key, heading in words(language)["tmm2"]["sections"].items():
        number = int(key)
        names = report.get(number, ())
        for name in names:
            first.setdefault(name, number)
        own = tuple(lines[name] for name in names if first[name] == number)
        shared = 0 if own or not names else first[names[0]]
        found.append(Section(number, heading, own, shared, tuple(lines[name] for name in names)))
    return tuple(found)


def without_empty(laid: Sequence[Line]) -> list[Line]:
    """Leave out the verdicts on answers that are not there yet: a section is checked by what is filled."""
    return [replace(line, verdict=None) if line.verdict and line.verdict.code == "empty" else line for line in laid]


@dataclass(frozen=True, slots=True)
class Slide:
    """A slider of the page: a given, its symbol (MathML), its group (lengths, rates, accelerations) and its unit."""

    name: str
    symbol: str
    group: str
    unit_text: str


def slides(machine: Machine, language: str) -> tuple[Slide, ...]:
    """List the givens that may be changed: lengths, rates and accelerations."""
    base = {pair.coordinate: "rad" if pair.kind == "turn" else "m" for pair in machine.pairs}
    found = [(link.length, "lengths", "m") for link in machine.links]
    found += [(drive.rate, "rates", f"{base[drive.name]}/s") for drive in machine.drives]
    found += [(drive.surge, "accelerations", f"{base[drive.name]}/s^2") for drive in machine.drives]
    return tuple(Slide(name, symbol_mathml(name), group, printed_unit(unit, language)) for name, group, unit in found)


@dataclass(frozen=True, slots=True)
class Strip:
    """Five positions of the true motion: figures, and their coordinates as a table."""

    figures: tuple[str, ...]
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def positions(machine: Machine, variant: Variant, language: str) -> Strip:
    """Draw the true motion at five moments by turns and shifts of the givens; the table gives the coordinates."""
    values, units = numbers(variant.givens), {pair.coordinate: SHOWN_UNITS[pair.kind] for pair in machine.pairs}
    times = [machine.span * k / (POSITIONS - 1) for k in range(POSITIONS)]
    figures = (
        strip.draw(machine, values, t, f"strip-{k}", say(language, "laboratory.position_number", number=k))
        for k, t in enumerate(times, 1)
    )
    rows = (
        (
            str(k),
            with_unit(decimal(t, language), "s", language),
            *(_printed(strip.coordinate_at(machine, values, q, t), unit, language) for q, unit in units.items()),
        )
        for k, t in enumerate(times, 1)
    )
    return Strip(tuple(figures), ("", symbol_mathml("t"), *map(symbol_mathml, units)), tuple(rows))


def _printed(value: float, unit: str, language: str) -> str:
    return with_unit(decimal(value / read_unit(unit).factor, language, 4), unit, language)


def own_polygon(variant: Variant, typed: str, title: str) -> Picture | None:
    """Draw the polygon that was typed, where it can be read and the exercise knows how to draw it."""
    drawn = typed_polygon(variant, typed)
    if drawn is None:
        return None
    vectors = [(vector.label, vector.start, vector.end) for vector in drawn.vectors]
    return catalogue.load(variant.exercise).polygon(variant.givens, title, vectors)


@dataclass(frozen=True, slots=True)
class Laboratory:
    """All that the page of a laboratory shows beside the workspace."""

    sections: tuple[Section, ...]
    open: frozenset[int]
    machine: str
    island: str
    plotted: tuple[str, ...]
    last: str
    rod: bool
    slides: tuple[Slide, ...]
    strip: Strip | None
    polygon: Picture | None
    second: str


def laboratory(
    variant: Variant, laid: Sequence[Line], language: str, at: int | None, held: bool = False
) -> Laboratory | None:
    """Lay out the laboratory of a variant; None for an exercise that is none.

    Args:
        variant: The variant answered.
        laid: Its answers as the workspace lays them out.
        language: The reader's language.
        at: The section that was just checked.
        held: Whether results are held back: then nothing is shown of the true motion.
    """
    exercise = catalogue.load(variant.exercise).exercise
    if not exercise.report or exercise.machine is None:
        return None
    machine, found = exercise.machine(variant.givens), sections(variant, laid, language)
    typed = next((line.typed for line in laid if line.field.kind == "polygon"), "")
    return Laboratory(
        sections=found,
        open=_opened(found, at),
        machine=json.dumps(asdict(machine) | {"values": numbers(variant.givens)}),
        island=json.dumps(part(language, "island")),
        plotted=tuple(symbol_mathml(one.name) for one in machine.plotted),
        last=machine.links[-1].end,
        rod=bool(machine.rod),
        slides=slides(machine, language),
        strip=None if held else positions(machine, variant, language),
        polygon=own_polygon(variant, typed, found[4].heading),
        second=printed_unit("s", language),
    )


def _opened(found: Sequence[Section], at: int | None) -> frozenset[int]:
    """Open the section just checked, those with something to mend, or else the first two with something to do."""
    mending = {one.number for one in found if one.state in ("wrong", "partly", "unreadable") and one.lines}
    mending |= {one.number for one in found if any(line.echo and not line.verdict for line in one.lines)}
    return frozenset(mending | ({at} if at else set()) or [one.number for one in found if one.open][:2])
