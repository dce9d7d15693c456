"""Judging on one thread of this process: ball precision belongs to the process, so several would mix it up."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextvars import copy_context
from functools import partial
from typing import Any

from exercises.exercise import Grade, Submission
from server.judging.apart import Processes
from server.judging.judging import P, T, graded


class JudgingThread:
    """The judging of one server, in the order of arrival; `processes` compute apart."""

    def __init__(self, processes: int | None = None) -> None:
        self._thread = ThreadPoolExecutor(1, "judge")
        self._apart = Processes(processes or os.cpu_count() or 1)

    def begin(self) -> None:
        """Get ready: a thread always is."""

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
