"""A trial of writing: as much as a long submission takes, then gone again."""

from __future__ import annotations

from sqlalchemy import Connection, delete, insert

from server.tables import settings

NAME, ROWS = "room for writing", 128
VALUE = "x" * 256  # so that ROWS of them take 32 kB


def fill(connection: Connection) -> None:
    """Write rows that mean nothing, in place of those that a trial left which did not end."""
    clear(connection)
    connection.execute(insert(settings), [{"name": f"{NAME} {number}", "value": VALUE} for number in range(ROWS)])


def clear(connection: Connection) -> None:
    """Take the rows of a trial away."""
    connection.execute(delete(settings).where(settings.c.name.startswith(NAME)))
