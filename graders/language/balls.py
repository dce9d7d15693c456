"""The language in ball arithmetic (python-flint): an enclosure of the true value at any precision.

A ball that is not finite means *not sure*; UndefinedError means that there is proved to be no value.
`flint.ctx.prec` belongs to the whole process: balls are used on one thread at a time.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from flint import arb, ctx, fmpq

from graders.language.doubles import UndefinedError
from graders.language.program import Arithmetic
from graders.language.tree import Number

CLAMPING = 256  # bits from which a ball that touches the edge of a domain is cut there
UNSURE = arb("nan")


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
    if number.whole:
        return arb(int(number.digits))
    whole, _, part = number.digits.partition(".")
    figures, power = int(whole + part), number.exponent - len(part)
    return arb(figures * 10**power) if power >= 0 else arb(fmpq(figures, 10**-power))


def _divide(a: Any, b: Any) -> Any:
    if isinstance(b, arb) and b.is_zero():
        raise UndefinedError("a division by zero")
    return a / b


def _sign(x: arb) -> arb:
    if x > 0:
        return arb(1)
    if x < 0:
        return arb(-1)
    if x.is_zero():
        return arb(0)
    return arb(0, 1) if x.is_finite() else UNSURE


def _macaulay(inside: arb, order: arb) -> arb:
    """`<u>^n`, which has no value for n < 0: an impulse."""
    if order < 0:
        raise UndefinedError("an impulse has no value")
    if inside < 0:
        return arb(0)
    if order.is_zero():
        return arb(1) if inside >= 0 else arb(0.5, 0.5) if inside.is_finite() else UNSURE
    if inside > 0:
        return inside**order
    return arb(0) if inside.is_zero() else _clamped(inside) ** order


def _clamped(x: arb) -> arb:
    """Cut the part below zero from a ball that touches zero: the function is continuous there.

    Raises:
        UndefinedError: All of the ball is below zero.
    """
    if x >= 0:
        return x
    if x < 0:
        raise UndefinedError("beyond the edge of a domain")
    return x.nonnegative_part() if ctx.prec >= CLAMPING else UNSURE


def _asin(x: arb) -> arb:
    return x.asin() if -1 < x < 1 else arb.pi() / 2 - _acos(x)


def _acos(x: arb) -> arb:
    """Take the arccosine; at the ends by the root of what is left to them, which is cut there."""
    if -1 < x < 1:
        return x.acos()
    if x > 0:
        return 2 * _clamped((1 - x) / 2).sqrt().asin()
    return arb.pi() - 2 * _clamped((1 + x) / 2).sqrt().asin()


def _logarithm(x: arb) -> arb:
    if x <= 0:
        raise UndefinedError("a logarithm of a number that is not positive")
    return x.log()


def _power(base: arb, exponent: arb) -> arb:
    if not (base.is_finite() and exponent.is_finite()):
        return UNSURE
    if base > 0 or exponent.is_integer():
        if exponent < 0 and base.is_zero():
            raise UndefinedError("a division by zero")
        return base**exponent
    return _clamped(base) ** exponent if exponent > 0 else _positive(base) ** exponent


def _whole_power(base: arb, power: int) -> arb:
    """Raise to a whole power from 0; one of a ball around zero is a product, for `**` is not sure of it."""
    if not base.contains(0):
        return base**power
    if not base.is_finite():
        return UNSURE
    found = arb(1)
    for digit in f"{power:b}":
        found = found * found * base if digit == "1" else found * found
    return found


def _positive(base: arb) -> arb:
    if base <= 0:
        raise UndefinedError("a power of a number that is not positive")
    return base


def _root(radicand: arb, degree: arb) -> arb:
    """Take a root; one of odd degree has a sign."""
    odd = degree.is_integer() and ((degree - 1) / 2).is_integer()
    if odd and not radicand > 0:
        return -((-radicand) ** (1 / degree)) if radicand < 0 else _around_zero(radicand, degree)
    return _power(radicand, _divide(arb(1), degree))


def _around_zero(radicand: arb, degree: arb) -> arb:
    greatest = radicand.abs_upper() ** (1 / degree)
    return arb(0, 1) * greatest


def _arc(y: arb, x: arb) -> arb:
    if y.is_zero() and x.is_zero():
        raise UndefinedError("no direction")
    sure = x.is_finite() and y.is_finite() and not (x.contains(0) and y.contains(0))
    return arb.atan2(y, x) if sure else UNSURE


def _tenths(x: arb) -> arb:
    return _logarithm(x) / arb(10).log()


BALLS = Arithmetic(
    _literal,
    {
        "+": operator.add, "-": operator.sub, "*": operator.mul, "/": _divide, "^": _power,
        "negate": operator.neg, "degrees": lambda x: x * arb.pi() / 180, "pi": arb.pi,
        "integer_power": _whole_power, "power2": lambda x: x * x,
        "sin": arb.sin, "cos": arb.cos, "tan": arb.tan, "cot": arb.cot,
        "asin": _asin, "acos": _acos, "atan": arb.atan,
        "acot": lambda x: arb.pi() / 2 - x.atan(), "atan2": _arc,
        "sinh": arb.sinh, "cosh": arb.cosh, "tanh": arb.tanh, "exp": arb.exp, "ln": _logarithm, "log": _tenths,
        "log_base": lambda x, base: _divide(_logarithm(x), _logarithm(base)),
        "sqrt": lambda x: _clamped(x).sqrt(), "root": _root, "abs": abs, "sign": _sign,
        "min": lambda a, b: a.min(b), "max": lambda a, b: a.max(b), "macaulay": _macaulay,
    },
)  # fmt: skip
