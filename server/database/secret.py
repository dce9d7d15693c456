"""The server's secret, which lives in the store and in its backups."""

from __future__ import annotations

import secrets

from sqlalchemy import select

from server.database.engine import engine
from server.database.once import insert_once
from server.tables import settings

SECRET_BYTES = 32


def secret_of(url: str) -> bytes:
    """Give the server's secret; the first one to ask makes it."""
    store = engine(url, connections=1, begin="BEGIN IMMEDIATE")
    with store.begin() as connection:
        insert_once(connection, settings, {"name": "secret", "value": secrets.token_hex(SECRET_BYTES)})
        value = connection.execute(select(settings.c.value).where(settings.c.name == "secret")).scalar_one()
    store.dispose()
    return bytes.fromhex(value)
