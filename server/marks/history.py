"""All of a student's work in a set: what was shown, typed, judged and marked, from what was kept at publishing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from exercises import presenting
from server.answering.variants import PRESENTED
from server.marks.counting import NONE, by_submission, earned, left_open
from server.marks.gradebook import Cell, Row, computed, material, students
from server.sets.handing import rules_of
from server.storage import Draft, Handed
from server.storage.marks import Mark
from server.storage.sets import Card, Line, TaskSet
from server.web.errors import Refused
from server.web.language import DEFAULT
from server.workbench import Bench


@dataclass(frozen=True, slots=True)
class Piece:
    """A submission: as it was typed, judged and marked by hand; `open` names what is still to be settled."""

    handed: Handed
    line: Line
    share: float
    late: bool
    counts: bool
    marks: tuple[Mark, ...]
    open: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Seen:
    """A card as the student had it before the eyes, in the language of the last submission; with the draft, if some of
    it was not handed in."""

    card: Card
    language: str
    shown: presenting.Presented
    pieces: tuple[Piece, ...]
    draft: Draft | None


@dataclass(frozen=True, slots=True)
class Work:
    """A task of a student: what it gives, and its cards, the present one first."""

    cell: Cell
    cards: tuple[Seen, ...]


@dataclass(frozen=True, slots=True)
class History:
    """A student's work in a set, and the names of who gave the marks."""

    row: Row
    works: tuple[Work, ...]
    authors: Mapping[str, str]


async def history(bench: Bench, task_set: TaskSet, person: str) -> History:
    """Collect the work of a student.

    Raises:
        Refused: 404, no such student in the course.
    """
    everybody = [one for one in await students(bench, task_set.course) if one[0].person.id == person]
    if not everybody:
        raise Refused(404, "unknown_member")
    found = await material(bench, task_set, everybody, person)
    (row,) = computed(found).rows
    marks = await bench.marks.of(task_set.id, person)
    handed = {one.receipt: one for one in await bench.marks.handed(task_set.id, person)}
    drafts = {one.variant: one for one in await bench.marks.drafts(task_set.id, person)}
    rules, given = rules_of(task_set), by_submission(marks)
    pieces = [
        Piece(
            handed[line.receipt], line,
            earned(line, given.get(line.receipt, NONE), found.weights.get(line.variant, {}), rules),
            bool(row.window.due and line.time > row.window.due), line.receipt in {one.receipt for one in row.cells},
            tuple(mark for mark in marks if mark.submission == line.receipt),
            tuple(left_open(line, given.get(line.receipt, NONE))),
        )
        for line in await bench.sets.ledger(task_set.id, person)
    ]  # fmt: skip
    cards = [card for card in await bench.sets.cards(task_set.id, person) if card.variant]
    spoken = row.member.person.language or DEFAULT
    seen = [_seen(card, pieces, drafts, spoken) for card in reversed(cards)]
    works = tuple(Work(cell, tuple(one for one in seen if one.card.slot == cell.slot.id)) for cell in row.cells)
    return History(row, works, await bench.audit.names({mark.author for mark in marks}))


def _seen(card: Card, pieces: Sequence[Piece], drafts: Mapping[str, Draft], spoken: str) -> Seen:
    own = tuple(piece for piece in pieces if piece.line.variant == card.variant)
    language = own[-1].handed.language if own else spoken
    draft = drafts.get(card.variant or "")
    if draft is not None and own and draft.time <= own[-1].handed.time:
        draft = None  # it was handed in
    return Seen(card, language, PRESENTED.validate_python(card.shown[language]), own, draft)
