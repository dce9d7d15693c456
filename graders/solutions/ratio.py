"""What two values of the unknown tell of two equations: whether their ratio is constant, and zeros of affine sides."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from itertools import chain
from typing import NamedTuple

from flint import arb

from graders.solutions.reduction import degrees_along
from graders.solutions.scene import Residuals, exactly, moved
from graders.solutions.zeros import Zero

DRAWS = 4  # points at which the ratio is tested
LINES = 4  # on which a zero of an affine side is looked for
SHARE = 0.6180339887  # of the range between the two values of the unknown


class Looked(NamedTuple):
    """What both sides are at a point, and there with another value of the unknown."""

    point: Sequence[arb]
    place: arb
    here: Sequence[arb | None]
    there: Sequence[arb | None]


class Ratio:
    """The ratio of two residuals along the unknown.

    Args:
        both: The residuals, one of each side.
        unknown: The number of the unknown.
    """

    def __init__(self, both: Residuals, unknown: int) -> None:
        self.both, self.scene, self.unknown = both, both.scene, unknown
        self.looked = list[Looked]()  # where the ratio is another one

    @cached_property
    def along(self) -> list[int]:
        """Give the degrees of all slots in the unknown."""
        return degrees_along(self.both.program, self.unknown)

    def constant(self) -> bool:
        """Tell whether the ratio is constant in the unknown at some points, and the sides are not."""
        tested, depends = 0, False
        for point in exactly(self.scene.points):
            match self.changes(point):
                case None:
                    return False
                case changes if changes >= 0:
                    depends, tested = depends or changes > 0, tested + 1
            if tested == DRAWS:
                return depends
        return False

    def kept(self, points: Iterable[Sequence[float]]) -> bool:
        """Tell whether the ratio is constant at some more points, too."""
        return not any(self.changes(point) is None for point in exactly(list(points)))

    def changes(self, point: Sequence[arb]) -> int | None:
        """Compare the ratio at two values of the unknown: 1 where the side changes, 0 where it does not.

        -1 where neither side has a value; None where the ratio is another one, or one side alone has no value.
        """
        looked = self._look(point)
        (one, other), (first, second) = looked.here, looked.there
        if one is None or other is None or first is None or second is None:
            return None if (one is None) != (other is None) or (first is None) != (second is None) else -1
        if not (one * second - other * first).contains(0) or first.contains(0) or second.contains(0):
            self.looked.append(looked)
            return None
        return int(not (one - first).contains(0))

    def _look(self, point: Sequence[arb]) -> Looked:
        there = moved(point, self.unknown, self._elsewhere(point))
        return Looked(point, there[self.unknown], self.both.balls(point), self.both.balls(there))

    def _elsewhere(self, point: Sequence[arb]) -> arb:
        low, high = self.scene.ranges[self.unknown]
        share = (float(point[self.unknown]) - low) / (high - low) if high > low else 0.0
        return arb(low + (high - low) * ((share + SHARE) % 1.0))

    def apart(self) -> tuple[int, Zero] | None:
        """Give a zero of a side that is affine in the unknown, and the side, where the other is proved not to be zero.

        Most wrong answers end here.
        """
        for which in [at for at in (0, 1) if self.along[self.both.program.outputs[at]] == 1]:
            zero = next(self._straight(which), None)
            value = None if zero is None else self.both.balls(zero.point)[1 - which]
            if zero is not None and value is not None and not value.contains(0):
                return which, zero
        return None

    def _straight(self, which: int) -> Iterator[Zero]:
        """Give the zeros of an affine side on some lines, those that were looked at before any other."""
        for looked in chain(self.looked, map(self._look, exactly(self.scene.points[:LINES]))):
            at, one, two = self.unknown, looked.here[which], looked.there[which]
            if one is not None and two is not None and not (two - one).contains(0):
                place = looked.point[at] - one * (looked.place - looked.point[at]) / (two - one)
                if self.scene.inside(at, place):
                    yield Zero(tuple(moved(looked.point, at, place)), (at,))
