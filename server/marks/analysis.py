"""What the answers of a class tell of the tasks: pure functions over plain numbers, nothing of a person in them.

Sources: discrimination is the corrected item-total correlation (Nunnally and Bernstein, Psychometric Theory, 3rd ed.,
1994, chapter 8). Fairness is Fisher's exact test (Fisher, Statistical Methods for Research Workers, 5th ed., 1934,
section 21.02; two-sided: the tables no more probable than the one found), each variant against all others of its task,
with the correction of Holm (A simple sequentially rejective multiple test procedure, Scandinavian Journal of
Statistics 6, 1979) over the variants of the task. A correlation counts as negative where Fisher's z (section 35 of the
same book) lies so far below 0 as chance alone leads to in 5 % of classes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import atanh, comb, sqrt
from statistics import fmean, median
from typing import TypeVar

LEAST = 5  # people: a smaller group is not shown
LEVEL = 0.05  # of all tests of a task together
BELOW = -1.645  # standard deviations of Fisher's z: 5 % of the normal distribution lie lower
CLOSE = 1e-9  # relative: probabilities that differ by rounding are the same
TOP = 5  # commonest wrong answers that are listed
T = TypeVar("T", bound=Hashable)


@dataclass(frozen=True, slots=True)
class Try:
    """What one student did in one task.

    Attributes:
        who: The student, by any number; none of it comes out.
        group: What was dealt: of a pool the exercise, else the card.
        share: The share of the points before lateness and hints take any off; none where nothing was judged.
        attempts: How many attempts were counted.
        first_right: Minutes from opening to the first full points; none without them.
        mistakes: The named mistakes that were recognised, each once.
        wrong: The wrong answers, each once: name of the answer and text.
    """

    who: str
    group: str
    share: float | None
    attempts: int
    first_right: float | None
    mistakes: frozenset[str] = frozenset()
    wrong: frozenset[tuple[str, str, str]] = frozenset()


@dataclass(frozen=True, slots=True)
class Fairness:
    """A variant against the others of its task: the share that solved it, and the probability of so much by chance."""

    group: str
    students: int
    solved: float
    p: float
    unfair: bool


@dataclass(frozen=True, slots=True)
class Analysis:
    """What a class did in one task. A number that too few people stand behind is none.

    Attributes:
        students: How many have been judged.
        success: The mean share of the points.
        solved: The share of students with full points.
        separates: Correlation of this task with the rest of the set.
        attempts: Mean number of counted attempts.
        first_right: Median of the minutes to the first full points.
        mistakes: Recognised mistakes and the share of students who made each, the commonest first.
        wrong: Wrong answers (name, text, mistake or nothing) and how many students gave each.
        groups: The variants that at least five students had.
    """

    students: int
    success: float | None
    solved: float | None
    separates: float | None
    attempts: float | None
    first_right: float | None
    mistakes: tuple[tuple[str, float], ...]
    wrong: tuple[tuple[tuple[str, str, str], int], ...]
    groups: tuple[Fairness, ...]

    @property
    def against(self) -> bool:
        """Whether students who are good in the rest lose points here, by more than chance may lead to."""
        return self.separates is not None and negative(self.separates, self.students)


def analysed(tries: Sequence[Try], rest: Mapping[str, float]) -> Analysis:
    """Sum one task up.

    Args:
        tries: What each student did in it.
        rest: The points of each student in all other tasks of the set, before anything was taken off.
    """
    judged = [one for one in tries if one.share is not None]
    if len(judged) < LEAST:
        return Analysis(0, None, None, None, None, None, (), (), ())
    shares = [one.share or 0.0 for one in judged]
    right = [one.first_right for one in judged if one.first_right is not None]
    number = len(judged)
    return Analysis(
        students=number, success=fmean(shares), solved=sum(map(_solved, judged)) / number,
        separates=correlation(shares, [rest.get(one.who, 0.0) for one in judged]),
        attempts=fmean(one.attempts for one in judged), first_right=median(right) if len(right) >= LEAST else None,
        mistakes=tuple((name, times / number) for name, times in common(one.mistakes for one in judged)),
        wrong=tuple(common(one.wrong for one in judged)), groups=fairness(judged),
    )  # fmt: skip


def common(each: Iterable[frozenset[T]]) -> list[tuple[T, int]]:
    """List what at least five people share, the commonest first."""
    counts = Counter(thing for things in each for thing in things)
    enough = [(thing, times) for thing, times in counts.items() if times >= LEAST]
    return sorted(enough, key=lambda one: (-one[1], str(one[0])))[:TOP]


def negative(correlation: float, students: int) -> bool:
    """Tell whether a correlation is below 0 by more than chance may lead to in a class of that size."""
    bounded = max(-1 + CLOSE, min(1 - CLOSE, correlation))
    return atanh(bounded) * sqrt(max(0, students - 3)) < BELOW


def correlation(one: Sequence[float], other: Sequence[float]) -> float | None:
    """Give Pearson's correlation; none where one of the two does not vary."""
    first, second = fmean(one), fmean(other)
    covered = sum((a - first) * (b - second) for a, b in zip(one, other, strict=True))
    spread = sqrt(sum((a - first) ** 2 for a in one)) * sqrt(sum((b - second) ** 2 for b in other))
    return None if spread <= CLOSE else max(-1.0, min(1.0, covered / spread))


def fisher(solved: int, students: int, all_solved: int, all_students: int) -> float:
    """Give the two-sided probability of a table at least as unlikely as this one, by chance alone.

    Args:
        solved: How many of the group have solved the task.
        students: How many are in the group.
        all_solved: How many of all have solved it.
        all_students: How many there are.

    Raises:
        ValueError: The table cannot be.
    """
    least, most = max(0, students + all_solved - all_students), min(students, all_solved)
    if not 0 <= students <= all_students or not 0 <= all_solved <= all_students or not least <= solved <= most:
        raise ValueError(f"{solved} of {students} in {all_solved} of {all_students} cannot be")
    weights = [comb(all_solved, k) * comb(all_students - all_solved, students - k) for k in range(least, most + 1)]
    found = weights[solved - least]
    return sum(weight for weight in weights if weight <= found) / comb(all_students, students)


def fairness(judged: Sequence[Try]) -> tuple[Fairness, ...]:
    """Compare each variant that at least five students had with all others of the task."""
    total, solved = len(judged), sum(map(_solved, judged))
    groups = Counter(one.group for one in judged)
    right = Counter(one.group for one in judged if _solved(one))
    seen = sorted(name for name, number in groups.items() if LEAST <= number <= total - LEAST)
    chances = [fisher(right[name], groups[name], solved, total) for name in seen]
    unfair = holm(chances)
    return tuple(
        Fairness(name, groups[name], right[name] / groups[name], p, flag)
        for name, p, flag in zip(seen, chances, unfair, strict=True)
    )


def holm(chances: Sequence[float]) -> list[bool]:
    """Tell which of several tests fail by more than chance, all of them together at the level of 5 %."""
    order = sorted(range(len(chances)), key=lambda at: chances[at])
    flags = [False] * len(chances)
    for rank, at in enumerate(order):
        if chances[at] > LEVEL / (len(chances) - rank):
            break
        flags[at] = True
    return flags


def _solved(one: Try) -> bool:
    return one.share is not None and one.share >= 1
