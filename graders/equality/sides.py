"""Both sides of the zero of one argument in a box: found by descent, or shown by branch and bound not to be there."""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from graders.judge import Domain
from graders.language.intervals import Interval
from graders.states import Point, near_end

BOXES, LEAST_BOXES = 160, 8  # of branch and bound
WIDE, FINE, FINEST = 0.25, 4e-6, 2e-14  # steps of a descent, as shares of a domain
STARTS, DEEP = 4, 8000  # descents to the finest steps where nothing was proved, and their operations
STILL = 5  # halvings without a lower value, behind which there is none near...
CLEAR = 0.01  # ...where this share of the greatest value is left
NARROWEST = 5e-11  # of the way between two points, around a border
ASIDE = (1e-3, 1e-6, 1e-10)  # distances from a border, as shares of the way between two points
END = 1e-12  # distance from the end of a domain, as a share of its width
TOUCHING = 1e-7  # of the usual size of an argument
ZERO = 1e-12  # of the usual size of an argument: what doubles leave of a zero
ROUND, NARROW = 2e-4, 2e-8  # how far from a touched zero, as a share of a domain

Box: TypeAlias = tuple[Interval, ...]
Found: TypeAlias = tuple[float, Point]


def ends(box: Sequence[Domain]) -> Box:
    """Give the places next to the ends of all domains; the ends themselves of whole numbers."""
    return tuple([(near_end(domain, False, END), near_end(domain, True, END)) for domain in box])


def whole(box: Sequence[Domain]) -> Box:
    """Give all of a box as intervals of doubles; whole numbers would grow without a bound in powers."""
    return tuple([(float(domain.low), float(domain.high)) for domain in box])


@dataclass(frozen=True, slots=True)
class Sides:
    """Points on both sides of a zero, or around one that is touched; whether what was not found is proved not to be."""

    points: tuple[Point, ...]
    touched: bool = False
    proved: bool = True


NOTHING = Sides(())


@dataclass(frozen=True, slots=True)
class Part:
    """One argument of a formula over a box.

    Attributes:
        value: Its value in doubles.
        state: Whether a point is a state.
        bounds: The interval of its values on a box.
        box: The domains of all symbols.
        ends: The places next to the ends of these, where a search stops.
        moving: Numbers of the symbols that it depends on.
        integers: Numbers of the symbols that are whole numbers.
        size: Its number of operations.
        work: Operations on intervals that its branch and bound may take.
        deep: Whether what this leaves open is followed further in doubles.
        trends: Gives which way it goes along each moving symbol; nothing where it turns back along one of them.
    """

    value: Callable[[Point], float]
    state: Callable[[Point], bool]
    bounds: Callable[[Box], Interval]
    box: tuple[Domain, ...]
    ends: Box
    moving: tuple[int, ...]
    integers: tuple[int, ...]
    size: int
    work: int
    deep: bool
    trends: Callable[[], Sequence[int]]

    def sides(self, held: Sequence[Found], one_sided: bool, edge: bool) -> Sides:
        """Give points on both sides of the zero, or around a zero that is only touched.

        Args:
            held: Values at some points.
            one_sided: No state lies where the argument has another sign.
            edge: A zero counts also where it is only touched.
        """
        if not held or not self.moving:
            return NOTHING
        low, high = min(held), max(held)
        if low[0] < 0 < high[0]:
            return Sides(self._beside(low[1], high[1]))
        sign = 1.0 if high[0] > 0 else -1.0
        start, far = (low, high) if sign > 0 else ((-high[0], high[1]), (-low[0], low[1]))
        touching, corner = TOUCHING * far[0], self._corner(start, sign)
        if corner[0] > touching:
            return NOTHING
        best, proved = self._descent(start, sign, far[0]), True
        if best[0] >= 0 and not one_sided and best[0] > (touching if edge else ZERO * far[0]):
            best, proved = self._bounded(best, sign)
        if best[0] < 0:
            return Sides(self._beside(far[1], best[1]))
        if best[0] <= touching:
            nothing, narrow = ZERO * far[0], best[0] > ZERO * far[0]
            best = self._lowered(best, sign, (FINE, FINEST), math.inf, nothing) if narrow else best
            return Sides(self._round(best[1], narrow), touched=True, proved=proved or best[0] <= nothing)
        return NOTHING if proved else Sides((), proved=False)

    def below(self, start: Found) -> Sides:
        """Give a point where the value is negative, from a start where it is not."""
        best, proved = self._descent(start, 1.0, start[0]), True
        if best[0] >= 0 and self.moving:
            best, proved = self._bounded(best, 1.0)
        return Sides((best[1],) if best[0] < 0 else (), proved=proved)

    def _corner(self, start: Found, sign: float) -> Found:
        """Give the least value times a sign where it lies at the ends of all symbols; else nothing is known."""
        point, trends = list(start[1]), self.trends()
        if not trends:
            return -math.inf, start[1]
        for at, way in zip(self.moving, trends, strict=True):
            point[at] = self.ends[at][way * sign < 0]
        return sign * self.value(tuple(point)), tuple(point)

    def _descent(self, best: Found, sign: float, usual: float) -> Found:
        """Go down until the sign changes: from corner to corner first, then by ever smaller steps."""
        for end in (0, 1, 0, 1):
            for at in self.moving:
                best = self._better(best, at, self.ends[at][end], sign)
        return self._lowered(best, sign, (WIDE, FINE), CLEAR * usual)

    def _lowered(self, best: Found, sign: float, steps: tuple[float, float], clear: float, floor: float = 0.0) -> Found:
        """Step along the symbols with ever smaller steps, from the first to the last share of a domain.

        Args:
            best: Where to start.
            sign: Of the values at the points that were looked at.
            steps: The first and the last step.
            clear: A value above which some steps without a lower one end it.
            floor: A value below which it ends.
        """
        (step, last), still = steps, 0
        while step > last and best[0] >= floor and not (still > STILL and best[0] > clear):
            before = best
            for at in self.moving:
                width = step * (self.box[at].high - self.box[at].low)
                place = best[1][at]
                best = min(self._better(best, at, place - width, sign), self._better(best, at, place + width, sign))
            still = still + 1 if best is before else 0
            step /= 2
        return best

    def _better(self, best: Found, at: int, place: float, sign: float) -> Found:
        (low, high), here = self.ends[at], best[1]
        inside = low if place < low else high if place > high else place
        if at in self.integers:
            inside = float(round(inside))
        if inside == here[at]:
            return best
        point = (*here[:at], inside, *here[at + 1 :])
        found = sign * self.value(point)
        return (found, point) if found < best[0] and self.state(point) else best

    def _moved(self, point: Point, at: int, place: float) -> Point:
        """Move one symbol, never quite to the end of its domain."""
        low, high = self.ends[at]
        inside = low if place < low else high if place > high else place
        return (*point[:at], float(round(inside)) if self.box[at].integer else inside, *point[at + 1 :])

    def _bounded(self, best: Found, sign: float) -> tuple[Found, bool]:
        """Branch and bound: a point of the other side, where one is found, and whether there is proved to be none."""
        start, seen = whole(self.box), [best]
        heap = [(self._bound(start, sign), 0, start)]
        for number in range(1, 2 * min(BOXES, max(LEAST_BOXES, self.work // (3 * self.size))), 2):
            bound, _, box = heapq.heappop(heap)
            if bound >= 0:
                return best, True
            middle = best[1]
            for at in self.moving:
                middle = self._moved(middle, at, (box[at][0] + box[at][1]) / 2)
            found = sign * self.value(middle)
            if self.state(middle):
                if found < 0:
                    return (found, middle), True
                seen.append((found, middle))
            for more, half in enumerate(self._halves(box)):
                heapq.heappush(heap, (self._bound(half, sign), number + more, half))
        return self._deep(seen, sign) if self.deep else best, False

    def _deep(self, seen: Sequence[Found], sign: float) -> Found:
        """Follow the lowest of some points down to steps as small as doubles know."""
        best, steps = min(seen), max(1, DEEP // (88 * len(self.moving) * self.size))
        for start in sorted(one for one in seen if not math.isnan(one[0]))[: min(STARTS, steps)]:
            best = min(best, self._lowered(start, sign, (WIDE, FINEST), math.inf))
            if best[0] < 0:
                break
        return best

    def _bound(self, box: Box, sign: float) -> float:
        low, high = self.bounds(box)
        bound = low if sign > 0 else -high
        return -math.inf if math.isnan(bound) else bound

    def _halves(self, box: Box) -> tuple[Box, Box]:
        """Cut a box across its widest side."""
        at = max(self.moving, key=lambda at: (box[at][1] - box[at][0]) / (self.box[at].high - self.box[at].low or 1.0))
        low, high = box[at]
        middle = (low + high) / 2
        return (*box[:at], (low, middle), *box[at + 1 :]), (*box[:at], (middle, high), *box[at + 1 :])

    def _beside(self, one: Point, other: Point) -> tuple[Point, ...]:
        """Find the border between two points of different sides, and give points on both sides of it."""
        low, high = self._border(one, other)
        shares = [share for distance in ASIDE for share in (max(0.0, low - distance), min(1.0, high + distance))]
        return tuple([self._between(one, other, share) for share in shares])

    def _border(self, one: Point, other: Point) -> tuple[float, float]:
        """Enclose the border between two points: around where a straight line would cross, else by halving."""
        low, high, start, end = 0.0, 1.0, self.value(one), self.value(other)
        first, around = start > 0, 0.4 * NARROWEST
        while high - low > NARROWEST:
            width, crossing = high - low, low + (high - low) * (start / (start - end))
            for place in (crossing - around, crossing + around, None):
                if place is None and high - low < width / 4:
                    break
                share = (low + high) / 2 if place is None else place
                if not low < share < high:
                    continue
                value = self.value(self._between(one, other, share))
                if (value > 0) is first:
                    low, start = share, value
                else:
                    high, end = share, value
            around = max(0.4 * NARROWEST, (high - low) ** 2)
        return low, high

    def _between(self, one: Point, other: Point, share: float) -> Point:
        found = [a + (b - a) * share for a, b in zip(one, other, strict=True)]
        for at in self.integers:
            found[at] = float(round(found[at]))
        return tuple(found)

    def _round(self, point: Point, narrow: bool) -> tuple[Point, ...]:
        """Step aside from a touched zero along every symbol; of a narrow one by smaller steps too."""
        widths = [
            (at, share * (self.box[at].high - self.box[at].low))
            for at in self.moving
            for share in ((ROUND, NARROW) if narrow else (ROUND,))
        ]
        return tuple([self._moved(point, at, point[at] + way) for at, width in widths for way in (-width, width)])
