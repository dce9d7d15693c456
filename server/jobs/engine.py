"""The engine that looks at the table: in the server of an embedded store, and in commands that wait for their job."""

from __future__ import annotations

import asyncio
import logging
from contextlib import suppress

from server.jobs.working import Bureau, work
from server.storage import StorageUnavailable

LOOK = 1.0  # s between two looks, unless somebody wakes the engine
GRACE = 10.0  # s that a batch may still take when the server ends
log = logging.getLogger("grubler")


class Engine:
    """Takes batches as they come, so many at a time.

    Args:
        bureau: What its workers need.
        name: Of the worker. One that is started anew under a name takes the batches back that were left under it.
        most: Batches at a time.
    """

    def __init__(self, bureau: Bureau, name: str, most: int) -> None:
        self._bureau = bureau
        self._name = name
        self._most = most
        self._woken = asyncio.Event()
        self._working: set[asyncio.Task[None]] = set()

    def wake(self) -> None:
        """Look at once: there is a new job."""
        self._woken.set()

    async def run(self) -> None:
        """Work until cancelled; then batches under way may end, or are given back."""
        try:
            await self._forever()
        finally:
            await self._end()

    async def _forever(self) -> None:
        left = True
        while True:
            try:
                if left:
                    await self._bureau.jobs.take_back(self._name)
                    left = False
                await self._bureau.jobs.take_back()
                await self._fill()
            except StorageUnavailable as error:
                log.warning("jobs wait for the store: %s", error)
            await self._pause()

    async def _fill(self) -> None:
        while len(self._working) < self._most:
            batch = await self._bureau.jobs.take(self._name)
            if batch is None:
                return
            task = asyncio.create_task(work(self._bureau, batch))
            self._working.add(task)
            task.add_done_callback(self._done)

    def _done(self, task: asyncio.Task[None]) -> None:
        self._working.discard(task)
        self._woken.set()

    async def _pause(self) -> None:
        with suppress(TimeoutError):
            async with asyncio.timeout(LOOK):
                await self._woken.wait()
        self._woken.clear()

    async def _end(self) -> None:
        if self._working:
            await asyncio.wait(self._working, timeout=GRACE)
        for task in self._working:
            task.cancel()
        await asyncio.gather(*self._working, return_exceptions=True)
