"""The marks of a diagram: span, jumps, slopes, degree, ordinates, extremes, zeros and ends, each for itself."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

from graders.profile.polynomial import crossings, derivative
from graders.profile.stretches import Profile, Stretch, covering, highest, inner_places
from graders.remarks import Remark, Slip

SNAP = 0.002  # of the span: a border nearer than this to a true one is that one
FAR = 0.02  # of the span: a zero or an extreme may lie as far aside as rounded numbers put it
HALF = 0.5


@dataclass(frozen=True, slots=True)
class Mark:
    """One thing a diagram is judged by: the share of it that is right, and what is off."""

    share: float
    flaws: tuple[Remark, ...] = ()


@dataclass(frozen=True, slots=True)
class Pair:
    """The true and the drawn curve between two neighbouring borders; None where nothing is drawn."""

    true: Stretch
    drawn: Stretch | None


@dataclass(frozen=True, slots=True)
class Comparison:
    """A drawn diagram beside the true one, both cut at the borders of both."""

    pairs: tuple[Pair, ...]
    span: Mark
    tolerance: float
    length: float

    @property
    def right(self) -> bool:
        """Whether the drawn curve is the true one: span, degree and every ordinate."""
        return all(mark.share == 1 for mark in (self.span, degree(self), ordinates(self)))

    def marks(self) -> list[Mark]:
        """Give the marks that apply, in the order in which a lecturer would look."""
        found = [jumps(self), slopes(self), degree(self), ordinates(self), extremes(self), zeros(self), ends(self)]
        return [self.span, *(mark for mark in found if mark is not None)]

    @property
    def share(self) -> float:
        """Give the mean share of the marks that is right."""
        marks = self.marks()
        return sum(mark.share for mark in marks) / len(marks)


def compare(drawn: Profile, true: Profile, rtol: float) -> Comparison:
    """Put a drawn diagram beside the true one; borders that are nearly the true ones count as those."""
    first, last = true[0].start, true[-1].end
    length = last - first
    borders = [first, *(one.end for one in true)]
    held = sorted((_snapped(one, borders, SNAP * length) for one in drawn), key=lambda one: one.start)
    held = [one for one in held if one.end > one.start]
    inner = {x for one in held for x in (one.start, one.end) if first < x < last}
    cuts = sorted({*borders, *inner})
    pairs = tuple(
        Pair(part, covering(held, start, end))
        for start, end in pairwise(cuts)
        if (part := covering(true, start, end)) is not None
    )
    return Comparison(pairs, _span(held, first, last), rtol * highest(true), length)


@lru_cache(maxsize=256)
def idle_share(true: Profile, rtol: float) -> float:
    """Give the share of the marks that a diagram left at zero would get: it must earn nothing."""
    return compare((Stretch(true[0].start, true[-1].end, (0.0,)),), true, rtol).share


def _snapped(one: Stretch, borders: Sequence[float], near: float) -> Stretch:
    start, end = (min(borders, key=lambda border: abs(border - x)) for x in (one.start, one.end))
    start = start if abs(start - one.start) <= near else one.start
    end = end if abs(end - one.end) <= near else one.end
    return one.part(start, end)


def _span(held: Sequence[Stretch], first: float, last: float) -> Mark:
    flaws: list[Remark] = []
    reached = first
    for one in held:
        if one.start > reached:
            flaws.append(Remark(Slip.GAP, reached, one.start))
        elif one.start < reached:
            flaws.append(Remark(Slip.OVERLAP if one.start >= first else Slip.BEYOND, one.start, min(reached, one.end)))
        reached = max(reached, one.end)
    if reached < last:
        flaws.append(Remark(Slip.GAP, reached, last))
    elif reached > last:
        flaws.append(Remark(Slip.BEYOND, last, reached))
    return Mark(float(not flaws), tuple(flaws))


def _mark(judged: Iterable[Remark | None]) -> Mark | None:
    """Make a mark of what was found at each place; no mark where there was nothing to judge."""
    found = list(judged)
    flaws = tuple(flaw for flaw in found if flaw is not None)
    return Mark(1 - len(flaws) / len(found), flaws) if found else None


def jumps(seen: Comparison) -> Mark | None:
    """Judge each place inside where either curve jumps."""
    return _mark(_jumps(seen))


def _jumps(seen: Comparison) -> Iterator[Remark | None]:
    near = 2 * seen.tolerance  # a jump is the difference of two ordinates
    for one, other in pairwise(seen.pairs):
        x = other.true.start
        true = other.true.at(x) - one.true.at(x)
        if one.drawn is None or other.drawn is None:
            if abs(true) > near:
                yield Remark(Slip.LOST_JUMP, x)
            continue
        drawn = other.drawn.at(x) - one.drawn.at(x)
        if abs(true) <= near and abs(drawn) <= near:
            continue
        if abs(drawn - true) <= near:
            yield None
        elif abs(drawn) <= near:
            yield Remark(Slip.LOST_JUMP, x)
        elif abs(true) <= near:
            yield Remark(Slip.EXTRA_JUMP, x)
        else:
            yield Remark(Slip.OPPOSITE_JUMP if abs(drawn + true) <= near else Slip.JUMP, x)


def slopes(seen: Comparison) -> Mark | None:
    """Judge the slope at both ends of each stretch."""
    steepest = max(abs(slope) for pair in seen.pairs for slope in _slopes(pair.true))
    near = seen.tolerance / highest(pair.true for pair in seen.pairs) * steepest if steepest else 0.0
    return _mark(_slope(pair, max(near, 2 * seen.tolerance / seen.length)) for pair in seen.pairs)


def _slopes(one: Stretch) -> tuple[float, float]:
    rise = Stretch(one.start, one.end, derivative(one.curve))
    return rise.at(one.start), rise.at(one.end)


def _slope(pair: Pair, near: float) -> Remark | None:
    place = pair.true.start, pair.true.end
    if pair.drawn is None:
        return Remark(Slip.SLOPE, *place)
    both = list(zip(_slopes(pair.true), _slopes(pair.drawn), strict=True))
    if all(abs(true - drawn) <= near for true, drawn in both):
        return None
    opposite = all(abs(true + drawn) <= near for true, drawn in both)
    return Remark(Slip.OPPOSITE_SLOPE if opposite else Slip.SLOPE, *place)


def degree(seen: Comparison) -> Mark:
    """Judge of each stretch whether it is level, straight or curved as it should be."""
    return _mark(_degree(pair, seen.tolerance) for pair in seen.pairs) or Mark(1.0)


def _degree(pair: Pair, tolerance: float) -> Remark | None:
    place = pair.true.start, pair.true.end
    if pair.drawn is None:
        return Remark(Slip.DEGREE, *place)
    length = place[1] - place[0]
    for power in range(max(len(pair.true.curve), len(pair.drawn.curve)) - 1, 0, -1):
        true, drawn = (_rise(one, power, length) for one in (pair.true, pair.drawn))
        if true and abs(drawn) >= HALF * abs(true):
            return None  # of the same degree; how steep and how curved it is, slopes and ordinates tell
        if abs(drawn - true) > tolerance:
            return Remark(Slip.DEGREE if power == 1 else Slip.STRAIGHT if true else Slip.BENT, *place)
    return None


def _rise(one: Stretch, power: int, length: float) -> float:
    """Give what a power adds to the curve at the end of the stretch."""
    return one.curve[power] * length**power if power < len(one.curve) else 0.0


def ordinates(seen: Comparison) -> Mark:
    """Judge the ordinates at both ends of each stretch and between them."""
    return _mark(_ordinate(pair, seen.tolerance) for pair in seen.pairs) or Mark(1.0)


def _ordinate(pair: Pair, tolerance: float) -> Remark | None:
    if pair.drawn is None:
        return Remark(Slip.GAP, pair.true.start, pair.true.end)
    near = tolerance * (1 + 1e-9)
    for x in inner_places(pair.true.start, pair.true.end):
        if not abs(pair.true.at(x) - pair.drawn.at(x)) <= near:
            return Remark(Slip.ORDINATE, x)
    return None


def extremes(seen: Comparison) -> Mark | None:
    """Judge the places and ordinates where the curve turns, and its largest and smallest ordinate."""
    true, drawn = (_extremes(seen, of) for of in (lambda pair: pair.true, lambda pair: pair.drawn))
    return _mark(_met(place, drawn, seen) for place in true)


def _extremes(seen: Comparison, of: Callable[[Pair], Stretch | None]) -> list[tuple[float, float]]:
    held = [one for pair in seen.pairs if (one := of(pair)) is not None]
    turns = [
        (one.start + t, one.at(one.start + t))
        for one in held
        for t in crossings(derivative(one.curve), 0.0, one.end - one.start)
    ]
    ordinates_ = [(x, one.at(x)) for one in held for x in (one.start, one.end)] + turns
    if not ordinates_:
        return []
    outer = [max(ordinates_, key=lambda at: at[1]), min(ordinates_, key=lambda at: at[1])]
    return sorted({*turns, *(at for at in outer if abs(at[1]) > seen.tolerance)})


def _met(place: tuple[float, float], drawn: Iterable[tuple[float, float]], seen: Comparison) -> Remark | None:
    x, ordinate = place
    for at, height in drawn:
        if abs(height - ordinate) <= 2 * seen.tolerance and (
            abs(at - x) <= FAR * seen.length or _level(x, at, seen)  # a level stretch is extreme everywhere
        ):
            return None
    return Remark(Slip.EXTREME, x)


def _level(x: float, at: float, seen: Comparison) -> bool:
    low, high = sorted((x, at))
    between = [p.true for p in seen.pairs if p.true.start < high and low < p.true.end]
    ordinates_ = [one.at(place) for one in between for place in inner_places(one.start, one.end)]
    return bool(ordinates_) and max(ordinates_) - min(ordinates_) <= 2 * seen.tolerance


def zeros(seen: Comparison) -> Mark | None:
    """Judge the places inside where the curve changes its sign; those drawn too many count as well."""
    true, drawn = (_zeros(seen, of) for of in (lambda pair: pair.true, lambda pair: pair.drawn))
    lost = [x for x in true if not _near(x, drawn, seen)]
    extra = [x for x in drawn if not _near(x, true, seen)]
    return _mark([*(Remark(Slip.ZERO, x) for x in (*lost, *extra)), *[None] * (len(true) - len(lost))])


def _near(x: float, others: Iterable[float], seen: Comparison) -> bool:
    return any(abs(x - other) <= FAR * seen.length for other in others)


def _zeros(seen: Comparison, of: Callable[[Pair], Stretch | None]) -> list[float]:
    """Give the changes of sign by more than the tolerance, over jumps as well."""
    found: list[float] = []
    sign, since, crossed = 0, 0.0, list[float]()
    for pair in seen.pairs:
        one = of(pair)
        if one is None:
            continue
        inner = [one.start + t for t in crossings(one.curve, 0.0, one.end - one.start)]
        for x in sorted([*inner_places(one.start, one.end), *inner]):
            height = one.at(x)
            if abs(height) <= seen.tolerance:
                crossed += [x] if x in inner else []
                continue
            if sign and (height > 0) != (sign > 0):
                crossed += [zero for zero in inner if since < zero <= x]
                found.append(crossed[-1] if crossed else max(since, one.start))
            sign, since, crossed = (1 if height > 0 else -1), x, []
    return found


def ends(seen: Comparison) -> Mark | None:
    """Judge whether the diagram closes: its ordinates at both ends of the span."""
    return _mark(_end(pair, right, seen.tolerance) for pair, right in ((seen.pairs[0], False), (seen.pairs[-1], True)))


def _end(pair: Pair, right: bool, tolerance: float) -> Remark | None:
    x = pair.true.end if right else pair.true.start
    if pair.drawn is not None and abs(pair.true.at(x) - pair.drawn.at(x)) <= tolerance * (1 + 1e-9):
        return None
    return Remark(Slip.OPEN_END, x)
