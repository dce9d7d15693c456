"""The connections to a store: one that writes, some that read."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from typing import TypeVar

from sqlalchemy import Connection
from sqlalchemy.exc import IntegrityError, SQLAlchemyError

from server.database import trial
from server.database.engine import READERS, engine
from server.database.writer import Writer
from server.storage import StorageUnavailable

T = TypeVar("T")


class Connections:
    """The writer and the readers of one store; each has connections of its own."""

    def __init__(self, url: str) -> None:
        self._writing = engine(url, connections=1, begin="BEGIN IMMEDIATE")
        self._reading = engine(url, connections=READERS)
        self._writer = Writer(self._writing)
        self._proved = -1  # failures that a trial has answered; a store that was just opened has not been tried
        self._readers = ThreadPoolExecutor(READERS, "reader")

    async def write(self, write: Callable[[Connection], T]) -> T:
        """Write a piece, which may run twice; it is on disk when this returns.

        Raises:
            StorageUnavailable: Nothing was written.
        """
        return await asyncio.wrap_future(self._writer.write(write))

    async def prove(self) -> None:
        """Try to write, once after each failure, so that a store that takes its writes is not worn by being asked.

        Raises:
            StorageUnavailable: The store does not take a write: it is full, or only reads.
        """
        failures = self._writer.failures
        if failures == self._proved:
            return
        with suppress(IntegrityError):  # another server tries at this moment, and has written the same
            await self.write(trial.fill)
        await self.write(trial.clear)
        self._proved = failures

    def failures(self) -> int:
        """Tell how many pieces the store could not write since it was opened."""
        return self._writer.failures

    async def read(self, read: Callable[[Connection], T]) -> T:
        """Read something.

        Raises:
            StorageUnavailable: The store does not answer.
        """
        return await asyncio.get_running_loop().run_in_executor(self._readers, self._answer, read)

    def close(self) -> None:
        """Finish what is under way and let go of the files."""
        self._writer.close()
        self._readers.shutdown()
        self._writing.dispose()
        self._reading.dispose()

    def _answer(self, read: Callable[[Connection], T]) -> T:
        try:
            with self._reading.connect() as connection:
                return read(connection)
        except SQLAlchemyError as error:
            raise StorageUnavailable(str(error)) from error
