"""The language in ball arithmetic (python-flint): an enclosure of the true value at any precision.

`flint.ctx.prec` belongs to the whole process: balls are used on one thread at a time.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator
from contextlib import contextmanager

from flint import arb, ctx, fmpq, fmpz

from graders.language.program import Arithmetic
from graders.language.tree import Number


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work at a precision in bits and restore the former one."""
    before = ctx.prec
    ctx.prec = bits
    try:
        yield
    finally:
        ctx.prec = before


def _literal(number: Number) -> arb:
    value = number.exact
    return arb(fmpq(fmpz(value.numerator), fmpz(value.denominator)))


def _sign(x: arb) -> arb:
    if x > 0:
        return arb(1)
    if x < 0:
        return arb(-1)
    return arb(0) if x.is_zero() else arb(0, 1)


def _macaulay(inside: arb, power: arb) -> arb:
    if inside < 0:
        return arb(0)
    if power.is_zero():
        return arb(1) if inside >= 0 else arb(0.5, 0.5)
    if inside >= 0:
        return inside**power
    return _clamped(inside) ** power


def _clamped(x: arb) -> arb:
    """Cut the part below zero from a ball that touches zero: the function is continuous there."""
    return x.nonnegative_part() if x.contains(0) else x


def _sqrt(x: arb) -> arb:
    return _clamped(x).sqrt() if x.mid() != 0 or x.is_zero() else x.sqrt()


def _inside_one(x: arb) -> arb:
    """Cut the part beyond [-1, 1] from a ball that touches an end, so that acos(1±r) has a value."""
    if x.contains(1) and not x > 1:
        return 1 - _clamped(1 - x)
    if x.contains(-1) and not x < -1:
        return _clamped(x + 1) - 1
    return x


def _root(radicand: arb, degree: arb) -> arb:
    return -((-radicand) ** (1 / degree)) if radicand < 0 else radicand ** (1 / degree)


BALLS = Arithmetic(
    _literal,
    {
        "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "^": operator.pow,
        "negate": operator.neg, "degrees": lambda x: x * arb.pi() / 180, "pi": arb.pi,
        "integer_power": lambda base, n: base**n,
        "sin": arb.sin, "cos": arb.cos, "tan": arb.tan, "cot": arb.cot,
        "asin": lambda x: _inside_one(x).asin(), "acos": lambda x: _inside_one(x).acos(), "atan": arb.atan,
        "acot": lambda x: arb.pi() / 2 - x.atan(), "atan2": lambda y, x: arb.atan2(y, x),
        "sinh": arb.sinh, "cosh": arb.cosh, "tanh": arb.tanh, "exp": arb.exp,
        "ln": arb.log, "log": lambda x: x.log() / arb(10).log(), "log_base": lambda x, base: x.log() / base.log(),
        "sqrt": _sqrt, "root": _root, "abs": abs, "sign": _sign,
        "min": lambda a, b: a.min(b), "max": lambda a, b: a.max(b), "macaulay": _macaulay,
    },
)  # fmt: skip
