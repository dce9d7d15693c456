"""Publishing a set: every slot is drawn and checked, then deck and state are stored together."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime

from server import ids
from server.bench import Bench
from server.sets import dealing
from server.sets.dealing import Drawn, Plan, Trouble
from server.storage.audit import Action, Entry
from server.storage.sets import PUBLISHED, Card, Slot, TaskSet

CODE = 9  # signs of a code, such as 7F3K-2M0Q


class Troubled(ValueError):
    """The set cannot be published; `troubles` say why, slot by slot."""

    def __init__(self, troubles: Sequence[Trouble]) -> None:
        super().__init__(troubles)
        self.troubles = tuple(troubles)


async def publish(bench: Bench, task_set: TaskSet, actor: str) -> TaskSet:
    """Deal the deck of a draft and publish it.

    Raises:
        Troubled: Some slot cannot be published.
        NotADraft: It is published already, or has changed meanwhile.
    """
    cards, troubles = await dealt(bench, task_set)
    if troubles:
        raise Troubled(troubles)
    now = datetime.now(UTC)
    entry = Entry(actor, Action.SET_PUBLISHED, task_set.id, task_set.course, {"cards": len(cards)})
    await bench.sets.publish(task_set.id, task_set.revision, cards, now, entry)
    return replace(task_set, state=PUBLISHED, published=now)


async def dealt(bench: Bench, task_set: TaskSet) -> tuple[list[Card], list[Trouble]]:
    """Draw the deck of a draft without storing it; gives the cards, and what stands against publishing."""
    roster = await bench.sets.students(task_set.course)
    plans = planned(task_set, dealing.seats(roster))
    if not plans:
        return [], [Trouble(0, "empty")]
    prepared = await bench.judging.apart(dealing.prepare, [(bench.secret, plan) for plan in plans])
    members = set(roster)
    cards = [
        stored(plan.slot, number, one, one.seat if one.seat in members else None)
        for plan, (drawn, _) in zip(plans, prepared, strict=True)
        for number, one in enumerate(drawn, 1)
    ]
    return cards, [trouble for _, trouble in prepared if trouble]


def planned(task_set: TaskSet, seats: tuple[str, ...]) -> list[Plan]:
    """Plan the slots of a set; slots of one pool take turns in it."""
    places: Counter[frozenset[str]] = Counter()
    plans = []
    for slot in task_set.slots:
        pool = frozenset(slot.pool)
        plans.append(_plan(task_set, slot, seats, places[pool]))
        places[pool] += 1
    return plans


def _plan(task_set: TaskSet, slot: Slot, seats: tuple[str, ...], place: int) -> Plan:
    return Plan(slot.id, slot.number, slot.pool, slot.limits, seats, task_set.id, place)


def stored(slot: str, number: int, drawn: Drawn, person: str | None) -> Card:
    """Make the card of a slot from what was drawn."""
    return Card(
        id=ids.new(), slot=slot, number=number, code=ids.new()[:CODE], exercise=drawn.exercise, version=drawn.version,
        seed=drawn.seed, givens=drawn.givens, shown=drawn.shown, reference=drawn.reference, person=person, turn=1,
        variant=None, dealt=None,
    )  # fmt: skip


async def one_more(bench: Bench, task_set: TaskSet, slot: Slot) -> None:
    """Draw one more spare card where a deck has run out."""
    plans = planned(task_set, (f"added {ids.new()}",))
    plan = next(plan for plan in plans if plan.slot == slot.id)
    drawn = await bench.judging.run(_drawn, bench.secret, plan)
    await bench.sets.append(stored(slot.id, 0, drawn, None))


def _drawn(secret: bytes, plan: Plan) -> Drawn:
    (seat,) = plan.seats
    return dealing.card(seat, dealing.draw(secret, plan, seat))
