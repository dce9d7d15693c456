"""`grubler verify`: the gate that an exercise passes before a student sees it."""

from __future__ import annotations

import sys
import time
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from multiprocessing import get_context

from cli.draw import known
from cli.problems import language
from exercises import catalogue
from exercises.verifying import Report, verify

SEEDS = 1000
SHOWN = 20  # failures printed for one exercise


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("exercises", nargs="*", metavar="ID", help="ids of exercises (default: all)")
    parser.add_argument("--seeds", type=_count, default=SEEDS, metavar="N", help=f"seeds 0 to N - 1 (default: {SEEDS})")
    parser.add_argument("--jobs", type=_count, default=1, metavar="N", help="processes (default: 1)")
    language(parser)


def run(options: Namespace) -> int:
    """Verify the exercises; the time goes to standard error, so that two runs print the same."""
    start, failures = time.monotonic(), 0
    names = [known(name) for name in options.exercises] or list(catalogue.ids())
    for report in _reports(names, options.seeds, options.jobs):
        failures += len(report.failures)
        print("\n".join(_lines(report)), flush=True)
    print(f"{len(names)} × {options.seeds} variants in {time.monotonic() - start:.1f} s", file=sys.stderr)
    return 1 if failures else 0


def _reports(names: Sequence[str], seeds: int, jobs: int) -> Iterator[Report]:
    check = partial(verify, seeds=range(seeds))
    if jobs == 1:
        yield from map(check, names)
        return
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        yield from pool.map(check, names)


def _lines(report: Report) -> Iterator[str]:
    yield f"{report.exercise}: {report.seeds} seeds, {report.distinct} distinct, {len(report.failures)} failures"
    yield from (f"  {failure}" for failure in report.failures[:SHOWN])
    if len(report.failures) > SHOWN:
        yield f"  and {len(report.failures) - SHOWN} more"


def _count(text: str) -> int:
    if not (text.isascii() and text.isdecimal() and len(text) < 8 and 0 < int(text) <= 10**6):
        raise ArgumentTypeError(f"{text!r} is not a whole number from 1 to 1000000")
    return int(text)
