"""The types of the exercise room: what an exercise is made of, and what happens to a student's answers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Generic, TypeAlias, TypeVar

from exercises.draw import Draw
from exercises.givens import each, given, option
from graders import Domain, Grader, States, Value, Verdict
from graders.common_slips import CommonSlip

if TYPE_CHECKING:
    from figures.machine import Machine

Values: TypeAlias = Mapping[str, Value]
Line: TypeAlias = str | Callable[..., Value]
Steps: TypeAlias = Mapping[str, Line]
Answers: TypeAlias = Mapping[str, Grader]

G = TypeVar("G")


class Mistake(Generic[G]):
    """A known slip: some steps (or givens) replaced, everything after them solved again.

    Args:
        lines_of: A function of the givens that returns the replaced lines of this variant; no lines where the
            slip has no occasion.
        lines: The replaced lines, for slips that are the same in every variant.
    """

    __slots__ = ("_lines", "_lines_of")

    def __init__(self, lines_of: Callable[[G], Steps] | None = None, /, **lines: Line) -> None:
        self._lines_of = lines_of
        self._lines = lines

    def lines(self, givens: G) -> Steps:
        """Give the replaced lines of one variant."""
        return self._lines_of(givens) if self._lines_of else self._lines


@dataclass(frozen=True, slots=True)
class Exercise(Generic[G]):
    """One exercise: givens, how they are drawn, how they are solved (twice), what is asked, and known slips.

    An answer whose judge needs more than the value or the formula of a step (the true states of a mechanism, the pose
    of a chain) names in `references` a function of the givens, the solved values and the drawn states that makes it.
    What is counted off the drawing has one value in a variant; `counts` gives the range that such a step has where a
    formula is asked for, so that the formula is judged and not its one value.
    A laboratory exercise names in `report` which answers fill the sections of report TMM-2; `machine` gives what moves
    on its page.
    The function `figure` in the folder's `figure.py` is imported when the variant is first drawn.
    """

    systems: tuple[str, ...]
    givens: type[G]
    draw: Callable[[Draw], G]
    steps: Steps | Callable[[G], Steps]
    oracle: Callable[[G], Values]
    answers: Answers | Callable[[G], Answers]
    mistakes: Mapping[str, Mistake[G]]
    references: Mapping[str, Callable[[G, Values, States], Any]] = field(default_factory=dict)
    counts: Callable[[G], Mapping[str, Domain]] | None = None
    report: Mapping[int, tuple[str, ...]] = field(default_factory=dict)
    machine: Callable[[G], Machine] | None = None
    version: int = 1
    minutes: int = 20

    def steps_of(self, givens: G) -> Steps:
        """Give the steps of one variant in the order of solving."""
        return self.steps(givens) if callable(self.steps) else self.steps

    def counts_of(self, givens: G) -> Mapping[str, Domain]:
        """Give the ranges of the steps of one variant that are counted."""
        return self.counts(givens) if self.counts else {}

    def answers_of(self, givens: G) -> Answers:
        """Give the answers asked for in one variant."""
        return self.answers(givens) if callable(self.answers) else self.answers


AnyExercise: TypeAlias = Exercise[Any]


@dataclass(frozen=True, slots=True)
class Variant:
    """One student's task: the realised givens stand beside the seed, so an upgrade cannot change them."""

    exercise: str
    version: int
    seed: int
    givens: Any


@dataclass(frozen=True, slots=True)
class Submission:
    """Answers to one variant, exactly as typed."""

    variant: Variant
    answers: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Grade:
    """The judgement of a submission.

    Attributes:
        verdicts: One verdict for each answer asked for, in the order asked.
        score: Weighted mean of the verdicts' scores, 0 to 1.
        mistake: Name of the known slip that explains every answer given, or None.
        counted: Whether the submission uses up an attempt where attempts are limited.
        provisional: Some answer is undecided or failed by our fault and will be settled by the lecturer.
        grader_version: Version of the judges that made this grade.
        slip: A slip of any kind of task that explains every wrong answer, or those that `mistake` does not.
    """

    verdicts: Mapping[str, Verdict]
    score: float
    mistake: str | None
    counted: bool
    provisional: bool
    grader_version: str
    slip: CommonSlip | None = None


__all__ = [
    "Answers", "AnyExercise", "Draw", "Exercise", "Grade", "Line", "Mistake", "Steps", "Submission", "Value", "Values",
    "Variant", "each", "given", "option",
]  # fmt: skip
