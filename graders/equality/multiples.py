"""What the value of a function says of another: at the end of its domain, or for a multiple of its argument."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, NamedTuple

from flint import arb

from graders.equality.deciding import SMALL
from graders.equality.signs import Column
from graders.language.intervals import Interval
from graders.language.program import Program
from graders.states import Point

AT_EDGE: Mapping[str, Sequence[tuple[int, Callable[[], Any]]]] = {  # values at the ends of domains
    "sqrt": ((0, lambda: arb(0)),),
    "asin": ((1, lambda: arb.pi() / 2), (-1, lambda: -arb.pi() / 2)),
    "acos": ((1, lambda: arb(0)), (-1, arb.pi)),
}


REACH = 2.0  # of drawn numbers, where the values of a function reach further
ANGLES = {"asin": "asin", "acos": "asin", "atan": "atan", "acot": "atan", "atan2": "atan2"}


SHIFTED = {"acos": "asin", "acot": "atan"}  # a right angle less the other


class Known(NamedTuple):
    """A function for which a number was drawn: its kind, its arguments, the number."""

    kind: str
    arguments: Sequence[Column]
    value: Column


def of_other_angles(program: Program, sides: Sequence[Collection[int]]) -> bool:
    """Tell whether the two sides, by the slots they stand on, hold angles of other kinds.

    Numbers drawn for these agree by chance alone.
    """
    if ANGLES.keys().isdisjoint(name for name, _ in program.operations):
        return False
    start = len(program.inputs)
    kinds = [
        {
            kind
            for slot, (name, _) in enumerate(program.operations, start)
            if slot in side and (kind := ANGLES.get(name))
        }
        for side in sides
    ]
    return all(kinds) and kinds[0] != kinds[1]


def kind_of(name: str) -> str:
    """Give the function by which another one is known: an arccosine by the arcsine."""
    return SHIFTED.get(name, name)


def number_for(slot: int, values: Interval, points: Sequence[Point]) -> Column:
    """Draw a number for a slot at each point, as secret as the point; a large one would hide what is small."""
    low, high = values
    if low > REACH:
        high = min(high, 2 * low)
    elif high < -REACH:
        low = max(low, 2 * high)
    else:
        low, high = max(low, -REACH), min(high, REACH)
    shares = [(hash((point, slot)) % 2**52) / 2**52 for point in points]
    return [arb(low + (high - low) * (0.1 + 0.8 * share)) for share in shares]


def at_edge(name: str, column: Column) -> Any:
    """Give the value of a function whose argument is an end of its domain at all points; None where it is not."""
    for edge, value in AT_EDGE.get(name, ()):
        if all(_is_number(x, edge) for x in column):
            return value()
    return None


def is_one(factor: Any) -> bool:
    """Tell whether a ball is one to thirty digits."""
    return _is_number(factor, 1)


def _is_number(value: Any, number: int) -> bool:
    """Tell whether a ball holds a whole number and nothing that thirty digits tell from it."""
    return bool((value - number).abs_upper() < SMALL)


MULTIPLES: Mapping[str, Callable[[Any, Any], Any]] = {  # f(k u) from k and f(u)
    "exponent": lambda k, value: k * value,
    "abs": lambda k, value: abs(k) * value,
    "bracket": lambda k, value: k * value if k > 0 else None,
    "step": lambda k, value: value if k > 0 else None,
    "sqrt": lambda k, value: k.sqrt() * value if k > 0 else None,
    "ln": lambda k, value: k.log() + value if k > 0 else None,
    "sign": lambda k, value: value if k > 0 else -value if k < 0 else None,
    "asin": lambda k, value: k * value if is_one(abs(k)) else None,
    "atan": lambda k, value: k * value if is_one(abs(k)) else None,
}


def multiple(kind: str, factors: Sequence[Any], value: Column) -> Column | None:
    """Give a function of multiples of arguments from its number for these; None where it is another number."""
    factor = factors[0]
    if kind in MULTIPLES:
        found = [MULTIPLES[kind](factor, x) for x in value]
        return None if None in found else found
    if kind == "atan2":
        return value if factor > 0 and is_one(factor / factors[1]) else None
    return value if all(map(is_one, factors)) else None
