"""What becomes of the processes of a server that is killed."""

from __future__ import annotations

import subprocess
import sys


def outlived(program: str) -> bytes:
    """Run a server that prints the number of another process; kill it and give what is printed until nobody can.

    The pipe that the other one has inherited is closed by the last who holds it, so this returns once all have ended.
    """
    server = subprocess.Popen([sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    assert server.stdout is not None and server.stdin is not None
    assert int(server.stdout.readline()) != server.pid
    server.kill()
    left = server.stdout.read()
    server.wait()
    server.stdin.close()
    server.stdout.close()
    return left
