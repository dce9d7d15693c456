"""Solving a variant: the steps in order, with some names fixed (follow-through) or some lines replaced (a mistake)."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import chain
from typing import Any, TypeAlias, TypeVar

from exercises import catalogue
from exercises.exercise import AnyExercise, Line, Steps, Variant
from exercises.givens import domains, numbers, words_of
from graders import Code, Domain, Formula, Grader, Outcome, States, Symbols, Value, Verdict
from graders.language import Tree, parse_line
from graders.language.doubles import UndefinedError, domain_test, line_runner, run
from graders.language.grids import Rows, rows_of
from graders.language.program import Runner, Table
from graders.language.text import text_of
from graders.language.tree import Grid
from graders.language.tree import names as names_in
from graders.plausible import plausible
from graders.states import drawn
from graders.verdict import FOLLOWED, RIGHT

T = TypeVar("T")
Kept: TypeAlias = tuple[tuple[str, Value], ...]
SETS = 16  # of states that are drawn for a topology
NO_SECRET = b"grubler"
Lines: TypeAlias = Mapping[str, Line | Tree]
Own: TypeAlias = Mapping[str, Value]
SEVERAL = ("diagram", "set")  # kinds that are wrong where one of several numbers is


def evaluate(line: Line | Tree, values: Mapping[str, Value]) -> Value:
    """Compute one step from the values before it.

    Raises:
        UndefinedError: The step has no finite value here.
        KeyError: A formula names something that is neither a given nor an earlier step.
    """
    if callable(line):
        return _checked(line(**{name: values[name] for name in _parameters(line)}))
    runner = _runner(line) if isinstance(line, str) else line_runner(line)
    inputs = [values[name] for name in runner.inputs]
    (value,) = run(runner, [Table(value) if isinstance(value, tuple) else value for value in inputs])
    return _checked(value.rows if isinstance(value, Table) else value)


@lru_cache(maxsize=8192)
def _runner(line: str) -> Runner:
    return line_runner(parse_line(line))


@lru_cache(maxsize=1024)
def _parameters(function: Callable[..., Value]) -> tuple[str, ...]:
    return tuple(inspect.signature(function).parameters)


def _inputs(line: Line) -> Sequence[str]:
    return _parameters(line) if callable(line) else _runner(line).inputs


def _checked(value: Value) -> Value:
    if isinstance(value, str):
        return value
    if not all(map(math.isfinite, chain.from_iterable(value) if isinstance(value, tuple) else (value,))):
        raise UndefinedError("not a finite value")
    return value


def solve(
    exercise: AnyExercise,
    givens: Any,
    replaced: Lines | None = None,
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
    return _solve(exercise.steps_of(givens), _start(givens), replaced or {}, fixed or {})


def _start(givens: Any) -> dict[str, Value]:
    return {**numbers(givens), **words_of(givens)}


def _solve(
    steps: Steps, start: Mapping[str, Value], replaced: Lines, fixed: Mapping[str, Value | Tree]
) -> dict[str, Value]:
    values = {**start, **{name: evaluate(line, start) for name, line in replaced.items() if name in start}}
    for name, line in steps.items():
        own = fixed.get(name)
        if isinstance(own, int | float | tuple | str):
            values[name] = own
        else:
            values[name] = evaluate(own if own is not None else replaced.get(name, line), values)
    return values


@dataclass(slots=True)
class Solved:
    """A solved variant: values of all steps, and the reference of each answer made when it is asked for.

    Values that were kept when the variant was dealt stand in place of what the steps give now.
    """

    exercise: AnyExercise
    variant: Variant
    secret: bytes = NO_SECRET
    kept: Kept = ()
    values: dict[str, Value] = field(init=False)
    answers: Mapping[str, Grader] = field(init=False)
    steps: Steps = field(init=False)
    _start: dict[str, Value] = field(init=False)
    _formulas: Formulas = field(init=False)
    _below: dict[str, frozenset[str]] = field(init=False, default_factory=dict)
    _known: dict[tuple[Hashable, ...], Any] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        givens = self.variant.givens
        self.steps = self.exercise.steps_of(givens)
        self.answers = self.exercise.answers_of(givens)
        self._start = _start(givens)
        self.values = self.again(fixed=dict(self.kept))
        self._formulas = self._topology()

    def again(self, replaced: Lines | None = None, fixed: Mapping[str, Value | Tree] | None = None) -> dict[str, Value]:
        """Solve the variant with some lines replaced or some steps fixed; as `solve`."""
        return _solve(self.steps, self._start, replaced or {}, fixed or {})

    def once(self, compute: Callable[[], T], *key: Hashable) -> T:
        """Compute something of this variant under a name, and give it again after that: many answer the same card."""
        if key not in self._known:
            self._known[key] = compute()
        found: T = self._known[key]
        return found

    def onward(self, name: str, value: Value, until: str) -> dict[str, Value]:
        """Change a given or a step, and solve again what stands on it, up to a step; raises UndefinedError."""
        values, touched, behind = {**self.values, name: value}, {name}, name in self._start
        for step, line in self.steps.items():
            if behind and not touched.isdisjoint(_inputs(line)):
                values[step] = evaluate(line, values)
                touched.add(step)
            if step == until:
                break
            behind = behind or step == name
        return values

    def below(self, step: str) -> frozenset[str]:
        """Give the givens and steps on which a step stands."""
        if step not in self._below:
            inputs = _inputs(self.steps[step]) if step in self.steps else ()
            self._below[step] = frozenset(inputs).union(*map(self.below, inputs))
        return self._below[step]

    def step_of(self, answer: str) -> str:
        """Give the step an answer asks for."""
        return self.answers[answer].step or answer

    def reference(self, answer: str, values: Mapping[str, Value] | None = None, replaced: Lines | None = None) -> Any:
        """Give what an answer is judged against: a value, or a formula with its true states.

        A replaced given leaves a formula answer as it is; only a replaced step changes it.
        """
        step = self.step_of(answer)
        made = self.exercise.references.get(answer)
        if made is not None:
            return made(self.variant.givens, values or self.values, self.states(step))
        if self.answers[answer].symbolic:
            line = (replaced or {}).get(step, self.steps[step])
            if callable(line):
                raise TypeError(f"step {step!r} is a function; a symbolic answer needs a formula step")
            text = line if isinstance(line, str) else text_of(line)
            return Formula(self._formulas.formula(step, text), self.states(step))
        return (values or self.values)[step]

    def symbols(self, answer: str) -> Symbols:
        """Give the names an answer may use: all givens and the steps strictly before its own."""
        return self._formulas.symbols(self.step_of(answer))

    def states(self, step: str) -> States:
        """Give points of the givens' domain at which the variant's topology can be assembled."""
        givens = self.variant.givens
        ranges = (*domains(givens).items(), *self.exercise.counts_of(givens).items())
        return _states(self._formulas, ranges, step, (self.secret, self.variant.exercise, self.variant.seed % SETS))

    def _topology(self) -> Formulas:
        """Find the formulas of this topology: their form does not depend on the numbers of the variant."""
        counted = self.exercise.counts_of(self.variant.givens)
        formulas = {name: line for name, line in self.steps.items() if isinstance(line, str) and name not in counted}
        lines = tuple((name, formulas.get(name)) for name in self.steps)
        matrices = frozenset(name for name in self.steps if isinstance(self.values[name], tuple))
        return _formulas((*self._numbers(), *counted), lines, matrices)

    def _numbers(self) -> Iterator[str]:
        return (name for name, value in self._start.items() if not isinstance(value, str))


@lru_cache(maxsize=1024)
def solved(variant: Variant, secret: bytes = NO_SECRET, kept: Kept = ()) -> Solved:
    """Solve a variant, or give it again: the same one is shown, previewed and graded in turn.

    Raises:
        UnknownExercise: No exercise has the variant's id.
    """
    return Solved(catalogue.load(variant.exercise).exercise, variant, secret, kept)


@dataclass(frozen=True, slots=True)
class Formulas:
    """The steps of a topology that are formulas: which names stand before each, and where each has a value.

    Attributes:
        givens: Names of the numeric givens.
        lines: All steps in order; None for a function.
        matrices: Names of the steps whose value is a matrix.
    """

    givens: tuple[str, ...]
    lines: tuple[tuple[str, str | None], ...]
    matrices: frozenset[str]
    _before: dict[str, tuple[tuple[str, Tree], ...]] = field(init=False, default_factory=dict, compare=False)
    _symbols: dict[str, Symbols] = field(init=False, default_factory=dict, compare=False)
    _defined: dict[str, Callable[[tuple[float, ...]], bool]] = field(init=False, default_factory=dict, compare=False)

    def before(self, step: str) -> tuple[tuple[str, Tree], ...]:
        """Give the formula steps before a step; what stands on a function step cannot be typed."""
        if step not in self._before:
            self._before[step] = tuple(self._usable(step))
        return self._before[step]

    def _usable(self, step: str) -> Iterator[tuple[str, Tree]]:
        known = set(self.givens)
        for name, line in self.lines:
            if name == step:
                break
            tree = parse_line(line) if line is not None else None
            if tree is not None and names_in(tree) <= known and name not in self.matrices:
                known.add(name)
                yield name, tree

    def formula(self, step: str, line: str) -> Tree:
        """Give the formula of a step; a matrix is multiplied out, so that every entry is one."""
        tree, grids = parse_line(line), dict[str, Rows]()
        if step not in self.matrices:
            return tree
        for name, earlier in self.lines:
            if name == step:
                break
            rows = rows_of(parse_line(earlier), grids) if name in self.matrices and earlier is not None else None
            grids |= {name: rows} if rows is not None else {}
        rows = rows_of(tree, grids)
        return tree if rows is None else Grid(rows)

    def symbols(self, step: str) -> Symbols:
        """Give the names that an answer for a step may use, and those it may not."""
        if step not in self._symbols:
            steps = dict(self.lines)
            usable = [name for name, _ in self.before(step)] if step in steps else []
            self._symbols[step] = Symbols([*self.givens, *usable], [*steps, *self.givens])
        return self._symbols[step]

    def defined(self, step: str) -> Callable[[tuple[float, ...]], bool]:
        """Give the test that tells whether a step has a value at a point of the givens."""
        if step not in self._defined:
            tree = self.formula(step, dict(self.lines).get(step) or "0")
            self._defined[step] = domain_test(tree, self.givens, self.before(step))
        return self._defined[step]


@lru_cache(maxsize=1024)
def _formulas(givens: tuple[str, ...], lines: tuple[tuple[str, str | None], ...], matrices: frozenset[str]) -> Formulas:
    return Formulas(givens, lines, matrices)


@lru_cache(maxsize=512)
def _states(
    formulas: Formulas, domains: tuple[tuple[str, Domain], ...], step: str, chance: tuple[bytes, str, int]
) -> States:
    """Draw the states of a topology; its steps, and variants whose seeds agree modulo `SETS`, share them."""
    secret, exercise, number = chance
    words = b"\x1f".join((secret, exercise.encode(), str(number).encode()))
    try:
        return drawn(dict(domains), words, formulas.defined(step), formulas.before(step))
    except UndefinedError as error:
        raise UndefinedError(f"{exercise}: step {step!r}: {error}") from error


@dataclass(slots=True)
class Earlier:
    """What a student answered before.

    Attributes:
        solved: The variant.
        wrong: Wrong values, and free choices, by step.
        right: Right answers as they were read, by name.
        own: For a wrong answer all values as they follow from the earlier wrong ones.
    """

    solved: Solved
    wrong: dict[str, Value | Tree] = field(default_factory=dict)
    right: dict[str, Any] = field(default_factory=dict)
    own: dict[str, Own] = field(default_factory=dict)

    def seen(self, name: str, answer: Any, verdict: Verdict) -> Verdict:
        """Judge an answer once more beside the earlier ones, and keep it for later ones."""
        off = verdict.outcome in (Outcome.PARTLY, Outcome.WRONG)
        if off and self._rounded(name, answer, verdict):
            verdict = RIGHT
        elif off:
            verdict = FOLLOWED if self._followed(name, answer) else verdict
            carry(self.solved, name, answer, self.wrong)
        if verdict is RIGHT and not self.solved.answers[name].symbolic:
            self.right[name] = answer
        return verdict

    def _rounded(self, name: str, answer: Any, verdict: Verdict) -> bool:
        """Tell whether an answer misses by the rounding of earlier right ones alone; one number has to come near."""
        kind = self.solved.answers[name].kind
        near = kind == "quantity" and verdict.code is Code.NOT_PRECISE
        return (near or kind in SEVERAL) and self._right(name, answer, self._from(name, self._typed()))

    def _followed(self, name: str, answer: Any) -> bool:
        """Tell whether an answer is right when solved from earlier wrong ones, and right ones as they were typed."""
        found = self._from(name, self.wrong)
        if found is None:
            return False
        self.own[name] = found
        return self._right(name, answer, found) or self._right(
            name, answer, self._from(name, self._typed() | self.wrong)
        )

    def _typed(self) -> dict[str, Value | Tree]:
        """Give the values of the right answers to the figures typed."""
        found: dict[str, Value | Tree] = {}
        for name, answer in self.right.items():
            carry(self.solved, name, answer, found)
        return found

    def _from(self, name: str, earlier: Mapping[str, Value | Tree]) -> Own | None:
        """Solve from earlier answers; None where nothing follows from them."""
        grader, step = self.solved.answers[name], self.solved.step_of(name)
        if not earlier or grader.symbolic or step not in self.solved.steps:
            return None
        fixed = {key: one for key, one in earlier.items() if key != step or not isinstance(one, float | tuple | str)}
        try:
            return self.solved.again(fixed=fixed)
        except UndefinedError:
            return None

    def _right(self, name: str, answer: Any, found: Own | None) -> bool:
        step = self.solved.step_of(name)
        return (
            found is not None
            and plausible(found[step], self.solved.values[step], counted(self.solved, step))
            and self.solved.answers[name].check(answer, found[step]).code is Code.RIGHT
        )


def counted(solved: Solved, step: str) -> bool:
    """Tell whether a step is a whole number of things, whichever answer asks for it."""
    return any(judge.kind == "integer" and solved.step_of(name) == step for name, judge in solved.answers.items())


def carry(solved: Solved, name: str, answer: Any, kept: dict[str, Value | Tree]) -> None:
    """Keep an answer for the later ones, unless its value is trivial or outside the plausible range."""
    step, carried = solved.step_of(name), solved.answers[name].carried(answer)
    if carried is None:
        return
    try:
        value = carried if isinstance(carried, float | tuple | str) else solved.again(fixed={step: carried})[step]
    except UndefinedError:
        return
    if plausible(value, solved.values[step], counted(solved, step)):
        kept[step] = carried
