"""What a variant costs, each exercise alone: draw and numeric solve, deal, first and second grading of right answers.

Draw and solve is what every variant needs; a deal also tells the known mistakes apart. Medians over fresh seeds, in
microseconds; one pass over other seeds warms up. Run: ``uv run python benchmarks/variant.py [--seeds 100] [ID …]``.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse  # noqa: E402
import time  # noqa: E402
from collections.abc import Callable, Iterable  # noqa: E402
from statistics import median  # noqa: E402
from typing import TypeVar  # noqa: E402

from exercises import catalogue, grading, solving  # noqa: E402
from exercises.draw import Draw, Rejected  # noqa: E402
from exercises.exercise import Submission  # noqa: E402
from exercises.variants import deal  # noqa: E402
from graders.language.doubles import UndefinedError  # noqa: E402

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


def costs(exercise_id: str, seeds: range) -> tuple[float, ...]:
    """Give the four medians of one exercise."""
    draw = microseconds(lambda seed: drawn(exercise_id, seed), seeds)
    dealing = microseconds(lambda seed: deal(exercise_id, seed), seeds)
    variants = [deal(exercise_id, seed) for seed in seeds]
    handed_in = [Submission(variant, grading.reference(variant)) for variant in variants]
    solving.solved.cache_clear()
    return draw, dealing, microseconds(grading.grade, handed_in), microseconds(grading.grade, handed_in)


def main() -> None:
    """Measure and print one line an exercise."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("exercises", nargs="*", metavar="ID")
    parser.add_argument("--seeds", type=int, default=100)
    given = parser.parse_args()
    print(f"{'microseconds':24}{'draw + solve':>14}{'deal':>10}{'grade first':>14}{'again':>10}")
    for exercise_id in given.exercises or catalogue.ids():
        costs(exercise_id, range(10**6, 10**6 + given.seeds // 2))
        draw, dealing, first, again = costs(exercise_id, range(given.seeds))
        print(f"{exercise_id:24}{draw:14.0f}{dealing:10.0f}{first:14.0f}{again:10.0f}", flush=True)


if __name__ == "__main__":
    main()
