"""Printing a deck for a class: what each card shows becomes sheets, what it is judged against becomes the key.

Made from the deck alone, so an upgrade of an exercise leaves the sheets as they were dealt.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

from pydantic import TypeAdapter
from sqlalchemy import Connection, select

from exercises.presenting import Presented
from reports import formats, sheets
from reports.sheets import Sheet
from server.storage.jobs import DONE, Batch, Ending, Job, Jobs, Json, Kept, Kind, Order
from server.storage.sets import TaskSet
from server.tables import batches, deck, slots
from server.web import ids

NAME = "sheets"
AT_ONCE = 100  # sheets of one document
PRESENTED: TypeAdapter[Presented] = TypeAdapter(Presented)


@dataclass(frozen=True, slots=True)
class Printed:
    """What one document is made of; plain data."""

    language: str
    key: bool
    cards: tuple[tuple[str, Mapping[str, Any], Mapping[str, str]], ...]


def sheet(code: str, shown: Mapping[str, Any], right: Mapping[str, str]) -> Sheet:
    """Make the sheet of a card, from what it shows in one language."""
    return Sheet(code, PRESENTED.validate_python(shown), right)


async def order(jobs: Jobs, task_set: TaskSet, cards: Sequence[int], person: str | None, language: str) -> str:
    """Order the sheets and the keys of a published set; gives the number of the job.

    Args:
        jobs: The store of jobs.
        task_set: The set.
        cards: Numbers of the cards that are printed, the same in all tasks.
        person: Who orders.
        language: pl, en or ru.

    Raises:
        Busy: They are being printed.
    """
    pieces = list(_pieces([slot.number for slot in task_set.slots], cards))
    payload = {"task_set": task_set.id, "language": language}
    made = Order(ids.new(), NAME, task_set.id, task_set.course, payload, pieces, person, datetime.now(UTC))
    await jobs.start(made)
    return made.id


def _pieces(tasks: Sequence[int], cards: Sequence[int]) -> Iterator[Json]:
    for slot in tasks:
        for key in (False, True):
            for start in range(0, len(cards), AT_ONCE):
                yield {"slot": slot, "key": key, "cards": list(cards[start : start + AT_ONCE])}


def read(connection: Connection, batch: Batch) -> Printed:
    """Read the cards of one document."""
    piece, language = batch.piece, batch.payload["language"]
    columns = deck.c.code, deck.c.shown[language].label("shown"), deck.c.reference["texts"].label("right")
    theirs = slots.c.task_set == batch.payload["task_set"], slots.c.number == piece["slot"]
    query = select(*columns).join(slots).where(*theirs, deck.c.number.in_(piece["cards"])).order_by(deck.c.number)
    cards = tuple((row.code, row.shown, row.right) for row in connection.execute(query))
    return Printed(language, piece["key"], cards)


def compute(secret: bytes, given: Printed) -> bytes:
    """Print one document."""
    return document(given, "pdf")


def document(given: Printed, form: str) -> bytes:
    """Write one document in a form; long work, to be done apart from the judging."""
    make = sheets.key if given.key else sheets.sheets
    return formats.written(make([sheet(*card) for card in given.cards], given.language), form)


def write(connection: Connection, batch: Batch, outcome: bytes) -> Kept:
    """Keep the document."""
    piece = batch.piece
    told = {"number": batch.number, "slot": piece["slot"], "key": piece["key"], "sheets": len(piece["cards"])}
    return Kept(told, outcome)


def finish(connection: Connection, job: Job) -> Ending:
    """List the documents."""
    mine = batches.c.job == job.id, batches.c.state == DONE
    told = connection.execute(select(batches.c.result).where(*mine).order_by(batches.c.number)).scalars().all()
    return Ending({"documents": list(told)})


def undo(connection: Connection, job: Job) -> None:
    """Leave the documents: each is whole."""


SHEETS = Kind(NAME, read, compute, write, finish, undo)
