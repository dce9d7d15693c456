"""How a student stands in a set: windows, attempts, points; all of it computed from the ledger."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Any

from server.courses import zones
from server.marks.counting import by_submission, entries
from server.sets import clock
from server.sets.handing import faulty, rules_of, shown_after, window_of
from server.sets.rules import Entry, Rules, Stage, Window, combined, held, left, result
from server.storage.marks import DealtCard
from server.storage.sets import Line, Slot, TaskSet
from server.workbench import Bench


@dataclass(frozen=True, slots=True)
class Task:
    """One slot of a student.

    Attributes:
        card: The card as it was dealt; none before the first open.
        ledger: What was handed in, in the order received.
        share: The share of the points earned so far; none where nothing was judged.
        left: Attempts left; none for as many as one likes.
        marked: The submissions that the lecturer has marked or commented on.
    """

    slot: Slot
    card: DealtCard | None
    ledger: tuple[Entry, ...]
    share: float | None
    left: int | None
    marked: tuple[Line, ...] = ()

    @property
    def counted(self) -> int:
        """How many attempts are used up."""
        return sum(entry.counted for entry in self.ledger)

    @property
    def points(self) -> float:
        """The points earned so far."""
        return round((self.share or 0.0) * self.slot.points, 3)


@dataclass(frozen=True, slots=True)
class Standing:
    """A student in a set; while results are held, points are not to be shown to him."""

    task_set: TaskSet
    rules: Rules
    window: Window
    stage: Stage
    held: bool
    tasks: tuple[Task, ...]

    @property
    def worth(self) -> float:
        """The points of the whole set."""
        return sum(task.slot.points for task in self.tasks)

    @property
    def points(self) -> float:
        """The points earned so far."""
        return round(sum(task.points for task in self.tasks), 3)

    @property
    def share(self) -> float:
        """The share of the points earned so far."""
        return self.points / self.worth if self.worth else 0.0

    @property
    def taken(self) -> bool:
        """Whether anything was judged."""
        return any(task.share is not None for task in self.tasks)


async def standing(bench: Bench, task_set: TaskSet, person: str, now: datetime) -> Standing:
    """Tell how a student stands."""
    lines = await bench.sets.ledger(task_set.id, person)
    marks = await bench.marks.of(task_set.id, person)
    weights = await bench.marks.weights(task_set.id, person) if marks else {}
    dealt = await bench.marks.dealt(task_set.id, person)
    extra, begun = await bench.sets.extra(task_set.id, person), await bench.sets.begun(task_set.id, person)
    rules, found = rules_of(task_set), window_of(task_set, extra, begun)
    shown = shown_after(task_set, found, await bench.sets.most_extra(task_set.id)).stage(now)
    ledger = entries(lines, by_submission(marks), weights, rules)
    said, both = {mark.submission for mark in marks}, list(zip(ledger, lines, strict=True))
    tasks = tuple(
        replace(
            _task(slot, dealt, [one for one, line in both if line.slot == slot.id], found, rules),
            marked=tuple(line for line in lines if line.slot == slot.id and line.receipt in said),
        )
        for slot in task_set.slots
    )
    return Standing(task_set, rules, found, found.stage(now), held(rules, shown), tasks)


def _task(slot: Slot, dealt: Sequence[DealtCard], ledger: Sequence[Entry], found: Window, rules: Rules) -> Task:
    card = next((card for card in reversed(dealt) if card.slot == slot.id), None)
    counted = sum(entry.counted for entry in ledger)
    return Task(slot, card, tuple(ledger), result(ledger, found.due, rules), left(slot.attempts, counted))


async def final(bench: Bench, own: Standing, person: str, now: datetime) -> float | None:
    """Give the share of a student who stands so in a set; one that is a second chance is weighed with the first.

    None while the results of either are held back.
    """
    before = own.rules.second_chance_of
    first = await bench.sets.task_set(before) if before else None
    if first is None or own.held:
        return None if own.held else own.share
    earlier = await standing(bench, first, person, now)
    if earlier.held:
        return None
    return combined(earlier.share, own.share if own.taken else None)


async def on_page(bench: Bench, variant: str, language: str, now: datetime) -> dict[str, Any]:
    """Give what the page of a variant shows of its set; nothing of it is there in practice."""
    place = await bench.sets.place(variant)
    if place is None:
        return {"task": None}
    assert place.card.person is not None
    course = await bench.courses.course(place.task_set.course)
    assert course is not None
    own = await standing(bench, place.task_set, place.card.person, now)
    task = own.tasks[place.slot.number - 1]
    last = await bench.storage.latest(variant)
    return {
        "task": task,
        "own": own,
        "task_open": own.stage in (Stage.OPEN, Stage.LATE) and task.left != 0,
        "spoilt": last is not None and faulty(last),
        "remaining": clock.left(own.window.due, now),
        "seconds": clock.seconds_left(own.window.due, now),
        "ahead": _ahead(own.window, now),
        **zones.told(language, clock.zone(course.time_zone)),
    }


def _ahead(own: Window, now: datetime) -> dict[str, int]:
    """Give in how many seconds work is late, and in how many it is not taken any more, where that is still to come."""
    moments = {Stage.LATE.value: own.due, Stage.CLOSED.value: own.closes}
    return {stage: clock.seconds_left(moment, now) for stage, moment in moments.items() if moment and moment > now}
