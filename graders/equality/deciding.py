"""Two formulas at one point in balls: proved different, zero to thirty digits, without a value, or open."""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import StrEnum
from functools import lru_cache
from typing import Any

from flint import arb, ctx

from graders.judge import States
from graders.language.balls import BALLS
from graders.language.doubles import UndefinedError
from graders.language.program import Program, Runner
from graders.states import Point

PRECISIONS = (128, 256, 512, 1024, 2048, 4096)
SETTLING = 256  # bits from which a ball that touches an edge counts as on it, and two zeros as equal
SMALL = arb(2) ** -100  # 30 digits
TINY = 2e-4  # of the values of a symbol: its powers count beyond 30 digits...
TOLD, MOST_FINE = 8, 4096  # ...up to this one, as far as so many bits tell


class Finding(StrEnum):
    """What comparing two formulas found; `nowhere` where neither has a value anywhere."""

    EQUAL = "equal"
    DIFFERENT = "different"
    UNDEFINED = "undefined"
    UNDECIDED = "undecided"
    NOWHERE = "nowhere"


class Balls:
    """A program of two outputs, right and typed, made ready for one precision after another.

    Args:
        program: The outputs are the reference and the answer.
        mutual: Whether a point where only the reference has no value tells the two apart as well.
        lines: Slots of the earlier names: where one of them has no value there is no state.
        fine: Bits by which a difference may be less than 30 digits of the larger and still counts (`fineness`).
    """

    __slots__ = ("fine", "known", "lines", "mutual", "program", "runners", "share")

    def __init__(self, program: Program, mutual: bool, lines: Sequence[int] = (), fine: int = 0) -> None:
        self.program, self.mutual, self.lines, self.fine = program, mutual, tuple(lines), fine
        self.share = share_of(fine)
        self.runners: dict[int, Runner] = {}
        self.known: dict[Point, Finding] = {}

    def at(self, point: Point) -> Finding:
        """Decide at a point; NOWHERE where it is no state: where the reference (if mutual: both) has no value."""
        found = self.known.get(point)
        if found is None:
            before = ctx.prec
            try:
                found = self.known[point] = self._at(point)
            finally:
                ctx.prec = before
        return found

    def _at(self, point: Point) -> Finding:
        radius, share = math.inf, self.share
        for bits in PRECISIONS:
            ctx.prec = bits + self.fine
            try:
                right, typed = (self.runners.get(bits) or self.runner(bits)).run(exactly(point))
            except UndefinedError:
                found = self._one_sided(point)
                if found is not None or bits > SETTLING:
                    return found or Finding.UNDECIDED
                continue
            found = zero(right, typed, bits, share)
            if found is not None:
                return found
            now = float((right - typed).rad())
            if bits > SETTLING and not now < radius:
                return Finding.UNDECIDED
            radius = now
        return Finding.UNDECIDED

    def runner(self, bits: int) -> Runner:
        """Give the program ready for a precision."""
        runner = self.runners.get(bits)
        if runner is None:
            runner = self.runners[bits] = Runner(self.program, BALLS)
        return runner

    def _one_sided(self, point: Point) -> Finding | None:
        """Tell where one of the two has no value whether the other has one; None where that is not sure."""
        one, other = self.program.outputs
        right, typed = self._exists((one, *self.lines), point), self._exists((other,), point)
        if right is False and (typed is False or not self.mutual):
            return Finding.NOWHERE
        if right is None or typed is None:
            return None
        return Finding.UNDEFINED if right is not typed else Finding.NOWHERE

    def _exists(self, outputs: tuple[int, ...], point: Point) -> bool | None:
        try:
            values = Runner(self.program.only(*outputs), BALLS).run(exactly(point))
        except UndefinedError:
            return False
        return True if all(value.is_finite() for value in values) else None


@lru_cache(maxsize=4096)
def exactly(point: Point) -> tuple[arb, ...]:
    """Give the numbers of a point as balls of no width; points are used again and again."""
    return tuple(map(arb, point))


def fineness(states: States) -> int:
    """Give the bits by which two formulas are told apart beyond 30 digits where a symbol is next to nothing.

    There `sin(x)` is `x` to any number of digits but for the cube of `x`: powers up to the eighth are told.
    """
    if not states.points[0] or min(map(abs, states.points[0])) > TINY:
        return 0
    sizes = (max(abs(domain.low), abs(domain.high)) for domain in states.box)
    least = min((size for size in sizes if 0 < size < TINY), default=1.0)
    return min(MOST_FINE, int(-TOLD * math.log2(least)))


def share_of(fine: int) -> Any:
    """Give the share of the larger below which a difference is none."""
    return SMALL * arb(2) ** -fine if fine else SMALL


def zero(right: Any, typed: Any, bits: int, small: Any = SMALL) -> Finding | None:
    """Decide whether two balls are equal relative to the larger; None asks for more precision."""
    difference = right - typed
    size, share = abs(difference), abs(right) * small
    if size < share:
        return Finding.EQUAL
    if not difference.is_finite():
        return None
    if size > share + share:  # so it is above the share of the typed one as well
        return Finding.DIFFERENT
    if difference.abs_lower() > max(right.abs_upper(), typed.abs_upper()) * small:
        return Finding.DIFFERENT
    if bits < SETTLING or right.abs_lower() > 0 or typed.abs_lower() > 0:
        return None
    return Finding.EQUAL if difference.contains(0) and difference.abs_upper() < arb(2) ** (-bits // 5) else None


def same(one: Any, other: Any, share: Any) -> bool:
    """Tell whether two balls of the first precision are equal, or both nothing."""
    return zero(one, other, PRECISIONS[0], share) is Finding.EQUAL or (one.is_zero() and other.is_zero())
