"""The gradebook of a set and of a course: students by group, tasks in columns, all of it computed from the ledger."""

from __future__ import annotations

import asyncio
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from typing import NamedTuple, Protocol

from graders import Code
from server.alphabet import alphabetical
from server.marks.counting import Given, Weights, by_submission, entries, unsettled
from server.sets.handing import rules_of, window_of
from server.sets.rules import Entry, Rules, Window, combined, kept, reached, worth
from server.storage.courses import LEFT, Courses, Member
from server.storage.marks import DealtCard, Marks
from server.storage.sets import Line, Sets, Slot, TaskSet


class Store(Protocol):
    """Where a gradebook is read from: a running server, or the store alone."""

    @property
    def sets(self) -> Sets:
        """Task sets."""
        ...

    @property
    def marks(self) -> Marks:
        """Marks by hand."""
        ...

    @property
    def courses(self) -> Courses:
        """Courses."""
        ...


class Cell(NamedTuple):
    """A task of a student.

    Attributes:
        card: The card as it was opened last; none before the first open.
        handed: How many submissions there are.
        counted: How many attempts are used up.
        share: The share of the points earned; none where nothing was judged.
        points: The points earned.
        late_loss: The points that lateness took off.
        hint_loss: The points that hints at a price took off after that.
        receipt: The submission that gives the points.
        late: Whether that came after the due moment of this student.
        by_hand: Whether a mark by hand decides over it.
        hints: How many hints were opened at a price before it.
        open: What the lecturer has still to settle: undecided, fault, or none of them.
    """

    slot: Slot
    card: DealtCard | None
    handed: int
    counted: int
    share: float | None
    points: float
    late_loss: float
    hint_loss: float
    receipt: str | None
    late: bool
    by_hand: bool
    hints: int
    open: str | None

    @property
    def before(self) -> float:
        """The points before anything was taken off."""
        return round(self.points + self.late_loss + self.hint_loss, 3)

    @property
    def provisional(self) -> bool:
        """Whether the points can still change by what the lecturer settles."""
        return self.open is not None

    @property
    def look(self) -> tuple[object, ...]:
        """What makes a cell of one student look different from another's."""
        return self.slot.number, self.state, self.points, self.share is None, self.late, self.by_hand, self.hints

    @property
    def state(self) -> str:
        """The state at a glance: an outcome, `unreadable` for work without a judged answer, or `open` for no work.

        Right is right, whatever late work and hints lose of its points.
        """
        if self.open is not None:
            return self.open
        if self.share is None:
            return "unreadable" if self.handed else "open"
        return "right" if self.before >= self.slot.points else "partly" if self.before > 0 else "wrong"


@dataclass(frozen=True, slots=True)
class Row:
    """A student in a set; `share` is weighed with the first chance where the set is a second one."""

    member: Member
    group: str
    cells: tuple[Cell, ...]
    window: Window
    begun: datetime | None
    extra: int
    share: float

    @property
    def points(self) -> float:
        """The points earned so far."""
        return round(sum(cell.points for cell in self.cells), 3)

    @property
    def before(self) -> float:
        """The points before anything was taken off."""
        return round(sum(cell.before for cell in self.cells), 3)

    @property
    def late_loss(self) -> float:
        """The points that lateness took off."""
        return round(sum(cell.late_loss for cell in self.cells), 3)

    @property
    def hint_loss(self) -> float:
        """The points that hints at a price took off after that."""
        return round(sum(cell.hint_loss for cell in self.cells), 3)

    @property
    def provisional(self) -> bool:
        """Whether the points can still change by what the lecturer settles."""
        return any(cell.provisional for cell in self.cells)

    @property
    def taken(self) -> bool:
        """Whether anything was judged."""
        return any(cell.share is not None for cell in self.cells)

    @property
    def handed(self) -> bool:
        """Whether anything was handed in."""
        return any(cell.handed for cell in self.cells)

    @property
    def left(self) -> bool:
        """Whether this is a student of the course no more."""
        return self.member.role == LEFT


@dataclass(frozen=True, slots=True)
class Gradebook:
    """The students of a set by group and name, and what it was computed from."""

    task_set: TaskSet
    rows: tuple[Row, ...]
    material: Material

    @property
    def worth(self) -> float:
        """The points of the whole set."""
        return sum(slot.points for slot in self.task_set.slots)


@dataclass(frozen=True, slots=True)
class Material:
    """What a gradebook is computed from, as the store gives it."""

    task_set: TaskSet
    students: Sequence[tuple[Member, str]]
    lines: Sequence[Line]
    dealt: Sequence[DealtCard]
    extra: Mapping[str, tuple[int, str]]
    marks: Mapping[str, Given]
    weights: Weights


async def gradebook(store: Store, task_set: TaskSet) -> Gradebook:
    """Compute the gradebook of a set; of those who are students no more, it lists who handed in to it."""
    found = await _of(store, task_set, await students(store, task_set.course))
    return replace(found, rows=tuple(row for row in found.rows if row.handed or not row.left))


async def of_course(store: Store, course: str) -> list[Gradebook]:
    """Compute the gradebooks of the published sets of a course, the oldest first."""
    everybody = await students(store, course)
    sets = [one for one in reversed(await store.sets.of(course)) if one.published]
    return [await _of(store, one, everybody) for one in sets]


async def students(store: Store, course: str) -> list[tuple[Member, str]]:
    """List the students of a course with the names of their groups, by group and name; without one, last.

    Who has handed in and then left, or now teaches, is among them: the work is there, and so are its points.
    """
    names = {group.id: group.name for group in await store.courses.groups(course)}
    found = [one for one in await store.courses.members(course) if one.role == "student"]
    found += await store.courses.left(course)
    named = [(one, names.get(one.group or "", "")) for one in found]
    return sorted(named, key=lambda one: (not one[1], alphabetical(one[1]), alphabetical(one[0].person.name)))


async def _of(store: Store, task_set: TaskSet, everybody: Sequence[tuple[Member, str]]) -> Gradebook:
    found = await asyncio.to_thread(computed, await material(store, task_set, everybody))
    before = rules_of(task_set).second_chance_of
    first = await store.sets.task_set(before) if before else None
    if first is None:
        return found
    earlier = await asyncio.to_thread(computed, await material(store, first, everybody))
    shares = {row.member.person.id: row.share for row in earlier.rows}
    return replace(found, rows=tuple(_weighed(row, shares) for row in found.rows))


async def material(
    store: Store, task_set: TaskSet, everybody: Sequence[tuple[Member, str]], person: str | None = None
) -> Material:
    """Read what a gradebook is computed from, of all students or one."""
    marks = await store.marks.of(task_set.id, person)
    by_answer = any(mark.answer is not None for mark in marks)
    return Material(
        task_set, everybody, await store.marks.lines(task_set.id, person),
        await store.marks.dealt(task_set.id, person),
        await store.sets.accommodations(task_set.id), by_submission(marks),
        await store.marks.weights(task_set.id, person) if by_answer else {},
    )  # fmt: skip


def computed(found: Material) -> Gradebook:
    """Compute the rows of a set."""
    rules = rules_of(found.task_set)
    lines = _grouped(found.lines)
    dealt: dict[str, list[DealtCard]] = {}
    for card in found.dealt:
        dealt.setdefault(card.person, []).append(card)
    rows = [
        _row(found, member, group, dealt.get(member.person.id, []), lines, rules) for member, group in found.students
    ]
    return Gradebook(found.task_set, tuple(rows), found)


def _grouped(lines: Iterable[Line]) -> dict[tuple[str, str], list[Line]]:
    found: dict[tuple[str, str], list[Line]] = defaultdict(list)
    for line in lines:
        found[line.person, line.slot].append(line)
    return found


def _row(
    found: Material, member: Member, group: str, dealt: Sequence[DealtCard],
    lines: Mapping[tuple[str, str], list[Line]], rules: Rules,
) -> Row:  # fmt: skip
    task_set, person = found.task_set, member.person.id
    begun = min((card.dealt for card in dealt), default=None)
    extra = found.extra.get(person, (0, ""))[0]
    own = window_of(task_set, extra, begun)
    cards = {card.slot: card for card in dealt}
    cells = tuple([
        cell(slot, cards.get(slot.id), lines.get((person, slot.id), ()), found, own, rules) for slot in task_set.slots
    ])  # fmt: skip
    worth = sum(slot.points for slot in task_set.slots)
    share = sum(one.points for one in cells) / worth if worth else 0.0
    return Row(member, group, cells, own, begun, extra, round(share, 6))


def cell(slot: Slot, card: DealtCard | None, lines: Sequence[Line], found: Material, own: Window, rules: Rules) -> Cell:
    """Compute a task of a student."""
    ledger = entries(lines, found.marks, found.weights, rules)
    best = kept(ledger, own.due, rules)
    share = None if best is None else reached(best, own.due, rules)
    codes = unsettled(lines, found.marks, best, share, rules)
    state = None if not codes else "fault" if codes == {Code.FAULT.value} else "undecided"
    counted = sum([line.counted for line in lines])
    if best is None or share is None:
        return Cell(slot, card, len(lines), counted, None, 0.0, 0.0, 0.0, None, False, False, 0, state)
    return Cell(
        slot, card, len(lines), counted, share, round(share * slot.points, 3), *_losses(slot, best, share, own, rules),
        best.receipt, own.due is not None and best.time > own.due, best.settled, best.hints, state,
    )  # fmt: skip


def _losses(slot: Slot, best: Entry, share: float, own: Window, rules: Rules) -> tuple[float, float]:
    """Give the points that lateness took off a submission, and those that hints took off what was left."""
    if share >= best.share:
        return 0.0, 0.0
    full, net = best.share * slot.points, round(share * slot.points, 3)
    on_time = round(full * worth(best.time, own.due, rules), 3)
    return round(full - on_time, 3), round(on_time - net, 3)


def _weighed(row: Row, earlier: Mapping[str, float]) -> Row:
    first = earlier.get(row.member.person.id, 0.0)
    return replace(row, share=combined(first, row.share if row.taken else None))
