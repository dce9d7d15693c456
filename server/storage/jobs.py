"""Jobs, their batches, and what a store of them promises."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any, Protocol, TypeAlias

from sqlalchemy import Connection

Json: TypeAlias = Any
WAITING, RUNNING, DONE, FAILED, CANCELLED = "waiting", "running", "done", "failed", "cancelled"
LIVE = (WAITING, RUNNING)


@dataclass(frozen=True, slots=True)
class Job:
    """Work that is done batch by batch.

    Attributes:
        kind: Name of its kind.
        subject: Number of what it works on; of one kind and subject there is one live job at a time.
        course: Whose lecturers may see it.
        payload: What was ordered.
        done: Batches done, of the `total`.
        result: What came of it, once it has ended.
        error: The fault that ended it.
        person: Who ordered it; none for the command line.
    """

    id: str
    kind: str
    subject: str
    course: str | None
    payload: Mapping[str, Json]
    state: str
    done: int
    total: int
    result: Json
    error: str | None
    person: str | None
    created: datetime
    finished: datetime | None

    @property
    def live(self) -> bool:
        """Whether it has not ended."""
        return self.state in LIVE


@dataclass(frozen=True, slots=True)
class Order:
    """A job to be: what is worked on, for whom, and the pieces of which each is a batch."""

    id: str
    kind: str
    subject: str
    course: str | None
    payload: Mapping[str, Json]
    pieces: Sequence[Json]
    person: str | None
    created: datetime
    parts: int = 1  # of each piece, which are counted while it is worked on


@dataclass(frozen=True, slots=True)
class Batch:
    """A batch in the hands of a worker; `fence` tells this taking from all others."""

    job: str
    kind: str
    number: int
    fence: int
    payload: Mapping[str, Json]
    piece: Json


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a batch is: so many of its parts are done; a refused one is over, and none of them is."""

    piece: Json
    reached: int
    parts: int
    refused: bool


@dataclass(frozen=True, slots=True)
class Kept:
    """What stays of a batch: a few JSON values, and a document where one was made.

    A refused batch is over but has come to nothing: none of its parts counts as done.
    """

    result: Json
    content: bytes | None = None
    refused: bool = False


@dataclass(frozen=True, slots=True)
class Ending:
    """How a job ends when its last batch is done."""

    result: Json
    failed: bool = False


@dataclass(frozen=True, slots=True)
class Kind:
    """What is done in the batches of one kind of job.

    Attributes:
        name: The name that jobs carry.
        read: Gives what a batch works on.
        compute: Does the work of a batch, in a process of its own, with the server's secret; a function of a module.
        write: Writes what came of a batch, in the transaction that marks it done.
        finish: Ends the job, in the transaction of the last batch.
        undo: Takes back what batches have written when the job fails or is cancelled.
        tells: Whether `compute` takes a third argument, to tell how many parts of its batch are done.
    """

    name: str
    read: Callable[[Connection, Batch], Any]
    compute: Callable[..., Any]
    write: Callable[[Connection, Batch, Any], Kept]
    finish: Callable[[Connection, Job], Ending]
    undo: Callable[[Connection, Job], None]
    tells: bool = False


class Fenced(RuntimeError):
    """A batch was given to another worker, or its job has ended: nothing was written."""


class Busy(RuntimeError):
    """A job of this kind is under way on the same subject; the message is its number."""


class Jobs(Protocol):
    """A store of jobs. Whatever a worker writes is refused once its batch is another's."""

    lease: float  # s for which a batch is its worker's, unless it is renewed

    async def start(self, order: Order, record: Callable[[Connection], None] | None = None) -> None:
        """Store a job with its batches, and the record that needs it, together.

        Raises:
            Busy: One of this kind is under way on the same subject.
        """
        ...

    async def plan(self, plan: Callable[[Connection], Sequence[Json]]) -> Sequence[Json]:
        """Read the pieces of a job to be."""
        ...

    async def job(self, number: str) -> Job | None:
        """Give a job."""
        ...

    async def latest(self, kind: str, subject: str) -> Job | None:
        """Give the last job of a kind on a subject."""
        ...

    async def progress(self, number: str) -> Sequence[Progress]:
        """Tell how far each batch of a job is."""
        ...

    async def results(self, number: str, after: int, most: int) -> Sequence[tuple[int, Json]]:
        """List number and result of the batches that are done, behind a number."""
        ...

    async def content(self, number: str, batch: int) -> bytes | None:
        """Give the document that a batch has made."""
        ...

    async def take(self, worker: str) -> Batch | None:
        """Take the next batch that waits or whose worker is gone; shorter jobs go first."""
        ...

    async def take_one(self, worker: str, number: str, batch: int) -> Batch | None:
        """Take a certain batch, unless it is done or in other hands."""
        ...

    async def renew(self, batch: Batch, reached: int = 0) -> bool:
        """Keep a batch for longer, and how many of its parts are done; tells whether it is still this worker's."""
        ...

    async def read(self, kind: Kind, batch: Batch) -> Any:
        """Read what a batch works on."""
        ...

    async def keep(self, kind: Kind, batch: Batch, outcome: Any) -> None:
        """Write what came of a batch and mark it done, together, once.

        Raises:
            Fenced: Nothing was written.
        """
        ...

    async def give_back(self, batch: Batch) -> None:
        """Let others take a batch."""
        ...

    async def fail(self, kind: Kind, batch: Batch, error: str) -> None:
        """Note that a batch failed; it is tried some times, then the job has failed."""
        ...

    async def take_back(self, worker: str | None = None) -> int:
        """Take batches back whose lease is over, or all of a worker that was started anew; gives how many."""
        ...

    async def cancel(self, kind: Kind, number: str) -> bool:
        """End a job; tells whether it was under way."""
        ...

    async def forget(self, before: datetime) -> int:
        """Forget the documents of jobs that ended before a moment; gives how many."""
        ...
