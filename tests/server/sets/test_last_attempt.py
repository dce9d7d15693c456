"""Two servers race for the last attempt of a student who was dealt a second card: they wait for one another.

On one card the second post waits for the row of the variant anyway; only the lock on all cards of the slot lets it wait
where the posts are to different cards. SQLite has one writer, so this is tried on PostgreSQL alone.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import pytest
from sqlalchemy import Engine, text

from server.database import Database, attempts
from server.database.engine import engine
from server.settings import Settings
from server.storage.sets import Card, NoAttemptLeft
from tests.server.sets.classroom import NOW, card, draft, enrol, publish
from tests.server.sets.test_store import marked
from tests.server.stores import Postgres

HERE = "SELECT count(*) FROM pg_stat_activity WHERE datname = current_database()"
WAITING = text(f"{HERE} AND wait_event_type = 'Lock'")
PATIENCE = 60.0  # s


@dataclass
class Race:
    """The store, and the two cards that share the last attempt of a student."""

    store: Engine
    old: Card
    new: Card

    def hand_in(self, to: Card, receipt: str) -> Any:
        """Hand in as a server of its own."""
        with self.store.begin() as connection:
            return attempts.keep(connection, marked(to, receipt), 1)

    def waits(self) -> bool:
        """Whether a session waits for a lock."""
        with self.store.connect() as connection:
            return bool(connection.execute(WAITING).scalar_one())


@pytest.fixture
def race(postgres: Postgres) -> Iterator[Race]:
    address = postgres.lend()
    url = Settings(database_url=address).store_url
    enrol(url, ["anna"])
    database, new = Database(url), draft(slots=1)
    (slot,) = new.slots
    asyncio.run(database.sets.add(new))
    publish(url, new, [card(slot, 1, "anna"), card(slot, 2)])
    cards = [
        asyncio.run(deal(slot, "anna", f"V {n}", NOW))
        for n, deal in enumerate((database.sets.open, database.sets.replace))
    ]
    assert cards[0] and cards[1]
    store = engine(url, connections=3)
    yield Race(store, cards[0], cards[1])
    store.dispose()
    database.close()
    postgres.take_back(address)


def settled(race: Race, second: Future[Any]) -> None:
    """Wait until the second post has ended, or waits for the first."""
    until = time.monotonic() + PATIENCE
    while not second.done() and not race.waits():
        assert time.monotonic() < until, "the second post neither ends nor waits"
        time.sleep(0.01)


def test_a_post_to_another_card_waits_for_the_one_that_takes_the_last_attempt(race: Race) -> None:
    with ThreadPoolExecutor(1) as pool:
        with race.store.begin() as first:
            attempts.keep(first, marked(race.old, "R 1"), 1)
            second = pool.submit(race.hand_in, race.new, "R 2")
            settled(race, second)
            assert not second.done()
        with pytest.raises(NoAttemptLeft):
            second.result(PATIENCE)


def test_a_post_to_another_card_gets_the_last_attempt_if_the_first_gives_up(race: Race) -> None:
    with ThreadPoolExecutor(1) as pool:
        with race.store.connect() as first:
            attempts.keep(first, marked(race.old, "R 1"), 1)
            second = pool.submit(race.hand_in, race.new, "R 2")
            settled(race, second)
            first.rollback()
        kept, replayed = second.result(PATIENCE)
    assert (kept.handed.receipt, kept.counted, replayed) == ("R 2", True, False)
