"""The sign of a sum or a product that follows from the signs of its two parts: where x < 0, 1 - x is above zero."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, TypeAlias

from graders.equality.deciding import PRECISIONS, Finding, zero

FLAT = 1e-9  # of the products in a determinant: what doubles leave of zero
Column: TypeAlias = Sequence[Any]  # a ball at each of the points


class Signed(NamedTuple):
    """Values at the first three points whose sign is known, and whether they are below zero."""

    column: Column
    below: bool


Screened: TypeAlias = tuple[Signed, Sequence[float]]


def implied(inside: Column, known: Sequence[Signed], others: Sequence[Screened]) -> bool | None:
    """Tell whether a column is below zero because of what has a sign; None where this does not tell.

    It may be a sum of multiples of two columns, or the product of one by another or by its inverse.

    Args:
        inside: The column.
        known: Columns of a case, each with its sign in it.
        others: More columns of one sign.
    """
    one, values = [screened(signed) for signed in known], doubles(inside)
    two = [*one, *others]
    for at, (first, a) in enumerate(one):
        x, y, z = (
            a[1] * values[2] - a[2] * values[1],
            a[2] * values[0] - a[0] * values[2],
            a[0] * values[1] - a[1] * values[0],
        )
        over, under = values[0] * a[1], values[1] * a[0]
        for second, (b, c, d) in two[at + 1 :]:
            p, q, found = x * b, y * c, None
            if abs(p + q + z * d) <= FLAT * (abs(p) + abs(q)):
                found = _of_sum(inside, first, second)
            elif abs(over * c - under * b) <= FLAT * abs(over * c):
                found = _of_product(inside, first, second, _times)
            elif abs(over * b - under * c) <= FLAT * abs(over * b):
                found = _of_product(inside, first, second, _over)
            if found is not None:
                return found
    return None


def screened(signed: Signed) -> Screened:
    """Give a column with its doubles."""
    return signed, doubles(signed.column)


def doubles(column: Column) -> list[float]:
    """Give the values of a column at the first three points in doubles."""
    return [float(x) for x in column[:3]]


def _of_sum(inside: Column, one: Signed, other: Signed) -> bool | None:
    """Tell the sign of a sum from its terms: both have it, and the third point says that there is no other term."""
    (a, b, c), (d, e, f), (u, v, w) = one.column[:3], other.column[:3], inside[:3]
    size = a * e - b * d
    if size.contains(0):
        return None
    first, second = (u * e - v * d) / size, (a * v - b * u) / size
    if not _equal(w, first * c + second * f):
        return None
    terms = [(factor, signed) for factor, signed in ((first, one), (second, other)) if not factor.contains(0)]
    signs = {(factor > 0) is signed.below for factor, signed in terms}
    return signs.pop() if len(signs) == 1 else None


def _of_product(
    inside: Column, one: Signed, other: Signed, product: Callable[[Column, Column], list[Any]]
) -> bool | None:
    """Tell the sign of a product, or of a quotient, from its factors: it is a multiple of theirs at three points."""
    values = product(one.column, other.column)
    factor = inside[0] / values[0]
    if factor.contains(0) or not all(_equal(x, factor * y) for x, y in zip(inside[1:3], values[1:], strict=True)):
        return None
    return (one.below is not other.below) is (factor > 0)


def _times(one: Column, other: Column) -> list[Any]:
    return [x * y for x, y in zip(one[:3], other[:3], strict=True)]


def _over(one: Column, other: Column) -> list[Any]:
    return [x / y for x, y in zip(one[:3], other[:3], strict=True)]


def _equal(one: Any, other: Any) -> bool:
    return zero(one, other, PRECISIONS[0]) is Finding.EQUAL
