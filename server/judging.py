"""One thread that deals, judges and words: ball precision belongs to the process, so a pool would mix it up."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import ParamSpec, Protocol, TypeVar

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

    async def grade(self, submission: Submission, secret: bytes) -> Grade:
        """Grade a submission."""
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

    async def grade(self, submission: Submission, secret: bytes) -> Grade:
        """Grade a submission; a failure of ours is a grade too, and the attempt is returned."""
        return await self.run(_grade, submission, secret)

    def close(self) -> None:
        """Finish what is under way."""
        self._thread.shutdown()


def _grade(submission: Submission, secret: bytes) -> Grade:
    try:
        return grading.grade(submission, secret)
    except grading.UnknownAnswer:
        raise
    except Exception:  # our fault, whatever it is: the student keeps the receipt and loses nothing
        log.exception("grading %s with seed %d failed", submission.variant.exercise, submission.variant.seed)
        return grading.failed(submission)
