"""Group commit: promises are kept after COMMIT only, and a failing piece fails alone."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future, wait
from functools import partial
from pathlib import Path
from threading import Event

import pytest
from sqlalchemy import Connection, Engine, text

from server.database import writer as writing
from server.database.engine import engine
from server.database.writer import LARGEST_GROUP, Writer
from server.settings import Settings
from server.storage import StorageUnavailable


@pytest.fixture
def database(tmp_path: Path) -> Iterator[Engine]:
    made = engine(Settings(tmp_path).store_url, connections=2, begin="BEGIN IMMEDIATE")
    with made.begin() as connection:
        connection.execute(text("CREATE TABLE numbers (value INTEGER PRIMARY KEY)"))
    yield made
    made.dispose()


@pytest.fixture
def writer(database: Engine) -> Iterator[Writer]:
    made = Writer(database)
    yield made
    made.close()


def insert(connection: Connection, value: int) -> int:
    connection.execute(text("INSERT INTO numbers VALUES (:value)"), {"value": value})
    return value


def stored(database: Engine) -> set[int]:
    with database.connect() as connection:
        return set(connection.execute(text("SELECT value FROM numbers")).scalars())


def test_a_kept_promise_is_on_disk(database: Engine, writer: Writer) -> None:
    assert writer.write(lambda connection: insert(connection, 7)).result(5) == 7
    assert stored(database) == {7}


def test_a_failing_piece_is_rolled_back_alone(database: Engine, writer: Writer) -> None:
    held = Event()
    writer.write(lambda connection: held.wait(5))
    promises = [writer.write(partial(_half, value=value)) for value in range(10)]
    held.set()
    wait(promises, 5)
    assert [promise.exception() is None for promise in promises] == [value != 4 for value in range(10)]
    assert stored(database) == set(range(10)) - {4}


def _half(connection: Connection, value: int) -> None:
    insert(connection, value)
    if value == 4:
        raise ValueError(value)


def test_what_gathers_is_written_in_few_transactions(database: Engine, writer: Writer) -> None:
    held, begun = Event(), []
    writer.write(lambda connection: held.wait(5))
    count = 2 * LARGEST_GROUP + 10

    def note(connection: Connection, value: int) -> None:
        begun.append(connection)
        insert(connection, value)

    promises = [writer.write(partial(note, value=value)) for value in range(count)]
    held.set()
    wait(promises, 20)
    assert len(set(map(id, begun))) <= 4
    assert len(stored(database)) == count


def test_a_transaction_that_cannot_commit_breaks_every_promise(database: Engine, writer: Writer) -> None:
    with database.begin() as connection:
        connection.execute(text("DROP TABLE numbers"))
        connection.execute(text("CREATE TABLE owner (id INTEGER PRIMARY KEY)"))
        connection.execute(
            text("CREATE TABLE numbers (value INTEGER REFERENCES owner (id) DEFERRABLE INITIALLY DEFERRED)")
        )
    promises = [writer.write(partial(insert, value=value)) for value in range(3)]
    wait(promises, 5)
    broken = [promise.exception() for promise in promises]
    assert all(isinstance(error, StorageUnavailable) for error in broken)
    assert stored(database) == set()


def test_closing_writes_what_is_queued_and_takes_no_more(database: Engine) -> None:
    writer = Writer(database)
    held = Event()
    writer.write(lambda connection: held.wait(5))
    promise = writer.write(lambda connection: insert(connection, 1))
    held.set()
    writer.close()
    assert promise.result(0) == 1
    with pytest.raises(StorageUnavailable):
        writer.write(lambda connection: insert(connection, 2))


def test_too_much_waiting_is_refused(database: Engine, writer: Writer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writing, "LONGEST_QUEUE", 2)
    held = Event()
    accepted: list[Future[bool]] = []
    with pytest.raises(StorageUnavailable):
        while True:
            accepted.append(writer.write(lambda connection: held.wait(5)))
    held.set()
    wait(accepted, 5)
    assert len(accepted) >= 2


def test_a_cancelled_piece_is_not_written(database: Engine, writer: Writer) -> None:
    held = Event()
    writer.write(lambda connection: held.wait(5))
    cancelled = writer.write(lambda connection: insert(connection, 1))
    last = writer.write(lambda connection: insert(connection, 2))
    assert cancelled.cancel()
    held.set()
    last.result(5)
    assert stored(database) == {2}
