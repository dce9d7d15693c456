"""Two formulas at one point in balls: proved different, zero to thirty digits, without a value, or open."""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import StrEnum
from typing import Any

from flint import arb

from graders.language.balls import BALLS, precision
from graders.language.doubles import UndefinedError
from graders.language.program import Program, Runner

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
    """

    __slots__ = ("mutual", "program", "runners")

    def __init__(self, program: Program, mutual: bool) -> None:
        self.program, self.mutual = program, mutual
        self.runners: dict[int, Runner] = {}

    def at(self, point: Sequence[float]) -> Finding:
        """Decide at a point; NOWHERE where it is no state: where the reference (if mutual: both) has no value."""
        radius = math.inf
        for bits in PRECISIONS:
            with precision(bits):
                try:
                    right, typed = self._runner(bits).run([arb(x) for x in point])
                except UndefinedError:
                    return self._one_sided(point, bits)
                found = zero(right, typed, bits)
            if found is not None:
                return found
            now = float((right - typed).rad())
            if bits > SETTLING and not now < radius:
                return Finding.UNDECIDED
            radius = now
        return Finding.UNDECIDED

    def _runner(self, bits: int) -> Runner:
        runner = self.runners.get(bits)
        if runner is None:
            runner = self.runners[bits] = Runner(self.program, BALLS)
        return runner

    def _one_sided(self, point: Sequence[float], bits: int) -> Finding:
        right, typed = (self._exists(output, point, bits) for output in self.program.outputs)
        if right and not typed:
            return Finding.UNDEFINED
        return Finding.UNDEFINED if self.mutual and typed and not right else Finding.NOWHERE

    def _exists(self, output: int, point: Sequence[float], bits: int) -> bool:
        with precision(bits):
            try:
                Runner(self.program.only(output), BALLS).run([arb(x) for x in point])
            except UndefinedError:
                return False
        return True


def zero(right: Any, typed: Any, bits: int) -> Finding | None:
    """Decide whether two balls are equal relative to the larger; None asks for more precision."""
    difference = right - typed
    upper, least = difference.abs_upper(), max(right.abs_lower(), typed.abs_lower())
    if upper < least * SMALL:
        return Finding.EQUAL
    if not difference.is_finite():
        return None
    if difference.abs_lower() > max(right.abs_upper(), typed.abs_upper()) * SMALL:
        return Finding.DIFFERENT
    if least > 0 or bits < SETTLING:
        return None
    return Finding.EQUAL if difference.contains(0) and upper < arb(2) ** (-bits // 5) else None
