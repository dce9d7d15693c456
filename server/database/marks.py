"""Marks by hand in the database, and what a gradebook is made of: a few queries, however large the class."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from operator import attrgetter
from typing import Any

from sqlalchemy import Connection, Select, bindparam, case, func, insert, or_, select

from server.database.attempts import HANDED, graded, within
from server.database.audit import noting
from server.database.connections import Connections
from server.database.deck import WEIGHTS, weights_of
from server.database.hints import before, moments
from server.storage import Draft, Handed
from server.storage.audit import Entry
from server.storage.marks import DealtCard, Mark, Progress
from server.storage.sets import Line
from server.tables import deck, drafts, grades, marks, slots, submissions

CARD = (
    deck.c.slot, deck.c.person, deck.c.variant, deck.c.code, deck.c.exercise, deck.c.version, deck.c.seed,
    deck.c.turn, deck.c.dealt,
)  # fmt: skip
# What may hold an answer that was left open: what did not count may be all undecided, or our fault.
DOUBTFUL = or_(~grades.c.counted, grades.c.grade["provisional"].as_boolean())
MARKED = submissions.c.receipt.in_(select(marks.c.submission).where(marks.c.answer.is_not(None)))
WHOLE = case((or_(DOUBTFUL, MARKED), grades.c.grade))
LIGHT = select(*HANDED, WHOLE, grades.c.grade["score"].as_float(), grades.c.counted)

NONE: Mapping[str, Any] = {}

AT_ONCE = 1000  # receipts or variants in one query
MOST_WEIGHTS = 20_000  # variants whose weights are remembered
THESE = select(submissions).where(submissions.c.receipt.in_(bindparam("receipts", expanding=True)))
WEIGHED = select(deck.c.variant, *WEIGHTS).where(deck.c.variant.in_(bindparam("variants", expanding=True)))
ON = select(marks).where(marks.c.submission == bindparam("receipt")).order_by(marks.c.id)


class Marks:
    """The marks by hand of one store."""

    def __init__(self, connections: Connections) -> None:
        self._connections = connections
        self._weights: dict[str, Mapping[str, float]] = {}

    async def give(self, given: Sequence[Mark], entry: Entry | None = None) -> None:
        """Store marks together."""
        rows = [{c.name: getattr(mark, c.name) for c in marks.columns if c.name != "id"} for mark in given]
        await self._connections.write(noting(lambda connection: connection.execute(insert(marks), rows), entry))

    async def of(self, task_set: str, person: str | None = None) -> Sequence[Mark]:
        """List the marks in a set in the order given, of all students or one."""
        query = select(marks).join(submissions).join(deck, deck.c.variant == submissions.c.variant)
        return [_mark(row) for row in await self._rows(within(query, task_set, person).order_by(marks.c.id))]

    async def on(self, receipt: str) -> Sequence[Mark]:
        """List the marks on a submission in the order given."""
        return [_mark(row) for row in await self._rows(ON, {"receipt": receipt})]

    async def weights(self, task_set: str, person: str | None = None) -> Mapping[str, Mapping[str, float]]:
        """Give the weights of the answers of those variants in a set of which some answer is marked."""
        marked = select(submissions.c.variant).join(marks).where(marks.c.answer.is_not(None))
        here = within(select(deck.c.variant), task_set, person).where(deck.c.variant.in_(marked))
        asked = [row["variant"] for row in await self._rows(here)]
        known = {one: self._weights[one] for one in asked if one in self._weights}
        return {**known, **await self._read_weights([one for one in asked if one not in known])}

    async def _read_weights(self, variants: Sequence[str]) -> Mapping[str, Mapping[str, float]]:
        """Read weights from cards, and remember them: what was published does not change."""
        rows = [row for part in _parts(variants) for row in await self._rows(WEIGHED, {"variants": part})]
        found = {row["variant"]: weights_of(row) for row in rows}
        if len(self._weights) + len(found) > MOST_WEIGHTS:
            self._weights.clear()
        self._weights.update(found)
        return found

    async def dealt(self, task_set: str, person: str | None = None) -> Sequence[DealtCard]:
        """List the cards that were opened in a set, by slot and turn."""
        query = within(select(*CARD), task_set, person).where(deck.c.variant.is_not(None))
        ordered = query.order_by(slots.c.number, deck.c.turn)
        return await self._connections.read(
            lambda connection: [DealtCard(*row) for row in connection.execute(ordered).all()]
        )

    async def lines(self, task_set: str, person: str | None = None) -> Sequence[Line]:
        """List the submissions to a set in the order received, with the verdicts of those alone that need them."""
        return await self._connections.read(lambda connection: _lines(connection, task_set, person))

    async def handed(self, task_set: str, person: str | None = None) -> Sequence[Handed]:
        """List what was handed in to a set in the order received."""
        query = graded(select(submissions), task_set, person)
        return [Handed(**row) for row in await self._rows(query.order_by(submissions.c.time, submissions.c.receipt))]

    async def with_receipts(self, receipts: Sequence[str]) -> Mapping[str, Handed]:
        """Give what was handed in under some receipts."""
        rows = [row for part in _parts(receipts) for row in await self._rows(THESE, {"receipts": part})]
        return {row["receipt"]: Handed(**row) for row in rows}

    async def drafts(self, task_set: str, person: str) -> Sequence[Draft]:
        """List the drafts of a student in a set."""
        query = within(select(drafts).join(deck, deck.c.variant == drafts.c.variant), task_set, person)
        return [Draft(**row) for row in await self._rows(query)]

    async def progress(self, task_set: str) -> Sequence[Progress]:
        """Tell how far the students are that have opened a set."""
        query = select(
            deck.c.person,
            func.count(deck.c.slot.distinct()).label("opened"),
            func.count(deck.c.slot.distinct()).filter(submissions.c.receipt.is_not(None)).label("answered"),
            func.count(submissions.c.receipt).label("submissions"),
            func.max(submissions.c.time).label("last"),
        ).outerjoin(submissions, submissions.c.variant == deck.c.variant)
        opened = within(query, task_set, None).where(deck.c.variant.is_not(None)).group_by(deck.c.person)
        return [Progress(**row) for row in await self._rows(opened)]

    async def _rows(self, query: Select[Any], values: Mapping[str, Any] | None = None) -> Sequence[Mapping[str, Any]]:
        return await self._connections.read(
            lambda connection: [dict(row) for row in connection.execute(query, values).mappings().all()]
        )


def _parts(names: Sequence[str]) -> list[Sequence[str]]:
    return [names[at : at + AT_ONCE] for at in range(0, len(names), AT_ONCE)]


def _lines(connection: Connection, task_set: str, person: str | None) -> list[Line]:
    """Read the score of each submission, and the whole grade where some answer is marked or may be left open."""
    rows = connection.execute(graded(LIGHT, task_set, person)).all()
    opened = moments(connection, task_set)
    scored = {row[6]: {"score": row[6], "verdicts": NONE} for row in rows}  # there are few different ones
    found = [
        Line(slot, who, card, receipt, at, whole or scored[score], counted, before(opened, card, at) if opened else 0)
        for slot, who, card, receipt, at, whole, score, counted in rows
    ]
    found.sort(key=attrgetter("receipt"))
    found.sort(key=attrgetter("time"))  # the database would sort whole rows, which takes longer
    return found


def _mark(row: Mapping[str, Any]) -> Mark:
    return Mark(**{name: value for name, value in row.items() if name != "id"}, number=row["id"])
