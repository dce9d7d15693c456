"""Two arithmetics over a formula: with its first two derivatives, and with its sensitivity to rounding."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any, TypeAlias

from graders.language.doubles import DOUBLES, UndefinedError
from graders.language.program import Arithmetic, Builder, Runner
from graders.language.tree import Number, Tree, names

Trio: TypeAlias = tuple[float, float, float]  # a value, its rate, the rate of the rate
Pair: TypeAlias = tuple[float, float]  # a value, and how much it moves when all inputs move by their own size
Slopes: TypeAlias = Callable[[float], Trio]

DEGREE = math.pi / 180
NOTHING = 1e-12  # of the sensitivity of a value: the rounding of doubles


def _atan(x: float) -> Trio:
    slope = 1 / (1 + x * x)
    return math.atan(x), slope, -2 * x * slope * slope


def _acot(x: float) -> Trio:
    value, slope, bend = _atan(x)
    return math.pi / 2 - value, -slope, -bend


def _tan(x: float) -> Trio:
    t = math.tan(x)
    return t, 1 + t * t, 2 * t * (1 + t * t)


def _cot(x: float) -> Trio:
    t = 1 / math.tan(x)
    return t, -(1 + t * t), 2 * t * (1 + t * t)


def _asin(x: float) -> Trio:
    root = math.sqrt(1 - x * x)
    return math.asin(x), 1 / root, x / root**3


def _acos(x: float) -> Trio:
    value, slope, bend = _asin(x)
    return math.pi / 2 - value, -slope, -bend


def _tanh(x: float) -> Trio:
    t = math.tanh(x)
    return t, 1 - t * t, -2 * t * (1 - t * t)


def _sqrt(x: float) -> Trio:
    root = math.sqrt(x)
    return root, 0.5 / root, -0.25 / (x * root)


FUNCTIONS: dict[str, Slopes] = {
    "negate": lambda x: (-x, -1.0, 0.0),
    "degrees": lambda x: (x * DEGREE, DEGREE, 0.0),
    "sin": lambda x: (math.sin(x), math.cos(x), -math.sin(x)),
    "cos": lambda x: (math.cos(x), -math.sin(x), -math.cos(x)),
    "tan": _tan, "cot": _cot, "asin": _asin, "acos": _acos, "atan": _atan, "acot": _acot,
    "sinh": lambda x: (math.sinh(x), math.cosh(x), math.sinh(x)),
    "cosh": lambda x: (math.cosh(x), math.sinh(x), math.cosh(x)),
    "tanh": _tanh,
    "exp": lambda x: (math.exp(x), math.exp(x), math.exp(x)),
    "ln": lambda x: (math.log(x), 1 / x, -1 / (x * x)),
    "log": lambda x: (math.log10(x), 1 / (x * math.log(10)), -1 / (x * x * math.log(10))),
    "sqrt": _sqrt,
    "abs": lambda x: (abs(x), math.copysign(1.0, x), 0.0),
    "sign": lambda x: (float((x > 0) - (x < 0)), 0.0, 0.0),
}  # fmt: skip


def _power(base: float, exponent: float) -> Trio:
    """Give a power with a constant exponent and its slopes."""
    if exponent == 0:
        return 1.0, 0.0, 0.0
    value, slope = DOUBLES.functions["^"](base, exponent), exponent
    first = slope * DOUBLES.functions["^"](base, exponent - 1) if exponent != 1 else 1.0
    second = exponent * (exponent - 1)
    return value, first, second * DOUBLES.functions["^"](base, exponent - 2) if second else 0.0


def chained(slopes: Trio, inner: Trio) -> Trio:
    """Differentiate g(f): g', f' and the second derivatives by the chain rule."""
    value, first, second = slopes
    return value, first * inner[1], second * inner[1] ** 2 + first * inner[2]


def times(a: Trio, b: Trio) -> Trio:
    """Multiply with the product rule."""
    return a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2 * a[1] * b[1] + a[0] * b[2]


def _plus(a: Trio, b: Trio) -> Trio:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _minus(a: Trio, b: Trio) -> Trio:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _over(a: Trio, b: Trio) -> Trio:
    return times(a, chained((1 / b[0], -1 / b[0] ** 2, 2 / b[0] ** 3), b))


def direction(y: Trio, x: Trio) -> Trio:
    """Give atan2(y, x) and its rates."""
    square = x[0] ** 2 + y[0] ** 2
    first = (x[0] * y[1] - y[0] * x[1]) / square
    second = (x[0] * y[2] - y[0] * x[2]) / square - 2 * first * (x[0] * x[1] + y[0] * y[1]) / square
    return math.atan2(y[0], x[0]), first, second


def distance(x: Trio, y: Trio) -> Trio:
    """Give the length of (x, y) and its rates."""
    return chained(_sqrt(x[0] ** 2 + y[0] ** 2), _plus(times(x, x), times(y, y)))


def _raised(base: Trio, exponent: Trio) -> Trio:
    if exponent[1] == exponent[2] == 0:
        return chained(_power(base[0], exponent[0]), base)
    return chained(
        FUNCTIONS["exp"](math.log(base[0]) * exponent[0]), times(chained(FUNCTIONS["ln"](base[0]), base), exponent)
    )


def _bracket(inside: Trio, order: Trio) -> Trio:
    return (0.0, 0.0, 0.0) if inside[0] < 0 else _raised(inside, order)


def _lifted(slopes: Slopes) -> Callable[[Trio], Trio]:
    return lambda inner: chained(slopes(inner[0]), inner)


def constant(number: Number) -> Trio:
    """Read a literal, which has no rate."""
    return DOUBLES.literal(number), 0.0, 0.0


JETS = Arithmetic(
    constant,
    {
        **{name: _lifted(slopes) for name, slopes in FUNCTIONS.items()},
        "+": _plus, "-": _minus, "*": times, "/": _over, "^": _raised, "pi": lambda: (math.pi, 0.0, 0.0),
        "integer_power": lambda base, n: chained(_power(base[0], float(n)), base),
        "atan2": direction, "min": min, "max": max, "macaulay": _bracket,
        "root": lambda x, n: _raised(x, _over((1.0, 0.0, 0.0), n)),
        "log_base": lambda x, b: _over(chained(FUNCTIONS["ln"](x[0]), x), chained(FUNCTIONS["ln"](b[0]), b)),
    },
)  # fmt: skip


def _felt(slopes: Slopes) -> Callable[[Pair], Pair]:
    def feel(inner: Pair) -> Pair:
        value, slope, _ = slopes(inner[0])
        return value, abs(value) + abs(slope) * inner[1]

    return feel


class UnsureError(ArithmeticError):
    """A jump stands where rounding alone decides its side."""


def _jump(value: Callable[[float], float]) -> Callable[[Pair], Pair]:
    """Feel a jump at zero: what is nothing beside its own parts has no sure side."""

    def feel(inner: Pair) -> Pair:
        if abs(inner[0]) <= NOTHING * inner[1]:
            raise UnsureError
        return value(inner[0]), abs(value(inner[0]))

    return feel


def _two(function: Callable[[Trio, Trio], Trio]) -> Callable[[Pair, Pair], Pair]:
    """Feel a function of two arguments through its derivative by each."""

    def feel(a: Pair, b: Pair) -> Pair:
        value, by_a, _ = function((a[0], 1.0, 0.0), (b[0], 0.0, 0.0))
        _, by_b, _ = function((a[0], 0.0, 0.0), (b[0], 1.0, 0.0))
        return value, abs(value) + abs(by_a) * a[1] + abs(by_b) * b[1]

    return feel


_step = _jump(lambda x: float(x > 0))
_higher = _two(_bracket)


def _felt_bracket(inside: Pair, order: Pair) -> Pair:
    return _step(inside) if order[0] == 0 else _higher(inside, order)


SENSITIVE = Arithmetic(
    lambda number: (DOUBLES.literal(number), abs(DOUBLES.literal(number))),
    {
        **{name: _felt(slopes) for name, slopes in FUNCTIONS.items()},
        **{name: _two(JETS.functions[name]) for name in ("/", "^", "atan2", "min", "max", "root")},
        "log_base": _two(JETS.functions["log_base"]),
        "sign": _jump(DOUBLES.functions["sign"]),
        "macaulay": _felt_bracket,
        "+": lambda a, b: (a[0] + b[0], a[1] + b[1]),
        "-": lambda a, b: (a[0] - b[0], a[1] + b[1]),
        "*": lambda a, b: (a[0] * b[0], abs(a[0]) * b[1] + abs(b[0]) * a[1]),
        "pi": lambda: (math.pi, math.pi),
        "integer_power": lambda base, n: _felt(lambda x: _power(x, float(n)))(base),
    },
)  # fmt: skip


@lru_cache(maxsize=2048)
def runner(tree: Tree, arithmetic: str) -> Runner:
    """Make a runner for a tree in `jets` or `sensitive` arithmetic; its inputs are the names in the tree, sorted."""
    builder = Builder(sorted(names(tree)))
    return Runner(builder.program(builder.add(tree)), JETS if arithmetic == "jets" else SENSITIVE)


def _run(tree: Tree, arithmetic: str, values: Mapping[str, Any]) -> Any:
    made = runner(tree, arithmetic)
    try:
        (found,) = made.run([values[name] for name in made.inputs])
    except (ValueError, ArithmeticError, TypeError) as error:
        raise UndefinedError(str(error)) from error
    if not all(map(math.isfinite, found)):
        raise UndefinedError("not a finite value")
    return found


def jet(tree: Tree, values: Mapping[str, Trio]) -> Trio:
    """Compute a formula and its first two rates from those of its names; raises UndefinedError, KeyError."""
    found: Trio = _run(tree, "jets", values)
    return found


def sensitive(tree: Tree, values: Mapping[str, float]) -> Pair:
    """Compute a formula and its sensitivity; raises UndefinedError, KeyError."""
    found: Pair = _run(tree, "sensitive", {name: (value, abs(value)) for name, value in values.items()})
    return found
