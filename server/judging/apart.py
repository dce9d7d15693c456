"""Processes for long tasks, beside the judging."""

from __future__ import annotations

import asyncio
import os
import signal
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context, parent_process
from threading import Thread

IDLE = 30.0  # s after which processes end that nobody needs
NICE = 10  # students who wait for a verdict go first


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
                process.kill()
            self._pool = None


def _begin() -> None:
    """Start a process that computes apart: below the server in the eyes of the system, and ending with it."""
    os.nice(NICE)
    leave_signals()
    end_with_parent()


def leave_signals() -> None:
    """Leave what a terminal or a service manager sends to all processes of a server to the server."""
    for one in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(one, signal.SIG_IGN)


def end_with_parent() -> None:
    """End this process when the one that has started it ends, whatever is computed here."""
    Thread(target=_outlive, daemon=True).start()


def _outlive() -> None:
    parent = parent_process()
    assert parent is not None
    parent.join()  # a server that was killed cannot tell
    os._exit(1)
