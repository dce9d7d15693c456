"""Task sets in the database; their cards are in `deck.py`, what is handed in to them in `attempts.py`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from datetime import datetime
from functools import partial
from typing import Any

from sqlalchemy import Connection, Select, bindparam, delete, exists, func, insert, select, update

from server.database import attempts, deck, hints
from server.database.audit import note, noting
from server.database.connections import Connections
from server.sets.rules import Rules, Stage, window
from server.storage import Marked
from server.storage.audit import Entry
from server.storage.sets import (
    DRAFT,
    PUBLISHED,
    Card,
    DeadlinesMoved,
    Hint,
    Line,
    NotADraft,
    Place,
    Slot,
    TaskSet,
    Waiting,
    weights_of,
)  # fmt: skip
from server.tables import accommodations, memberships, slots, task_sets
from server.tables import deck as cards

NOT_READ: Mapping[str, Any] = {}
MOST_SETS = 1000  # published ones whose slots are remembered
SLOTS = select(slots).where(slots.c.task_set == bindparam("number")).order_by(slots.c.number)
GIVEN, OPENED, AMONG = accommodations.c, cards.alias().c, slots.alias().c
EXTRA = GIVEN.task_set == task_sets.c.id
THEIRS = OPENED.slot == AMONG.id, AMONG.task_set == task_sets.c.id, OPENED.person == cards.c.person
ENROLLED = (
    memberships.c.course == task_sets.c.course, memberships.c.person == cards.c.person, memberships.c.role == "student",
)  # fmt: skip
BRIEF = tuple(column for column in cards.columns if column is not cards.c.shown)
SHOWN = select(cards.c.shown).where(cards.c.id == bindparam("number"))
PLACE = (
    select(
        *BRIEF, task_sets,
        select(GIVEN.minutes).where(EXTRA, GIVEN.person == cards.c.person).scalar_subquery().label("extra"),
        select(func.max(GIVEN.minutes)).where(EXTRA).scalar_subquery().label("most"),
        select(func.min(OPENED.dealt)).where(*THEIRS).scalar_subquery().label("begun"),
        exists().where(*ENROLLED).label("enrolled"),
    )
    .join_from(cards, slots).join(task_sets).where(cards.c.variant == bindparam("variant"))
)  # fmt: skip


class Sets:
    """The task sets of one store."""

    def __init__(self, connections: Connections) -> None:
        self._connections = connections
        self._slots: dict[str, tuple[Slot, ...]] = {}  # of published sets, which do not change

    async def add(self, new: TaskSet, entry: Entry | None = None) -> None:
        """Store a new draft with its slots."""
        await self._connections.write(noting(lambda connection: _add(connection, new), entry))

    async def change(self, new: TaskSet, revision: int) -> None:
        """Store a draft anew over one of a revision."""
        await self._connections.write(lambda connection: _change(connection, new, revision))

    async def remove(self, number: str, entry: Entry) -> None:
        """Remove a draft."""
        await self._connections.write(noting(lambda connection: _remove(connection, number), entry))

    async def task_set(self, number: str) -> TaskSet | None:
        """Give a set with its slots."""
        return await self._connections.read(lambda connection: task_set(connection, number))

    async def of(self, course: str) -> Sequence[TaskSet]:
        """List the sets of a course, the newest first."""
        query = select(task_sets).where(task_sets.c.course == course).order_by(task_sets.c.created.desc())
        return await self._connections.read(lambda connection: _sets(connection, query))

    async def students(self, course: str) -> Sequence[str]:
        """List the students of a course, in the order of joining."""
        mine = memberships.c.course == course, memberships.c.role == "student"
        query = select(memberships.c.person).where(*mine).order_by(memberships.c.joined, memberships.c.person)
        return await self._connections.read(lambda connection: list(connection.execute(query).scalars()))

    async def deck(self, number: str, slot: int | None = None) -> Sequence[Card]:
        """List the cards of a set, or of one of its slots, by slot and number."""
        return await self._connections.read(lambda connection: deck.of_set(connection, number, slot))

    async def numbers(self, number: str) -> Sequence[tuple[int, str | None]]:
        """List the numbers of the cards of the first task, and for whom each is kept."""
        first = slots.c.task_set == number, slots.c.number == 1
        query = select(cards.c.number, cards.c.person).join(slots).where(*first).order_by(cards.c.number)
        rows = await self._connections.read(lambda connection: connection.execute(query).all())
        return [(row.number, row.person) for row in rows]

    async def cards(self, number: str, person: str) -> Sequence[Card]:
        """List the cards of a student in a set by slot and turn."""
        return await self._connections.read(lambda connection: deck.of_student(connection, number, person))

    async def titles(self, number: str, person: str, language: str) -> Mapping[int, str]:
        """Give the titles of the cards that a student has opened in a set."""
        return await self._connections.read(lambda connection: deck.titles(connection, number, person, language))

    async def open(self, slot: Slot, person: str, variant: str, now: datetime) -> Card | None:
        """Deal a student's card of a slot."""
        return await self._connections.write(lambda connection: deck.open_card(connection, slot, person, variant, now))

    async def replace(self, slot: Slot, person: str, variant: str, now: datetime) -> Card | None:
        """Deal a student another card of a slot."""
        return await self._connections.write(lambda connection: deck.replace(connection, slot, person, variant, now))

    async def append(self, card: Card) -> None:
        """Store one more card of a deck, behind the others."""
        await self._connections.write(lambda connection: deck.append(connection, card))

    async def place(self, variant: str) -> Place | None:
        """Tell where a variant stands; None for practice."""
        return await self._connections.read(lambda connection: _place(connection, variant, self._slots))

    async def shown(self, variant: str, language: str) -> Mapping[str, Any] | None:
        """Give what the card of a variant shows in a language; None for practice."""
        query = select(cards.c.shown[language]).where(cards.c.variant == variant)
        return await self._connections.read(lambda connection: connection.execute(query).scalar_one_or_none())

    async def begun(self, number: str, person: str) -> datetime | None:
        """Tell when a student first opened a set."""
        return await self._connections.read(lambda connection: deck.begun(connection, number, person))

    async def extra(self, number: str, person: str) -> int:
        """Tell how many minutes more a student has."""
        return await self._connections.read(lambda connection: _extra(connection, number, person))

    async def most_extra(self, number: str) -> int:
        """Tell how many minutes more anybody has."""
        return await self._connections.read(lambda connection: _most_extra(connection, number))

    async def accommodate(
        self, number: str, person: str, minutes: int, reason: str, entry: Entry | None = None
    ) -> None:
        """Give a student more time; 0 minutes take it back."""
        give = partial(_accommodate, number=number, person=person, minutes=minutes, reason=reason)
        await self._connections.write(noting(give, entry))

    async def accommodations(self, number: str) -> Mapping[str, tuple[int, str]]:
        """Give minutes and reason by student."""
        query = select(accommodations).where(accommodations.c.task_set == number)
        rows = await self._connections.read(lambda connection: connection.execute(query).all())
        return {row.person: (row.minutes, row.reason) for row in rows}

    async def move(self, moves: Sequence[tuple[TaskSet, TaskSet]], entries: Sequence[Entry] = ()) -> None:
        """Move the deadlines of sets from those that were seen to others, all together."""
        await self._connections.write(lambda connection: _move(connection, moves, entries))

    async def open_hint(self, hint: Hint) -> None:
        """Store that a step of a ladder was opened, once."""
        await self._connections.write(lambda connection: hints.keep(connection, hint))

    async def hints(self, variant: str) -> Sequence[Hint]:
        """List the steps that were opened under the answers of a variant."""
        return await self._connections.read(lambda connection: hints.of(connection, variant))

    async def keep_attempt(self, marked: Marked, limit: int | None) -> tuple[Marked, bool]:
        """Store a submission to a set, and its attempt, together."""
        return await self._connections.write(lambda connection: attempts.keep(connection, marked, limit))

    async def ledger(self, number: str, person: str | None = None) -> Sequence[Line]:
        """List the submissions to a set in the order received, of all students or one."""
        return await self._connections.read(lambda connection: attempts.ledger(connection, number, person))

    async def used_up(self, number: str) -> Sequence[str]:
        """List the students who have used up the attempts of some task of a set."""
        return await self._connections.read(lambda connection: attempts.used_up(connection, number))

    async def reserved(self, exercise: str, now: datetime) -> bool:
        """Tell whether a published set that is not over deals an exercise."""
        return await self._connections.read(lambda connection: _reserved(connection, exercise, now))

    async def waiting(self) -> Sequence[Waiting]:
        """List the drafts in examinations that are newer than what was handed in, where an attempt is left."""
        return await self._connections.read(attempts.waiting)


def task_set(connection: Connection, number: str) -> TaskSet | None:
    """Give a set with its slots."""
    return next(iter(_sets(connection, select(task_sets).where(task_sets.c.id == number))), None)


def _add(connection: Connection, new: TaskSet) -> None:
    connection.execute(insert(task_sets), _columns(new))
    _add_slots(connection, new)


def _columns(new: TaskSet) -> dict[str, object]:
    return {column.name: getattr(new, column.name) for column in task_sets.columns}


def _add_slots(connection: Connection, new: TaskSet) -> None:
    rows = [
        {column.name: getattr(slot, column.name) for column in slots.columns} | {"pool": list(slot.pool)}
        for slot in new.slots
    ]
    if rows:
        connection.execute(insert(slots), rows)


def _change(connection: Connection, new: TaskSet, revision: int) -> None:
    draft = task_sets.c.id == new.id, task_sets.c.state == DRAFT, task_sets.c.revision == revision
    if connection.execute(update(task_sets).where(*draft), _columns(new)).rowcount != 1:
        raise NotADraft(new.id)
    connection.execute(delete(slots).where(slots.c.task_set == new.id))
    _add_slots(connection, new)


def _remove(connection: Connection, number: str) -> None:
    draft = task_sets.c.id == number, task_sets.c.state == DRAFT
    if connection.execute(select(task_sets.c.id).where(*draft).with_for_update()).first() is None:
        raise NotADraft(number)
    for table in (slots, accommodations):
        connection.execute(delete(table).where(table.c.task_set == number))
    connection.execute(delete(task_sets).where(*draft))


def _move(connection: Connection, moves: Sequence[tuple[TaskSet, TaskSet]], entries: Sequence[Entry]) -> None:
    for old, new in moves:
        moved = update(task_sets).where(task_sets.c.id == old.id, task_sets.c.revision == old.revision)
        values = {"due": new.due, "closes": new.closes, "extended": new.extended, "revision": old.revision + 1}
        if connection.execute(moved, values).rowcount != 1:
            raise DeadlinesMoved(old.id)
    for entry in entries:
        note(connection, entry)


def _sets(connection: Connection, query: Select[tuple[object, ...]]) -> list[TaskSet]:
    rows = connection.execute(query).mappings().all()
    found = select(slots).where(slots.c.task_set.in_([row["id"] for row in rows])).order_by(slots.c.number)
    theirs: dict[str, list[Slot]] = {}
    for row in connection.execute(found).mappings():
        theirs.setdefault(row["task_set"], []).append(deck.slot_of(row))
    return [_task_set(row, theirs.get(row["id"], ())) for row in rows]


def _task_set(row: Mapping[Any, Any], its_slots: Iterable[Slot]) -> TaskSet:
    own = {column.name: row[column] for column in task_sets.columns}
    return TaskSet(**own | {"extended": tuple(map(tuple, own["extended"]))}, slots=tuple(its_slots))


def _place(connection: Connection, variant: str, known: dict[str, tuple[Slot, ...]]) -> Place | None:
    row = connection.execute(PLACE, {"variant": variant}).mappings().first()
    if row is None:
        return None
    card = Card(shown=NOT_READ, **{column.name: row[column] for column in BRIEF})
    if card.weights is None:  # dealt by an older version
        card = replace(card, weights=weights_of(connection.execute(SHOWN, {"number": card.id}).scalar_one()))
    found = _task_set(row, known.get(row[task_sets.c.id]) or _slots(connection, row[task_sets.c.id], known))
    slot = next(slot for slot in found.slots if slot.id == card.slot)
    return Place(found, slot, card, row["extra"] or 0, row["begun"], row["most"] or 0, row["enrolled"])


def _slots(connection: Connection, number: str, known: dict[str, tuple[Slot, ...]]) -> tuple[Slot, ...]:
    """Read the slots of a set of which a card was opened, and remember them: it is published, so they stay."""
    found = tuple(map(deck.slot_of, connection.execute(SLOTS, {"number": number}).mappings()))
    if len(known) >= MOST_SETS:
        known.clear()
    known[number] = found
    return found


def _reserved(connection: Connection, exercise: str, now: datetime) -> bool:
    dealt = exists().where(cards.c.exercise == exercise, cards.c.slot == slots.c.id, slots.c.task_set == task_sets.c.id)
    found = _sets(connection, select(task_sets).where(task_sets.c.state == PUBLISHED, dealt))
    return any(not _is_over(connection, one, now) for one in found)


def _is_over(connection: Connection, found: TaskSet, now: datetime) -> bool:
    most, rules = _most_extra(connection, found.id), Rules.model_validate(found.rules)
    return window(found.opens, found.due, found.closes, rules, extra=most).stage(now) is Stage.CLOSED


def _extra(connection: Connection, number: str, person: str) -> int:
    mine = accommodations.c.task_set == number, accommodations.c.person == person
    return connection.execute(select(accommodations.c.minutes).where(*mine)).scalar_one_or_none() or 0


def _most_extra(connection: Connection, number: str) -> int:
    query = select(func.max(accommodations.c.minutes)).where(accommodations.c.task_set == number)
    return connection.execute(query).scalar_one() or 0


def _accommodate(connection: Connection, number: str, person: str, minutes: int, reason: str) -> None:
    mine = accommodations.c.task_set == number, accommodations.c.person == person
    connection.execute(delete(accommodations).where(*mine))
    if minutes:
        values = {"task_set": number, "person": person, "minutes": minutes, "reason": reason}
        connection.execute(insert(accommodations), values)
