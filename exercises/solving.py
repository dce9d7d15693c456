"""Solving a variant: the steps in order, with some names fixed (follow-through) or some lines replaced (a mistake)."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from exercises.draw import Draw
from exercises.exercise import AnyExercise, Line, Steps, Variant
from exercises.givens import Domain, domains, numbers, words_of
from graders import Formula, Grader, States, Symbols, Value
from graders.language import Tree, parse_line
from graders.language.doubles import UndefinedError, line_runner, run
from graders.language.program import Runner, Table
from graders.language.tree import names as names_in

POINTS = 16
TRIES = 400
NO_SECRET = b"grubler"


def evaluate(line: Line | Tree, values: Mapping[str, Value]) -> Value:
    """Compute one step from the values before it.

    Raises:
        UndefinedError: The step has no finite value here.
        KeyError: A formula names something that is neither a given nor an earlier step.
    """
    if callable(line):
        return _checked(line(**{name: values[name] for name in _parameters(line)}))
    runner = _runner(line) if isinstance(line, str) else line_runner(line)
    (value,) = run(runner, [_inward(values[name]) for name in runner.inputs])
    return _checked(value.rows if isinstance(value, Table) else value)


@lru_cache(maxsize=8192)
def _runner(line: str) -> Runner:
    return line_runner(parse_line(line))


@lru_cache(maxsize=1024)
def _parameters(function: Callable[..., Value]) -> tuple[str, ...]:
    return tuple(inspect.signature(function).parameters)


def _inward(value: Value) -> Any:
    return Table(value) if isinstance(value, tuple) else value


def _checked(value: Value) -> Value:
    if isinstance(value, str):
        return value
    entries = (e for row in value for e in row) if isinstance(value, tuple) else (value,)
    if not all(math.isfinite(entry) for entry in entries):
        raise UndefinedError("not a finite value")
    return value


def solve(
    exercise: AnyExercise,
    givens: Any,
    replaced: Steps | None = None,
    fixed: Mapping[str, Value | Tree] | None = None,
) -> dict[str, Value]:
    """Solve a variant's steps in order.

    Args:
        exercise: The exercise.
        givens: The realised givens, SI units.
        replaced: Lines of a mistake, for steps or givens.
        fixed: Values or formulas of the student that stand in place of steps.

    Returns:
        The givens and the steps by name.

    Raises:
        UndefinedError: A step has no finite value.
    """
    replaced, fixed = replaced or {}, fixed or {}
    start: dict[str, Value] = {**numbers(givens), **words_of(givens)}
    values = {**start, **{name: evaluate(replaced[name], start) for name in start if name in replaced}}
    for name, line in exercise.steps_of(givens).items():
        own = fixed.get(name)
        if isinstance(own, float | tuple | str):
            values[name] = own
        else:
            values[name] = evaluate(own if own is not None else replaced.get(name, line), values)
    return values


@dataclass(slots=True)
class Solved:
    """A solved variant: values of all steps, and the reference of each answer made when it is asked for."""

    exercise: AnyExercise
    variant: Variant
    secret: bytes = NO_SECRET
    values: dict[str, Value] = field(init=False)
    answers: Mapping[str, Grader] = field(init=False)
    steps: Steps = field(init=False)
    _states: dict[str, States] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        givens = self.variant.givens
        self.steps = self.exercise.steps_of(givens)
        self.answers = self.exercise.answers_of(givens)
        self.values = solve(self.exercise, givens)

    def step_of(self, answer: str) -> str:
        """Give the step an answer asks for."""
        return self.answers[answer].step or answer

    def reference(self, answer: str, values: Mapping[str, Value] | None = None, replaced: Steps | None = None) -> Any:
        """Give what an answer is judged against: a value, or a formula with its true states.

        A replaced given leaves a formula answer as it is; only a replaced step changes it.
        """
        step = self.step_of(answer)
        made = self.exercise.references.get(answer)
        if made is not None:
            return made(self.variant.givens, values or self.values, self.states(step))
        if self.answers[answer].symbolic:
            line = (replaced or {}).get(step, self.steps[step])
            if not isinstance(line, str):
                raise TypeError(f"step {step!r} is a function; a symbolic answer needs a formula step")
            return Formula(parse_line(line), self.states(step))
        return (values or self.values)[step]

    def symbols(self, answer: str) -> Symbols:
        """Give the names an answer may use: all givens and the steps strictly before its own."""
        step = self.step_of(answer)
        givens = numbers(self.variant.givens)
        usable = [name for name, _ in self._lines(step)] if step in self.steps else []
        return Symbols([*givens, *usable], [*self.steps, *givens])

    def _lines(self, step: str) -> tuple[tuple[str, Tree], ...]:
        """Give the formula steps before a step; what stands on a function step cannot be typed."""
        known = set(numbers(self.variant.givens))
        found: list[tuple[str, Tree]] = []
        for name, line in self.steps.items():
            if name == step:
                break
            tree = parse_line(line) if isinstance(line, str) else None
            if tree is not None and names_in(tree) <= known and not isinstance(self.values[name], tuple):
                known.add(name)
                found.append((name, tree))
        return tuple(found)

    def states(self, step: str) -> States:
        """Give points of the givens' domain at which the variant's topology can be assembled."""
        if step not in self._states:
            line = self.steps.get(step, "0")
            tree = parse_line(line) if isinstance(line, str) else parse_line("0")
            self._states[step] = self._drawn(step, tree)
        return self._states[step]

    def _drawn(self, step: str, tree: Tree) -> States:
        from graders.equality import domain_test

        ranges, lines = domains(self.variant.givens), self._lines(step)
        rng = Draw(self.secret.hex(), self.variant.exercise, self.variant.seed, step)
        points: list[tuple[float, ...]] = []
        names = tuple(ranges)
        defined = domain_test(tree, names, lines)
        for turn in range(TRIES):
            point = tuple(_inside(rng, domain, turn) for domain in ranges.values())
            if defined(point):
                points.append(point)
            if len(points) == POINTS:
                ends = _ends(points, tuple(ranges.values()))
                return States(names, (*points, *filter(defined, ends)), lines)
        raise UndefinedError(f"{self.variant.exercise}: step {step!r} has values at {len(points)} of {TRIES} points")


def _ends(points: list[tuple[float, ...]], ranges: tuple[Domain, ...]) -> Iterator[tuple[float, ...]]:
    """Move each symbol in turn to both ends of its range: a bracket may open only there."""
    for at, domain in enumerate(ranges):
        step = 0.0 if domain.integer else (domain.high - domain.low) * 1e-6
        for end, point in ((domain.low + step, points[at % POINTS]), (domain.high - step, points[-1 - at % POINTS])):
            yield (*point[:at], end, *point[at + 1 :])


def _inside(rng: Draw, domain: Domain, turn: int) -> float:
    """Draw a value; the turns walk through sixteenths of the range in different orders."""
    if domain.integer:
        return float(int(domain.low) + rng.below(int(domain.high - domain.low) + 1))
    stratum = (turn * 7 + rng.below(POINTS)) % POINTS
    return domain.low + (domain.high - domain.low) * (stratum + rng.uniform(0.02, 0.98)) / POINTS
