"""Two formulas at one point in balls: proved different, zero to thirty digits, without a value, or open."""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import StrEnum
from functools import lru_cache
from typing import Any

from flint import arb, ctx

from graders.language.balls import BALLS
from graders.language.doubles import UndefinedError
from graders.language.program import Program, Runner
from graders.states import Point

PRECISIONS = (128, 256, 512, 1024, 2048, 4096)
SETTLING = 256  # bits from which a ball that touches an edge counts as on it, and two zeros as equal
SMALL = arb(2) ** -100  # 30 digits


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
    """

    __slots__ = ("known", "lines", "mutual", "program", "runners")

    def __init__(self, program: Program, mutual: bool, lines: Sequence[int] = ()) -> None:
        self.program, self.mutual, self.lines = program, mutual, tuple(lines)
        self.runners: dict[int, Runner] = {}
        self.known: dict[Point, Finding] = {}

    def at(self, point: Point) -> Finding:
        """Decide at a point; NOWHERE where it is no state: where the reference (if mutual: both) has no value."""
        if point in self.known:
            return self.known[point]
        before = ctx.prec
        try:
            found = self.known[point] = self._at(point)
        finally:
            ctx.prec = before
        return found

    def _at(self, point: Point) -> Finding:
        radius = math.inf
        for bits in PRECISIONS:
            ctx.prec = bits
            try:
                right, typed = self.runner(bits).run(exactly(point))
            except UndefinedError:
                return self._one_sided(point)
            found = zero(right, typed, bits)
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

    def _one_sided(self, point: Point) -> Finding:
        one, other = self.program.outputs
        right, typed = self._exists((one, *self.lines), point), self._exists((other,), point)
        if right and not typed:
            return Finding.UNDEFINED
        return Finding.UNDEFINED if self.mutual and typed and not right else Finding.NOWHERE

    def _exists(self, outputs: tuple[int, ...], point: Point) -> bool:
        try:
            Runner(self.program.only(*outputs), BALLS).run(exactly(point))
        except UndefinedError:
            return False
        return True


@lru_cache(maxsize=4096)
def exactly(point: Point) -> tuple[arb, ...]:
    """Give the numbers of a point as balls of no width; points are used again and again."""
    return tuple(map(arb, point))


def zero(right: Any, typed: Any, bits: int) -> Finding | None:
    """Decide whether two balls are equal relative to the larger; None asks for more precision."""
    difference = right - typed
    if abs(difference) < abs(right) * SMALL:
        return Finding.EQUAL
    if not difference.is_finite():
        return None
    if difference.abs_lower() > max(right.abs_upper(), typed.abs_upper()) * SMALL:
        return Finding.DIFFERENT
    if bits < SETTLING or right.abs_lower() > 0 or typed.abs_lower() > 0:
        return None
    return Finding.EQUAL if difference.contains(0) and difference.abs_upper() < arb(2) ** (-bits // 5) else None
