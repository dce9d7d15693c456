"""Task sets: their slots, cards, attempts, extra time, and what a store of them promises."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any, NamedTuple, Protocol

from server.storage.audit import Entry
from server.storage.practice import Answers, Marked

DRAFT, PUBLISHING, PUBLISHED = "draft", "publishing", "published"


@dataclass(frozen=True, slots=True)
class Slot:
    """A place in a set: a pool of exercises of which one is dealt, its points and attempts, limits on givens."""

    id: str
    task_set: str
    number: int
    pool: tuple[str, ...]
    points: float
    attempts: int | None
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class TaskSet:
    """A set with its slots.

    Attributes:
        rules: The rules as JSON values.
        state: draft, publishing (its deck is being dealt) or published.
        revision: Grows with every change of the draft, and with every move of the deadlines.
        extended: When deadlines were moved, and by how many minutes: time limits that ran then are longer.
        changed: When the draft was changed last.
        changed_by: The person who did; none where it was a token of nobody, or one who has been erased.
    """

    id: str
    course: str
    title: str
    rules: Mapping[str, Any]
    state: str
    opens: datetime | None
    due: datetime | None
    closes: datetime | None
    published: datetime | None
    revision: int
    created: datetime
    slots: tuple[Slot, ...] = ()
    extended: Sequence[tuple[str, int]] = ()
    changed: datetime | None = None
    changed_by: str | None = None


@dataclass(frozen=True, slots=True)
class Card:
    """A card of the deck.

    Attributes:
        code: What a student sees instead of the seed.
        shown: What the card shows, by language.
        reference: What it is judged against; it is never served.
        person: For whom it is kept; none for a spare one.
        turn: 1, more where it replaced a card that was at fault.
        variant: The variant it was dealt as.
        weights: Of its answers; none where they stand in what is shown alone.
    """

    id: str
    slot: str
    number: int
    code: str
    exercise: str
    version: int
    seed: int
    givens: Mapping[str, Any]
    shown: Mapping[str, Any]
    reference: Mapping[str, Any]
    person: str | None
    turn: int
    variant: str | None
    dealt: datetime | None
    weights: Mapping[str, float] | None = None


def weights_of(shown: Mapping[str, Any]) -> dict[str, float]:
    """Give the weights of the answers of a card from what it shows."""
    return {name: field["weight"] for name, field in next(iter(shown.values()))["answers"].items()}


@dataclass(frozen=True, slots=True)
class Place:
    """Where a variant stands: its set, slot and card, how much longer its student may work, since when, and whether the
    student is in the course still; `most` is the extra time of whoever has the most in the set.

    What the card shows is long, and is not read with its place; the weights of its answers are.
    """

    task_set: TaskSet
    slot: Slot
    card: Card
    extra: int
    begun: datetime | None
    most: int
    enrolled: bool


class Line(NamedTuple):
    """A submission of a student to a slot, with its newest grade; `hints` were opened at a price before it."""

    slot: str
    person: str
    variant: str
    receipt: str
    time: datetime
    grade: Mapping[str, Any]
    counted: bool
    hints: int = 0


@dataclass(frozen=True, slots=True)
class Hint:
    """A step of the ladder under an answer that was opened at its price; the first one is 1."""

    variant: str
    answer: str
    rung: int
    time: datetime


@dataclass(frozen=True, slots=True)
class Waiting:
    """A draft that was not handed in, and whose it is."""

    variant: str
    person: str
    answers: Answers
    time: datetime


class NotADraft(RuntimeError):
    """The set is published, or somebody else has changed the draft meanwhile."""


class DeadlinesMoved(RuntimeError):
    """Somebody else has moved the deadlines of this set meanwhile."""


class NoAttemptLeft(RuntimeError):
    """The attempts of this variant are used up."""


class Sets(Protocol):
    """A store of task sets."""

    async def add(self, new: TaskSet, entry: Entry | None = None) -> None:
        """Store a new draft with its slots."""
        ...

    async def change(self, new: TaskSet, revision: int) -> None:
        """Store a draft anew over one of a revision.

        Raises:
            NotADraft: It is published, or has another revision.
        """
        ...

    async def remove(self, number: str, entry: Entry) -> None:
        """Remove a draft.

        Raises:
            NotADraft: It is published, or there is none.
        """
        ...

    async def task_set(self, number: str) -> TaskSet | None:
        """Give a set with its slots."""
        ...

    async def of(self, course: str) -> Sequence[TaskSet]:
        """List the sets of a course, the newest first."""
        ...

    async def students(self, course: str) -> Sequence[str]:
        """List the students of a course, in the order of joining."""
        ...

    async def deck(self, number: str, slot: int | None = None) -> Sequence[Card]:
        """List the cards of a set, or of one of its slots, by slot and number."""
        ...

    async def numbers(self, number: str) -> Sequence[tuple[int, str | None]]:
        """List the numbers of the cards of the first task, and for whom each is kept."""
        ...

    async def cards(self, number: str, person: str) -> Sequence[Card]:
        """List the cards of a student in a set by slot and turn."""
        ...

    async def titles(self, number: str, person: str, language: str) -> Mapping[int, str]:
        """Give the titles of the cards that a student has opened in a set, by the number of the task."""
        ...

    async def open(self, slot: Slot, person: str, variant: str, now: datetime) -> Card | None:
        """Deal a student's card of a slot: the one dealt before, else the one kept for the student, else a spare.

        Args:
            slot: The slot.
            person: The student.
            variant: The number of the variant if it is dealt now.
            now: The moment.

        Returns:
            The card; None where no spare is left.
        """
        ...

    async def replace(self, slot: Slot, person: str, variant: str, now: datetime) -> Card | None:
        """Deal a student another card of a slot in place of the present one, whose attempts stay with it."""
        ...

    async def append(self, card: Card) -> None:
        """Store one more card of a deck."""
        ...

    async def place(self, variant: str) -> Place | None:
        """Tell where a variant stands; None for practice."""
        ...

    async def shown(self, variant: str, language: str) -> Mapping[str, Any] | None:
        """Give what the card of a variant shows in a language; None for practice."""
        ...

    async def begun(self, number: str, person: str) -> datetime | None:
        """Tell when a student first opened a set."""
        ...

    async def extra(self, number: str, person: str) -> int:
        """Tell how many minutes more a student has."""
        ...

    async def most_extra(self, number: str) -> int:
        """Tell how many minutes more anybody has."""
        ...

    async def accommodate(
        self, number: str, person: str, minutes: int, reason: str, entry: Entry | None = None
    ) -> None:
        """Give a student more time; 0 minutes take it back."""
        ...

    async def accommodations(self, number: str) -> Mapping[str, tuple[int, str]]:
        """Give minutes and reason by student."""
        ...

    async def move(self, moves: Sequence[tuple[TaskSet, TaskSet]], entries: Sequence[Entry] = ()) -> None:
        """Move the deadlines of sets from those that were seen to others, all together.

        Raises:
            DeadlinesMoved: Those of one are not as they were seen; nothing was stored.
        """
        ...

    async def open_hint(self, hint: Hint) -> None:
        """Store that a step of a ladder was opened; one that is open stays as it is."""
        ...

    async def hints(self, variant: str) -> Sequence[Hint]:
        """List the steps that were opened at a price under the answers of a variant, in order."""
        ...

    async def keep_attempt(self, marked: Marked, limit: int | None) -> tuple[Marked, bool]:
        """Store a submission to a set, and its attempt, together.

        Returns:
            What is stored under its key, and whether it had been there before.

        Raises:
            NoAttemptLeft: Nothing was stored.
            KeyReused: The key was used with another body.
        """
        ...

    async def ledger(self, number: str, person: str | None = None) -> Sequence[Line]:
        """List the submissions to a set in the order received, of all students or one."""
        ...

    async def used_up(self, number: str) -> Sequence[str]:
        """List the students who have used up the attempts of some task of a set."""
        ...

    async def reserved(self, exercise: str, now: datetime) -> bool:
        """Tell whether a published set that is not over deals an exercise."""
        ...

    async def waiting(self) -> Sequence[Waiting]:
        """List the drafts in examinations that are newer than what was handed in, where an attempt is left."""
        ...
