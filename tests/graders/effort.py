"""The processor time of a call: other work on the machine does not count, and coverage is not measured meanwhile."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from math import inf


def effort(call: Callable[[], object], tries: int = 3, enough: float = 0.0) -> float:
    """Give the least processor time of several calls, in seconds; one that took less than `enough` is the last."""
    least = inf
    for _ in range(tries):
        least = min(least, _once(call))
        if least < enough:
            break
    return least


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
