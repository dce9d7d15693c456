"""Building a set: what a lecturer may write, drafts by revision, copies with shifted dates, moved deadlines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from hashlib import sha256
from math import isfinite
from typing import Annotated, Any
from zoneinfo import ZoneInfo

from pydantic import Field, StrictInt

from exercises import catalogue
from server.people.api import Strict
from server.sets.clock import NoSuchMoment, read, shifted, zone
from server.sets.foresight import Scarce, Task, Uneven, length, refuse_unfit, scarce, uneven
from server.sets.reopening import solved_for
from server.sets.rules import Rules, window
from server.storage.audit import Action, Entry
from server.storage.courses import Course
from server.storage.sets import DRAFT, PUBLISHED, DeadlinesMoved, NotADraft, Slot, TaskSet
from server.web import ids
from server.web.errors import Refused, printable
from server.web.typed import Typed
from server.workbench import Bench

MOST_SLOTS = 50
Name = Annotated[Typed, Field(min_length=1, max_length=64)]
Title = Annotated[Typed, Field(min_length=1, max_length=200)]
Local = Annotated[Typed, Field(max_length=40)]
Minutes = Annotated[StrictInt, Field(ge=1, le=100_000)]
Days = Annotated[StrictInt, Field(ge=-3660, le=3660)]


class Item(Strict):
    """A place in a set: one exercise or a pool, of which `pick` are dealt; points and attempts of each; limits of
    givens in SI units."""

    exercise: Name | None = None
    pool: Annotated[tuple[Name, ...], Field(max_length=MOST_SLOTS)] = ()
    pick: Annotated[StrictInt, Field(ge=1, le=MOST_SLOTS)] = 1
    points: Annotated[float, Field(ge=0, le=1000)] = 1.0
    attempts: Annotated[StrictInt, Field(ge=1, le=1000)] | None = None
    limits: Annotated[dict[Name, tuple[float, float]], Field(default_factory=dict)]


class Draft(Strict):
    """What a lecturer writes of a set. Moments without an offset are local time of the course."""

    title: Title
    items: Annotated[tuple[Item, ...], Field(max_length=MOST_SLOTS)] = ()
    opens: Local | None = None
    due: Local | None = None
    closes: Local | None = None
    rules: Rules = Rules()


async def add(bench: Bench, course: Course, draft: Draft) -> TaskSet:
    """Store a new draft.

    Raises:
        Refused: 422, something in it cannot be.
    """
    new = _made(ids.new(), course, draft, 1, datetime.now(UTC))
    await _refuse_what_cannot_be(bench, new, draft)
    await bench.sets.add(new)
    return new


async def change(
    bench: Bench, old: TaskSet, course: Course, draft: Draft, revision: int, person: str | None = None
) -> TaskSet:
    """Store a draft anew, as it was changed by a person.

    Raises:
        Refused: 409, it is published, or was changed meanwhile; 422, something in it cannot be.
    """
    new = _made(old.id, course, draft, revision + 1, old.created)
    new = replace(new, changed=datetime.now(UTC), changed_by=person)
    await _refuse_what_cannot_be(bench, new, draft)
    try:
        await bench.sets.change(new, revision)
    except NotADraft:
        raise _not_a_draft(old) from None
    return new


def _not_a_draft(old: TaskSet) -> Refused:
    return Refused(409, "set_changed" if old.state == DRAFT else "set_frozen", field="revision")


def _made(number: str, course: Course, draft: Draft, revision: int, created: datetime) -> TaskSet:
    place = zone(course.time_zone)
    opens, due, closes = (_moment(draft, name, place) for name in ("opens", "due", "closes"))
    bounds = [moment for moment in (opens, due, closes) if moment is not None]
    if bounds != sorted(bounds):
        raise Refused(422, "set_times", field="due")
    slots = _slots(number, draft.items)
    rules = draft.rules.model_dump(mode="json")
    return TaskSet(number, course.id, draft.title, rules, DRAFT, opens, due, closes, None, revision, created, slots)


def _moment(draft: Draft, name: str, place: ZoneInfo) -> datetime | None:
    text = getattr(draft, name)
    try:
        return read(text, place) if text else None
    except NoSuchMoment:
        raise Refused(422, "no_moment", field=name, name=name, zone=place.key) from None


def _slots(number: str, items: Sequence[Item]) -> tuple[Slot, ...]:
    slots: list[Slot] = []
    for at, item in enumerate(items):
        pool = _pool(item, at)
        for low, high in item.limits.values():
            if not (isfinite(low) and isfinite(high) and low <= high):
                raise Refused(422, "out_of_range", field=f"items.{at}.limits", name="limits")
        for _ in range(item.pick):
            slots.append(Slot(ids.new(), number, len(slots) + 1, pool, item.points, item.attempts, dict(item.limits)))
    if len(slots) > MOST_SLOTS:
        raise Refused(422, "out_of_range", field="items", name="items")
    return tuple(slots)


def _pool(item: Item, at: int) -> tuple[str, ...]:
    pool = tuple(dict.fromkeys([*([item.exercise] if item.exercise else []), *item.pool]))
    for exercise in pool:
        if exercise not in catalogue.ids():
            raise Refused(422, "unknown_exercise", field=f"items.{at}.{printable(exercise)}")
    if not 1 <= item.pick <= len(pool):
        raise Refused(422, "set_pick", field=f"items.{at}")
    return pool


async def _refuse_what_cannot_be(bench: Bench, new: TaskSet, draft: Draft) -> None:
    await _refuse_strange_chance(bench, new)
    tasks = [(_pool(item, at), item.limits) for at, item in enumerate(draft.items)]
    await _looked_through(bench, tasks)
    await bench.judging.run(refuse_unfit, tasks)


async def _looked_through(bench: Bench, tasks: Sequence[Task]) -> None:
    """Let the judge look through exercises one at a time: what students hand in goes between."""
    for exercise in dict.fromkeys(name for pool, _ in tasks for name in pool if name in catalogue.ids()):
        await bench.judging.run(length, exercise)


def _tasks(task_set: TaskSet) -> list[Task]:
    return [(slot.pool, slot.limits) for slot in task_set.slots]


async def unfit(bench: Bench, task_set: TaskSet) -> Refused | None:
    """Tell why a stored draft can never be published, as far as that is known: exercises change."""
    await _looked_through(bench, _tasks(task_set))
    try:
        await bench.judging.run(refuse_unfit, _tasks(task_set))
    except Refused as refused:
        return refused
    return None


async def scarcely(bench: Bench, task_set: TaskSet) -> tuple[Scarce, ...]:
    """Name the tasks of a stored draft whose limits keep too few draws for it to be published."""
    found = [await bench.judging.run(scarce, [task]) for task in _tasks(task_set)]
    return tuple(replace(one, slot=slot) for slot, told in enumerate(found, 1) for one in told)


async def unequal(bench: Bench, task_set: TaskSet) -> tuple[Uneven, ...]:
    """Name the pools of a stored draft of which most cards would differ in their number of steps."""
    found = [await bench.judging.run(uneven, [task]) for task in _tasks(task_set)]
    return tuple(replace(one, slot=slot) for slot, told in enumerate(found, 1) for one in told)


async def _refuse_strange_chance(bench: Bench, new: TaskSet) -> None:
    first = new.rules["second_chance_of"]
    if first is None:
        return
    found = await bench.sets.task_set(first)
    if found is None or found.course != new.course or found.id == new.id or found.rules["second_chance_of"]:
        raise Refused(422, "unknown_set", field="rules.second_chance_of")


def draft_of(task_set: TaskSet) -> Draft:
    """Give a set as its lecturer would write it."""
    items = tuple(
        Item(pool=slot.pool, points=slot.points, attempts=slot.attempts, limits=dict(slot.limits))
        for slot in task_set.slots
    )
    moments = {name: _iso(getattr(task_set, name)) for name in ("opens", "due", "closes")}
    return Draft(title=task_set.title, items=items, rules=Rules.model_validate(task_set.rules), **moments)


def says(task_set: TaskSet, course: Course, draft: Draft) -> bool:
    """Tell whether a set is as a draft has it."""
    made = _made(task_set.id, course, draft, task_set.revision, task_set.created)
    return draft_of(made) == draft_of(task_set)


def _iso(moment: datetime | None) -> str | None:
    return moment.isoformat() if moment else None


async def copy(
    bench: Bench, task_set: TaskSet, course: Course, days: int, actor: str, first: str | None = None
) -> TaskSet:
    """Copy a set as a draft; its dates move by whole days of the course's clock. `first` is the set to which the copy
    is a second chance."""
    place = zone(course.time_zone)
    opens, due, closes = (
        shifted(moment, days, place) if moment else None for moment in (task_set.opens, task_set.due, task_set.closes)
    )
    number, rules = ids.new(), {**task_set.rules, "second_chance_of": first}
    slots = tuple(replace(slot, id=ids.new(), task_set=number) for slot in task_set.slots)
    new = replace(
        task_set, id=number, course=course.id, rules=rules, state=DRAFT, published=None, revision=1,
        created=datetime.now(UTC), slots=slots, opens=opens, due=due, closes=closes, extended=(), changed=None,
        changed_by=None,
    )  # fmt: skip
    entry = Entry(actor, Action.SET_COPIED, number, course.id, {"from": task_set.id, "days": days})
    await bench.sets.add(new, entry)
    return new


async def remove(bench: Bench, task_set: TaskSet, actor: str) -> None:
    """Remove a draft.

    Raises:
        Refused: 409, it is published.
    """
    entry = Entry(actor, Action.SET_REMOVED, task_set.id, task_set.course, {"title": task_set.title})
    try:
        await bench.sets.remove(task_set.id, entry)
    except NotADraft:
        raise Refused(409, "set_frozen") from None


async def extend(
    bench: Bench, sets: Sequence[TaskSet], minutes: int, now: datetime, actor: str, seen: str | None = None
) -> list[tuple[TaskSet, int]]:
    """Move the deadlines of published sets of which one is still ahead, and the end of time limits that run.

    Gives the sets that moved, each with the number of students to whom its solutions stood open.

    Raises:
        Refused: 409, the deadlines are not those that were `seen`, or were moved at the same moment.
    """
    if seen is not None and seen != deadlines(sets):
        raise Refused(409, "deadlines_moved")
    moves = [(one, _moved(one, minutes, now)) for one in movable(sets, now)]
    solved = [await solved_for(bench, one, now) for one, _ in moves]
    try:
        await bench.sets.move(
            moves, [_entry(actor, one, minutes, n) for (one, _), n in zip(moves, solved, strict=True)]
        )
    except DeadlinesMoved:
        raise Refused(409, "deadlines_moved") from None
    return [(new, number) for (_, new), number in zip(moves, solved, strict=True)]


def _entry(actor: str, moved: TaskSet, minutes: int, solved: int) -> Entry:
    told = {"minutes": minutes} | ({"solved_for": solved} if solved else {})
    return Entry(actor, Action.DEADLINES_MOVED, moved.id, moved.course, told)


def movable(sets: Sequence[TaskSet], now: datetime) -> list[TaskSet]:
    """Keep the published sets of which a deadline is still ahead."""
    return [one for one in sets if one.state == PUBLISHED and _ahead(one, now)]


def deadlines(sets: Sequence[TaskSet]) -> str:
    """Give a digest of the deadlines of published sets, by which a form knows whether they have moved."""
    told = sorted(f"{one.id} {one.due} {one.closes} {one.revision}" for one in sets if one.state == PUBLISHED)
    return sha256("\n".join(told).encode()).hexdigest()


def _ahead(task_set: TaskSet, now: datetime) -> bool:
    rules = Rules.model_validate(task_set.rules)
    found = window(task_set.opens, task_set.due, task_set.closes, rules)
    undated = rules.minutes is not None and found.due is None and found.closes is None
    return undated or any(moment is not None and now <= moment for moment in (found.due, found.closes))


def _moved(task_set: TaskSet, minutes: int, now: datetime) -> TaskSet:
    due, closes = _later(task_set.due, minutes), _later(task_set.closes, minutes)
    limited = Rules.model_validate(task_set.rules).minutes is not None
    extended = [*task_set.extended, *([(now.isoformat(), minutes)] if limited else [])]
    return replace(task_set, due=due, closes=closes, extended=extended)


def _later(moment: datetime | None, minutes: int) -> datetime | None:
    return moment + timedelta(minutes=minutes) if moment else None


def merged(old: Draft, changes: dict[str, Any]) -> Draft:
    """Give a draft with some of its parts written anew."""
    return old.model_copy(update=changes)
