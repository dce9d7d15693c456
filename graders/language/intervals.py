"""The language in intervals of doubles: all values that a formula can take on a box.

They choose where balls look. Ends are not rounded outwards: whoever asks for a sign leaves a margin.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TypeAlias

from graders.language.doubles import DEGREE, DOUBLES
from graders.language.program import Arithmetic
from graders.language.tree import Number

Interval: TypeAlias = tuple[float, float]

ALL: Interval = (-math.inf, math.inf)
TURN = 2 * math.pi
MARGIN = 1e-12  # of the ends, which are not rounded outwards


def side_of_zero(values: Interval) -> int:
    """Give the sign of all of some values; 0 where it may be either, or none."""
    low, high = values
    margin = MARGIN * max(abs(low), abs(high))
    margin = margin if margin < math.inf else 0.0
    return int(low > margin) - int(high < -margin)


def _literal(number: Number) -> Interval:
    value = DOUBLES.literal(number)
    return value, value


def _hull(*values: float) -> Interval:
    """Give the least interval around some values; everything where one of them does not exist."""
    return ALL if any(map(math.isnan, values)) else (min(values), max(values))


def _multiply(a: Interval, b: Interval) -> Interval:
    if a[0] > 0 and b[0] > 0:
        return a[0] * b[0], a[1] * b[1]
    return _hull(a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1])


def _divide(a: Interval, b: Interval) -> Interval:
    if not (0 < b[0] <= b[1] or b[0] <= b[1] < 0):
        return ALL
    return _multiply(a, (1 / b[1], 1 / b[0]))


def _rising(
    function: Callable[[float], float], low: float = -math.inf, high: float = math.inf
) -> Callable[[Interval], Interval]:
    """Make the image of a rising function that exists from `low` to `high`."""

    def image(x: Interval) -> Interval:
        if not (x[0] <= high and x[1] >= low):
            return ALL
        return _value(function, max(x[0], low)), _value(function, min(x[1], high))

    return image


def _value(function: Callable[[float], float], x: float) -> float:
    try:
        return function(x)
    except OverflowError:
        return math.copysign(math.inf, x)
    except ValueError:
        return -math.inf  # a logarithm of zero


def _sine(x: Interval, shift: float = 0.0) -> Interval:
    low, high = x[0] + shift, x[1] + shift
    if not high - low < TURN:
        return -1.0, 1.0
    ends = math.sin(low), math.sin(high)
    top = math.floor((high - math.pi / 2) / TURN) > math.floor((low - math.pi / 2) / TURN)
    bottom = math.floor((high + math.pi / 2) / TURN) > math.floor((low + math.pi / 2) / TURN)
    return (-1.0 if bottom else min(ends)), (1.0 if top else max(ends))


def _cosine(x: Interval) -> Interval:
    return _sine(x, math.pi / 2)


def _tangent(x: Interval) -> Interval:
    if not x[1] - x[0] < math.pi or math.floor(x[0] / math.pi + 0.5) != math.floor(x[1] / math.pi + 0.5):
        return ALL
    return math.tan(x[0]), math.tan(x[1])


def _square(x: Interval, _: Interval) -> Interval:
    low, high = x[0] * x[0], x[1] * x[1]
    if x[0] > 0:
        return low, high
    if x[0] <= 0 <= x[1]:
        return 0.0, max(low, high)
    return (high, low) if x[1] < 0 else ALL


def _power(x: Interval, n: int) -> Interval:
    ends = _end_power(x[0], n), _end_power(x[1], n)
    if n % 2 == 0:
        return (0.0 if x[0] <= 0 <= x[1] else min(ends)), max(ends)
    return ends


def _end_power(end: float, n: int) -> float:
    try:
        return end**n
    except OverflowError:
        return math.inf if end > 0 or n % 2 == 0 else -math.inf


def _general_power(base: Interval, exponent: Interval) -> Interval:
    if exponent[0] == exponent[1] and float(exponent[0]).is_integer() and abs(exponent[0]) < 1000:
        n = int(exponent[0])
        return _power(base, n) if n >= 0 else _divide((1.0, 1.0), _power(base, -n))
    if base[0] < 0:
        return ALL
    return _exponential(_multiply(_logarithm(base), exponent))


def _absolute(x: Interval) -> Interval:
    return (x[0], x[1]) if x[0] >= 0 else (-x[1], -x[0]) if x[1] <= 0 else (0.0, max(-x[0], x[1]))


def _macaulay(inside: Interval, order: Interval) -> Interval:
    if order[0] != order[1] or order[0] < 0:
        return 0.0, math.inf
    opened = max(inside[0], 0.0), max(inside[1], 0.0)
    if order[0] == 0:
        return float(inside[0] >= 0), float(inside[1] >= 0)
    return _general_power(opened, order)


def _angle(y: Interval, x: Interval) -> Interval:
    if x[0] > 0:
        return _rising(math.atan)(_divide(y, x))
    return -math.pi, math.pi


def _root(radicand: Interval, degree: Interval) -> Interval:
    if degree[0] != degree[1] or degree[0] <= 0:
        return ALL
    odd = degree[0] % 2 == 1
    if radicand[0] < 0 and (odd or radicand[1] < 0):
        return ALL
    return _general_power((max(radicand[0], 0.0), max(radicand[1], 0.0)), (1 / degree[0], 1 / degree[0]))


def _sign(x: Interval) -> Interval:
    return float((x[0] > 0) - (x[0] < 0)), float((x[1] > 0) - (x[1] < 0))


_exponential = _rising(math.exp)
_logarithm = _rising(math.log, 0.0)

INTERVALS = Arithmetic(
    _literal,
    {
        "+": lambda a, b: (a[0] + b[0], a[1] + b[1]), "-": lambda a, b: (a[0] - b[1], a[1] - b[0]),
        "*": _multiply, "/": _divide, "^": _general_power, "negate": lambda x: (-x[1], -x[0]),
        "degrees": lambda x: (x[0] * DEGREE, x[1] * DEGREE), "pi": lambda: (math.pi, math.pi), "integer_power": _power,
        "square": _square,
        "sin": _sine, "cos": _cosine, "tan": _tangent, "cot": lambda x: _divide((1.0, 1.0), _tangent(x)),
        "asin": _rising(math.asin, -1.0, 1.0), "atan": _rising(math.atan),
        "acos": lambda x: _negated(_rising(math.asin, -1.0, 1.0)(x), math.pi / 2),
        "acot": lambda x: _negated(_rising(math.atan)(x), math.pi / 2), "atan2": _angle,
        "sinh": _rising(math.sinh), "cosh": lambda x: _rising(math.cosh)(_absolute(x)), "tanh": _rising(math.tanh),
        "exp": _exponential, "ln": _logarithm, "log": _rising(math.log10, 0.0),
        "log_base": lambda x, base: _divide(_logarithm(x), _logarithm(base)), "sqrt": _rising(math.sqrt, 0.0),
        "root": _root, "abs": _absolute, "sign": _sign,
        "min": lambda a, b: (min(a[0], b[0]), min(a[1], b[1])), "max": lambda a, b: (max(a[0], b[0]), max(a[1], b[1])),
        "macaulay": _macaulay,
    },
)  # fmt: skip


def _negated(x: Interval, start: float) -> Interval:
    return start - x[1], start - x[0]
