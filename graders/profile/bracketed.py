"""Functions of the place along a bar, compared stretch by stretch on true states of the task.

Both sides of every place and of every bracket are tried. The states keep the topology: the places stand in the order
in which they stand in the task, inside the span.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import TypeAlias

from graders.equality import Finding, compare
from graders.judge import Formula, States
from graders.language.doubles import DOUBLES, UndefinedError, run
from graders.language.program import Builder, Runner
from graders.language.tree import Binary, Call, Number, Tree, walk
from graders.solutions.reduction import degrees

STATES = 4
MOST_CUTS = 16
SLIVER = 1e-6  # of the span
EXACT = 1e-9
GOLDEN = (math.sqrt(5) - 1) / 2
TURNING = ("macaulay", "abs", "sign")
START = Number("0")


@dataclass(frozen=True, slots=True)
class Part:
    """A typed piece: its range (None: the whole span) and its formula."""

    start: Tree | None
    end: Tree | None
    body: Tree


@dataclass(frozen=True, slots=True)
class Span:
    """Where the function lives: its variable, and the names of the places in order, the last being the end."""

    x: str
    places: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Spot:
    """A place at a state: the numbers of the state, the stretch it lies in, and the typed pieces that hold there."""

    point: tuple[float, ...]
    state: int
    stretch: int
    parts: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Tried:
    """A typed function beside the true one at all spots."""

    parts: tuple[Part, ...]
    reference: Formula
    span: Span
    spots: tuple[Spot, ...]

    @property
    def stretches(self) -> int:
        """The number of stretches between neighbouring places."""
        return max(spot.stretch for spot in self.spots) + 1

    @property
    def cut(self) -> bool:
        """Tell whether all that turns in the typed function was cut at its zero: each argument has one in x at most."""
        borders = [one for part in self.parts for one in turning(part.body)]
        straight = all(degrees(border, {}).get(self.span.x, 0) < 2 for border in borders)
        return straight and len({*borders, *turning(self.reference.tree)}) <= MOST_CUTS

    @property
    def finding(self) -> Finding:
        """Compare by balls at all spots."""
        groups: dict[int, list[tuple[float, ...]]] = defaultdict(list)
        for spot in self.spots:
            if len(spot.parts) != 1:
                return Finding.DIFFERENT
            groups[spot.parts[0]].append(spot.point)
        found = {self._group(part, points) for part, points in groups.items()}
        order = (Finding.DIFFERENT, Finding.UNDEFINED, Finding.UNDECIDED)
        return next((worse for worse in order if worse in found), Finding.EQUAL)

    def _group(self, part: int, points: Sequence[tuple[float, ...]]) -> Finding:
        states = self.reference.states
        held = Formula(self.reference.tree, States(states.names, tuple(points), states.lines))
        return compare(self.parts[part].body, held).finding

    def ordinates(self) -> Iterator[tuple[Spot, float, float]]:
        """Give the typed and the true value in doubles; no number where nothing, or more than one thing, is typed."""
        trees = [self.reference.tree, *(part.body for part in self.parts)]
        runner = _runner(self.reference.states, trees)
        for spot in self.spots:
            try:
                true, *typed = run(runner, list(spot.point))
            except UndefinedError:
                continue
            yield spot, typed[spot.parts[0]] if len(spot.parts) == 1 else math.nan, true


def tried(parts: Sequence[Part], reference: Formula, span: Span) -> Tried:
    """Lay a typed function over true states."""
    states = tuple(_ordered(point, reference.states.names, span) for point in reference.states.points[:STATES])
    borders = _borders(parts, reference)
    runner = _runner(reference.states, borders)
    ends = _runner(reference.states, [end for part in parts for end in (part.start or START, part.end or START)])
    spots: list[Spot] = []
    for number, state in enumerate(states):
        spots += _spots(number, state, parts, (runner, ends), reference.states.names, span)
    return Tried(tuple(parts), reference, span, tuple(spots))


def _runner(states: States, trees: Sequence[Tree]) -> Runner:
    builder = Builder(states.names)
    for name, line in states.lines:
        builder.define(name, line)
    return Runner(builder.program(*map(builder.add, trees)), DOUBLES)


def _borders(parts: Sequence[Part], reference: Formula) -> list[Tree]:
    """Collect what turns a branch where it changes its sign, that of the reference first."""
    found: dict[Tree, None] = {}
    for tree in (reference.tree, *(part.body for part in parts)):
        found |= dict.fromkeys(turning(tree))
    return list(found)[:MOST_CUTS]


def turning(tree: Tree) -> list[Tree]:
    """Give what turns a branch of a formula."""
    found: list[Tree] = []
    for node in walk(tree):
        if isinstance(node, Call) and node.function in TURNING:
            found.append(node.arguments[0])
        elif isinstance(node, Call) and node.function in ("min", "max"):
            found += [Binary("-", one, other) for one, other in combinations(node.arguments, 2)]
    return found


def _ordered(point: tuple[float, ...], names: Sequence[str], span: Span) -> tuple[float, ...]:
    """Move the places of a state into their order, half-way between where they are and even spacing."""
    *inner, end = (names.index(name) for name in span.places)
    length = point[end]
    raw = sorted(point[at] for at in inner)
    reach = max([1.0, *(x / (0.95 * length) for x in raw)])
    moved = {
        at: (x / reach + length * share / (len(inner) + 1)) / 2
        for share, (at, x) in enumerate(zip(inner, raw, strict=True), 1)
    }
    return tuple(moved.get(at, value) for at, value in enumerate(point))


def _spots(
    number: int,
    state: tuple[float, ...],
    parts: Sequence[Part],
    runners: tuple[Runner, Runner],
    names: Sequence[str],
    span: Span,
) -> Iterator[Spot]:
    at = names.index(span.x)
    places = [state[names.index(name)] for name in span.places]
    ranges = _ranges(state, parts, runners[1], places[-1])
    inner = {x for x in (*places, *(x for pair in ranges for x in pair)) if 0 < x < places[-1]}
    inner |= set(_roots(state, at, runners[0], places[-1]))
    for start, end in pairwise([0.0, *sorted(inner), places[-1]]):
        if end - start < SLIVER * places[-1]:
            continue
        for turn in (1, 2) if start == 0 else (1,):
            x = start + (end - start) * (0.1 + 0.8 * ((number + turn * 3) * GOLDEN % 1.0))
            holding = tuple(i for i, (low, high) in enumerate(ranges) if low < x < high)
            stretch = sum(place < x for place in places[:-1])
            yield Spot((*state[:at], x, *state[at + 1 :]), number, stretch, holding)


def _ranges(
    state: tuple[float, ...], parts: Sequence[Part], runner: Runner, length: float
) -> list[tuple[float, float]]:
    try:
        ends = run(runner, list(state))
    except UndefinedError:
        return [(0.0, 0.0) for _ in parts]
    pairs = zip(parts, ends[::2], ends[1::2], strict=True)
    return [(0.0, length) if part.start is None else (low, high) for part, low, high in pairs]


def _roots(state: tuple[float, ...], at: int, runner: Runner, length: float) -> Iterator[float]:
    """Find where the arguments of brackets vanish; they are linear in the place."""
    try:
        first, last = (run(runner, [*state[:at], x, *state[at + 1 :]]) for x in (0.0, length))
    except UndefinedError:
        return
    for low, high in zip(first, last, strict=True):
        if low * high < 0:
            yield length * low / (low - high)


Ordinates: TypeAlias = Sequence[tuple[Spot, float, float]]


@dataclass(frozen=True, slots=True)
class Differences:
    """How a function that is not the true one differs from it: seen in doubles, for explanation and credit only."""

    stretches: int
    x: int  # number of the variable in a point
    found: Ordinates

    @property
    def right(self) -> list[bool]:
        """Tell of each stretch whether both agree on it; nowhere where doubles see no difference at all."""
        off = {spot.stretch for spot, typed, true in self.found if abs(typed - true) > EXACT * (abs(typed) + abs(true))}
        held = {spot.stretch for spot, *_ in self.found} - self._left_out()
        right = [stretch in held and stretch not in off for stretch in range(self.stretches)]
        return right if not all(right) else [False] * self.stretches

    def _left_out(self) -> set[int]:
        return {spot.stretch for spot, typed, _ in self.found if math.isnan(typed)}

    @property
    def opposite(self) -> bool:
        """Tell whether the typed function is the negative of the true one."""
        return all(abs(typed + true) <= EXACT * abs(true) for _, typed, true in self.found) and bool(self.found)

    @property
    def scaled(self) -> bool:
        """Tell whether the typed function is a constant multiple of the true one at each state."""
        return self._each_state(_proportional)

    @property
    def linear(self) -> bool:
        """Tell whether at each state the two functions differ by a constant or a linear term."""
        return self._each_state(lambda group: _straight(self.x, group))

    def _each_state(self, holds: Callable[[Ordinates], bool]) -> bool:
        groups: dict[int, list[tuple[Spot, float, float]]] = defaultdict(list)
        for spot, typed, true in self.found:
            groups[spot.state].append((spot, typed, true))
        return bool(groups) and all(len(group) > 2 and holds(group) for group in groups.values())


def differences(tried_: Tried) -> Differences:
    """See in doubles how a typed function differs from the true one."""
    return Differences(tried_.stretches, tried_.reference.states.names.index(tried_.span.x), tuple(tried_.ordinates()))


def _proportional(ordinates: Ordinates) -> bool:
    ratios = [typed / true for _, typed, true in ordinates if true]
    return len(ratios) > 2 and max(ratios) - min(ratios) <= EXACT * max(map(abs, ratios)) and min(map(abs, ratios)) > 0


def _straight(at: int, ordinates: Ordinates) -> bool:
    spots = [(spot.point[at], typed - true, abs(typed) + abs(true)) for spot, typed, true in ordinates]
    (x1, d1, _), (x2, d2, _) = spots[0], spots[-1]
    scale = max(size for _, _, size in spots)
    rise = (d2 - d1) / (x2 - x1)
    return all(abs(d - d1 - rise * (x - x1)) <= EXACT * scale for x, d, _ in spots)
