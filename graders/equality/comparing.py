"""Equality of two formulas as functions on the true states of a system.

Doubles choose where to look; balls decide. `different` is proved at a named point; `equal` is zero to 30 digits,
relative to the larger side, at several points; anything else is undecided.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from flint import arb

from graders.judge import Formula
from graders.language.balls import BALLS, precision
from graders.language.doubles import DOUBLES, UndefinedError, run
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Call, Tree, walk

PRECISIONS = (128, 256, 512, 1024, 2048, 4096)
POINTS = 4
SMALL = 2.0**-100  # 30 digits
BRANCHING = frozenset(("abs", "sign", "min", "max", "macaulay", "atan2", "sqrt", "root", "asin", "acos", "acot"))


class Finding(StrEnum):
    """What comparing two formulas found."""

    EQUAL = "equal"
    DIFFERENT = "different"
    UNDEFINED = "undefined"
    UNDECIDED = "undecided"


@dataclass(frozen=True, slots=True)
class Comparison:
    """A finding with the point that proves a difference."""

    finding: Finding
    witness: tuple[tuple[str, float], ...] = ()


def compare(answer: Tree, reference: Formula) -> Comparison:
    """Compare an answer with a reference on the states of the reference."""
    if answer == reference.tree:
        return Comparison(Finding.EQUAL)
    program = _program(answer, reference)
    doubles, balls = Runner(program, DOUBLES), Runner(program, BALLS)
    states = reference.states
    order = sorted(states.points, key=lambda point: -_far(doubles, point))
    branching = any(isinstance(n, Call) and n.function in BRANCHING for t in (answer, reference.tree) for n in walk(t))
    settled = 0
    for point in order:
        finding = _at(balls, doubles, point)
        if finding in (Finding.DIFFERENT, Finding.UNDEFINED):
            return Comparison(finding, tuple(zip(states.names, point, strict=True)))
        settled += finding is Finding.EQUAL
        if settled >= POINTS and not branching:
            return Comparison(Finding.EQUAL)
    return Comparison(Finding.EQUAL if settled >= max(POINTS, len(order) * 3 // 4) else Finding.UNDECIDED)


def _program(answer: Tree, reference: Formula) -> Program:
    builder = Builder(reference.states.names)
    for name, line in reference.states.lines:
        builder.define(name, line)
    return builder.program(builder.add(reference.tree), builder.add(answer))


def _far(doubles: Runner, point: tuple[float, ...]) -> float:
    """Give the relative difference in doubles; what doubles cannot tell is worth a look first."""
    try:
        right, typed = run(doubles, list(point))
    except UndefinedError:
        return 3.0
    difference, scale = abs(right - typed), max(abs(right), abs(typed))
    return difference / scale if scale and math.isfinite(difference) else 0.0 if not scale else 3.0


def _at(balls: Runner, doubles: Runner, point: tuple[float, ...]) -> Finding:
    radius = math.inf
    for bits in PRECISIONS:
        with precision(bits):
            try:
                right, typed = balls.run([arb(x) for x in point])
            except (ZeroDivisionError, ValueError, OverflowError):
                return _undefined(doubles, point)
            if not typed.is_finite() or not right.is_finite():
                if bits >= 512:
                    return _undefined(doubles, point)
                continue
            finding = _zero(right - typed, right, typed, bits)
            if finding is not None:
                return finding
            now = float((right - typed).rad())
            if not now < radius and bits > 256:
                return Finding.UNDECIDED
            radius = now
    return Finding.UNDECIDED


def _zero(difference: Any, right: Any, typed: Any, bits: int) -> Finding | None:
    """Decide whether a ball is zero relative to its two sides; None asks for more precision."""
    scale = max(right.abs_upper(), typed.abs_upper())
    if difference.abs_lower() > scale * SMALL:
        return Finding.DIFFERENT
    least = max(right.abs_lower(), typed.abs_lower())
    if least > 0:
        return Finding.EQUAL if difference.abs_upper() < least * SMALL else None
    shrunk = difference.contains(0) and difference.abs_upper() < arb(2) ** (-bits // 5)
    return Finding.EQUAL if shrunk and bits >= 256 else None


def _undefined(doubles: Runner, point: tuple[float, ...]) -> Finding:
    """An answer without a value where the reference has one differs; doubles confirm that it has none."""
    try:
        run(doubles, list(point))
    except UndefinedError:
        return Finding.UNDEFINED
    return Finding.UNDECIDED
