"""One thread that deals, judges and words: ball precision belongs to the process, so a pool would mix it up."""

from __future__ import annotations

import asyncio
import logging
import os
from collections.abc import Callable, Collection, Sequence
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextvars import copy_context
from dataclasses import replace
from functools import partial
from multiprocessing import get_context, parent_process
from threading import Thread
from typing import Any, ParamSpec, Protocol, TypeVar

from exercises import catalogue, grading
from exercises.exercise import Grade, Submission
from graders.verdict import EMPTY, FAULT, KEPT

P = ParamSpec("P")
T = TypeVar("T")
IDLE = 30.0  # s after which processes end that nobody needs
NICE = 10  # students who wait for a verdict go first
log = logging.getLogger("grubler")


class Judging(Protocol):
    """Where exercises are computed."""

    async def run(self, compute: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """Compute something of the exercise room."""
        ...

    async def grade(self, submission: Submission, secret: bytes, **rules: Any) -> Grade:
        """Grade a submission; the rules are those of `grading.grade`."""
        ...

    async def apart(self, compute: Callable[..., T], tasks: Sequence[tuple[Any, ...]]) -> list[T]:
        """Compute long tasks without holding up the judging."""
        ...

    def close(self) -> None:
        """Finish what is under way."""
        ...


class JudgingThread:
    """The judging of one server, in the order of arrival; `processes` compute apart."""

    def __init__(self, processes: int | None = None) -> None:
        self._thread = ThreadPoolExecutor(1, "judge")
        self._apart = Processes(processes or os.cpu_count() or 1)

    async def run(self, compute: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """Compute something of the exercise room."""
        here = copy_context()  # the number of the request goes along, for the log
        work = partial(here.run, compute, *args, **kwargs)
        return await asyncio.get_running_loop().run_in_executor(self._thread, work)

    async def grade(self, submission: Submission, secret: bytes, **rules: Any) -> Grade:
        """Grade a submission; a failure of ours is a grade too, and the attempt is returned."""
        return await self.run(graded, submission, secret, **rules)

    async def apart(self, compute: Callable[..., T], tasks: Sequence[tuple[Any, ...]]) -> list[T]:
        """Compute long tasks in processes that stay for the next ones, and end when none come."""
        if not tasks:
            return []
        pool, loop = self._apart.entered(), asyncio.get_running_loop()
        try:
            return await asyncio.gather(*(loop.run_in_executor(pool, compute, *task) for task in tasks))
        except BrokenProcessPool:
            self._apart.end()  # the next ones get new processes
            raise
        finally:
            self._apart.left(loop)

    def close(self) -> None:
        """Finish what is under way."""
        self._thread.shutdown()
        self._apart.end()


class Processes:
    """Processes that compute apart, below the server in the eyes of the system; they end after some idle time."""

    def __init__(self, number: int) -> None:
        self._number = number
        self._pool: ProcessPoolExecutor | None = None
        self._users = 0
        self._ending: asyncio.TimerHandle | None = None

    def entered(self) -> ProcessPoolExecutor:
        """Give the processes; they stay until the last user has left for a while."""
        self._users += 1
        if self._ending is not None:
            self._ending.cancel()
            self._ending = None
        if self._pool is None:
            self._pool = ProcessPoolExecutor(self._number, get_context("spawn"), _begin)
        return self._pool

    def left(self, loop: asyncio.AbstractEventLoop) -> None:
        """Note that a user has left."""
        self._users -= 1
        if self._users == 0 and self._pool is not None:
            self._ending = loop.call_later(IDLE, self.end)

    def end(self) -> None:
        """End the processes, whatever they compute: a batch that is not done is somebody's again."""
        if self._ending is not None:
            self._ending.cancel()
            self._ending = None
        if self._pool is not None:
            computing = list((self._pool._processes or {}).values())
            self._pool.shutdown(wait=False, cancel_futures=True)
            for process in computing:
                process.terminate()
            self._pool = None


def _begin() -> None:
    """Start a process that computes apart: below the server in the eyes of the system, and ending with it."""
    os.nice(NICE)
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = parent_process()
    assert parent is not None
    parent.join()  # a server that was killed cannot tell
    os._exit(1)


def graded(submission: Submission, secret: bytes, **rules: Any) -> Grade:
    try:
        return grading.grade(submission, secret, **rules)
    except grading.UnknownAnswer:
        raise
    except Exception:  # our fault, whatever it is: the student keeps the receipt and loses nothing
        log.exception("grading %s with seed %d failed", submission.variant.exercise, submission.variant.seed)
        return grading.failed(submission)


def graded_as_asked(submission: Submission, secret: bytes, asked: Collection[str], **rules: Any) -> Grade:
    """Grade answers to a task that was dealt before its exercise changed what it asks for.

    What the exercise no longer asks for has no judge: it is kept for the lecturer.

    Raises:
        UnknownAnswer: An answer that the task does not ask for.
    """
    unknown = sorted(set(submission.answers) - set(asked))
    if unknown:
        raise grading.UnknownAnswer(unknown[0])
    variant = submission.variant
    judged = catalogue.load(variant.exercise).exercise.answers_of(variant.givens)
    known = {name: text for name, text in submission.answers.items() if name in judged}
    grade = graded(replace(submission, answers=known), secret, **rules)
    if grade.verdicts.keys() != judged.keys() or FAULT in grade.verdicts.values():
        return grade
    gone = {name: submission.answers.get(name, "") for name in asked if name not in judged}
    kept = {name: KEPT if text.strip() else EMPTY for name, text in gone.items()}
    return replace(grade, verdicts={**grade.verdicts, **kept}, provisional=grade.provisional or KEPT in kept.values())
