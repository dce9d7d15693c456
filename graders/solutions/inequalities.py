"""Whether two inequalities, also chained ones, hold at the same points of a box.

They are tested inside, exactly on every border that is found, and between neighbouring borders of both.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from itertools import islice, pairwise, product
from typing import TypeAlias

from flint import arb

from graders.equality import Finding
from graders.equality.turns import EDGES
from graders.language.balls import precision
from graders.language.tree import Binary, Relation, Tree
from graders.solutions.beside import SLANT, Beside, beside
from graders.solutions.branches import Branches, branch_starts
from graders.solutions.descent import descended
from graders.solutions.found import EQUAL, UNDECIDED, Found
from graders.solutions.reduction import BENT, degrees_along
from graders.solutions.scene import (
    BITS,
    Effort,
    Residuals,
    Scene,
    Side,
    TooMuchWork,
    exactly,
    extreme,
    moved,
    used_symbols,
)
from graders.solutions.zeros import Line, Zero, crossing, parabola, scanned, straight

ORDERS = {"<": (True, True), "<=": (True, False), ">": (False, True), ">=": (False, False)}  # below, strict
LINES = 4  # points through which borders are looked for
NODES = 33
NUDGE = 2.0**-30  # of a range
ASIDE = 0.43  # of the way between two borders: the middle may be a special place
BESIDE = 1e-4  # of the way: so near to a border a side has the value that it has there
MOST_BRANCHES = 40  # points in branches, through which borders are looked for
MOST = 6  # borders of one line
MOST_CORNERED, CORNER = 5, 1e-3  # symbols whose corners are tested, and how far inside
EDGE = 1e-6  # of a range: nearer to an end of it a border does not count
STEEP = 8  # points from which a border that no line met is looked for
INEQUALITY_WORK = 30_000
ENDING = EDGES | {"asin", "acos", "^"}  # these have no value somewhere
Place: TypeAlias = tuple[int, int]  # a side and one of its residuals


def is_inequality(tree: Tree) -> bool:
    """Tell whether a tree is an inequality or a chain of them."""
    return isinstance(tree, Relation) and all(operator in ORDERS for operator in tree.operators)


def compare_inequalities(answer: Relation, reference: Relation, scene: Scene, near: Sequence[float] = ()) -> Found:
    """Compare where two inequalities hold in a box.

    Args:
        answer: The inequality to judge.
        reference: The inequality it should be equal to.
        scene: The box.
        near: A point that is tested first: where two like them differ.
    """
    if answer == reference:
        return EQUAL
    with precision(BITS):
        try:
            return Regions(scene, reference, answer, near).known()
        except TooMuchWork:
            return UNDECIDED


class Regions:
    """The regions in which the reference and the answer hold."""

    def __init__(self, scene: Scene, reference: Relation, answer: Relation, near: Sequence[float] = ()) -> None:
        self.scene, self.first = scene, [near] if near else []
        trees = [[Binary("-", a, b) for a, b in pairwise(chain.sides)] for chain in (reference, answer)]
        self.orders = [[ORDERS[operator] for operator in chain.operators] for chain in (reference, answer)]
        self.effort = Effort(INEQUALITY_WORK)
        self.both = Residuals(scene, trees, self.effort)
        self.sides = (Side(self.both, 0), Side(self.both, 1))
        self.trees = [tree for side in trees for tree in side]
        self.met = set[Place]()  # residuals of which a border was met
        self.degrees = dict[int, list[int]]()  # of all slots, by the symbol
        self._residuals = [(which, index) for which in (0, 1) for index in range(len(trees[which]))]
        self.unsure = self.seen = False  # whether lines along all symbols were tested through some point

    def known(self) -> Found:
        """Compare, and give equality up where a branch may have been missed."""
        found = self.compared()
        return found if found.finding is not Finding.EQUAL or self.found.proved else UNDECIDED

    @cached_property
    def found(self) -> Branches:
        """Give points on both sides of everything that turns in one of the two."""
        return branch_starts(self.scene, (self.both.sides[0], self.both.sides[1]), self.effort, MOST_BRANCHES)

    def compared(self) -> Found:
        """Test points inside, on the borders and between them."""
        points = [*self.first, *extreme(self.scene), *self._corners()]
        found = self._inside(points) or self._inside(self.found.points)
        if found is not None:
            return found
        lines = [*islice(extreme(self.scene), LINES), *self.found.points]
        try:
            return self._across(lines)
        except TooMuchWork:
            return EQUAL if self.seen and not self.unsure else UNDECIDED

    def _inside(self, points: Sequence[Sequence[float]]) -> Found | None:
        """Test points; what differs at one of them alone does not decide."""
        for point in exactly(points):
            found = self._tested(point)
            if found is not None and self._tested(self._nudged(point)) is not None:
                return found
        return None

    def _corners(self) -> Iterator[list[float]]:
        """Give the corners of the box over the symbols that count, a little inside."""
        used = used_symbols(self.scene, self.trees)[:MOST_CORNERED]
        for shares in product((CORNER, 1 - CORNER), repeat=len(used)):
            point = list(self.scene.points[0])
            for at, share in zip(used, shares, strict=True):
                low, high = self.scene.ranges[at]
                point[at] = low + share * (high - low)
            yield point

    def _across(self, starts: Sequence[Sequence[float]]) -> Found:
        """Test borders and stretches on lines along every symbol."""
        for start in starts:
            for at in used_symbols(self.scene, self.trees):
                found = self._along(start, at)
                if found is not None:
                    return found
            self.seen = True
        return self._elsewhere() or (UNDECIDED if self.unsure else EQUAL)

    def _elsewhere(self) -> Found | None:
        """Test borders that no line has met, where steps down a slope lead to them."""
        used = used_symbols(self.scene, self.trees)
        for place in self._residuals:
            side = Side(self.both, place[0], place[1:])
            starts = () if place in self.met else islice(extreme(self.scene), STEEP)
            zeros = (descended(side, start, used) for start in starts)
            inner = (zero for zero in zeros if zero is not None and self._within(zero, used))
            for zero in islice(inner, 2):
                found = self._on_border(place, zero, {})
                if found is not None:
                    return found
        return None

    def _within(self, zero: Zero, used: Sequence[int]) -> bool:
        """Tell whether a zero lies inside the box: what differs on its boundary alone does not decide."""
        room = ((at, EDGE * self.scene.width(at)) for at in used)
        ranges, point = self.scene.ranges, zero.point
        return all(bool(point[at] > ranges[at][0] + by) and bool(point[at] < ranges[at][1] - by) for at, by in room)

    def _nudged(self, point: Sequence[arb]) -> list[arb]:
        """Give a point close by: what differs at a single point alone does not decide."""
        return [x + NUDGE * SLANT**at * self.scene.width(at) for at, x in enumerate(point)]

    def _along(self, start: Sequence[float], at: int) -> Found | None:
        """Test the borders along a symbol and the stretches between them."""
        places, shared = list[arb](), dict[Place, list[Zero]]()
        for place in self._residuals:
            for zero in self._zeros(place, start, at, shared.get(place, [])):
                self.met.add(place)
                if not any(zero.point[at].overlaps(known.point[at]) for known in shared.get(place, [])):
                    places.append(zero.point[at])
                    found = self._on_border(place, zero, shared)
                    if found is not None:
                        return found
        places.sort(key=lambda place: float(place.mid()))
        low, high = self.scene.ranges[at]
        for one, two in pairwise([arb(low), *places, arb(high)]):
            if not one.overlaps(two):
                found = self._between(start, at, one, two)
                if found is not None:
                    return found
        return None

    def _between(self, start: Sequence[float], at: int, one: arb, two: arb) -> Found | None:
        """Test a stretch between two borders; near its ends too where a side may begin to have a value within it."""
        for share in self._shares:
            middle = arb((one.mid() + share * (two.mid() - one.mid())).mid())
            found = self._tested(moved([arb(x) for x in start], at, middle))
            if found is not None:
                return found
        return None

    @cached_property
    def _shares(self) -> tuple[float, ...]:
        ends = any(name in ENDING for name, _ in self.both.program.operations)
        return (ASIDE, BESIDE, 1 - BESIDE) if ends else (ASIDE,)

    def _zeros(self, place: Place, start: Sequence[float], at: int, known: Sequence[Zero]) -> Iterable[Zero]:
        """Give the zeros of a residual on a line; those that are known are not looked for again."""
        line, degree = Line(self.sides[place[0]], start, at, place[1]), self._degree(place, at)
        if degree < BENT:
            zeros = parabola(line) if degree == 2 else [crossing(line)] if degree else []
            if zeros is not None:
                return [zero for zero in zeros if zero is not None]
        found = straight(line)
        if found is None:
            return islice(scanned(line, NODES, known), MOST)
        return [] if found.zero is None else [found.zero]

    def _degree(self, place: Place, at: int) -> int:
        """Give the degree of a residual in a symbol, as it is written."""
        if at not in self.degrees:
            self.degrees[at] = degrees_along(self.both.program, at)
        return self.degrees[at][self.both.program.outputs[self.both.starts[place[0]] + place[1]]]

    def _on_border(self, place: Place, zero: Zero, shared: dict[Place, list[Zero]]) -> Found | None:
        """Test a point where a residual is zero; others that are zero there are found by how they behave around it.

        Args:
            place: The residual.
            zero: The point.
            shared: Takes the zero for those others.
        """
        zeros, missing = {place}, set[Place]()
        for other in self._residuals:
            value = self.sides[other[0]].ball(zero.point, other[1])
            if other not in zeros and (value is None or value.contains(0)):
                state = beside(Side(self.both, other[0], other[1:]), zero)
                if state is Beside.ZERO:
                    zeros.add(other)
                    shared.setdefault(other, []).append(zero)
                elif value is None:
                    missing.add(other)
                elif state is Beside.UNSURE:
                    self.unsure = True
                    return None
        return self._tested([arb(x.mid()) for x in zero.point], frozenset(zeros), frozenset(missing))

    def _tested(
        self, point: Sequence[arb], zeros: frozenset[Place] = frozenset(), missing: frozenset[Place] = frozenset()
    ) -> Found | None:
        """Compare where a point lies; None where both say the same or it is not known."""
        gone = [any(place[0] == which for place in missing) for which in (0, 1)]
        here = [False if gone[which] else self._holds(which, point, zeros) for which in (0, 1)]
        if here[0] is None or here[1] is None:
            self.unsure = self.unsure or bool(zeros)
            return None
        if here[0] == here[1]:
            return None
        witness = tuple((name, float(x)) for name, x in zip(self.scene.names, point, strict=True))
        return Found(Finding.DIFFERENT, witness, lost=here[0])

    def _holds(self, which: int, point: Sequence[arb], zeros: frozenset[Place]) -> bool | None:
        """Tell whether an inequality holds at a point; where a side has no value it does not."""
        unknown = False
        for index, (below, strict) in enumerate(self.orders[which]):
            if (which, index) in zeros:
                if strict:
                    return False
                continue
            value = self.sides[which].ball(point, index)
            if value is None:
                if self.sides[which].nowhere(point):
                    return False
                unknown = True
            elif value.contains(0):
                unknown = unknown or not (value.is_zero() and not strict)
                if value.is_zero() and strict:
                    return False
            elif (value < 0) != below:
                return False
        return None if unknown else True
