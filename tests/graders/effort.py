"""The processor time of a call on its thread: other work does not count, be it the machine's or that of other tests.

Meanwhile coverage is not measured, and what other tests left behind is not collected.
"""

from __future__ import annotations

import gc
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
    with _undisturbed():
        start = time.thread_time()
        call()
        return time.thread_time() - start


@contextmanager
def _undisturbed() -> Iterator[None]:
    tracer, collected = sys.gettrace(), gc.isenabled()
    sys.settrace(None)
    gc.disable()
    try:
        yield
    finally:
        if collected:
            gc.enable()
        sys.settrace(tracer)
