"""Correct rewritings and wrong mutants of every reference on many seeds: how many are judged as they should be.

Run: ``uv run python benchmarks/spellings.py [--seeds 200] [ID …]``.
Prints one line an exercise and a total; exit code 1 when a right text is refused or a wrong one gets full marks.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import time
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from itertools import cycle, islice

from exercises import catalogue, variants
from exercises.exercise import Submission
from exercises.grading import grade, reference
from exercises.solving import Solved
from graders import Code
from graders.language import AnswerSyntaxError
from tests.spellings import answers

LEAST_RIGHT, LEAST_WRONG = 12, 8


@dataclass(slots=True)
class Count:
    """What was judged and what was judged otherwise than it should be."""

    right: int = 0
    wrong: int = 0
    whole: int = 0
    kinds: Counter[str] = field(default_factory=Counter)
    least: tuple[int, int] = (99, 99)
    failures: list[str] = field(default_factory=list)


def judge_of(solved: Solved, name: str) -> Callable[[str], bool]:
    """Make a test that tells whether a text gets full marks."""
    grader, symbols, reference = solved.answers[name], solved.symbols(name), solved.reference(name)

    def full(text: str) -> bool:
        try:
            verdict = grader.check(grader.parse(text, symbols), reference)
        except AnswerSyntaxError:
            return False
        return verdict.code is Code.RIGHT and verdict.score == 1

    return full


def judge(solved: Solved, count: Count) -> None:
    """Judge all rewritings and mutants of one variant, and one whole submission with rewritings where there are any."""
    seed, typed = solved.variant.seed, dict(reference(solved.variant))
    for name in answers.covered(solved):
        right, wrong, full = answers.right(solved, name), answers.wrong(solved, name), judge_of(solved, name)
        count.right += len(right)
        count.wrong += len(wrong)
        count.kinds.update(f"{type(solved.answers[name]).__name__}: {kind}" for kind, _ in right)
        count.least = (min(count.least[0], len(right)), min(count.least[1], len(wrong)))
        count.failures += [f"seed {seed} {name} refused {k}: {t!r}" for k, t in right if not full(t)]
        count.failures += [f"seed {seed} {name} accepted {k}: {t!r}" for k, t in wrong if full(t)]
        typed[name] = next(islice(cycle(right), seed, None))[1]
    count.whole += 1
    if grade(Submission(solved.variant, typed)).score != 1:
        count.failures.append(f"seed {seed}: {typed} does not score 1")


def run(exercise: str, seeds: Iterable[int]) -> Count:
    """Judge an exercise on many seeds."""
    count = Count()
    for seed in seeds:
        judge(Solved(catalogue.load(exercise).exercise, variants.deal(exercise, seed)), count)
    return count


def report(exercise: str, count: Count, seconds: float) -> bool:
    """Print the counts of an exercise and tell whether all is as it should be."""
    enough = count.least[0] >= LEAST_RIGHT and count.least[1] >= LEAST_WRONG
    refused = sum(" accepted " not in failure for failure in count.failures)
    print(
        f"{exercise}: {count.right - refused} of {count.right} rewritings right ({len(count.kinds)} kinds, at least "
        f"{count.least[0]} an answer); {len(count.failures) - refused} of {count.wrong} mutants full marks (at least "
        f"{count.least[1]} an answer); {count.whole} whole submissions; {seconds:.1f} s"
    )
    for failure in count.failures[:10]:
        print(f"  {failure}")
    return enough and not count.failures


def main() -> int:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("exercises", nargs="*", metavar="ID")
    parser.add_argument("--seeds", type=int, default=200)
    arguments = parser.parse_args()
    passed, right, wrong = True, 0, 0
    for exercise in arguments.exercises or catalogue.ids():
        start = time.perf_counter()
        count = run(exercise, range(arguments.seeds))
        passed &= report(exercise, count, time.perf_counter() - start)
        right, wrong = right + count.right, wrong + count.wrong
    print(f"total: {right} rewritings, {wrong} mutants, {'all as they should be' if passed else 'FAILED'}")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
