"""Handing batches to Procrastinate, in the transaction that needs them. Imported on PostgreSQL only."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from procrastinate import App, SyncPsycopgConnector
from sqlalchemy import Connection

TASK, QUEUE = "batch", "grubler"

_app = App(connector=SyncPsycopgConnector())  # never opened: it only writes through connections of ours


def defer(connection: Connection, job: str, numbers: Iterable[int], size: int) -> None:
    """Put batches into the queue; they are there once the transaction is committed.

    Args:
        connection: The transaction.
        job: Number of the job.
        numbers: Numbers of its batches.
        size: How many batches the job has; shorter jobs go first.
    """
    tasks = [dict[str, Any](job=job, number=number) for number in numbers]
    if tasks:
        driver = connection.connection.driver_connection
        _app.configure_task(TASK, queue=QUEUE, priority=-size, connection=driver).batch_defer(*tasks)
