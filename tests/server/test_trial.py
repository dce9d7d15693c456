"""Servers of one store that ask at the same moment whether it takes writes do not stand in each other's way."""

from __future__ import annotations

import asyncio

from sqlalchemy import func, select

from server.database import Database
from server.database.connections import Connections
from server.tables import settings

SERVERS = 6


def test_servers_that_start_together_are_all_ready(store_url: str) -> None:
    databases = [Database(store_url) for _ in range(SERVERS)]

    async def asked() -> None:
        await asyncio.gather(*(database.practice.check() for database in databases))

    asyncio.run(asked())
    for database in databases:
        assert database.practice.failures() == 0
        database.close()
    assert left(store_url) == 0


def left(store_url: str) -> int:
    """Count the rows that trials of writing have left."""
    connections = Connections(store_url)
    trials = select(func.count()).where(settings.c.name.startswith("room for writing"))
    found: int = asyncio.run(connections.read(lambda connection: connection.execute(trials).scalar_one()))
    connections.close()
    return found
