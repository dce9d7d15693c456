"""What a variant costs, each exercise alone: draw, numeric solve, separation of the known mistakes, the whole deal,
first and second grading of right answers.

The draw counts what is refused on the way to a variant that can be solved. A deal draws again where mistakes fall
together; `draws` is the mean of the draws it takes. Medians over fresh seeds, in microseconds; one pass over other
seeds warms up. Run: ``uv run python benchmarks/variant.py [--seeds 100] [ID …]``.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from statistics import fmean, median
from typing import TypeVar

from exercises import catalogue, grading, solving
from exercises.draw import Draw, Rejected
from exercises.exercise import Submission, Variant
from exercises.variants import deal, told_apart
from graders.language.doubles import UndefinedError

T = TypeVar("T")


def microseconds(work: Callable[[T], object], over: Iterable[T]) -> float:
    """Give the median time of a piece of work."""
    times = []
    for one in over:
        start = time.perf_counter()
        work(one)
        times.append(time.perf_counter() - start)
    return 1e6 * median(times)


def drawn(exercise_id: str, seed: int) -> None:
    """Draw the first variant of a seed that is not refused, and solve it."""
    exercise = catalogue.load(exercise_id).exercise
    for turn in range(100):
        try:
            solving.solve(exercise, exercise.draw(Draw(exercise_id, seed, turn)))
        except (Rejected, UndefinedError):
            continue
        return


def draws(variant: Variant) -> int:
    """Count the draws that a deal took."""
    exercise = catalogue.load(variant.exercise).exercise
    for turn in range(100):
        with suppress(Rejected, UndefinedError):
            if exercise.draw(Draw(variant.exercise, variant.seed, turn)) == variant.givens:
                return turn + 1
    raise RuntimeError(f"{variant.exercise}: seed {variant.seed} is not drawn again")


def costs(exercise_id: str, seeds: range) -> tuple[float, ...]:
    """Give the medians of one exercise, in the order in which they are printed."""
    exercise = catalogue.load(exercise_id).exercise
    draw = microseconds(lambda seed: drawn(exercise_id, seed), seeds)
    dealing = microseconds(lambda seed: deal(exercise_id, seed), seeds)
    variants = [deal(exercise_id, seed) for seed in seeds]
    solve = microseconds(lambda variant: solving.solve(exercise, variant.givens), variants)
    apart = microseconds(told_apart, [solving.Solved(exercise, variant) for variant in variants])
    handed_in = [Submission(variant, grading.reference(variant)) for variant in variants]
    solving.solved.cache_clear()
    first, again = microseconds(grading.grade, handed_in), microseconds(grading.grade, handed_in)
    return draw, solve, apart, dealing, fmean(map(draws, variants)), first, again


def main() -> None:
    """Measure and print one line an exercise."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("exercises", nargs="*", metavar="ID")
    parser.add_argument("--seeds", type=int, default=100)
    given = parser.parse_args()
    heads = ("draw + solve", "solve", "separation", "deal", "draws", "grade first", "again")
    print(f"{'microseconds':24}" + "".join(f"{head:>14}" for head in heads))
    for exercise_id in given.exercises or catalogue.ids():
        costs(exercise_id, range(10**6, 10**6 + given.seeds // 2))
        found = costs(exercise_id, range(given.seeds))
        print(f"{exercise_id:24}" + "".join(f"{one:14.1f}" for one in found), flush=True)


if __name__ == "__main__":
    main()
