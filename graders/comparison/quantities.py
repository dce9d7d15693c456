"""Amounts with units of a request."""

from __future__ import annotations

from itertools import product
from math import pi, remainder

from graders.amounts import Amount
from graders.comparison.outcome import EQUAL, Answer, Why, different
from graders.comparison.request import NOTHING, Request
from graders.comparison.texts import Unread
from graders.kinds.quantity import Quantity
from graders.language import AnswerSyntaxError
from graders.units import NONE, Unit, fits, readings

ANGLE = (0, 0, 0, 1, 0)
SLACK = 1e-12  # of a value: what reading decimals and changing units costs
READER = Quantity("1")


def compare_quantities(request: Request, secret: bytes) -> Answer:
    """Compare two amounts: dimension first, then the value within `rtol` of the size of `a`, angles modulo a turn.

    A number without a unit is a pure number, which may stand for an angle in radians.
    """
    a, b = _amount(request.a[0], "a"), _amount(request.b[0], "b")
    one, other = _unit(a, b), _unit(b, a)
    if not (fits(other, one) or (one.dimension != other.dimension and fits(one, other))):
        return different(Why.DIMENSION)
    turns = one.dimension == other.dimension == ANGLE
    pairs = [(a.number * mine, b.number * yours) for mine, yours in product(readings(one, other), readings(other, one))]
    if any(_close(value, typed, request.rtol, turns) for value, typed in pairs):
        return EQUAL
    return different(Why.VALUE, (("a", pairs[0][0]), ("b", pairs[0][1])))


def _amount(text: str, side: str) -> Amount:
    try:
        return READER.parse(text, NOTHING)
    except AnswerSyntaxError as error:
        raise Unread(error, side) from None


def _unit(amount: Amount, beside: Amount) -> Unit:
    """Give the unit of an amount; a pure number beside an angle is in radians."""
    if amount.unit is not None:
        return amount.unit
    angle = beside.unit is not None and beside.unit.dimension == ANGLE
    return Unit(ANGLE, 1.0) if angle else NONE


def _close(value: float, typed: float, rtol: float, turns: bool) -> bool:
    difference = remainder(typed - value, 2 * pi) if turns else typed - value
    return abs(difference) <= rtol * abs(value) + SLACK * max(abs(value), abs(typed))
