"""Dealing a variant: drawing until no known mistake lands on a right answer; its stored form."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from functools import lru_cache
from itertools import zip_longest
from math import pi
from typing import Any

from exercises import catalogue
from exercises.draw import Draw, Rejected
from exercises.exercise import AnyExercise, Variant
from exercises.givens import Json, domains
from exercises.givens import dump as dump_givens
from exercises.givens import restore as restore_givens
from exercises.solving import Lines, Solved, evaluate
from graders import Value
from graders.common_slips import CommonSlip
from graders.language import Tree, parse_line
from graders.language.doubles import UndefinedError
from graders.language.tree import Binary, Call, Name, Number, Unary, mapped
from graders.line_slips import slips_in

MAX_SEED = 2**53 - 1
REDRAWS = 100
NOTHING_CHOSEN: Mapping[str, Value | Tree] = {}
TURNING = ("sin", "cos", "tan", "cot")
MISREAD = (
    (CommonSlip.OPPOSITE_SIGN, Unary("-", Number("1"))),
    (CommonSlip.KILO_PREFIX, Number("1", 3)),
    (CommonSlip.KILO_PREFIX, Number("1", -3)),
    (CommonSlip.FACTOR_TWO, Number("2")),
    (CommonSlip.FACTOR_TWO, Number("0.5")),
)
APART = 3.0  # tolerances between a mistake's prediction and the reference, in some answer


class Predictions(Mapping[str, Any]):
    """The answers that a set of steps leads to, each reference made when it is first looked at."""

    def __init__(self, solved: Solved, values: Mapping[str, Value], lines: Lines) -> None:
        self._solved, self._values, self._lines = solved, values, lines
        self._made: dict[str, Any] = {}

    def __getitem__(self, answer: str) -> Any:
        if answer not in self._made:
            self._made[answer] = self._solved.reference(answer, self._values, self._lines)
        return self._made[answer]

    def following(self, fixed: Mapping[str, Value | Tree]) -> Predictions:
        """Give the same with some steps as the student has them; without a value they are as before."""
        try:
            return Predictions(self._solved, self._solved.again(self._lines, fixed), self._lines)
        except UndefinedError:
            return self

    def __iter__(self) -> Iterator[str]:
        return iter(self._solved.answers)

    def __len__(self) -> int:
        return len(self._solved.answers)


class DrawError(RuntimeError):
    """An exercise refused a hundred draws in a row: its author must widen the draw."""


def deal(exercise_id: str, seed: int) -> Variant:
    """Deal the variant of a seed.

    Raises:
        UnknownExercise: No exercise has this id.
        ValueError: The seed is not a whole number from 0 to 2^53 - 1.
        DrawError: A hundred draws in a row were refused.
    """
    if isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed <= MAX_SEED:
        raise ValueError(f"seed {seed!r} is not a whole number from 0 to {MAX_SEED}")
    exercise = catalogue.load(exercise_id).exercise
    for turn in range(REDRAWS):
        try:
            givens = exercise.draw(Draw(exercise_id, seed, turn))
            variant = Variant(exercise_id, exercise.version, seed, givens)
            if told_apart(Solved(exercise, variant)):
                return variant
        except (Rejected, UndefinedError):
            continue
    raise DrawError(f"{exercise_id}: seed {seed} was refused {REDRAWS} times")


def predictions(solved: Solved) -> dict[str, Predictions]:
    """Give the answers each mistake leads to; a mistake without occasion or without a value is left out."""
    return dict(slips(solved))


def slips(solved: Solved, chosen: Mapping[str, Value | Tree] = NOTHING_CHOSEN) -> Iterator[tuple[str, Predictions]]:
    """Solve one mistake after the other, so that who has found his need not solve the rest.

    Args:
        solved: The variant.
        chosen: Right answers of the student in which he chose freely (frames of a chain), by their step.
    """
    if chosen:
        yield from _slips(solved, chosen)
    else:
        yield from solved.once(lambda: tuple(_slips(solved, chosen)), "slips")


def _slips(solved: Solved, chosen: Mapping[str, Value | Tree]) -> Iterator[tuple[str, Predictions]]:
    for name, mistake in solved.exercise.mistakes.items():
        lines = mistake.lines(solved.variant.givens)
        if not lines:
            continue
        try:
            yield name, Predictions(solved, solved.again(replaced=lines, fixed=chosen), lines)
        except UndefinedError:
            continue


def slipped(
    solved: Solved, step: str, own: Mapping[str, Value] | None
) -> Iterable[tuple[CommonSlip, Value]]:  # fmt: skip
    """Give what the line of a step leads to with a slip in one place, from own earlier values or the right ones."""
    if own:
        return _slipped(solved, step, own)
    return solved.once(lambda: tuple(_slipped(solved, step, solved.values)), "slipped", step)


def _slipped(solved: Solved, step: str, values: Mapping[str, Value]) -> Iterator[tuple[CommonSlip, Value]]:
    line = solved.steps[step]
    for slip, changed in slips_in(parse_line(line)) if isinstance(line, str) else ():
        with suppress(UndefinedError):
            yield slip, evaluate(changed, values)


def in_mode(solved: Solved, lines: Lines, factor: float, step: str) -> tuple[Value, ...]:
    """Give the value of a step where it alone, and where all lines are done in the other mode; none without a value."""

    def values() -> tuple[Value, ...]:
        with suppress(UndefinedError):
            return tuple(solved.again(replaced=source)[step] for source in ({step: lines[step]}, lines))
        return ()

    return solved.once(values, "mode", factor, step)


def modes(solved: Solved) -> Iterator[tuple[Lines, float]]:
    """Write the steps as a calculator does them that is set to radians where degrees are typed, and the other way; with
    the factor of the angles."""
    for factor in (180 / pi, pi / 180):
        turned = {name: _in_mode(line, factor) for name, line in solved.steps.items() if isinstance(line, str)}
        lines = {name: tree for name, tree in turned.items() if tree is not None}
        if lines:
            yield lines, factor


@lru_cache(maxsize=2048)
def _in_mode(line: str, factor: float) -> Tree | None:
    """Scale the arguments of sines, cosines and tangents; None for a line without them."""
    times, tree = Number(repr(factor)), parse_line(line)

    def scaled(node: Tree) -> Tree:
        if isinstance(node, Call) and node.function in TURNING:
            return Call(node.function, (Binary("*", node.arguments[0], times),))
        return node

    found = mapped(tree, scaled)
    return None if found == tree else found


def unasked(solved: Solved, names: frozenset[str]) -> Iterator[tuple[CommonSlip, str, Tree]]:
    """Write lines that are not asked for with a slip in one place of each; from every line in turn."""
    hidden = names - {solved.step_of(name) for name in solved.answers}
    lines = {name: line for name, line in solved.steps.items() if name in hidden and isinstance(line, str)}
    slipped = ([(slip, name, changed) for slip, changed in slips_in(parse_line(line))] for name, line in lines.items())
    yield from (one for turn in zip_longest(*slipped) for one in turn if one)


def misread(solved: Solved, names: frozenset[str]) -> Iterator[tuple[CommonSlip, str, Tree]]:
    """Write givens with a wrong prefix, at double or half their size, with the opposite sign."""
    for name, domain in domains(solved.variant.givens).items():
        if name in names and not domain.integer:
            yield from ((slip, name, Binary("*", Name(name), factor)) for slip, factor in MISREAD)


def told_apart(solved: Solved) -> bool:
    """Tell whether every mistake differs from the reference and from the others in at least one answer."""
    known = [Predictions(solved, solved.values, {})]
    for _, one in slips(solved):
        if not all(differ(solved, other, one) for other in known):
            return False
        known.append(one)
    return True


def differ(solved: Solved, one: Mapping[str, Any], other: Mapping[str, Any]) -> bool:
    """Tell whether two sets of answers are at least three tolerances apart somewhere; numbers are compared first."""
    for name in sorted(solved.answers, key=lambda answer: solved.answers[answer].symbolic):
        expected, other_one = one[name], other[name]
        if expected is not other_one and solved.answers[name].apart(expected, other_one) >= APART:
            return True
    return False


def dump(variant: Variant) -> dict[str, Json]:
    """Write a variant as JSON values."""
    return {
        "exercise": variant.exercise,
        "version": variant.version,
        "seed": variant.seed,
        "givens": dump_givens(variant.givens),
    }


def restore(stored: Mapping[str, Json]) -> Variant:
    """Build a variant from its stored form; the realised givens rule, not the seed."""
    exercise: AnyExercise = catalogue.load(stored["exercise"]).exercise
    givens = restore_givens(exercise.givens, stored["givens"])
    return Variant(stored["exercise"], stored["version"], stored["seed"], givens)
