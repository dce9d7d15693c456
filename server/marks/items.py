"""The analysis of the tasks of a set: what is read from the store, as plain numbers, shown without people."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from pydantic import BaseModel

from exercises.presenting import words_of
from exercises.words import plain
from graders.common_slips import CommonSlip
from graders.verdict import OUTCOMES, Code, Outcome
from graders.words import common_hint
from server.answering.receipts import whole
from server.marks.analysis import Analysis, Try, analysed
from server.marks.counting import entries
from server.marks.gradebook import Cell, Gradebook, Material, Row, computed, material, students
from server.sets.handing import rules_of
from server.sets.rules import Rules, kept
from server.storage import Handed
from server.storage.sets import Line, Slot, TaskSet
from server.workbench import Bench

LONGEST = 200  # characters of a wrong answer that are shown


@dataclass(frozen=True, slots=True)
class Item:
    """A task with what its answers tell."""

    slot: Slot
    found: Analysis


class ShownMistake(BaseModel):
    """A recognised mistake in words, and the share of students who made it."""

    name: str
    text: str
    share: float


class ShownWrong(BaseModel):
    """A wrong answer that at least five students gave, and the mistake it was recognised as."""

    answer: str
    text: str
    mistake: str | None
    students: int


class ShownAlternative(BaseModel):
    """An exercise of a pool against the others: the share that solved it, and the probability of so much by chance."""

    exercise: str
    students: int
    solved: float
    p: float
    unfair: bool


class ItemStatistics(BaseModel):
    """What a class did in a task. Numbers behind which stand fewer than five students are none.

    `against`: who is good in the rest loses points here, by more than chance may lead to.
    """

    number: int
    students: int
    success: float | None
    solved: float | None
    separates: float | None
    against: bool
    attempts: float | None
    minutes: float | None
    mistakes: list[ShownMistake]
    wrong: list[ShownWrong]
    groups: list[ShownAlternative]


async def items(bench: Bench, task_set: TaskSet) -> list[Item]:
    """Analyse the tasks of a set."""
    found = await material(bench, task_set, await students(bench, task_set.course))
    lines = await bench.sets.ledger(task_set.id)
    handed = {one.receipt: one for one in await bench.marks.handed(task_set.id)}
    return await asyncio.to_thread(_items, found, lines, handed)


def _items(found: Material, lines: Sequence[Line], handed: Mapping[str, Handed]) -> list[Item]:
    book, rules = computed(found), rules_of(found.task_set)
    own: dict[tuple[str, str], list[Line]] = {}
    for line in lines:
        own.setdefault((line.person, line.slot), []).append(line)
    return [
        Item(slot, analysed(_tries(book, at, slot, own, found, handed, rules), _rest(book, at)))
        for at, slot in enumerate(found.task_set.slots)
    ]


def _rest(book: Gradebook, at: int) -> dict[str, float]:
    return {
        row.member.person.id: sum(cell.before for cell in row.cells[:at] + row.cells[at + 1 :]) for row in book.rows
    }


def _tries(
    book: Gradebook, at: int, slot: Slot, own: Mapping[tuple[str, str], list[Line]], found: Material,
    handed: Mapping[str, Handed], rules: Rules,
) -> list[Try]:  # fmt: skip
    return [
        _try(row, row.cells[at], own.get((row.member.person.id, slot.id), []), found, handed, rules)
        for row in book.rows
        if row.cells[at].card is not None
    ]


def _try(
    row: Row, cell: Cell, lines: Sequence[Line], found: Material, handed: Mapping[str, Handed], rules: Rules
) -> Try:
    assert cell.card is not None
    ledger = entries(lines, found.marks, found.weights, rules)
    first = next((entry.time for entry in ledger if entry.share >= 1), None)
    best = kept(ledger, row.window.due, rules)
    exercise = cell.card.exercise
    named = {line.receipt: _mistake(line, exercise) for line in lines}
    wrong = {
        (name, whole(handed[line.receipt].answers).get(name, "").strip()[:LONGEST], named[line.receipt] or "")
        for line in lines
        for name, verdict in line.grade["verdicts"].items()
        if OUTCOMES[Code(verdict["code"])] is Outcome.WRONG
    }
    return Try(
        row.member.person.id, exercise, None if best is None else best.share, cell.counted,
        None if first is None else max(0.0, (first - cell.card.dealt).total_seconds() / 60),
        frozenset(one for one in named.values() if one), frozenset(wrong),
    )  # fmt: skip


def _mistake(line: Line, exercise: str) -> str | None:
    """Name the mistake of a submission: one of the exercise, else one of any kind of task."""
    own, common = line.grade["mistake"], line.grade["slip"]
    return f"{exercise}:{own}" if own else f":{common}" if common else None


def shown_item(item: Item, language: str) -> ItemStatistics:
    """Show a task in a language."""
    found = item.found
    return ItemStatistics(
        number=item.slot.number, students=found.students, success=found.success, solved=found.solved,
        separates=found.separates, against=found.against, attempts=found.attempts, minutes=found.first_right,
        mistakes=[ShownMistake(name=name, text=worded(name, language), share=s) for name, s in found.mistakes],
        wrong=[
            ShownWrong(answer=name, text=text, mistake=worded(mistake, language) if mistake else None, students=times)
            for (name, text, mistake), times in found.wrong
        ],
        groups=[
            ShownAlternative(exercise=one.group, students=one.students, solved=one.solved, p=one.p, unfair=one.unfair)
            for one in found.groups
        ],
    )  # fmt: skip


def worded(name: str, language: str) -> str:
    """Word a mistake as its hint does; one that the installed exercise knows no more keeps its name."""
    exercise, _, mistake = name.partition(":")
    if not exercise:
        return common_hint(CommonSlip(mistake), language)
    try:
        return plain(words_of(exercise, language)["mistakes"][mistake])
    except (KeyError, LookupError):
        return mistake
