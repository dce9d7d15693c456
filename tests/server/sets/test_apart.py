"""Long tasks run in processes of their own and hold up no judging."""

from __future__ import annotations

import asyncio
import os

from server.judging import JudgingThread


def test_tasks_are_computed_apart_in_their_order() -> None:
    async def computed() -> tuple[list[int], list[int]]:
        judging = JudgingThread()
        try:
            return await judging.apart(pow, [(2, 5), (3, 2)]), await judging.apart(os.getppid, [()])
        finally:
            judging.close()

    powers, parents = asyncio.run(computed())
    assert powers == [32, 9] and parents == [os.getpid()]
