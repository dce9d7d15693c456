"""One thread that deals, judges and words: ball precision belongs to the process, so a pool would mix it up."""

from __future__ import annotations

import asyncio
import logging
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from typing import Any, ParamSpec, Protocol, TypeVar

from exercises import grading
from exercises.exercise import Grade, Submission

P = ParamSpec("P")
T = TypeVar("T")
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
    """The judging of one server, in the order of arrival."""

    def __init__(self) -> None:
        self._thread = ThreadPoolExecutor(1, "judge")

    async def run(self, compute: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """Compute something of the exercise room."""
        return await asyncio.get_running_loop().run_in_executor(self._thread, lambda: compute(*args, **kwargs))

    async def grade(self, submission: Submission, secret: bytes, **rules: Any) -> Grade:
        """Grade a submission; a failure of ours is a grade too, and the attempt is returned."""
        return await self.run(_grade, submission, secret, **rules)

    async def apart(self, compute: Callable[..., T], tasks: Sequence[tuple[Any, ...]]) -> list[T]:
        """Compute long tasks in processes that end with them."""
        if not tasks:
            return []
        workers = min(len(tasks), os.cpu_count() or 1)
        loop = asyncio.get_running_loop()
        with ProcessPoolExecutor(workers, get_context("spawn")) as pool:
            return await asyncio.gather(*(loop.run_in_executor(pool, compute, *task) for task in tasks))

    def close(self) -> None:
        """Finish what is under way."""
        self._thread.shutdown()


def _grade(submission: Submission, secret: bytes, **rules: Any) -> Grade:
    try:
        return grading.grade(submission, secret, **rules)
    except grading.UnknownAnswer:
        raise
    except Exception:  # our fault, whatever it is: the student keeps the receipt and loses nothing
        log.exception("grading %s with seed %d failed", submission.variant.exercise, submission.variant.seed)
        return grading.failed(submission)
