"""Whether two systems of equations have the same solutions in a box.

First their linear dependence: where one is a combination of the other whose factors do not hold the unknowns, they are
zero together. Otherwise zeros of each are found, and the other must be zero there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import product

from flint import arb, arb_mat

from graders.equality import Finding
from graders.language.balls import precision
from graders.language.tree import Relation, Tree
from graders.solutions.beside import Beside, beside
from graders.solutions.branches import Branches, branch_starts
from graders.solutions.found import EQUAL, UNDECIDED, Found
from graders.solutions.newton import projected
from graders.solutions.reduction import reduced, residual
from graders.solutions.scene import BITS, Effort, Residuals, Scene, Side, TooMuchWork, exactly, extreme, used_symbols
from graders.solutions.written import Written
from graders.solutions.zeros import Zero

DRAWS = 3  # points at which the dependence is tested
ENOUGH, AT_LEAST = 9, 5  # zeros of each side that the other must share; as many where the work is up before
STARTS, BRANCHES = 40, 12  # points all over the box, and beside what turns
OTHERS = 2  # starts from which other solutions with the same parameters are looked for
SYSTEM_WORK = 60_000


def compare_systems(
    answer: Sequence[Relation], reference: Sequence[Relation], scene: Scene, unknowns: Sequence[str]
) -> Found:
    """Compare the solutions of two systems in a box.

    Args:
        answer: The equations to judge.
        reference: The equations they should be equal to.
        scene: The box over all symbols.
        unknowns: The symbols the systems are solved for.
    """
    if sorted(map(repr, answer)) == sorted(map(repr, reference)):
        return EQUAL
    written = [[residual(one) for one in side] for side in (reference, answer)]
    with precision(BITS):
        try:
            pair = Systems(scene, written, unknowns)
            return pair.known(pair.by_dependence() or pair.by_zeros())
        except TooMuchWork:
            return UNDECIDED


class Systems:
    """The residuals of the reference and the answer over one scene, as they were written and without what may go."""

    def __init__(self, scene: Scene, written: Sequence[Sequence[Tree]], unknowns: Sequence[str]) -> None:
        self.scene, self.unknowns = scene, [scene.names.index(name) for name in unknowns]
        self.trees = [[reduced(tree, frozenset(unknowns)) for tree in side] for side in written]
        self.both = Residuals(scene, self.trees, Effort(SYSTEM_WORK))
        self.sides = (Side(self.both, 0), Side(self.both, 1))
        self.written = Written(scene, written, self.trees, self.both.effort)

    def known(self, found: Found) -> Found:
        """Give equality up where a branch may have been missed."""
        return found if found.finding is not Finding.EQUAL or self._found.proved else UNDECIDED

    @cached_property
    def _found(self) -> Branches:
        return branch_starts(self.scene, (self.trees[0], self.trees[1]), self.both.effort, BRANCHES)

    def by_dependence(self) -> Found | None:
        """Tell whether the answer is a combination of the reference with factors free of the unknowns."""
        count, tested = len(self.trees[0]), 0
        if len(self.trees[1]) != count:
            return None
        points = list(exactly(self.scene.points))
        for start in range(0, len(points) - count - 2):
            depends = self._depends(points[start], points[start + 1 :])
            if depends is False or (depends is None and (tested or start > 4)):
                return None
            tested += depends is True
            if tested == DRAWS:
                break
        if tested < DRAWS:
            return None
        beside = (self._depends(point, points) for point in exactly(self._found.points))
        return EQUAL if all(beside) else None

    def _depends(self, base: Sequence[arb], others: Sequence[Sequence[arb]]) -> bool | None:
        """Tell whether the two are combinations of one another at some parameters; None where a value is missing."""
        count = len(self.trees[0])
        rows = [self._values(base, other) for other in others[: count + 2]]
        kept = [row for row in rows if row is not None]
        return self._dependent(kept, count) if len(kept) == len(rows) else None

    def _values(self, base: Sequence[arb], other: Sequence[arb]) -> list[arb] | None:
        """Evaluate both sides at a point with the unknowns of another."""
        point = list(base)
        for at in self.unknowns:
            point[at] = other[at]
        found = [value for value in self.both.balls(point) if value is not None]
        return found if len(found) == len(self.both.program.outputs) else None

    def _dependent(self, rows: Sequence[Sequence[arb]], count: int) -> bool:
        ours, theirs = ([row[:count] for row in rows], [row[count:] for row in rows])
        try:
            factors = arb_mat(ours[:count]).solve(arb_mat(theirs[:count]))
        except ZeroDivisionError:
            return False
        if factors.det().contains(0):
            return False
        rest = arb_mat(ours[count:]) * factors - arb_mat(theirs[count:])
        return all(value.contains(0) for value in rest.entries())

    def by_zeros(self) -> Found:
        """Find zeros of each and test the other there."""
        shared, enough, unsure = [0, 0], ENOUGH, False
        try:
            for which, zero in self._in_turn():
                match beside(self.sides[1 - which], zero):
                    case Beside.OTHER if self.written.vanishes(1 - which, zero):
                        unsure = True  # what went is zero there
                    case Beside.OTHER | Beside.UNDEFINED:
                        return Found(Finding.DIFFERENT, zero.named(self.scene.names), lost=which == 0)
                    case Beside.ZERO:
                        shared[which] += 1
                    case Beside.UNSURE:
                        return UNDECIDED
        except TooMuchWork:
            enough, unsure = AT_LEAST, unsure or bool(self._found.points)
        return EQUAL if min(shared) >= enough and not unsure else UNDECIDED

    def _in_turn(self) -> Iterator[tuple[int, Zero]]:
        """Give zeros in every branch, then enough zeros of both sides, one after the other."""
        for start, which in product(self._found.points, (0, 1)):
            zero = self._projected(which, start, self.unknowns)
            if zero is not None:
                yield which, zero
        sources = [self._zeros(0), self._zeros(1)]
        for _ in range(ENOUGH):
            for which, source in enumerate(sources):
                zero = next(source, None)
                if zero is not None:
                    yield which, zero

    def _zeros(self, which: int) -> Iterator[Zero]:
        """Give zeros of a side near points all over the box: all symbols move, the unknowns alone, or the others."""
        used = used_symbols(self.scene, self.trees[which])
        others = [at for at in used if at not in self.unknowns]
        moving = (used, self.unknowns, others)
        for k, start in enumerate(self.starts):
            zero = self._projected(which, start, moving[k % 3])
            if zero is not None:
                yield zero
                yield from self._assemblies(which, zero, k)

    def _assemblies(self, which: int, zero: Zero, number: int) -> Iterator[Zero]:
        """Look for other solutions with the same parameters."""
        points = self.scene.points
        for k in range(OTHERS):
            start = [float(x) for x in zero.point]
            for at in self.unknowns:
                start[at] = points[(OTHERS * number + k + 1) % len(points)][at]
            other = self._projected(which, start, self.unknowns)
            if other is not None:
                yield other

    def _projected(self, which: int, start: Sequence[float], moving: Sequence[int]) -> Zero | None:
        """Give a zero of a side near a point, if it is one as the side was written too."""
        zero = projected(self.sides[which], start, moving)
        holds = zero is not None and (not self.written.shorter(which) or self.written.holds(which, zero))
        return zero if holds else None

    @cached_property
    def starts(self) -> list[list[float]]:
        """Give points all over the box and beside everything that turns."""
        return [*(start for start in self._found.points for _ in range(3)), *map(list, extreme(self.scene)[:STARTS])]
