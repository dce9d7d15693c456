"""A gradebook is read without what the cards show, which for a large class is hundreds of megabytes."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from sqlalchemy import Connection, Engine, event

from server.database import Database
from server.database.engine import engine
from server.settings import Settings
from tests.server.stores import lay

Asked = list[tuple[str, Any]]


@pytest.fixture
def asked(tmp_path: Path) -> Iterator[Asked]:
    """The statements sent to the database of this test, with their values; a server beside it asks its own."""
    found: Asked = []

    def note(connection: Connection, _: Any, statement: str, values: Any, *__: Any) -> None:
        if str(tmp_path) in str(connection.engine.url):
            found.append((statement, values))

    event.listen(Engine, "before_cursor_execute", note)
    yield found
    event.remove(Engine, "before_cursor_execute", note)


@pytest.mark.parametrize("read", ["of", "lines", "dealt", "weights"])
def test_the_embedded_store_finds_the_cards_of_a_gradebook_in_their_index(
    read: str, asked: Asked, tmp_path: Path
) -> None:
    database = Database(lay(Settings(tmp_path)))
    asyncio.run(getattr(database.marks, read)("a set"))
    database.close()
    plan = [step for one in list(asked) if "slots.task_set" in one[0] for step in plan_of(tmp_path, *one)]
    searched = [step for step in plan if step.startswith(("SEARCH deck ", "SCAN deck"))]
    assert searched and all("COVERING INDEX ix_deck_dealt" in step for step in searched)


def plan_of(folder: Path, statement: str, values: Any) -> list[str]:
    """How the embedded store answers a statement, table by table."""
    store = engine(Settings(folder).store_url, connections=1)
    with store.connect() as connection:
        rows = connection.exec_driver_sql(f"EXPLAIN QUERY PLAN {statement}", values).all()
    store.dispose()
    return [str(row[-1]) for row in rows]
