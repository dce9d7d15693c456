"""Amounts, and one value told more than once: `0,5 m = 500 mm`, `l = 0,5 m = 500 mm`."""

from __future__ import annotations

import re
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import Symbols
from graders.language.tree import Number, Tree, walk
from graders.measured import WORD
from graders.units import Unit, fits

LONGEST = 200  # characters of a text that may tell a value more than once
ROUNDED = 2e-4  # relative, what rounding on the way adds to an answer
SLACK = 1e-12  # so that a value on the printed border of a tolerance is inside
EQUALS = re.compile("[=≈]")


@dataclass(frozen=True, slots=True)
class Amount:
    """A number as typed, its unit as typed (None: read in the printed unit), and the value in SI units."""

    tree: Tree
    number: float
    unit: Unit | None
    unit_text: str
    value: float

    @property
    def numbers(self) -> list[Number]:
        """Give the numbers in it: a single one where nothing was computed."""
        return [node for node in walk(self.tree) if isinstance(node, Number)]

    @property
    def rounding(self) -> float:
        """Give half of the last figure of a number as typed, in SI units; of a computed one what rounding may add."""
        numbers = self.numbers
        if len(numbers) != 1 or not self.value:
            return ROUNDED * abs(self.value)
        half = 0.5 * 10.0 ** (numbers[0].exponent - len(numbers[0].digits.partition(".")[2]))
        return half * abs(self.value / float(numbers[0].exact))


@dataclass(frozen=True, slots=True)
class Side:
    """What stands beside a sign of equality and is an amount by itself."""

    text: str
    amount: Amount

    def literal(self, symbols: Symbols) -> bool:
        """Tell whether nothing is computed in it, not even with a symbol that looks like a unit, `d = 20 m`."""
        return len(self.amount.numbers) == 1 and not any(map(symbols.find, WORD.findall(self.amount.unit_text)))


def sides(text: str, read: Callable[[str], Amount]) -> list[Side]:
    """Read the sides of a text that are amounts; none where there is but one side."""
    texts = EQUALS.split(text) if len(text) <= LONGEST else []
    found = []
    for side in texts if len(texts) > 1 else []:
        with suppress(AnswerSyntaxError):
            found.append(Side(side.strip(), read(side)))
    return found


def is_pair(text: str) -> bool:
    """Tell whether a text has two sides."""
    return len(EQUALS.findall(text)) == 1


def comparable(one: Amount, other: Amount) -> bool:
    """Tell whether two amounts can be one value: both without a unit, or in units that fit."""
    if one.unit is None or other.unit is None:
        return one.unit is other.unit
    return fits(one.unit, other.unit) or fits(other.unit, one.unit)


def one_value(told: list[Side], text: str) -> Amount:
    """Give the finest amount of sides that tell one value; raises AnswerSyntaxError where they differ."""
    last = told[-1]
    for side in told[:-1]:
        if not comparable(side.amount, last.amount) or _differ(side.amount, last.amount):
            place = max(found.start() for found in EQUALS.finditer(text))
            raise AnswerSyntaxError(Reason.TWO_VALUES, place, f"{side.text[:20]} ≠ {last.text[:20]}")
    return min((side.amount for side in reversed(told)), key=lambda amount: amount.rounding)


def _differ(one: Amount, other: Amount) -> bool:
    """Tell whether no number is rounded to both."""
    off = abs(one.value - other.value)
    return off > SLACK * abs(other.value) and off >= (one.rounding + other.rounding) * (1 - SLACK)
