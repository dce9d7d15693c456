"""A class made by hand: people, a course, a set with a deck; written straight into the tables."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from typing import Any

from sqlalchemy import insert, update

from server.database import deck, decks
from server.database.engine import engine
from server.storage.jobs import Job
from server.storage.sets import Card, Slot, TaskSet
from server.tables import courses, memberships, owners, persons, task_sets
from server.web import ids

NOW = datetime(2026, 12, 1, 12, tzinfo=UTC)
COURSE = "CCCC-CCCC-CCCC"
SET = "SSSS-SSSS-SSSS"


def person(number: str, role: str = "student") -> dict[str, Any]:
    return {"id": number, "login": number, "name": number.title(), "role": role, "active": True, "created": NOW}


def enrol(url: str, students: Sequence[str], lecturer: str = "lecturer") -> None:
    """Write a course with a lecturer and students."""
    everybody = [(lecturer, "lecturer"), *((one, "student") for one in students)]
    store = engine(url, connections=1)
    with store.begin() as connection:
        connection.execute(insert(owners), [{"id": one, "anonymous": False, "created": NOW} for one, _ in everybody])
        connection.execute(insert(persons), [person(one, role) for one, role in everybody])
        course = {"id": COURSE, "title": "Machines", "language": "pl", "time_zone": "Europe/Warsaw"}
        connection.execute(insert(courses), course | {"archived": False, "created": NOW})
        rows = [{"course": COURSE, "person": one, "role": role, "joined": NOW} for one, role in everybody]
        connection.execute(insert(memberships), rows)
    store.dispose()


def publish(url: str, task_set: TaskSet, cards: Sequence[Card], now: datetime = NOW) -> None:
    """Publish a draft as the batches of its job do, with cards that nobody drew."""
    payload = {"actor": "lecturer"}
    job = Job(ids.new(), "publish", task_set.id, task_set.course, payload, "running", 1, 1, None, None, None, now, None)
    store = engine(url, connections=1, begin="BEGIN IMMEDIATE")
    try:
        with store.begin() as connection:
            decks.begin(connection, task_set.id, task_set.revision)
            deck.add(connection, cards)
            decks.finish(connection, job)
            here = update(task_sets).where(task_sets.c.id == task_set.id)
            connection.execute(here.values(published=now))
    finally:
        store.dispose()


def draft(number: str = SET, slots: int = 2) -> TaskSet:
    due = NOW + timedelta(days=7)
    made = tuple(slot(number, n) for n in range(1, slots + 1))
    return TaskSet(number, COURSE, "Set 4", {}, "draft", NOW, due, None, None, 1, NOW, made)


def slot(task_set: str, number: int = 1) -> Slot:
    return Slot(f"{task_set}-{number}", task_set, number, ("slider_crank",), 10.0, 1, {"l1": (0.04, 0.12)})


def card(of: Slot, number: int, person: str | None = None) -> Card:
    code = f"{of.id[-8:]}-{number}"
    return Card(
        id=f"{of.id}-{number}", slot=of.id, number=number, code=code, exercise="slider_crank", version=1, seed=number,
        givens={"l1": 0.05}, shown={"pl": {"title": f"{number}", "answers": {"l3": {"weight": 2.0}}}},
        reference={"values": {}}, person=person, turn=1, variant=None, dealt=None, weights={"l3": 2.0},
    )  # fmt: skip
