"""The processor time of a call: other work on the machine does not count, nor does the measuring of coverage."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

TRACED = 3.0  # how many times longer a line takes while its coverage is measured


def effort(call: Callable[[], object], tries: int = 3) -> float:
    """Give the least processor time of several calls, in seconds."""
    return min(_once(call) for _ in range(tries))


def _once(call: Callable[[], object]) -> float:
    start = time.process_time()
    call()
    return (time.process_time() - start) / (TRACED if sys.gettrace() else 1.0)
