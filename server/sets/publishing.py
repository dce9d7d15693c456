"""Publishing a set: a job draws and checks every slot, then the set may be used."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from datetime import UTC, datetime
from functools import partial

from server.database import decks
from server.sets import dealing
from server.sets.dealing import Drawn, Plan, Trouble
from server.sets.planning import planned, stored
from server.sets.rules import Rules, window
from server.storage.jobs import Job, Kind, Order
from server.storage.sets import Slot, TaskSet
from server.web import ids
from server.workbench import Bench

NAME = "publish"
PUBLISH = Kind(NAME, decks.read, dealing.prepare, decks.write, decks.finish, decks.undo, tells=True)
LOOK = 0.05  # s between two looks at a job that is waited for


class Troubled(ValueError):
    """The set cannot be published; `troubles` say why, slot by slot."""

    def __init__(self, troubles: Sequence[Trouble]) -> None:
        super().__init__(troubles)
        self.troubles = tuple(troubles)


async def order(bench: Bench, task_set: TaskSet, actor: str, person: str | None) -> str:
    """Order the publishing of a draft, which is frozen from now on; gives the number of the job.

    Raises:
        Troubled: It has no tasks, its results would be held back for ever, or it is a second chance to a draft.
        NotADraft: It is published already, or has changed meanwhile.
        Busy: It is being published.
    """
    if not task_set.slots:
        raise Troubled([Trouble(0, "empty")])
    if endless(task_set):
        raise Troubled([Trouble(0, "endless")])
    if await _first_is_a_draft(bench, task_set):
        raise Troubled([Trouble(0, "early_chance")])
    roster = await bench.sets.students(task_set.course)
    seats = dealing.seats(roster)
    payload = {"task_set": task_set.id, "roster": roster, "seats": seats, "actor": actor}
    numbers, now = [slot.number for slot in task_set.slots], datetime.now(UTC)
    made = Order(ids.new(), NAME, task_set.id, task_set.course, payload, numbers, person, now, parts=len(seats))
    await bench.jobs.start(made, partial(decks.begin, number=task_set.id, revision=task_set.revision))
    bench.engine.wake()
    return made.id


async def _first_is_a_draft(bench: Bench, task_set: TaskSet) -> bool:
    """Whether the set to which this is a second chance is not published: nobody can have done it."""
    number = task_set.rules.get("second_chance_of")
    first = await bench.sets.task_set(number) if number else None
    return first is not None and first.published is None


def endless(task_set: TaskSet) -> bool:
    """Whether a set is an examination that ends for nobody, so that nobody would ever see a result."""
    rules = Rules.model_validate(task_set.rules)
    found = window(task_set.opens, task_set.due, task_set.closes, rules)
    return rules.mode == "exam" and rules.minutes is None and found.closes is None


async def waited(bench: Bench, number: str, seconds: float) -> Job:
    """Give a job once it has ended, or as it is after some time."""
    clock = asyncio.get_running_loop().time
    end = clock() + seconds
    while True:
        job = await bench.jobs.job(number)
        assert job is not None
        if not job.live or clock() > end:
            return job
        await asyncio.sleep(LOOK)


def troubles(job: Job) -> list[Trouble]:
    """Give what stood against publishing."""
    return [Trouble(**told) for told in (job.result or {}).get("troubles", ())]


async def one_more(bench: Bench, task_set: TaskSet, slot: Slot) -> None:
    """Draw one more spare card where a deck has run out; limits may take thousands of draws, beside the judging."""
    plans = planned(task_set, (f"added {ids.new()}",))
    plan = next(plan for plan in plans if plan.slot == slot.id)
    if plan.limits:
        (drawn,) = await bench.judging.apart(_drawn, [(bench.secret, plan)])
    else:
        drawn = await bench.judging.run(_drawn, bench.secret, plan)
    await bench.sets.append(stored(slot.id, 0, drawn, None))


def _drawn(secret: bytes, plan: Plan) -> Drawn:
    (seat,) = plan.seats
    return dealing.card(seat, dealing.draw(secret, plan, seat))
