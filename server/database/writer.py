"""Group commit: one thread writes, one transaction for all that has gathered while the last one went to disk."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from threading import Thread
from typing import Any, Generic, TypeAlias, TypeVar

from sqlalchemy import Connection, Engine
from sqlalchemy.exc import DBAPIError, InternalError, OperationalError, SQLAlchemyError

from server.storage import StorageUnavailable

T = TypeVar("T")
Result: TypeAlias = tuple[Any, Exception | None]
LARGEST_GROUP = 256  # pieces of work in one transaction
LONGEST_QUEUE = 4096  # pieces waiting; beyond it a client is asked to come back
NOT_NOW = (OperationalError, InternalError)  # full, cut off, locked; a PostgreSQL that only reads


@dataclass(frozen=True, slots=True)
class Work(Generic[T]):
    """A piece of writing and the promise made for it."""

    write: Callable[[Connection], T]
    promise: Future[T]


class Writer:
    """The one writer of a store.

    A promise is kept only after COMMIT. A group in which a piece fails is rolled back and written again with a
    savepoint for each piece, so that the piece fails alone; a piece may therefore run twice. When the transaction
    itself fails, every promise of the group is broken with `StorageUnavailable`.

    Attributes:
        failures: How many pieces the store could not write.
    """

    def __init__(self, engine: Engine) -> None:
        self.failures = 0
        self._engine = engine
        self._queue: SimpleQueue[Work[Any] | None] = SimpleQueue()
        self._open = True
        self._thread = Thread(target=self._run, name="writer", daemon=True)
        self._thread.start()

    def write(self, write: Callable[[Connection], T]) -> Future[T]:
        """Queue a piece of writing.

        Raises:
            StorageUnavailable: Too much is waiting, or the writer is closed.
        """
        if not self._open or self._queue.qsize() >= LONGEST_QUEUE:
            raise StorageUnavailable("the writer is closed or overloaded")
        promise: Future[T] = Future()
        self._queue.put(Work(write, promise))
        return promise

    def close(self) -> None:
        """Write what is queued, then end the thread."""
        self._open = False
        self._queue.put(None)
        self._thread.join()

    def _run(self) -> None:
        while group := self._gathered():
            self._commit([work for work in group if work.promise.set_running_or_notify_cancel()])

    def _gathered(self) -> list[Work[Any]]:
        group: list[Work[Any]] = []
        work = self._queue.get()
        while work is not None:
            group.append(work)
            if len(group) == LARGEST_GROUP:
                return group
            try:
                work = self._queue.get_nowait()
            except Empty:
                return group
        if group:
            self._queue.put(None)  # the end was met behind work: meet it again after the work is done
        return group

    def _commit(self, group: list[Work[Any]]) -> None:
        try:
            results = self._together(group) or self._apart(group)
        except SQLAlchemyError as error:
            self.failures += len(group)
            for work in group:
                work.promise.set_exception(StorageUnavailable(str(error)))
            return
        self.failures += sum(isinstance(failure, StorageUnavailable) for _, failure in results)
        for work, (value, failure) in zip(group, results, strict=True):
            if failure is None:
                work.promise.set_result(value)
            else:
                work.promise.set_exception(failure)

    def _together(self, group: list[Work[Any]]) -> list[Result] | None:
        """Write a group without savepoints; None, and nothing written, if a piece fails.

        A connection that is lost breaks all promises: nobody knows whether a COMMIT under way was done, so a client
        asks again with its key.
        """
        try:
            with self._engine.begin() as connection:
                return [(work.write(connection), None) for work in group]
        except DBAPIError as error:
            if error.connection_invalidated:
                raise
            return None
        except Exception:  # which piece it was, and why, is found out one by one
            return None

    def _apart(self, group: list[Work[Any]]) -> list[Result]:
        with self._engine.begin() as connection:
            return [_attempt(connection, work.write) for work in group]


def _attempt(connection: Connection, write: Callable[[Connection], Any]) -> Result:
    savepoint = connection.begin_nested()
    try:
        value = write(connection)
    except DBAPIError as failure:
        savepoint.rollback()
        return None, StorageUnavailable(str(failure)) if isinstance(failure, NOT_NOW) else failure
    except Exception as failure:  # handed on to the one who asked; the others' writing stands
        savepoint.rollback()
        return None, failure
    savepoint.commit()
    return value, None
