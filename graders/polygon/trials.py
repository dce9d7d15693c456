"""Equations against true states, and against what they could have been meant to be at free values of all names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import cos, inf, sin

from graders.language.doubles import UndefinedError
from graders.language.parser import parse_line
from graders.language.tree import Call, Tree, names, walk
from graders.polygon.drawn import Axis, Drawn
from graders.polygon.jets import Trio, UnsureError, jet, runner
from graders.polygon.naming import Named
from graders.polygon.walks import Walk
from graders.verdict import Code, Flaw

TRUE = 1e-9  # residual over the sensitivity of the equation: true below, false above the other, open between
FALSE = 1e-6
TURNING = frozenset(("abs", "sign", "macaulay", "min", "max"))  # functions that are others elsewhere
DRAWS = 6
PAIRS = 1200  # two slips in one equation are looked for up to this many combinations
GOLDEN = 0.6180339887498949
Numbers = tuple[float, ...]
Row = Mapping[str, Trio]


class Residual:
    """Left minus right of an equation, made once and taken at many states."""

    __slots__ = ("inputs", "run", "turning")

    def __init__(self, tree: Tree) -> None:
        made = runner(tree, "sensitive")
        self.inputs, self.run = made.inputs, made.run
        self.turning = any(isinstance(node, Call) and node.function in TURNING and names(node) for node in walk(tree))

    def at(self, row: Mapping[str, float]) -> float | None:
        """Give the residual over its sensitivity: None where it has no value, infinite where a name has none.

        Raises:
            UnsureError: Rounding decides the value.
        """
        if any(name not in row for name in self.inputs):
            return inf
        try:
            ((value, size),) = self.run([(row[name], abs(row[name])) for name in self.inputs])
        except UnsureError:
            raise
        except (ValueError, ArithmeticError, TypeError):
            return None
        return abs(value) / size if size else 0.0


def truth(residual: Residual, rows: Iterable[Mapping[str, float]]) -> bool | None:
    """Tell whether left minus right vanishes at all states; None where doubles cannot tell.

    What holds at all states but turns in between may be another formula there, and is not told either.
    """
    worst, seen = 0.0, False
    for row in rows:
        try:
            found = residual.at(row)
        except UnsureError:
            seen, worst = True, inf
            continue
        if found is None:
            continue
        if not found <= FALSE:
            return False
        seen, worst = True, max(worst, found)
    return (True if worst <= TRUE and not residual.turning else None) if seen else False


def free_rows(named: Named, more: Iterable[str] = (), derived: Iterable[tuple[str, str]] = ()) -> list[dict[str, Trio]]:
    """Give values and rates that are bound by nothing, so that only equal formulas agree.

    What rests keeps no rate, and what the task derives from other names follows from them.
    """
    lines = [(name, parse_line(line)) for name, line in derived]
    every = sorted({*named.rows[0], *more})
    moves = {name: tuple(any(trio[k] for trio in named.of(name)) for k in (1, 2)) for name in named.rows[0]}
    rows = []
    for draw in range(DRAWS):
        row = {}
        for at, name in enumerate(every):
            first, second, third = (_fraction(7 * at + 3 * k + 1, draw) for k in range(3))
            speeds, pushes = moves.get(name, (True, True))
            row[name] = (0.3 + first, 0.4 + second if speeds else 0.0, 0.7 + third if pushes else 0.0)
        for name, line in lines:
            row[name] = jet(line, row)
        rows.append(row)
    return rows


def _fraction(at: int, draw: int) -> float:
    return (GOLDEN * at * (1 + 0.37 * draw) + 0.2113 * draw * draw) % 1.0


def values(tree: Tree, rows: Sequence[Row], order: int = 0) -> Numbers | None:
    """Compute a formula, or its first or second rate, at all rows; None where it has no value."""
    try:
        return tuple(jet(tree, row)[order] for row in rows)
    except (UndefinedError, KeyError):
        return None


def proportional(one: Numbers | None, other: Numbers | None) -> bool:
    """Tell whether two rows of numbers differ by a constant factor that is not zero."""
    if one is None or other is None:
        return False
    at = max(range(len(one)), key=lambda k: abs(one[k]))
    if not one[at] or not other[at]:
        return False
    return all(abs(one[k] * other[at] - other[k] * one[at]) <= TRUE * abs(one[at] * other[at]) for k in range(len(one)))


@dataclass(frozen=True, slots=True)
class Part:
    """A term of an equation: its values, and the values that known slips would give it."""

    label: str
    base: Numbers
    slips: tuple[tuple[Code, Numbers], ...]


def parts_of(drawn: Drawn, walked: Walk, axis: Axis, order: int, rows: Sequence[Row]) -> list[Part] | None:
    """Give the terms of a projection of a polygon (order 0), or of its rate; None where a vector has no value.

    Source:
        Domain VP-1 (2.4), (2.5), (2.6).
    """
    found = []
    for label, sign in walked.items():
        vector = drawn.vector(label)
        try:
            lengths = [jet(vector.length, row) for row in rows]
            angles = [jet(vector.angle, row) for row in rows]
        except (UndefinedError, KeyError):
            return None
        for base, slips in _terms(lengths, angles, axis, order):
            signed = tuple((code, _times(sign, slip)) for code, slip in slips)
            found.append(Part(label, _times(sign, base), _telling(_times(sign, base), signed)))
    return found


def _times(factor: float, numbers: Numbers) -> Numbers:
    return tuple(factor * number for number in numbers)


def _telling(base: Numbers, slips: Iterable[tuple[Code, Numbers]]) -> tuple[tuple[Code, Numbers], ...]:
    """Leave out slips that change nothing."""
    return tuple(
        (code, slip) for code, slip in slips
        if any(abs(a - b) > TRUE * (abs(a) + abs(b)) and abs(a - b) > 1e-12 for a, b in zip(base, slip, strict=True))
    )  # fmt: skip


def _terms(
    lengths: list[Trio], angles: list[Trio], axis: Axis, order: int
) -> Iterator[tuple[Numbers, list[tuple[Code, Numbers]]]]:
    """Give the terms of one vector; f is cos on x, sin on y, and g the other one."""
    turn = 0 if axis == "x" else 1
    f = [(cos(a[0]), sin(a[0]))[turn] for a in angles]
    g = [(sin(a[0]), cos(a[0]))[turn] for a in angles]
    df = [(-sin(a[0]), cos(a[0]))[turn] for a in angles]
    dg = [(cos(a[0]), -sin(a[0]))[turn] for a in angles]
    length, slide, push = ([trio[k] for trio in lengths] for k in range(3))
    spin, surge = ([trio[k] for trio in angles] for k in (1, 2))
    if order == 0:
        yield _term(Code.TERM_MISSING, Code.PROJECTION_SIGN, (length, f), (length, g))
    if order == 1:
        yield _term(Code.TERM_MISSING, Code.RATE_SIGN, (slide, f), (slide, g))
        yield _term(
            Code.TERM_MISSING, Code.RATE_SIGN, (length, df, spin), (length, dg, spin), (Code.CHAIN_RULE, (length, df))
        )
    if order == 2:
        yield _term(Code.TERM_MISSING, Code.RATE_SIGN, (push, f), (push, g))
        coriolis = tuple(2 * v * w for v, w in zip(slide, spin, strict=True))
        halved = tuple(c / 2 for c in coriolis)
        yield _term(
            Code.CORIOLIS_MISSING, Code.RATE_SIGN, (coriolis, df), (coriolis, dg), (Code.CORIOLIS_FACTOR, (halved, df))
        )
        yield _term(Code.TANGENTIAL_MISSING, Code.RATE_SIGN, (length, df, surge), (length, dg, surge))
        square = [-w * w for w in spin]
        yield _term(
            Code.CENTRIPETAL_MISSING, Code.RATE_SIGN, (length, f, square), (length, g, square),
            (Code.SQUARE_MISSING, (length, f, spin)), (Code.CHAIN_RULE, (length, f)),
        )  # fmt: skip


Factors = tuple[Sequence[float], ...]


def _term(
    missing: Code, sign: Code, right: Factors, exchanged: Factors, *others: tuple[Code, Factors]
) -> tuple[Numbers, list[tuple[Code, Numbers]]]:
    base, swap = _product(right), _product(exchanged)
    slips = [
        (missing, _times(0.0, base)),
        (sign, _times(-1.0, base)),
        (Code.SINE_COSINE, swap),
        (Code.SINE_COSINE, _times(-1.0, swap)),
    ]
    for code, factors in others:
        slips += [(code, _product(factors)), (code, _times(-1.0, _product(factors)))]
    return base, slips


def _product(factors: Factors) -> Numbers:
    found = []
    for numbers in zip(*factors, strict=True):
        total = 1.0
        for number in numbers:
            total *= number
        found.append(total)
    return tuple(found)


def total(parts: Sequence[Part]) -> Numbers:
    """Add the terms up."""
    return tuple(sum(numbers) for numbers in zip(*(part.base for part in parts), strict=True))


def diagnose(typed: Numbers | None, parts: Sequence[Part] | None, place: str, pairs: int = PAIRS) -> list[Flaw]:
    """Name the slip, or the two, or the one made in every term, that turn the right equation into the typed one."""
    if typed is None or not parts:
        return []
    right, turned = total(parts), list[Flaw]()
    for slips in _combinations(parts, pairs):
        if turned and len(slips) > 1:
            break
        changed = list(right)
        for part, _, values_ in slips:
            changed = [c - b + v for c, b, v in zip(changed, part.base, values_, strict=True)]
        if proportional(tuple(changed), typed):
            if changed[0] * typed[0] > 0:
                return _flaws(slips, place)
            turned = turned or _flaws(slips, place)  # the same slip in an equation with both sides exchanged
    return turned


Slip = tuple[Part, Code, Numbers]


def _combinations(parts: Sequence[Part], most: int) -> Iterator[tuple[Slip, ...]]:
    singles = [(part, code, numbers) for part in parts for code, numbers in part.slips]
    yield from ((slip,) for slip in singles)
    for code in dict.fromkeys(slip[1] for slip in singles):
        alike = {slip[0].label: slip for slip in reversed(singles) if slip[1] is code}
        if len(alike) > 2:
            yield tuple(reversed(alike.values()))
    tried = 0
    for one, other in combinations(singles, 2):
        if one[0] is not other[0]:
            tried += 1
            if tried > most:
                return
            yield (one, other)


def _flaws(slips: Iterable[Slip], place: str) -> list[Flaw]:
    found: dict[Code, list[str]] = {}
    for part, code, _ in slips:
        found.setdefault(code, []).append(part.label)
    return [Flaw(code, ", ".join(dict.fromkeys(labels)), place) for code, labels in found.items()]
