"""The store keeps what it has acknowledged, on SQLite and on PostgreSQL alike."""

from __future__ import annotations

import asyncio
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from sqlalchemy import text, update
from sqlalchemy.exc import DBAPIError

from server.database import Database, secret_of
from server.database.engine import engine
from server.database.practice import Practice
from server.settings import Settings
from server.storage import Dealt, Handed, KeyReused, Marked, Owner, StorageUnavailable, UnknownVariant
from server.tables import submissions

NOW = datetime(2026, 11, 22, 10, 31, 7, 123456, UTC)
OWNER = Owner("o" * 64, anonymous=True)
VARIANT = Dealt("AAAA-AAAA-AAAA", OWNER, "slider_crank", 4, 2**53 - 1, {"l1": 0.1}, NOW, NOW)


def marked(receipt: str, key: str | None = None, body: str = "b", counted: bool = True, time: datetime = NOW) -> Marked:
    answers: dict[str, str | list[str]] = {"l3": "1,25 m\x00", "T": ["[1; 0]", "[0; 1]"]}
    handed = Handed(receipt, VARIANT.id, OWNER.id, answers, time, key, body, "d", "pl")
    return Marked(handed, {"score": 0.5}, counted, "1")


def keep(store: Practice, one: Marked) -> tuple[Marked, bool]:
    return asyncio.run(store.keep_submission(one))


@pytest.fixture
def kept(database: Database) -> Practice:
    asyncio.run(database.practice.keep_variant(VARIANT))
    return database.practice


def test_a_variant_comes_back_as_it_was_stored(kept: Practice) -> None:
    assert asyncio.run(kept.variant(VARIANT.id)) == VARIANT
    assert asyncio.run(kept.variant("BBBB-BBBB-BBBB")) is None


def test_two_variants_have_one_owner(kept: Practice) -> None:
    other = replace(VARIANT, id="BBBB-BBBB-BBBB")
    asyncio.run(kept.keep_variant(other))
    assert asyncio.run(kept.variant(other.id)) == other


def test_a_submission_comes_back_with_its_raw_text(kept: Practice) -> None:
    one = marked("R1")
    assert keep(kept, one) == (one, False)
    assert asyncio.run(kept.submission("R1")) == one
    assert asyncio.run(kept.submission("R2")) is None


def test_the_last_submission_is_the_newest(kept: Practice) -> None:
    assert asyncio.run(kept.latest(VARIANT.id)) is None
    keep(kept, marked("R2", time=NOW + timedelta(seconds=2)))
    keep(kept, marked("R1", time=NOW + timedelta(seconds=1)))
    last = asyncio.run(kept.latest(VARIANT.id))
    assert last is not None and last.handed.receipt == "R2"


def test_only_a_submission_that_counted_counts(kept: Practice) -> None:
    keep(kept, marked("R1", counted=False))
    assert not asyncio.run(kept.counted(VARIANT.id))
    keep(kept, marked("R2", counted=True))
    assert asyncio.run(kept.counted(VARIANT.id))


def test_the_same_key_gives_the_first_submission_back(kept: Practice) -> None:
    first = marked("R1", key="k")
    keep(kept, first)
    assert keep(kept, marked("R2", key="k")) == (first, True)
    assert asyncio.run(kept.submission("R2")) is None


def test_the_same_key_with_another_body_is_refused(kept: Practice) -> None:
    keep(kept, marked("R1", key="k"))
    with pytest.raises(KeyReused):
        keep(kept, marked("R2", key="k", body="other"))


def test_without_a_key_every_submission_is_a_new_one(kept: Practice) -> None:
    assert [keep(kept, marked(f"R{i}"))[1] for i in range(3)] == [False] * 3


def test_twenty_at_once_with_one_key_leave_one_submission(kept: Practice) -> None:
    async def all_at_once() -> list[tuple[Marked, bool]]:
        return await asyncio.gather(*(kept.keep_submission(marked(f"R{i}", key="k")) for i in range(20)))

    results = asyncio.run(all_at_once())
    assert len({one.handed.receipt for one, _ in results}) == 1
    assert [replayed for _, replayed in results].count(False) == 1


def test_two_servers_on_one_store_leave_one_submission_for_one_key(store_url: str, kept: Practice) -> None:
    other = Database(store_url)

    async def both() -> list[tuple[Marked, bool]]:
        pairs = ((kept, f"R{i}") for i in range(10)), ((other.practice, f"S{i}") for i in range(10))
        return await asyncio.gather(*(db.keep_submission(marked(r, key="k")) for side in pairs for db, r in side))

    results = asyncio.run(both())
    other.close()
    assert len({one.handed.receipt for one, _ in results}) == 1


def test_a_submission_never_changes(store_url: str, kept: Practice) -> None:
    keep(kept, marked("R1"))
    direct = engine(store_url, connections=1)
    with pytest.raises(DBAPIError, match="never changes"), direct.begin() as connection:
        connection.execute(update(submissions).values(answers={}))
    direct.dispose()


def test_a_submission_to_a_variant_that_has_gone_is_refused(database: Database) -> None:
    with pytest.raises(UnknownVariant):
        keep(database.practice, marked("R1"))


def test_idle_practice_is_forgotten_and_a_named_owner_s_is_not(kept: Practice) -> None:
    named = replace(VARIANT, id="BBBB-BBBB-BBBB", owner=Owner("n" * 64, anonymous=False))
    asyncio.run(kept.keep_variant(named))
    keep(kept, marked("R1"))
    assert asyncio.run(kept.purge(NOW)) == 0
    assert asyncio.run(kept.purge(NOW + timedelta(days=30))) == 1
    assert asyncio.run(kept.variant(VARIANT.id)) is None
    assert asyncio.run(kept.submission("R1")) is None
    assert asyncio.run(kept.variant(named.id)) == named


def test_a_variant_that_is_used_stays(kept: Practice) -> None:
    asyncio.run(kept.touch(VARIANT.id, NOW + timedelta(days=20)))
    assert asyncio.run(kept.purge(NOW + timedelta(days=19))) == 0
    found = asyncio.run(kept.variant(VARIANT.id))
    assert found is not None and found.last_used == NOW + timedelta(days=20)


def test_the_secret_is_made_once_and_stays(store_url: str) -> None:
    first = secret_of(store_url)
    assert len(first) == 32 and secret_of(store_url) == first


def test_a_store_without_tables_is_unavailable(tmp_path: Path) -> None:
    bare = Database(Settings(tmp_path).store_url)
    with pytest.raises(StorageUnavailable):
        asyncio.run(bare.practice.check())
    with pytest.raises(StorageUnavailable):
        asyncio.run(bare.practice.submission("R1"))
    bare.close()


def test_the_embedded_store_writes_through_to_disk(tmp_path: Path) -> None:
    direct = engine(Settings(tmp_path).store_url, connections=1)
    with direct.connect() as connection:
        found = [
            connection.execute(text(f"PRAGMA {name}")).scalar_one()
            for name in ("journal_mode", "synchronous", "foreign_keys")
        ]
    direct.dispose()
    assert found == ["wal", 2, 1]
