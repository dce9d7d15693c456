"""Between a set and its deck: what is to be dealt in each slot, and the card that is made of what was drawn."""

from __future__ import annotations

from collections import Counter

from server.sets.dealing import Drawn, Plan
from server.storage.sets import Card, Slot, TaskSet, weights_of
from server.web import ids

CODE = 9  # signs of a code, such as 7F3K-2M0Q


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
        variant=None, dealt=None, weights=weights_of(drawn.shown),
    )  # fmt: skip
