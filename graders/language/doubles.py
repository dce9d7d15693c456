"""The language in doubles: numbers of the statement, reference values, and where balls should look."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

from graders.language.program import Arithmetic, Builder, Runner
from graders.language.tree import Grid, Number, Tree, children, names

DEGREE = math.pi / 180


class UndefinedError(ArithmeticError):
    """An operation has no value at this point (a root of a negative number, a division by zero, an overflow)."""


def _literal(number: Number) -> float:
    try:
        return float(f"{number.digits}e{number.exponent}")
    except OverflowError:  # beyond doubles, still a legal number for balls
        return math.inf


def _power(base: float, exponent: float) -> float:
    if base < 0 and not float(exponent).is_integer():
        raise UndefinedError("a non-integer power of a negative number")
    return math.pow(base, exponent)


def _macaulay(inside: float, power: float) -> float:
    """`<u>^n`: zero before the bracket opens, u^n after; n = 0 is the unit step, n < 0 an impulse without a value."""
    if power < 0:
        raise UndefinedError("an impulse has no value")
    return 0.0 if inside < 0 else 1.0 if power == 0 else math.pow(inside, power)


def _root(radicand: float, degree: float) -> float:
    if radicand < 0 and degree % 2 == 1:
        return -math.pow(-radicand, 1 / degree)
    return math.pow(radicand, 1 / degree)


DOUBLES = Arithmetic(
    _literal,
    {
        "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "^": _power,
        "negate": operator.neg, "degrees": lambda x: x * DEGREE, "pi": lambda: math.pi,
        "integer_power": operator.pow,
        "sin": math.sin, "cos": math.cos, "tan": math.tan, "cot": lambda x: 1 / math.tan(x),
        "asin": math.asin, "acos": math.acos, "atan": math.atan, "acot": lambda x: math.pi / 2 - math.atan(x),
        "atan2": math.atan2, "sinh": math.sinh, "cosh": math.cosh, "tanh": math.tanh, "exp": math.exp,
        "ln": math.log, "log": math.log10, "log_base": lambda x, base: math.log(x) / math.log(base),
        "sqrt": math.sqrt, "root": _root, "abs": abs, "sign": lambda x: float((x > 0) - (x < 0)),
        "min": min, "max": max, "macaulay": _macaulay,
    },
)  # fmt: skip


@lru_cache(maxsize=8192)
def line_runner(tree: Tree) -> Runner:
    """Make a runner for one tree whose inputs are the names that occur in it, sorted."""
    builder = Builder(sorted(names(tree)))
    return Runner(builder.program(builder.add(tree)), DOUBLES)


def run(runner: Runner, values: list[Any]) -> list[Any]:
    """Run in doubles; raises UndefinedError where the value does not exist."""
    try:
        return runner.run(values)
    except (ValueError, ArithmeticError, TypeError, IndexError) as error:
        raise UndefinedError(str(error)) from error


def domain_test(
    tree: Tree, names: tuple[str, ...], lines: Sequence[tuple[str, Tree]]
) -> Callable[[tuple[float, ...]], bool]:
    """Make a test that tells in doubles whether a formula and the lines it stands on have a value at a point."""
    builder = Builder(names)
    slots = [builder.define(name, line) for name, line in lines]
    entries = children(tree) if isinstance(tree, Grid) else (tree,)
    runner = Runner(builder.program(*map(builder.add, entries), *slots), DOUBLES)

    def defined(point: tuple[float, ...]) -> bool:
        try:
            values = run(runner, list(point))
        except UndefinedError:
            return False
        return all(map(math.isfinite, values))

    return defined
