"""Polynomials in one variable: their arithmetic in the answer language, their values, slopes and zeros.

A polynomial is the tuple of its coefficients by rising powers.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise, zip_longest
from typing import TypeAlias

from graders.language.doubles import DOUBLES
from graders.language.program import Arithmetic

Polynomial: TypeAlias = tuple[float, ...]

MAX_DEGREE = 6
HALVINGS = 60


class NotPolynomialError(ValueError):
    """The variable stands where a polynomial cannot have it."""


def value(p: Polynomial, t: float) -> float:
    """Compute p(t)."""
    found = 0.0
    for coefficient in reversed(p):
        found = found * t + coefficient
    return found


def derivative(p: Polynomial) -> Polynomial:
    """Differentiate."""
    return tuple(power * c for power, c in enumerate(p))[1:] or (0.0,)


def shifted(p: Polynomial, by: float) -> Polynomial:
    """Give the coefficients of p(t + by), by repeated synthetic division."""
    found = list(p)
    for low in range(len(found) - 1):
        for at in range(len(found) - 2, low - 1, -1):
            found[at] += by * found[at + 1]
    return tuple(found)


def crossings(p: Polynomial, low: float, high: float) -> list[float]:
    """Give the places between two others where p changes sign, in order.

    Source:
        Between two zeros of its derivative a polynomial is monotone: each change of sign there is bisected.
    """
    if len(p) < 2:
        return []
    if len(p) == 2:
        inner: list[float] = []
    else:
        inner = crossings(derivative(p), low, high)
    spots = [low, *inner, high]
    return [_bisected(p, a, b) for a, b in pairwise(spots) if value(p, a) * value(p, b) < 0]


def _bisected(p: Polynomial, low: float, high: float) -> float:
    rises = value(p, low) < 0
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        if (value(p, middle) < 0) == rises:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def _sum(a: Polynomial, b: Polynomial) -> Polynomial:
    return tuple(x + y for x, y in zip_longest(a, b, fillvalue=0.0))


def _negated(a: Polynomial) -> Polynomial:
    return tuple(-x for x in a)


def _product(a: Polynomial, b: Polynomial) -> Polynomial:
    if len(a) + len(b) - 2 > MAX_DEGREE:
        raise NotPolynomialError("the degree is too high")
    found = [0.0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            found[i + j] += x * y
    return tuple(found)


def constant(p: Polynomial) -> float:
    """Give the value of a polynomial that is a number.

    Raises:
        NotPolynomialError: The variable stands in it.
    """
    if len(p) > 1:
        raise NotPolynomialError("a number is needed here")
    return p[0]


def _quotient(a: Polynomial, b: Polynomial) -> Polynomial:
    divisor = constant(b)
    return tuple(x / divisor for x in a)


def _power(base: Polynomial, power: int) -> Polynomial:
    if len(base) == 1:
        return (base[0] ** power,)
    if (len(base) - 1) * power > MAX_DEGREE:
        raise NotPolynomialError("the degree is too high")
    found: Polynomial = (1.0,)
    for _ in range(power):
        found = _product(found, base)
    return found


def _raised(base: Polynomial, exponent: Polynomial) -> Polynomial:
    power = constant(exponent)
    if len(base) == 1:
        return (DOUBLES.functions["^"](base[0], power),)
    if power < 0 or not power.is_integer():
        raise NotPolynomialError("a power of the variable must be a whole number")
    return _power(base, int(power))


def _of_numbers(function: Callable[..., float]) -> Callable[..., Polynomial]:
    return lambda *arguments: (function(*map(constant, arguments)),)


def arithmetic(opened: Callable[[Polynomial], bool]) -> Arithmetic:
    """Make the arithmetic of polynomials.

    Args:
        opened: Tells of what stands in a Macaulay bracket whether it is positive where the polynomial is wanted.
    """

    def bracket(inside: Polynomial, order: Polynomial) -> Polynomial:
        power = constant(order)
        if power < 0:
            raise NotPolynomialError("a bracket of negative order has no value")
        return _power(inside, int(power)) if opened(inside) else (0.0,)

    functions: dict[str, Callable[..., Polynomial]] = {
        name: _of_numbers(function) for name, function in DOUBLES.functions.items()
    }
    functions |= {
        "+": _sum, "-": lambda a, b: _sum(a, _negated(b)), "*": _product, "/": _quotient, "^": _raised,
        "negate": _negated, "integer_power": _power, "macaulay": bracket,
        "degrees": lambda a: tuple(math.radians(x) for x in a),
    }  # fmt: skip
    return Arithmetic(lambda number: (DOUBLES.literal(number),), functions)
