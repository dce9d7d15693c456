"""Long tasks run in processes of their own and hold up no judging."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys

from server.judging.thread import JudgingThread


def test_tasks_are_computed_apart_in_their_order() -> None:
    async def computed() -> tuple[list[int], list[int]]:
        judging = JudgingThread()
        try:
            return await judging.apart(pow, [(2, 5), (3, 2)]), await judging.apart(os.getppid, [()])
        finally:
            judging.close()

    powers, parents = asyncio.run(computed())
    assert powers == [32, 9] and parents == [os.getpid()]


PROGRAM = """
import asyncio, os, sys
from server.judging.thread import JudgingThread
if __name__ == "__main__":
    print(*asyncio.run(JudgingThread(1).apart(os.getpid, [()])), flush=True)
    sys.stdin.read()
"""


def test_processes_end_with_a_server_that_is_killed() -> None:
    """Their number is free once the pipe that they have inherited is closed by the last of them."""
    server = subprocess.Popen([sys.executable, "-c", PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    assert server.stdout is not None and server.stdin is not None
    assert int(server.stdout.readline()) != server.pid
    server.kill()
    assert server.stdout.read() == b""  # ends when nobody can write any more
    server.wait()
    server.stdin.close()
    server.stdout.close()
