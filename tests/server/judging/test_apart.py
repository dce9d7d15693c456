"""Long tasks run in processes of their own and hold up no judging."""

from __future__ import annotations

import asyncio
import os
import time
from pathlib import Path

from server.judging.thread import JudgingThread
from tests.server.judging.killed import outlived
from tests.server.judging.tasks import be_told_to_end


def test_tasks_are_computed_apart_in_their_order() -> None:
    async def computed() -> tuple[list[int], list[int]]:
        judging = JudgingThread()
        try:
            return await judging.apart(pow, [(2, 5), (3, 2)]), await judging.apart(os.getppid, [()])
        finally:
            judging.close()

    powers, parents = asyncio.run(computed())
    assert powers == [32, 9] and parents == [os.getpid()]


def test_what_all_processes_of_a_server_are_sent_is_the_server_s_to_heed() -> None:
    async def computed() -> list[int]:
        judging = JudgingThread(1)
        try:
            return [(await judging.apart(one, [()]))[0] for one in (os.getpid, be_told_to_end, os.getpid)]
        finally:
            judging.close()

    assert len(set(asyncio.run(computed()))) == 1


def test_processes_that_heed_no_signal_end_with_the_judging() -> None:
    async def computed() -> int:
        judging = JudgingThread(1)
        (process,) = await judging.apart(os.getpid, [()])
        busy = asyncio.create_task(judging.apart(time.sleep, [(600,)]))
        await asyncio.sleep(0.1)
        judging.close()
        await asyncio.gather(busy, return_exceptions=True)
        return process

    process, until = Path(f"/proc/{asyncio.run(computed())}"), time.monotonic() + 30
    while process.exists():
        assert time.monotonic() < until, "the process computes on"
        time.sleep(0.05)


PROGRAM = """
import asyncio, os, sys
from server.judging.thread import JudgingThread
if __name__ == "__main__":
    print(*asyncio.run(JudgingThread(1).apart(os.getpid, [()])), flush=True)
    sys.stdin.read()
"""


def test_processes_end_with_a_server_that_is_killed() -> None:
    assert outlived(PROGRAM) == b""
