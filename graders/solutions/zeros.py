"""Zeros of one residual along one symbol, enclosed in balls and proved by a change of sign of a continuous function."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field

from flint import arb

from graders.language.balls import precision
from graders.language.program import Program
from graders.solutions.closing import closed_in, lowest, polished
from graders.solutions.scene import Side, exact

NODES = 65
DELTA = arb(2) ** -140  # of the range: how far from a zero its sign is tested
NEAR, FAR = arb(2) ** -88, arb(2) ** -40  # of the range: where another residual is compared with its value at a zero
TINY = arb(2) ** -150
STEEP = arb(2) ** 20
CLOSED, CLOSE = 1e-13, 1e-10  # of the way: how far a change of sign is followed in doubles; where balls go on alone
ROUGH = 2.0**-32  # of the range: how far from a zero in doubles its sign is tested
SURE, HALVES = 128, 115  # bits up to which a ball that is finite means continuous; how often a way is halved
AWAY = 1e-6  # of the greater value at an end: with less at the other one there may be a zero after all


@dataclass(frozen=True, slots=True)
class Zero:
    """A zero of a side.

    Attributes:
        point: The point, with balls for coordinates.
        free: The symbols along which it was found.
        base: A point of the line on which it was found, if there is one.
        both: Whether it is known to be a zero of the other side, too.
    """

    point: tuple[arb, ...]
    free: tuple[int, ...]
    base: tuple[float, ...] = ()
    both: bool = False

    def named(self, names: Sequence[str]) -> tuple[tuple[str, float], ...]:
        """Give the point as a witness."""
        return tuple((name, float(x)) for name, x in zip(names, self.point, strict=True))


@dataclass(slots=True)
class Line:
    """One residual of a side along one symbol through a point of the box."""

    side: Side
    base: Sequence[float]
    at: int
    index: int = 0
    exactly: list[arb] = field(init=False)  # its points, but for the symbol
    doubly: list[float] = field(init=False)

    def __post_init__(self) -> None:
        self.exactly, self.doubly = list(exact(tuple(self.base))), list(self.base)

    def ball(self, x: arb) -> arb | None:
        """Enclose the value at a place."""
        self.exactly[self.at] = x
        return self.side.ball(self.exactly, self.index)

    def double(self, x: float) -> float:
        """Give the value in doubles; NaN where it has none."""
        self.doubly[self.at] = x
        values = self.side.doubles(self.doubly)
        return values[self.index] if values else math.nan

    @property
    def ends(self) -> tuple[float, float]:
        """Give the range of the symbol."""
        return self.side.scene.ranges[self.at]

    def zero(self, x: arb) -> Zero:
        """Give the zero at a place."""
        self.exactly[self.at] = x
        return Zero(tuple(self.exactly), (self.at,), tuple(self.base))


@dataclass(frozen=True, slots=True)
class Straight:
    """What an affine residual shows along a symbol: its zero, if it has one inside the range."""

    zero: Zero | None


def straight(line: Line) -> Straight | None:
    """Find the zero of a residual that is affine in the symbol; None where it is not affine."""
    low, high = line.ends
    width = high - low
    if not width:
        return None
    one, two, between = (arb(low) + arb(width) * share for share in (0.23, 0.81, 0.57))
    first, second = line.ball(one), line.ball(two)
    if first is None or second is None:
        return None
    slope = (second - first) / (two - one)
    middle = line.ball(between)
    if middle is None or not negligible(first + slope * (between - one) - middle, (first, second, middle)):
        return None
    if slope.contains(0):
        return Straight(None)
    place = one - first / slope
    if not line.side.scene.inside(line.at, place):
        return Straight(None)
    there = line.ball(place)  # beyond a bend the straight line does not go on
    return Straight(line.zero(place)) if there is not None and there.contains(0) else None


def crossing(line: Line) -> Zero | None:
    """Give the zero of a residual that is affine in the symbol as it is written, if there is one in the range."""
    low, high = line.ends
    one, two = arb(low), arb(low) + arb(high - low) * 0.81
    first, second = line.ball(one), line.ball(two)
    if first is None or second is None or (second - first).contains(0):
        return None
    place = one - first * (two - one) / (second - first)
    return line.zero(place) if line.side.scene.inside(line.at, place) else None


def parabola(line: Line) -> list[Zero] | None:
    """Give the zeros in the range of a residual that is quadratic in the symbol as it is written; None where unsure."""
    low, high = line.ends
    half, middle = arb(high - low) / 2, (arb(low) + arb(high)) / 2
    first, here, last = (line.ball(middle + half * share) for share in (-1, 0, 1))
    if first is None or here is None or last is None:
        return None
    bend, slope = first + last - here * 2, last - first  # of twice the residual, over shares of half the range
    square = slope * slope - bend * here * 8
    if bend.contains(0):
        return None
    if negligible(square, (slope * slope,)):
        places = [arb((middle - half * slope / (bend * 2)).mid(), NEAR * half)]
    elif square.contains(0):
        return None
    else:
        root = square.sqrt()
        places = [middle + half * (way - slope) / (bend * 2) for way in (-root, root)] if square > 0 else []
    return [line.zero(place) for place in places if line.side.scene.inside(line.at, place)]


def inside(first: float, middle: float, last: float) -> tuple[bool, ...]:
    """Tell of a parabola, by its values at both ends of a range and in the middle, which of its zeros lie there."""
    bend, slope = first + last - 2 * middle, last - first
    square = slope * slope - 8 * bend * middle
    if not (square >= 0 and bend):
        return ()
    return tuple([abs(way * math.sqrt(square) / abs(bend) - slope / bend) <= 2 for way in (-1, 1)])


def never(_: Zero) -> bool:
    """Take no zero in doubles for near enough."""
    return False


def each_way(values: Sequence[tuple[float, ...]], most: int) -> list[int]:
    """Choose some parabolas for each way in which zeros lie in the range, by their values as `inside` takes them."""
    told: dict[tuple[bool, ...], list[int]] = {}
    for k, three in enumerate(values):
        told.setdefault(inside(*three), []).append(k)
    return [k for way, alike in told.items() if any(way) for k in alike[:most]]


def only(line: Line, enough: Callable[[Zero], bool] = never) -> Zero | None:
    """Give the zero of a residual that only rises or only falls along the symbol, if there is one in the range.

    Args:
        line: The residual and the symbol.
        enough: Tells of a zero in doubles whether it is near enough.
    """
    (a, b), (before, after) = line.ends, map(line.double, line.ends)
    if not before * after < 0:
        return None
    width, start = arb(b) - arb(a), closed_in(line.double, (a, b), (before, after), CLOSE)
    rough = _roughly(line, start)
    if rough is not None and enough(rough):
        return rough
    place = polished(line.ball, arb(start), width)
    if place is None or not line.side.scene.inside(line.at, place):
        return rough
    return _between_signs(line, place, DELTA * width) or rough


def _roughly(line: Line, start: float) -> Zero | None:
    """Give a zero that is known in doubles, if it lies inside the range."""
    low, high = line.ends
    step = ROUGH * (high - low)
    return _between_signs(line, arb(start), arb(step)) if low < start - step and start + step < high else None


def _between_signs(line: Line, place: arb, step: arb) -> Zero | None:
    """Give a zero by the opposite signs a step before and behind a place."""
    left, right = line.ball(place - step), line.ball(place + step)
    if left is None or right is None or not left * right < 0:
        return None
    return line.zero(arb(place.mid(), step))


def away(line: Line) -> bool:
    """Tell in doubles whether a residual that is affine in the symbol has one sign at both ends of the range."""
    return same_side(*map(line.double, line.ends))


def same_side(before: float, after: float) -> bool:
    """Tell of the values of an affine residual at both ends whether it has one sign between them."""
    return before * after > 0 and min(abs(before), abs(after)) > AWAY * max(abs(before), abs(after))


def negligible(value: arb, beside: Sequence[arb]) -> bool:
    """Tell whether a ball is zero beside others."""
    return bool(value.contains(0) and value.abs_upper() <= TINY * max(other.abs_upper() for other in beside))


def scanned(line: Line, nodes: int = NODES, known: Sequence[Zero] = ()) -> Iterator[Zero]:
    """Find the zeros of a residual along a symbol, also those it touches without a change of sign.

    Args:
        line: The residual and the symbol.
        nodes: How many values are looked at.
        known: Zeros of it on the line; where one of them stands, no other is looked for.
    """
    low, high = line.ends
    places = [low + (high - low) * k / (nodes - 1) for k in range(nodes)]
    index = line.side.only[line.index] if line.side.only else line.index
    values = line.side.pair.along((line.side.which, index), line.base, line.at, places)
    sizes = list(map(abs, values))
    for k in range(nodes - 1):
        ends = places[k], places[k + 1]
        if values[k] * values[k + 1] < 0 or (values[k] == 0) != (values[k + 1] == 0):
            yield from _told(line, ends, known) or _between(line, ends, (values[k], values[k + 1]))
        elif k and sizes[k - 1] > sizes[k] <= sizes[k + 1] and _dips(values[k - 1], values[k], values[k + 1]):
            ends = places[k - 1], places[k + 1]
            touched = next(iter(_told(line, ends, known)), None) or touching(line, *ends)
            if touched is not None:
                yield touched


def _told(line: Line, ends: tuple[float, float], known: Sequence[Zero]) -> list[Zero]:
    """Give the only zero between two places that is known."""
    found = [zero for zero in known if ends[0] < float(zero.point[line.at]) < ends[1]]
    return found if len(found) == 1 else []


def _dips(before: float, here: float, after: float) -> bool:
    """Tell of a value that is less in size than those beside it whether they are of its sign and it is near to zero."""
    if not (before * here > 0 and here * after > 0):
        return False
    bend, slope = before - 2 * here + after, (after - before) / 2
    return abs(here - slope * slope / (2 * bend)) < abs(here) / 2 or abs(here) < (abs(before) + abs(after)) / 8


def _between(line: Line, ends: tuple[float, float], values: tuple[float, float]) -> Iterator[Zero]:
    """Close in on a change of sign, then prove it."""
    start = ends[values.index(0)] if 0 in values else closed_in(line.double, ends, values, CLOSED)
    near = proved(line, start) or steep(line, start)
    if near is not None:
        yield near


def proved(line: Line, start: float | arb) -> Zero | None:
    """Polish a zero by secant steps in balls and prove it: opposite signs beside it, and no jump or pole there."""
    low, high = line.ends
    width = arb(high) - arb(low)
    place = polished(line.ball, arb(start), width)
    if place is None or not line.side.scene.inside(line.at, place):
        return None
    step = DELTA * width
    left, right, further = line.ball(place - step), line.ball(place + step), line.ball(place - step * STEEP)
    if left is None or right is None or further is None or left.contains(0) or right.contains(0):
        return None
    if (left > 0) == (right > 0) or not abs(further) > abs(left) * 64:
        return None
    enclosure = arb(place.mid(), step)
    return line.zero(enclosure) if line.ball(enclosure) is not None else None


def steep(line: Line, start: float) -> Zero | None:
    """Prove a zero that steps do not close in on by halves; where that fails its place is known in doubles only."""
    if jumps(line.side.pair.program):
        return None
    rough, width = _roughly(line, start), arb(line.ends[1]) - arb(line.ends[0])
    with precision(SURE):  # below it nothing is cut at the edge of a domain: finite means continuous
        if rough is None or line.ball(rough.point[line.at]) is None:
            return None
    return _between_signs(line, _halved(line, arb(start), ROUGH * width), DELTA * width) or rough


def jumps(program: Program) -> bool:
    """Tell whether a program may change its sign at a jump: its balls are finite there."""
    return any(
        name in ("sign", "atan2") or (name == "macaulay" and not _opens(program, arguments[1]))
        for name, arguments in program.operations
    )


def _opens(program: Program, order: int) -> bool:
    """Tell the order of a bracket that opens without a jump: a number above zero."""
    return order < 0 and bool(program.literals[-1 - order].digits.strip("0."))


def _halved(line: Line, place: arb, step: arb) -> arb:
    """Halve the way between opposite signs."""
    before = line.ball(place - step)
    for _ in range(HALVES):
        step /= 2
        value = line.ball(place)
        same = value is not None and before is not None and value * before > 0
        place = (place + step if same else place - step).mid()
    return place


def secant(line: Line, start: float) -> Zero | None:
    """Polish a zero near a place; its last step is far below its distance from any other one that is told apart."""
    low, high = line.ends
    place = polished(line.ball, arb(start), arb(high) - arb(low))
    if place is None or not line.side.scene.inside(line.at, place):
        return None
    return line.zero(arb(place.mid(), DELTA * (high - low)))


def touching(line: Line, low: float, high: float) -> Zero | None:
    """Find a zero that a residual touches: where its slope is zero, the value is zero to the last figure."""
    width = arb(line.ends[1]) - arb(line.ends[0])
    start = lowest(line.double, low, high)
    scale = max(abs(line.double(low)), abs(line.double(high)))
    if not abs(line.double(start)) < 1e-6 * scale:
        return None
    step = width * arb(2) ** -70

    def slope(x: arb) -> arb | None:
        after, before = line.ball(x + step), line.ball(x - step)
        return None if after is None or before is None else after - before

    place = polished(slope, arb(start), width)
    value = line.ball(place) if place is not None else None
    if place is None or value is None or not value.contains(0) or value.abs_upper() > arb(2) ** -120 * scale:
        return None
    return line.zero(arb(place.mid(), NEAR * width)) if line.side.scene.inside(line.at, place) else None
