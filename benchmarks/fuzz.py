"""Random texts against tokenizer, parser, LaTeX reader, unit reader and every judge: crashes, slow answers, shares.

A third of the texts follow the grammar, nearly half are mutations of real answers in three languages, the rest is
LaTeX and any characters. All follow from the seed, whatever the number of processes. Run:
``uv run python benchmarks/fuzz.py --inputs 300000 --processes 2``.
Exit code 1 on a crash, an answer above 50 ms, or when too few texts pass the tokenizer (30 %) or reach a judge (10 %).
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import gc
import time
import tracemalloc
from functools import lru_cache, partial
from multiprocessing import get_context

from graders import KINDS
from tests.graders.fuzzing.attack import Found, Target, attack, one, targets

CHUNK = 5000
TOKENS, JUDGED = 0.30, 0.10
MEGABYTE = 1e6
SHOWN = 100_000  # inputs between two lines about the progress


@lru_cache(maxsize=1)
def every(exercises: tuple[str, ...]) -> list[Target]:
    """Give the targets, made once a process."""
    found = targets(exercises)
    gc.freeze()  # they stay: the collector need not look at them again and again
    return found


def chunk(exercises: tuple[str, ...], seed: int, inputs: int, number: int) -> Found:
    """Attack with the texts of one chunk."""
    size = min(CHUNK, inputs - number * CHUNK)
    return attack(every(exercises), seed * 1_000_003 + number, size)


def memory(exercises: tuple[str, ...], slowest: list[tuple[float, str, str]]) -> float:
    """Give the greatest memory, in megabytes, that one of the slowest texts takes at any judge of its kind."""
    greatest = 0.0
    for _, kind, text in slowest:
        target = next(t for t in every(exercises) if t.grader.kind == kind)
        tracemalloc.start()
        one(target, text, Found())
        greatest = max(greatest, tracemalloc.get_traced_memory()[1] / MEGABYTE)
        tracemalloc.stop()
    return greatest


def report(found: Found, seconds: float, megabytes: float) -> bool:
    """Print what was found and tell whether all is as it should be."""
    tokens, judged = found.tokens / found.tokenized, found.judged / found.inputs
    print(f"{found.inputs} inputs in {seconds:.0f} s, {found.inputs / found.seconds:.0f} a second of processor time")
    print(f"{tokens:.1%} pass the tokenizer, {judged:.1%} reach a judge, {found.right / found.inputs:.1%} are right")
    print(f"{found.overlong} of the texts above 3000 characters reached a judge (tables and sentences)")
    print("judged:", ", ".join(f"{kind} {count}" for kind, count in found.kinds.most_common()))
    print("refused:", ", ".join(f"{reason} {count}" for reason, count in found.reasons.most_common(12)))
    unreached = sorted(set(KINDS) - set(found.kinds))
    print("kinds not reached:", ", ".join(unreached) or "none")
    for cost, kind, text in found.slowest[:5]:
        print(f"  {cost * 1e3:.1f} ms {kind} {text[:80]!r}")
    print(f"greatest memory of the slowest texts: {megabytes:.1f} MB")
    print(f"{len(found.crashes)} crashes, {len(found.slow)} answers above 50 ms")
    return not found.crashes and not found.slow and tokens >= TOKENS and judged >= JUDGED and megabytes <= 20


def progress(total: Found, found: Found) -> None:
    """Print what a chunk found, and at times how far the work is."""
    for line in [*found.crashes, *found.slow]:
        print("  " + line, flush=True)
    if total.inputs // SHOWN > (total.inputs - found.inputs) // SHOWN:
        print(f"{total.inputs} inputs, {len(total.crashes)} crashes, {len(total.slow)} slow", flush=True)


def main() -> int:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("exercises", nargs="*", metavar="ID")
    parser.add_argument("--inputs", type=int, default=300_000)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    exercises, total = tuple(arguments.exercises), Found()
    start = time.perf_counter()
    with get_context("spawn").Pool(arguments.processes) as pool:
        work = partial(chunk, exercises, arguments.seed, arguments.inputs)
        for found in pool.imap_unordered(work, range(-(-arguments.inputs // CHUNK))):
            total.add(found)
            progress(total, found)
    seconds = time.perf_counter() - start
    return 0 if report(total, seconds, memory(exercises, total.slowest)) else 1


if __name__ == "__main__":
    sys.exit(main())
