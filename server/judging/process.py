"""Judging in a process of its own, which is started again when it ends: the server answers meanwhile."""

from __future__ import annotations

import asyncio
import atexit
import logging
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.context import SpawnProcess
from socket import socketpair
from typing import Any

from exercises import grading
from exercises.exercise import Grade, Submission
from server.judging.judge import LENGTH, judge, opened, sealed
from server.judging.judging import JudgingEnded, P, T, graded
from server.judging.thread import JudgingThread
from server.web import logs

LONGEST = 30.0  # s for one task; a judge that takes longer is ended
TRIES = 2  # judges that may end over one task
notes = logging.getLogger("grubler")


@dataclass(slots=True)
class Task:
    """What a judge is told, the promise made for it, and how many judges have ended over it."""

    told: bytes
    promise: asyncio.Future[bytes]
    ended: int = 0


class JudgingProcess(JudgingThread):
    """The judging of one server in the order of arrival, apart from the thread that serves.

    A task over which a judge ends is told to a second one; what waits behind it is told to the next. The judge ends
    with the server, whatever ends that.
    """

    def __init__(self, processes: int | None = None, *, log: str = "text", longest: float = LONGEST) -> None:
        super().__init__(processes)
        self._log, self.longest = log, longest
        self._tasks: deque[Task] = deque()
        self._line: asyncio.WriteTransport | None = None
        self._judge: SpawnProcess | None = None
        self._opening: asyncio.Task[None] | None = None
        self._limit: asyncio.TimerHandle | None = None
        atexit.register(self._end_judge)  # a server that is interrupted twice closes nothing

    def begin(self) -> None:
        """Start the judge before there is anything to judge."""
        if self._line is None and self._opening is None:
            self._opening = asyncio.create_task(self._open())

    async def run(self, compute: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """Compute something of the exercise room.

        Raises:
            JudgingEnded: Two judges have ended over it.
        """
        task = Task(sealed((logs.REQUEST.get(), compute, args, kwargs)), asyncio.get_running_loop().create_future())
        self._tell(task)
        made, raised, place = opened(await task.promise)
        if raised is not None:
            raise raised from logs.Elsewhere(place)
        found: T = made
        return found

    async def grade(self, submission: Submission, secret: bytes, **rules: Any) -> Grade:
        """Grade a submission; a failure of ours is a grade too, and the attempt is returned."""
        try:
            return await self.run(graded, submission, secret, **rules)
        except JudgingEnded:
            return grading.failed(submission)

    def close(self) -> None:
        """End the judge, whatever it computes."""
        while self._tasks:
            self._tasks.popleft().promise.cancel()
        self._watch()
        if self._opening is not None:
            self._opening.cancel()
        if self._line is not None:
            self._line.abort()
        self._end_judge()
        atexit.unregister(self._end_judge)
        super().close()

    def _tell(self, task: Task) -> None:
        self._tasks.append(task)
        if len(self._tasks) == 1:
            self._watch()
        if self._line is not None:
            self._line.write(task.told)
        else:
            self.begin()

    async def _open(self) -> None:
        """Start a judge and tell it all that waits."""
        try:
            self._line = await self._started()
        except Exception:  # whatever it is, nobody is left waiting
            notes.exception("no judge can be started")
            while self._tasks:
                self._give_up()
        else:
            for task in self._tasks:
                self._line.write(task.told)
        finally:
            self._opening = None

    async def _started(self) -> asyncio.WriteTransport:
        here, there = socketpair()
        with there:
            made = get_context("spawn").Process(target=judge, args=(there, self._log), daemon=True)
            try:
                made.start()
            except BaseException:
                here.close()
                raise
        self._judge = made
        line, _ = await asyncio.get_running_loop().create_connection(lambda: Line(self), sock=here)
        return line

    def answered(self, told: bytes) -> None:
        """Keep the promise of the task that the judge was at."""
        promise = self._tasks.popleft().promise
        if not promise.done():  # else nobody waits any more
            promise.set_result(told)
        self._watch()

    def ended(self) -> None:
        """Let another judge go on where one has ended."""
        self._line = None
        self._end_judge()
        if not self._tasks:
            return
        head = self._tasks[0]
        head.ended += 1
        notes.error("a judge has ended over a task, time %d of %d", head.ended, TRIES)
        if head.ended == TRIES:
            self._give_up()
        if self._tasks:
            self.begin()
        self._watch()

    def _give_up(self) -> None:
        promise = self._tasks.popleft().promise
        if not promise.done():
            promise.set_exception(JudgingEnded())

    def _watch(self) -> None:
        """Begin the time of the task that the judge is at."""
        if self._limit is not None:
            self._limit.cancel()
        self._limit = asyncio.get_running_loop().call_later(self.longest, self._end_judge) if self._tasks else None

    def _end_judge(self) -> None:
        if self._judge is not None:
            self._judge.kill()
            self._judge.join()
            self._judge = None


class Line(asyncio.Protocol):
    """The server's end of the line to one judge."""

    def __init__(self, judging: JudgingProcess) -> None:
        self._judging = judging
        self._come = bytearray()

    def data_received(self, data: bytes) -> None:
        """Hand over the answers that have come whole."""
        self._come += data
        while len(self._come) >= LENGTH.size:
            end = LENGTH.size + LENGTH.unpack_from(self._come)[0]
            if len(self._come) < end:
                return
            told = bytes(self._come[LENGTH.size : end])
            del self._come[:end]
            self._judging.answered(told)

    def connection_lost(self, exc: Exception | None) -> None:
        """Note that the judge has ended."""
        self._judging.ended()
