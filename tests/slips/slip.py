"""A slip as a student makes it: what he computes or types instead, and under which names it may be explained to him."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, TypeAlias

from exercises import solving, variants
from exercises.exercise import Grade, Submission, Variant
from exercises.grading import OFF, grade
from exercises.solving import Solved, evaluate
from graders import Grader, Verdict
from graders.language.doubles import UndefinedError
from graders.remarks import Remarks
from graders.verdict import Flaws

Texts: TypeAlias = Mapping[str, str]
Lines: TypeAlias = Callable[[Any], Mapping[str, Any] | None]
Instead: TypeAlias = Mapping[str, Any] | Lines
FIGURES = 5  # to which students round
SEEDS = range(1, 60)  # in which an occasion is looked for


@dataclass(frozen=True)
class S:
    """One slip.

    Args:
        name: What the student does, in words.
        named: The names under which it is explained rightly: mistakes, common slips, codes, parted by blanks.
        lines: Lines of steps or givens that the student computes instead; he carries on from them. Or a function of
            the givens that returns them; None where the slip has no occasion.
        typed: Answers that he types instead, as formulas over all values (SI units), as functions of all values that
            give the value or the text, or, behind `=`, as texts.
        left: Answers that he leaves empty.
    """

    name: str
    named: str
    lines: Instead = field(default_factory=dict)
    typed: Instead = field(default_factory=dict)
    left: str = ""

    @property
    def names(self) -> frozenset[str]:
        """Give the names one by one."""
        return frozenset(self.named.split())


def handed_in(slip: S, variant: Variant) -> Submission | None:
    """Give what is typed in a variant; None where the slip has no occasion or no value."""
    solved = solving.solved(variant)
    lines, typed = (part(variant.givens) if callable(part) else part for part in (slip.lines, slip.typed))
    if lines is None or typed is None or not set(lines) <= {*solved.steps, *solved.values}:
        return None
    if not set(typed) <= set(solved.answers):
        return None
    try:
        values = solved.again(replaced=lines)
        texts = {
            name: _text(solved, name, grader, values, lines, typed.get(name)) for name, grader in solved.answers.items()
        }
    except UndefinedError:
        return None
    return Submission(variant, {name: text for name, text in texts.items() if name not in slip.left.split()})


def _text(
    solved: Solved, name: str, grader: Grader, values: Mapping[str, Any], lines: Mapping[str, Any], instead: Any
) -> str:
    if isinstance(instead, str) and instead.startswith("="):
        return instead[1:]
    value = solved.reference(name, values, lines)
    if instead is not None:
        asked = {answer: values[solved.step_of(answer)] for answer, g in solved.answers.items() if not g.symbolic}
        own = {**values, **asked}
        value = instead(own) if callable(instead) else evaluate(instead, own)
    if isinstance(value, str) and grader.kind != "choice":
        return value
    if grader.kind == "quantity" and isinstance(value, float):
        return grader.show(float(f"{value:.{FIGURES}g}"))
    return grader.show(value)


@lru_cache(maxsize=4096)
def dealt(exercise: str, seed: int) -> Variant:
    """Deal a variant once for all slips."""
    return variants.deal(exercise, seed)


def occasions(exercise: str, slip: S, seeds: range = SEEDS) -> Iterator[tuple[Submission, Grade]]:
    """Give what is typed and its grade in each variant where the slip shows."""
    for seed in seeds:
        submission = handed_in(slip, dealt(exercise, seed))
        graded = grade(submission) if submission else None
        if submission and graded and any(verdict.outcome in OFF for verdict in graded.verdicts.values()):
            yield submission, graded


def found(graded: Grade) -> set[str]:
    """Give all names under which a grade explains what is wrong."""
    names = {graded.mistake, graded.slip.value if graded.slip else None} - {None}
    for verdict in graded.verdicts.values():
        if verdict.outcome in OFF:
            names |= {verdict.code.value, *_details(verdict)}
    return {str(name) for name in names}


def _details(verdict: Verdict) -> Iterator[str]:
    match verdict.details:
        case Flaws(found=flaws):
            yield from (flaw.code.value for flaw in flaws)
        case Remarks(found=remarks):
            yield from (remark.slip.value for remark in remarks)


def named_rightly(slip: S, graded: Grade) -> bool:
    """Tell whether a grade explains a slip by one of its names, and by no mistake that was not made."""
    attributed = {graded.mistake, graded.slip.value if graded.slip and not graded.mistake else None} - {None}
    return bool(found(graded) & slip.names) and attributed <= slip.names
