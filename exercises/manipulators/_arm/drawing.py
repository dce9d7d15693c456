"""What the arms of TMM-2 draw alike: whole degrees and rates, and that no result is a small difference."""

from __future__ import annotations

from math import hypot, pi, radians, remainder

from exercises.draw import Draw
from exercises.exercise import Steps, Value
from exercises.manipulators._arm import Sides, terms
from exercises.solving import evaluate

ANGLES = [a for a in range(-150, 151, 5) if a % 90 not in (0, 5, 45, 85)]  # degrees, far from where sin = +-cos or 0
CANCELLED = 0.2  # a sum below this part of its terms is lost in the rounding of earlier results
Trio = tuple[float, float, float]
LEVEL = 0.15  # rad: a direction nearer to an axis cannot be told by its sine


def lengths(rng: Draw) -> Trio:
    """Draw two links and a travel, in whole centimetres, m."""
    return rng.pick(range(30, 61)) / 100, rng.pick(range(20, 51)) / 100, rng.pick(range(10, 31)) / 100


def angles(rng: Draw) -> tuple[float, float]:
    """Draw two angles in whole degrees, rad."""
    return radians(rng.pick(ANGLES)), radians(rng.pick(ANGLES))


def rates(rng: Draw, word: str) -> Trio:
    """Draw a rate for each joint of a word over R and P, in tenths of rad/s or hundredths of m/s."""
    one, two, three = (_signed(rng, range(3, 13), 10) if j == "R" else _signed(rng, range(6, 26), 100) for j in word)
    return one, two, three


def accelerations(rng: Draw, word: str) -> Trio:
    """Draw an acceleration for each joint, in tenths of rad/s^2 or hundredths of m/s^2."""
    one, two, three = (_signed(rng, range(2, 16), 10) if j == "R" else _signed(rng, range(10, 41), 100) for j in word)
    return one, two, three


def _signed(rng: Draw, amounts: range, parts: int) -> float:
    return rng.pick((-1, 1)) * rng.pick(amounts) / parts


def clear(start: dict[str, float], steps: Steps, sides: Sides) -> bool:
    """Tell whether every result stands clear of zero and of what a lost term would give."""
    values: dict[str, Value] = dict(start)
    for name, line in steps.items():
        if name == "x_D" and not (_turned(start, values) and all(_whole(found, values) for found in terms(sides))):
            return False  # the directions tell, and refuse four of five draws
        values[name] = evaluate(line, values)
    return abs(_number("k_v", values) - 1) > CANCELLED and _node_moves(sides, values)


def _node_moves(sides: Sides, values: dict[str, Value]) -> bool:
    """Tell whether velocity and acceleration of the node C are no small difference of their terms."""
    _, _, *rates = terms(sides[:2])
    for name, *axes in zip(("v_C", "a_C"), rates[:2], rates[2:], strict=True):
        sizes = (sum(abs(_number(term, values)) for term in found) for found in axes)
        if _number(name, values) < CANCELLED * hypot(*sizes):
            return False
    return True


def _turned(start: dict[str, float], values: dict[str, Value]) -> bool:
    """Tell whether the last link turns, and lies clear of the axes."""
    parts = [abs(start[f"Theta{i}{mark}"]) for mark in ("_d", "_dd") for i in (1, 2, 3) if f"Theta{i}{mark}" in start]
    turned = (_number(name, values) for name in ("omega3", "epsilon3"))
    level = abs(remainder(_number("alpha3", values), pi / 2)) > LEVEL
    return level and all(abs(one) > CANCELLED * max(parts) for one in turned)


def _whole(terms: tuple[str, ...], values: dict[str, Value]) -> bool:
    """Tell whether a sum is no small difference of its terms."""
    found = [_number(term, values) for term in terms]
    return abs(sum(found)) > CANCELLED * sum(map(abs, found))


def _number(line: str, values: dict[str, Value]) -> float:
    found = evaluate(line, values)
    assert isinstance(found, float | int)
    return float(found)
