"""What a call costs: its processor time on its thread, in which no other work counts, or the calls that it makes.

Meanwhile coverage is not measured, and what other tests left behind is not collected.
"""

from __future__ import annotations

import gc
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from math import inf
from types import FrameType


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


def calls(call: Callable[[], object]) -> int:
    """Count the functions called, those written in C as well: the same on every machine."""
    count, before = 0, sys.getprofile()

    def called(_frame: FrameType, event: str, _argument: object) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    sys.setprofile(called)
    try:
        call()
    finally:
        sys.setprofile(before)
    return count


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
