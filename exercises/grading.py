"""Grading a submission: reading, judging, follow-through, mistakes, score."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import chain, islice, takewhile
from typing import Any

from exercises import catalogue, solving
from exercises.exercise import Grade, Submission, Variant
from exercises.solving import NO_SECRET, Earlier, Kept, Lines, Solved, carry, evaluate
from exercises.variants import Predictions, in_mode, misread, modes, slipped, slips, unasked
from graders import AnswerSyntaxError, Code, Echo, Outcome, Value, Verdict
from graders.common_slips import CommonSlip, Slips, agrees, is_right, likeliest, slips_of
from graders.language import Tree
from graders.language.doubles import UndefinedError
from graders.language.notes import notes_of
from graders.verdict import EMPTY, FAULT, RIGHT, unreadable

GRADER_VERSION = "1"
JUDGED = (Outcome.RIGHT, Outcome.PARTLY, Outcome.WRONG)
OFF = (Outcome.PARTLY, Outcome.WRONG)
MOST_TRIED = 120  # slips in lines that are not asked for
MEASURED = ("quantity", "matrix", "set")


@dataclass(frozen=True, slots=True)
class Judged:
    """The verdicts on a submission, and what stands behind them.

    Attributes:
        verdicts: By answer, in the order asked.
        expected: What each answer that could be read was judged against.
        own: For a wrong answer all values as they follow from the student's own earlier ones.
    """

    verdicts: dict[str, Verdict]
    expected: dict[str, Any]
    own: dict[str, Mapping[str, Value]]


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
    judged = _judge(solved, read)
    return _grade(solved, judged.verdicts, *explained(solved, read, judged))


def judge(variant: Variant, answer: str, text: str) -> Verdict:
    """Judge one answer alone; nothing is explained."""
    solved = solving.solved(variant)
    return _judge(solved, {answer: _read(solved, answer, text)}).verdicts[answer]


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
        return solved.answers[name].parse(_option(solved, name, text), solved.symbols(name))
    except AnswerSyntaxError as error:
        return unreadable(error)


def _option(solved: Solved, name: str, text: str) -> str:
    """Give the name of an option whose words were typed, in any language; any other text as it is."""
    if solved.answers[name].kind != "choice":
        return text
    said = _said(text)
    worded = [words["choices"][name] for words in catalogue.load(solved.variant.exercise).words.values()]
    return next((option for words in worded for option, label in words.items() if _said(label) == said), text)


def _said(text: str) -> str:
    return " ".join(text.casefold().replace("ё", "е").strip(" .").split())


def _judge(solved: Solved, read: Mapping[str, Any]) -> Judged:
    """Judge the answers in order; a wrong one is carried, and later ones are solved again from it.

    After a right one in which the student chooses freely (frames of a chain) they are solved from his own choice.
    """
    earlier = Earlier(solved)
    judged = Judged({}, {}, earlier.own)
    values = solved.values
    for name, answer in read.items():
        if isinstance(answer, Verdict):
            judged.verdicts[name] = answer
            continue
        expected = judged.expected[name] = _against(solved, read, name, solved.reference(name, values))
        verdict = earlier.seen(name, answer, solved.answers[name].check(answer, expected))
        if _free(solved, name) and verdict is RIGHT:
            chosen = _chosen(solved, {name: answer}, {name: verdict})
            with suppress(UndefinedError):  # a table without a value at the numbers of this variant
                values = solved.again(fixed={**earlier.wrong, **chosen})
                earlier.wrong |= chosen
        judged.verdicts[name] = verdict
    return judged


def _free(solved: Solved, name: str) -> bool:
    return getattr(solved.answers[name], "free", False)


def _against(solved: Solved, read: Mapping[str, Any], name: str, reference: Any) -> Any:
    """Give what an answer is judged against; a judge that stands beside another answer is handed it as it was read."""
    beside = read.get(getattr(solved.answers[name], "beside", ""))
    return reference if beside is None or isinstance(beside, Verdict) else reference.beside(beside)


def _chosen(solved: Solved, given: Mapping[str, Any], verdicts: Mapping[str, Verdict]) -> dict[str, Value | Tree]:
    """Give the right answers in which the student chose freely: what is behind them stands on his own choice."""
    carried = {
        solved.step_of(name): solved.answers[name].carried(answer)
        for name, answer in given.items()
        if _free(solved, name) and verdicts[name] is RIGHT
    }
    return {step: own for step, own in carried.items() if own is not None}


def explained(solved: Solved, read: Mapping[str, Any], judged: Judged) -> tuple[str | None, CommonSlip | None]:
    """Name what explains all that is wrong: a known slip of the exercise, a common one, or one of each."""
    given = {
        name: answer
        for name, answer in read.items()
        if not isinstance(answer, Verdict) and judged.verdicts[name].outcome is not Outcome.UNDECIDED
    }
    off = [name for name in given if judged.verdicts[name].outcome in OFF]
    if not off:
        return None, None
    seen = Seen(solved, read, judged, given, sorted(off, key=lambda name: solved.answers[name].symbolic))
    chosen, nearly = _chosen(solved, given, judged.verdicts), list[tuple[str, Predictions, list[str]]]()
    for mistake, expected in slips(solved, chosen):
        missed = seen.missed(expected)
        if missed == []:
            return mistake, None
        if missed:
            nearly.append((mistake, expected, missed))
    common = CommonSlip.FIELDS_EXCHANGED if seen.exchanged() else likeliest(seen.common(name) for name in off)
    if common:
        return None, common
    for mistake, expected, missed in nearly:
        common = likeliest(seen.beside(expected, missed))
        if common:
            return mistake, common
    if seen.in_the_other_mode():
        return None, CommonSlip.DEGREES_RADIANS
    sources = seen.sources()
    for slip, name, line in chain(islice(unasked(solved, sources), MOST_TRIED), misread(solved, sources)):
        if seen.led_by(slip, name, line, chosen):
            return None, slip
    return None, None


@dataclass(frozen=True, slots=True)
class Seen:
    """A submission beside what slips lead to; `off` are the wrong answers, the numbers first."""

    solved: Solved
    read: Mapping[str, Any]
    judged: Judged
    given: Mapping[str, Any]
    off: list[str]

    def _against(self, name: str, expected: Any) -> Any:
        return _against(self.solved, self.read, name, expected)

    def _is(self, name: str, expected: Any) -> bool:
        return is_right(self.solved.answers[name], self.given[name], expected)

    def _agrees(self, name: str, value: Value) -> bool:
        return agrees(self.solved.answers[name], self.given[name], value)

    def predicted(self, name: str, expected: Mapping[str, Any]) -> bool:
        """Tell whether an answer is the one expected; what was judged before is not judged again."""
        wanted = self._against(name, expected[name])
        if wanted == self.judged.expected[name]:
            return self.judged.verdicts[name].code is Code.RIGHT
        return self._is(name, wanted)

    def missed(self, expected: Mapping[str, Any]) -> list[str] | None:
        """Give the wrong answers that a slip does not predict; None where it predicts none, or a right one wrongly."""
        hits = {name for name in self.off if self.predicted(name, expected)}
        verdicts = self.judged.verdicts
        bound = [name for name in self.given if name not in self.off and verdicts[name].code is not Code.FOLLOWED]
        if not hits or not all(self.predicted(name, expected) for name in bound):
            return None
        return [name for name in self.given if name in self.off and name not in hits]

    def exchanged(self) -> bool:
        """Tell whether two answers stand in each other's fields."""
        moved = [name for name in self.given if self.judged.verdicts[name].code is not Code.RIGHT]
        if len(moved) != 2 or len({self.solved.answers[name].kind for name in moved}) > 1:
            return False
        one, other = moved
        if self.solved.answers[one].kind not in ("quantity", "matrix"):
            return False
        return self._agrees(one, self.judged.expected[other]) and self._agrees(other, self.judged.expected[one])

    def common(self, name: str) -> Slips:
        """Give the common slips that make a wrong answer out of the right one, or of what follows from earlier ones."""
        grader, answer, step = self.solved.answers[name], self.given[name], self.solved.step_of(name)
        found = slips_of(grader, answer, self.judged.expected[name], self.judged.verdicts[name].code)
        if grader.symbolic or step not in self.solved.steps:
            return found
        own = self.judged.own.get(name)
        if own:
            found |= slips_of(grader, answer, own[step])
        return found | self._in_its_line(name, step, own)

    def _in_its_line(self, name: str, step: str, own: Mapping[str, Value] | None) -> Slips:
        """Give the slips in the line of a step that lead to an answer."""
        found = set[CommonSlip]()
        for slip, value in slipped(self.solved, step, own):
            if slip not in found and self._agrees(name, value):
                found.add(slip)
        return frozenset() if found and own is None and self._contradicted(name, step) else frozenset(found)

    def _contradicted(self, name: str, step: str) -> bool:
        """Tell whether a right number that stands on a step would be wrong with what was typed for the step."""
        value = self.solved.answers[name].carried(self.given[name])
        return isinstance(value, float | tuple | str) and any(
            verdict is RIGHT and not self._stands(later, step, value) for later, verdict in self.judged.verdicts.items()
        )

    def _stands(self, later: str, step: str, value: Value) -> bool:
        """Tell whether an answer is right with another value of a step too."""
        behind = self.solved.step_of(later)
        if self.solved.answers[later].kind not in MEASURED or step not in self.solved.below(behind):
            return True
        try:
            return self._is(later, self.solved.onward(step, value, behind)[behind])
        except UndefinedError:
            return False

    def beside(self, expected: Predictions, missed: Iterable[str]) -> Iterator[Slips]:
        """Give the common slips that explain the answers a known slip does not; later ones may follow from them."""
        fixed: dict[str, Value | Tree] = {}
        for name in missed:
            if not (fixed and self.predicted(name, expected.following(fixed))):
                yield slips_of(self.solved.answers[name], self.given[name], self._against(name, expected[name]))
            carry(self.solved, name, self.given[name], fixed)

    def sources(self) -> frozenset[str]:
        """Give the givens and steps on which the first wrong number stands, and no right one before it."""
        solved, verdicts = self.solved, self.judged.verdicts
        before = takewhile(lambda name: name != self.off[0], self.given)
        right = [name for name in before if verdicts[name] is RIGHT and not solved.answers[name].symbolic]
        wrong, *settled = (solved.below(solved.step_of(name)) for name in (self.off[0], *right))
        return wrong.difference(*settled)

    def in_the_other_mode(self) -> bool:
        """Tell whether every wrong answer comes from sines and cosines in degrees for radians, or the other way."""
        return any(all(self._by_mode(name, *mode) for name in self.off) for mode in modes(self.solved))

    def _by_mode(self, name: str, lines: Lines, factor: float) -> bool:
        step = self.solved.step_of(name)
        if self.solved.answers[name].symbolic or step not in lines:
            return False
        found, own = in_mode(self.solved, lines, factor, step), self.judged.own.get(name)
        try:
            followed = [evaluate(lines[step], own)] if found and own is not None else []
        except UndefinedError:
            return False
        return any(self._agrees(name, value) for value in (*found, *followed))

    def led_by(self, slip: CommonSlip, name: str, line: Tree, chosen: Mapping[str, Value | Tree]) -> bool:
        """Tell whether one line, or a given that is misread, leads to every answer.

        A given misread is told by two wrong answers; by one only where it is a prefix, so far off as chance is not.
        """
        first, given = self.off[0], name not in self.solved.steps
        if self.solved.answers[first].kind not in MEASURED:
            return False
        if given and len(self.off) < 2 and slip is not CommonSlip.KILO_PREFIX:
            return False
        step = self.solved.step_of(first)
        try:
            changed = evaluate(line, self.solved.values)
            if not self._agrees(first, self.solved.onward(name, changed, step)[step]):
                return False
            expected = Predictions(self.solved, self.solved.again({name: line}, chosen), {name: line})
            return all(self.predicted(answer, expected) for answer in (self.given if given else self.off))
        except UndefinedError:
            return False


def _grade(
    solved: Solved, verdicts: dict[str, Verdict], mistake: str | None = None, slip: CommonSlip | None = None
) -> Grade:
    weights = {name: grader.weight for name, grader in solved.answers.items()}
    score = sum(weights[name] * verdict.score for name, verdict in verdicts.items()) / sum(weights.values())
    outcomes = {verdict.outcome for verdict in verdicts.values()}
    return Grade(
        verdicts=verdicts,
        score=round(score, 6),
        mistake=mistake,
        slip=slip,
        counted=any(outcome in JUDGED for outcome in outcomes),
        provisional=Outcome.UNDECIDED in outcomes,
        grader_version=GRADER_VERSION,
    )
