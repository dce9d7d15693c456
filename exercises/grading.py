"""Grading a submission: reading, judging, follow-through, mistakes, score."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

from exercises import catalogue, solving
from exercises.exercise import Grade, Submission, Variant
from exercises.solving import NO_SECRET, Kept, Solved
from exercises.variants import slips
from graders import AnswerSyntaxError, Code, Echo, Outcome, Value, Verdict
from graders.language import Tree
from graders.language.doubles import UndefinedError
from graders.language.notes import notes_of
from graders.verdict import EMPTY, FAULT, FOLLOWED, RIGHT, unreadable

GRADER_VERSION = "1"
PLAUSIBLE = 1e3  # follow-through only from values within this factor of the reference
JUDGED = (Outcome.RIGHT, Outcome.PARTLY, Outcome.WRONG)
OFF = (Outcome.PARTLY, Outcome.WRONG)


class UnknownAnswer(ValueError):
    """The submission names an answer that the exercise does not ask for."""


def grade(submission: Submission, secret: bytes = NO_SECRET, *, limited: bool = False, kept: Kept = ()) -> Grade:
    """Grade a submission.

    Args:
        submission: Answers as typed; a missing answer counts as empty.
        secret: The server's secret, from which the test points of formulas are drawn.
        limited: Attempts are limited: a non-empty unreadable answer stops the judging, and only reading errors
            come back.
        kept: Values of the steps from when the variant was dealt; they go before what the steps give now.

    Raises:
        UnknownAnswer: An answer that is not asked for.
    """
    solved = solving.solved(submission.variant, secret, kept)
    unknown = sorted(set(submission.answers) - set(solved.answers))
    if unknown:
        raise UnknownAnswer(unknown[0])
    read = {name: _read(solved, name, submission.answers.get(name, "")) for name in solved.answers}
    errors = {name: v for name, v in read.items() if isinstance(v, Verdict) and v is not EMPTY}
    if limited and errors:
        return Grade(errors, 0.0, None, False, False, GRADER_VERSION)
    verdicts = _judge(solved, read)
    return _grade(solved, verdicts, _mistake(solved, read, verdicts))


def failed(submission: Submission) -> Grade:
    """Give the grade of a submission that could not be graded by our fault: nothing counted, kept for the lecturer."""
    exercise = catalogue.load(submission.variant.exercise).exercise
    verdicts = dict.fromkeys(exercise.answers_of(submission.variant.givens), FAULT)
    return Grade(verdicts, 0.0, None, False, True, GRADER_VERSION)


def preview(variant: Variant, answer: str, text: str, comma: bool = False) -> Echo | Verdict:
    """Say what was understood of one answer; it depends neither on the seed nor on the reference.

    Args:
        variant: The variant answered.
        answer: Name of the answer.
        text: What is typed.
        comma: Echo decimals with a comma.

    Raises:
        UnknownAnswer: The exercise does not ask for this answer.
    """
    solved = solving.solved(variant)
    if answer not in solved.answers:
        raise UnknownAnswer(answer)
    read = _read(solved, answer, text)
    if isinstance(read, Verdict):
        return read
    return replace(solved.answers[answer].echo(read, comma), notes=notes_of(text, solved.symbols(answer)))


def reference(variant: Variant) -> dict[str, str]:
    """Give for each answer a text that a student could type and that is graded right."""
    solved = solving.solved(variant)
    return {name: grader.show(solved.reference(name)) for name, grader in solved.answers.items()}


def _read(solved: Solved, name: str, text: str) -> Any:
    """Read one answer; the one place where unreadable text becomes a verdict."""
    if not text.strip():
        return EMPTY
    try:
        return solved.answers[name].parse(text, solved.symbols(name))
    except AnswerSyntaxError as error:
        return unreadable(error)


def _judge(solved: Solved, read: Mapping[str, Any]) -> dict[str, Verdict]:
    """Judge the answers in order; a wrong one is carried, and later ones are solved again from it.

    After a right one in which the student chooses freely (frames of a chain) they are solved from his own choice.
    """
    verdicts: dict[str, Verdict] = {}
    fixed: dict[str, Value | Tree] = {}
    values = solved.values
    for name, answer in read.items():
        if isinstance(answer, Verdict):
            verdicts[name] = answer
            continue
        verdict = solved.answers[name].check(answer, _against(solved, read, name, solved.reference(name, values)))
        if verdict.outcome in OFF:
            if fixed and _follows(solved, name, answer, fixed):
                verdict = FOLLOWED
            _carry(solved, name, answer, fixed)
        elif _free(solved, name) and verdict is RIGHT:
            chosen = _chosen(solved, {name: answer}, {name: verdict})
            with suppress(UndefinedError):  # a table without a value at the numbers of this variant
                values = solved.again(fixed={**fixed, **chosen})
                fixed |= chosen
        verdicts[name] = verdict
    return verdicts


def _free(solved: Solved, name: str) -> bool:
    return getattr(solved.answers[name], "free", False)


def _against(solved: Solved, read: Mapping[str, Any], name: str, reference: Any) -> Any:
    """Give what an answer is judged against; a judge that stands beside another answer is handed it as it was read."""
    beside = read.get(getattr(solved.answers[name], "beside", ""))
    return reference if beside is None or isinstance(beside, Verdict) else reference.beside(beside)


def _follows(solved: Solved, name: str, answer: Any, fixed: Mapping[str, Value | Tree]) -> bool:
    """Tell whether an answer is right when solved from the student's own earlier values."""
    step, grader = solved.step_of(name), solved.answers[name]
    if grader.symbolic or step not in solved.steps:
        return False
    own = {key: value for key, value in fixed.items() if key != step or not isinstance(value, float | tuple | str)}
    try:
        values = solved.again(fixed=own)
    except UndefinedError:
        return False
    return _plausible(values[step], solved.values[step]) and grader.check(answer, values[step]).code is Code.RIGHT


def _carry(solved: Solved, name: str, answer: Any, fixed: dict[str, Value | Tree]) -> None:
    """Keep a wrong answer for the later ones, unless its value is trivial or outside the plausible range."""
    step, carried = solved.step_of(name), solved.answers[name].carried(answer)
    if carried is None:
        return
    if isinstance(carried, float | tuple | str) and not _plausible(carried, solved.values[step]):
        return
    fixed[step] = carried


def _plausible(value: Value, right: Value) -> bool:
    if isinstance(value, str) or isinstance(right, str):
        return True
    if isinstance(value, tuple) or isinstance(right, tuple):
        entries = [abs(e) for row in value for e in row] if isinstance(value, tuple) else []
        return bool(entries) and 0 < max(entries) < PLAUSIBLE * PLAUSIBLE
    return abs(right) / PLAUSIBLE < abs(value) < abs(right) * PLAUSIBLE


def _mistake(solved: Solved, read: Mapping[str, Any], verdicts: Mapping[str, Verdict]) -> str | None:
    """Name the known slip that predicts every answer given, if some answer is not right."""
    given = {
        name: answer
        for name, answer in read.items()
        if not isinstance(answer, Verdict) and verdicts[name].code is not Code.KEPT
    }
    if not any(verdicts[name].outcome in OFF or verdicts[name] is FOLLOWED for name in given):
        return None
    for mistake, expected in slips(solved, _chosen(solved, given, verdicts)):
        if all(
            _predicted(solved, name, answer, _against(solved, read, name, expected[name]))
            for name, answer in given.items()
        ):
            return mistake
    return None


def _chosen(solved: Solved, given: Mapping[str, Any], verdicts: Mapping[str, Verdict]) -> dict[str, Value | Tree]:
    """Give the right answers in which the student chose freely: his slips stand on his own choice."""
    carried = {
        solved.step_of(name): solved.answers[name].carried(answer)
        for name, answer in given.items()
        if _free(solved, name) and verdicts[name] is RIGHT
    }
    return {step: own for step, own in carried.items() if own is not None}


def _predicted(solved: Solved, name: str, answer: Any, expected: Any) -> bool:
    return solved.answers[name].check(answer, expected).code is Code.RIGHT


def _grade(solved: Solved, verdicts: dict[str, Verdict], mistake: str | None) -> Grade:
    weights = {name: grader.weight for name, grader in solved.answers.items()}
    score = sum(weights[name] * verdict.score for name, verdict in verdicts.items()) / sum(weights.values())
    outcomes = {verdict.outcome for verdict in verdicts.values()}
    return Grade(
        verdicts=verdicts,
        score=round(score, 6),
        mistake=mistake,
        counted=any(outcome in JUDGED for outcome in outcomes),
        provisional=Outcome.UNDECIDED in outcomes,
        grader_version=GRADER_VERSION,
    )
