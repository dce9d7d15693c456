"""The processor time of a call: other work on the machine does not count, and coverage is not measured meanwhile."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager


def effort(call: Callable[[], object], tries: int = 3) -> float:
    """Give the least processor time of several calls, in seconds."""
    return min(_once(call) for _ in range(tries))


def _once(call: Callable[[], object]) -> float:
    with _untraced():
        start = time.process_time()
        call()
        return time.process_time() - start


@contextmanager
def _untraced() -> Iterator[None]:
    tracer = sys.gettrace()
    sys.settrace(None)
    try:
        yield
    finally:
        sys.settrace(tracer)
