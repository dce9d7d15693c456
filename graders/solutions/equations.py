"""Whether two equations have the same solutions in a box.

First the ratio of the two sides: constant in the unknown, it says they are zero together. Otherwise zeros of each are
found and proved, and the other must be zero there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import islice, product

from graders.equality import Finding
from graders.equality.rising import Trend, trends
from graders.equality.turns import TURNING
from graders.language.balls import precision
from graders.language.intervals import INTERVALS
from graders.language.program import Runner
from graders.language.tree import Relation, Tree
from graders.solutions.beside import Beside, beside, flat_zero
from graders.solutions.branches import NONE, Branches, branch_starts
from graders.solutions.descent import descended
from graders.solutions.found import EQUAL, UNDECIDED, Found
from graders.solutions.ratio import Ratio
from graders.solutions.reduction import cleared, degrees, degrees_along, divides, factors, reduced, residual
from graders.solutions.scene import (
    BITS,
    Effort,
    Residuals,
    Scene,
    Side,
    TooMuchWork,
    exact,
    exactly,
    extreme,
    used_symbols,
)
from graders.solutions.written import Written
from graders.solutions.zeros import (
    NODES,
    Line,
    Zero,
    away,
    crossing,
    each_way,
    jumps,
    only,
    parabola,
    same_side,
    scanned,
)

ENOUGH = 3  # zeros of each side that the other must share
FIRST = 2  # lines on which the zeros of a parabola are looked at before their ways are told
STARTS = 8  # points from which zeros are looked for all over the box
SCANNED = 2  # lines that are searched from end to end
TRIED, REGIONS = 3, 12  # points at which a side may be zero in a whole region: looked at early, and in all
BRANCHES = 40  # points in every branch
SEARCHED, FEWER = 12, 33  # lines in branches that are searched from end to end, and their nodes
MOST = 12  # zeros of one line
PROVING = 3  # what an operation on ranges costs


def compare_equations(answer: Relation, reference: Relation, scene: Scene, unknown: str) -> Found:
    """Compare the solutions of two equations in a box.

    Args:
        answer: The equation to judge.
        reference: The equation it should be equal to.
        scene: The box over all symbols.
        unknown: The symbol the equations are solved for.
    """
    if answer == reference:
        return EQUAL
    unknowns = frozenset((unknown,))
    with precision(BITS):
        try:
            written = [residual(equation) for equation in (reference, answer)]
            pair = Pair(scene, written, [reduced(tree, unknowns) for tree in written], scene.names.index(unknown))
            return pair.known(pair.by_ratio() or pair.by_straight() or pair.by_zeros())
        except TooMuchWork:
            return UNDECIDED


@dataclass(frozen=True, slots=True)
class Factor:
    """A factor of a side: zero there, the whole is.

    Attributes:
        side: The side, of this factor alone.
        tree: As it is written.
        slot: Where its value stands in the program.
        degree: Its degree in the unknown, as it is written.
    """

    side: Side
    tree: Tree
    slot: int
    degree: int


class Pair:
    """The residuals of the reference and the answer over one scene, as they were written and without what may go."""

    def __init__(self, scene: Scene, written: Sequence[Tree], trees: Sequence[Tree], unknown: int) -> None:
        self.scene, self.trees, self.unknown = scene, trees, unknown
        self.name = scene.names[unknown]
        self.found: tuple[list[Zero], list[Zero]] = ([], [])  # zeros of each side
        self.settled = dict[tuple[float, ...], list[Zero]]()  # zeros of both sides, by their lines
        left = [[tree] for tree in trees]
        self.both = Residuals(scene, left, Effort())
        self.sides = (Side(self.both, 0), Side(self.both, 1))
        self.ratio = Ratio(self.both, unknown)
        self.written = Written(scene, [[tree] for tree in written], left, self.both.effort)

    @cached_property
    def numerators(self) -> Sequence[Tree]:
        """Give the sides without the denominators that hold the unknown."""
        held = divides(self.both.program, self.ratio.along)
        return [cleared(tree, self.name) for tree in self.trees] if held else self.trees

    @cached_property
    def factors(self) -> list[list[Factor]]:
        """Give the factors of the numerators."""
        parts = [factors(tree) for tree in self.numerators]
        whole = all(part == [tree] for part, tree in zip(parts, self.trees, strict=True))
        pair = self.both if whole else Residuals(self.scene, parts, self.both.effort)
        along = self.ratio.along if whole else degrees_along(pair.program, self.unknown)
        slots = [
            pair.program.outputs[start : start + len(part)] for start, part in zip(pair.starts, parts, strict=False)
        ]
        return [
            [
                Factor(Side(pair, which, (k,)), tree, slot, along[slot])
                for k, (tree, slot) in enumerate(zip(part, slots[which], strict=True))
            ]
            for which, part in enumerate(parts)
        ]

    def known(self, found: Found) -> Found:
        """Give equality up where a branch may have been missed."""
        return found if found.finding is not Finding.EQUAL or self._found.proved else UNDECIDED

    def by_ratio(self) -> Found | None:
        """Tell whether the ratio of the two is constant in the unknown; None where it is not, or has no value."""
        return EQUAL if self.ratio.constant() and self.ratio.kept(self.branches) else None

    def by_straight(self) -> Found | None:
        """Tell whether a zero of a side that is affine in the unknown is none of the other; None where none tells."""
        found = self.ratio.apart()
        told = found is not None and not self.written.vanishes(1 - found[0], found[1])
        return self._apart(*found) if found is not None and told else None

    def _apart(self, which: int, zero: Zero) -> Found:
        return Found(Finding.DIFFERENT, zero.named(self.scene.names), lost=which == 0)

    @cached_property
    def _found(self) -> Branches:
        if TURNING.isdisjoint(name for name, _ in self.both.program.operations):
            return NONE
        return branch_starts(self.scene, (self.trees[:1], self.trees[1:]), self.both.effort, BRANCHES)

    @property
    def branches(self) -> list[list[float]]:
        """Give points on both sides of everything that turns in one of the two."""
        return self._found.points

    def by_zeros(self) -> Found:
        """Find zeros of each and test the other there."""
        shared, unsure = [0, 0], False
        for which, zero in self._zeros():
            match Beside.ZERO if zero.both else beside(self.sides[1 - which], zero):
                case Beside.OTHER if self.written.vanishes(1 - which, zero):
                    unsure = True  # what went is zero there
                case Beside.OTHER | Beside.UNDEFINED:
                    return self._apart(which, zero)
                case Beside.ZERO:
                    shared[which] += 1
                    self._settle(zero)
                case Beside.UNSURE:
                    unsure = True
        return EQUAL if min(shared) >= ENOUGH - 1 and sum(shared) >= 2 * ENOUGH and not unsure else UNDECIDED

    def _settle(self, zero: Zero) -> None:
        """Remember a zero of both sides on its line along the unknown."""
        if zero.base and zero.free == (self.unknown,) and not zero.both:
            self.settled.setdefault(zero.base, []).append(replace(zero, both=True))

    def _known(self, factor: Factor, base: Sequence[float]) -> list[Zero]:
        """Give the zeros on a line that both sides share, if this factor is all of its side and not zero elsewhere."""
        known, which = self.settled.get(tuple(base), []), factor.side.which
        if not known or len(self.factors[which]) > 1 or (not self._plain(factor) and jumps(self.both.program)):
            return []
        value = self.both.ball(exact(tuple(base)), which)
        return known if value is not None and not value.contains(0) else []

    def _zeros(self) -> Iterator[tuple[int, Zero]]:
        """Give zeros of both sides: whole regions, along the unknown, all over the box, along whole lines."""
        for source in self._sources():
            for which, zero in source:
                if self._holds(which, zero):
                    self.found[which].append(zero)
                    yield which, zero
            if self._enough and self._all_plain and not self.branches:
                return
        if self._enough and self._all_plain:
            return
        for which in (0, 1):
            for zero in self._along_lines(which, [*self.found[0], *self.found[1]]):
                if self._holds(which, zero):
                    yield which, zero

    def _fraction(self, which: int) -> bool:
        """Tell whether the zeros of a side are looked for in its numerator."""
        return self.numerators[which] is not self.trees[which]

    def _holds(self, which: int, zero: Zero) -> bool:
        """Tell whether a zero of a numerator or a factor is one of the side."""
        parted = self._fraction(which) or len(self.factors[which]) > 1
        return zero.both or not parted or self.written.holds(which, zero)

    def _sources(self) -> Iterator[Iterator[tuple[int, Zero]]]:
        points = self.scene.points
        yield self._in_turn(self._solved)
        yield self._regions(points[:TRIED])
        yield self._in_turn(self._spread)
        yield self._regions(points[TRIED:REGIONS])
        yield self._regions(self.branches)

    @property
    def _enough(self) -> bool:
        """Tell whether enough zeros of each side were found."""
        return min(map(len, self.found)) >= ENOUGH

    @cached_property
    def _all_plain(self) -> bool:
        """Tell whether all zeros of each side on a line along the unknown are found at once."""
        return all(self._plain(factor) for factors in self.factors for factor in factors)

    def _in_turn(self, source: Callable[[int], Iterator[Iterable[Zero]]]) -> Iterator[tuple[int, Zero]]:
        """Give the zeros of both sides line by line, first of that of the lower degree, whose zeros cost less."""
        degrees = [max(factor.degree for factor in factors) for factors in self.factors]
        sources = [(which, source(which)) for which in sorted((0, 1), key=degrees.__getitem__)]
        while sources:
            for side in list(sources):
                zeros = next(side[1], None)
                if zeros is None:
                    sources.remove(side)
                else:
                    yield from ((side[0], zero) for zero in zeros)

    def _regions(self, points: Sequence[Sequence[float]]) -> Iterator[tuple[int, Zero]]:
        """Give points in the middle of the box where a side is zero: an identity, a bracket that is not open."""
        for point in exactly(points):
            for which, value in enumerate(self.both.balls(point)[:2]):
                if value is not None and flat_zero(value):
                    yield which, Zero(tuple(point), (self.unknown,))

    @cached_property
    def _lines(self) -> dict[str, dict[str, int]]:
        """Give the degrees of the names that lines define."""
        known = dict[str, dict[str, int]]()
        for name, line in self.scene.lines:
            known[name] = degrees(line, known)
        return known

    def _affine(self, factor: Factor) -> list[int]:
        """Give the symbols in which a factor is affine as it is written, the unknown first."""
        found = degrees(factor.tree, self._lines)
        symbols = [at for at, name in enumerate(self.scene.names) if found.get(name) == 1]
        return sorted(symbols, key=lambda at: at != self.unknown)

    def _plain(self, factor: Factor) -> bool:
        """Tell whether all zeros of a factor on a line along the unknown are found at once."""
        return factor.degree in (1, 2) or (factor.degree > 2 and self._trends[factor.slot] in (1, -1))

    @cached_property
    def _trends(self) -> list[Trend]:
        """Tell of the factors which only rise or only fall along the unknown."""
        program = self.factors[0][0].side.pair.program
        self.both.effort.spend(PROVING * len(program.operations))
        return trends(program, Runner(program, INTERVALS).slots(self.scene.ranges), self.unknown)

    def _on(self, factor: Factor, base: Sequence[float], nodes: int = NODES) -> Iterable[Zero]:
        """Give the zeros of a factor on the line along the unknown through a point."""
        line, degree, known = Line(factor.side, base, self.unknown), factor.degree, self._known(factor, base)
        if self._plain(factor) and len(known) == 1 + (degree == 2):
            return known
        found = parabola(line) if degree == 2 else None
        if found is not None:
            return found
        if degree == 2 or not self._plain(factor):
            return islice(scanned(line, nodes, known), MOST)
        zero = crossing(line) if degree == 1 else only(line, partial(self._excluded, 1 - factor.side.which))
        return [] if zero is None else [zero]

    def _excluded(self, which: int, zero: Zero) -> bool:
        """Tell whether a side is proved to have a value, and no zero, wherever a zero of the other one may be."""
        value = None if self._fraction(1 - which) else self.both.ball(zero.point, which)
        return value is not None and not value.contains(0)

    def _solved(self, which: int) -> Iterator[Iterable[Zero]]:
        """Give zeros of the factors whose zeros on a line are found at once."""
        for factor in filter(self._plain, self.factors[which]):
            left = ENOUGH + 1
            for base in self._bases(factor):
                found = list(self._on(factor, base))
                yield found
                left -= len(found) if factor.degree != 2 else 0
                if left <= 0:
                    break

    def _bases(self, factor: Factor) -> Iterator[Sequence[float]]:
        """Give points for lines; of a parabola some for each way in which its zeros lie in the range."""
        bases, first = extreme(self.scene), FIRST if factor.degree == 2 else STARTS
        yield from bases[:first]
        values = self._along(factor, bases)
        if factor.degree == 2:
            chosen = each_way(values, ENOUGH)
        else:
            chosen = [k for k, (before, _, after) in enumerate(values) if not same_side(before, after)]
        yield from (bases[k] for k in chosen if k >= first)

    def _along(self, factor: Factor, bases: Sequence[Sequence[float]]) -> list[tuple[float, ...]]:
        """Give the values in doubles at the ends and in the middle of the range on each of some lines."""
        at, (low, high) = self.unknown, self.scene.ranges[self.unknown]
        points = [(*base[:at], x, *base[at + 1 :]) for base in bases for x in (low, (low + high) / 2, high)]
        values = factor.side.pair.many((factor.side.which, factor.side.only[0]), points)
        return list(zip(values[::3], values[1::3], values[2::3], strict=True))

    def _spread(self, which: int) -> Iterator[Iterable[Zero]]:
        """Give zeros all over the box and in every branch: by a symbol in which a factor is affine, else by steps."""
        for factor in self.factors[which]:
            yield from self._spread_of(factor, used_symbols(self.scene, (self.trees[which],)))

    def _spread_of(self, factor: Factor, used: Sequence[int]) -> Iterator[Iterable[Zero]]:
        others, count = [at for at in used if at != self.unknown], 0
        symbols, moving = self._affine(factor), ((self.unknown,), used, others)
        yield from self._in_branches(factor)
        if self._enough and self._all_plain:
            return
        affine = [at for at in symbols if at in others or at == self.unknown]
        solved, left = self._plain(factor) and self._enough, []
        for k, start in enumerate(islice(extreme(self.scene), STARTS)):
            zero = self._beside(factor.side, start, affine)
            if zero is None and not solved:
                left.append((start, moving[k % 3]))
            elif zero is not None:
                count += 1
                yield [zero]
        for start, along in left:
            zero = descended(factor.side, start, along) if not affine or count < ENOUGH else None
            if zero is not None:
                count += 1
                yield [zero]

    def _in_branches(self, factor: Factor) -> Iterator[Iterable[Zero]]:
        """Give zeros with the parameters of points beside everything that turns."""
        for k, start in enumerate(self.branches):
            if k < SEARCHED or self._plain(factor):
                yield self._on(factor, start, FEWER)

    def _beside(self, side: Side, start: Sequence[float], affine: Sequence[int]) -> Zero | None:
        for at in affine[:3]:
            line = Line(side, start, at)
            zero = None if away(line) else crossing(line)
            if zero is not None:
                return zero
        return None

    def _along_lines(self, which: int, known: Sequence[Zero]) -> Iterator[Zero]:
        """Search whole lines along the unknown through points near zeros, else through any points."""
        near = known[:: max(1, len(known) // SCANNED)][:SCANNED]
        bases = list(map(self._base, near)) or self.scene.points[: 2 * SCANNED]
        for base, factor in product(bases, self.factors[which]):
            yield from self._on(factor, base)

    def _base(self, zero: Zero) -> Sequence[float]:
        """Give the line along the unknown on which a zero stands."""
        return zero.base if zero.free == (self.unknown,) and zero.base else tuple(map(float, zero.point))
