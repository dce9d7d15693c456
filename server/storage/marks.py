"""Marks by hand, what a gradebook is made of, and what a store of both promises."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import NamedTuple, Protocol

from server.storage.audit import Entry
from server.storage.practice import Draft, Handed
from server.storage.sets import Line


@dataclass(frozen=True, slots=True)
class Mark:
    """What a lecturer says of a submission; it is never changed, a newer one counts in its place.

    Attributes:
        submission: The receipt of the submission.
        answer: The answer it is about; none for the whole submission.
        share: The share of the points, 0 to 1; none for a comment only.
        comment: Why, in the lecturer's words.
        author: Who gave it.
        number: Grows with time; 0 before it is stored.
    """

    submission: str
    answer: str | None
    share: float | None
    comment: str
    author: str
    time: datetime
    number: int = 0


class DealtCard(NamedTuple):
    """A card that a student has opened, without what it shows."""

    slot: str
    person: str
    variant: str
    code: str
    exercise: str
    version: int
    seed: int
    turn: int
    dealt: datetime


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a student is in a set: tasks opened and handed in, submissions, and when the last one came."""

    person: str
    opened: int
    answered: int
    submissions: int
    last: datetime | None


class Marks(Protocol):
    """A store of marks by hand."""

    async def give(self, marks: Sequence[Mark], entry: Entry | None = None) -> None:
        """Store marks together."""
        ...

    async def of(self, task_set: str, person: str | None = None) -> Sequence[Mark]:
        """List the marks in a set in the order given, of all students or one."""
        ...

    async def on(self, receipt: str) -> Sequence[Mark]:
        """List the marks on a submission in the order given."""
        ...

    async def weights(self, task_set: str, person: str | None = None) -> Mapping[str, Mapping[str, float]]:
        """Give the weights of the answers of those variants in a set of which some answer is marked."""
        ...

    async def dealt(self, task_set: str, person: str | None = None) -> Sequence[DealtCard]:
        """List the cards that were opened in a set, by slot and turn."""
        ...

    async def lines(self, task_set: str, person: str | None = None) -> Sequence[Line]:
        """List the submissions to a set in the order received; the grade holds its verdicts only where some answer is
        marked or may be left open, else its score alone."""
        ...

    async def handed(self, task_set: str, person: str | None = None) -> Sequence[Handed]:
        """List what was handed in to a set in the order received."""
        ...

    async def with_receipts(self, receipts: Sequence[str]) -> Mapping[str, Handed]:
        """Give what was handed in under some receipts."""
        ...

    async def drafts(self, task_set: str, person: str) -> Sequence[Draft]:
        """List the drafts of a student in a set."""
        ...

    async def progress(self, task_set: str) -> Sequence[Progress]:
        """Tell how far the students are that have opened a set."""
        ...
