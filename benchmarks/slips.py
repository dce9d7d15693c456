"""How many slips are named rightly, how many random wrong answers are attributed to one, and what naming costs.

The slips stand in ``tests/slips``, written apart from the exercises' own lists. Each is made in several variants.
Run: ``uv run python benchmarks/slips.py [--seeds 5] [ID …]``; with ``-v`` it prints the slips that are not named.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])

import argparse
import time
from collections.abc import Iterable
from importlib import import_module
from itertools import islice
from statistics import median

from exercises import catalogue
from exercises.exercise import Submission
from exercises.grading import grade, reference
from tests.slips.random_answers import attributed, random_submissions
from tests.slips.slip import dealt, found, named_rightly, occasions


def named(exercise: str, variants: int, verbose: bool) -> tuple[int, int]:
    """Count the slips named rightly over several variants each, and all of them."""
    right = made = 0
    for slip in import_module(f"tests.slips.{exercise}").SLIPS:
        for submission, graded in islice(occasions(exercise, slip), variants):
            made += 1
            right += named_rightly(slip, graded)
            if verbose and not named_rightly(slip, graded):
                print(f"    {slip.name} (seed {submission.variant.seed}): {', '.join(sorted(found(graded)))}")
    return right, made


def microseconds(submissions: Iterable[Submission]) -> float:
    """Give the median time of a second grading."""
    times = []
    for submission in submissions:
        grade(submission)
        start = time.process_time()
        grade(submission)
        times.append(time.process_time() - start)
    return 1e6 * median(times)


def main() -> None:
    """Measure and print one line an exercise, then the sums."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("exercises", nargs="*", metavar="ID")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("-v", "--verbose", action="store_true")
    given = parser.parse_args()
    head = ("slips", "named", "share", "one random", "attributed", "all random", "attributed", "right us", "wrong us")
    print(f"{'':24}" + "".join(f"{word:>11}" for word in head))
    sums = [0] * 6
    for exercise in given.exercises or catalogue.ids():
        right, made = named(exercise, given.seeds, given.verbose)
        one, ones, _ = attributed(exercise, range(1, 40 * given.seeds), False)
        whole, wholes, _ = attributed(exercise, range(1, 20 * given.seeds), True)
        costs = (
            microseconds(Submission(dealt(exercise, seed), reference(dealt(exercise, seed))) for seed in range(1, 21)),
            microseconds(random_submissions(exercise, range(1, 21), False)),
        )
        counts = (made, right, ones, one, wholes, whole)
        sums = [total + count for total, count in zip(sums, counts, strict=True)]
        line(exercise, counts, f"{costs[0]:11.0f}{costs[1]:11.0f}")
    line("all", sums, "")


def line(name: str, counts: Iterable[int], costs: str) -> None:
    """Print one line."""
    made, right, *random = counts
    print(f"{name:24}{made:11}{right:11}{right / made:11.1%}" + "".join(f"{n:11}" for n in random) + costs, flush=True)


if __name__ == "__main__":
    main()
