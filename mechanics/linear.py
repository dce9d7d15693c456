"""Systems of linear equations: floats with pivoting, and exact arithmetic.

A system given row by row holds its right-hand side as the last entry of each row.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd
from operator import mul
from typing import TypeVar

from mechanics.errors import SingularError

Number = TypeVar("Number", float, Fraction)

PIVOT_FLOOR = 1e-12


def solve(matrix: Sequence[Sequence[Number]], right: Sequence[Number], floor: float = PIVOT_FLOOR) -> list[Number]:
    """Solve a square system by Gaussian elimination with row pivoting.

    Args:
        matrix: Coefficients, ``(n, n)``, all floats or all Fractions.
        right: Right-hand side, ``(n,)``, of the same kind.
        floor: For floats, the smallest pivot that counts, once columns and rows are scaled to a largest entry of 1.

    Returns:
        The ``n`` unknowns; Fractions are exact.

    Raises:
        ValueError: The system is empty or not square.
        SingularError: No unique solution.
    """
    return solve_with_pivot(matrix, right, floor)[0]


def solve_with_pivot(
    matrix: Sequence[Sequence[Number]], right: Sequence[Number], floor: float = PIVOT_FLOOR
) -> tuple[list[Number], Number]:
    """Solve a square system and tell how near it is to a singular one; arguments and errors as for `solve`.

    Returns:
        The unknowns, and the smallest pivot of the scaled system with the sign of its determinant.
    """
    size = len(matrix)
    if not size or len(right) != size or any(len(row) != size for row in matrix):
        raise ValueError(f"{size} equations need {size} unknowns and {size} right-hand sides")
    scales = [_largest(column) for column in zip(*matrix, strict=True)]
    rows = [_scaled(row, scales, value) for row, value in zip(matrix, right, strict=True)]
    pivots = [_eliminate_below(rows, column, floor) for column in range(size)]
    smallest = min(abs(pivot) for pivot in pivots)
    negative = sum(pivot < 0 for pivot in pivots) % 2
    unknowns = [unknown / scale for unknown, scale in zip(_back_substituted(rows), scales, strict=True)]
    return unknowns, -smallest if negative else smallest


def _largest(entries: Sequence[Number]) -> Number:
    largest = max(map(abs, entries))
    if not largest:
        raise SingularError("an unknown or an equation is empty")
    return largest


def _scaled(row: Sequence[Number], scales: Sequence[Number], value: Number) -> list[Number]:
    coefficients: list[Number] = [entry / scale for entry, scale in zip(row, scales, strict=True)]
    largest = _largest(coefficients)
    coefficients.append(value)
    return [entry / largest for entry in coefficients]


def _eliminate_below(rows: list[list[Number]], column: int, floor: float) -> Number:
    """Clear a column below its pivot; the pivot changes its sign where two rows change places."""
    sizes = [abs(row[column]) for row in rows[column:]]
    best = column + sizes.index(max(sizes))
    rows[column], rows[best] = rows[best], rows[column]
    pivot = rows[column]
    if abs(pivot[column]) <= (floor if isinstance(pivot[column], float) else 0):
        raise SingularError(f"unknown {column + 1} of {len(rows)} is not determined")
    tail = pivot[column:]
    for row in rows[column + 1 :]:
        if row[column]:
            factor = row[column] / pivot[column]
            row[column:] = [entry - factor * above for entry, above in zip(row[column:], tail, strict=True)]
    return pivot[column] if best == column else -pivot[column]


def _back_substituted(rows: list[list[Number]]) -> list[Number]:
    unknowns = [row[-1] for row in rows]
    for i in reversed(range(len(rows))):
        known = sum(map(mul, rows[i][i + 1 : -1], unknowns[i + 1 :]))
        unknowns[i] = (unknowns[i] - known) / rows[i][i]
    return unknowns


def extend(basis: dict[int, list[int]], equation: list[int]) -> bool:
    """Add one equation in integers to an exact reduced system.

    Args:
        basis: The system so far, changed in place: pivot column to row; a row is zero in every
            other pivot column. Starts empty.
        equation: Integer coefficients, then the right-hand side.

    Returns:
        Whether the equation agrees with the system. One that follows from it adds nothing; one
        that contradicts it is left out.
    """
    for column, row in basis.items():
        if equation[column]:
            equation = _combined(equation, row, column)
    pivot = next((i for i, entry in enumerate(equation[:-1]) if entry), None)
    if pivot is None:
        return not equation[-1]
    for column, row in basis.items():
        if row[pivot]:
            basis[column] = _combined(row, equation, pivot)
    basis[pivot] = equation
    return True


def _combined(row: list[int], other: list[int], column: int) -> list[int]:
    keep, take = other[column], row[column]
    result = [keep * x - take * y for x, y in zip(row, other, strict=True)]
    common = gcd(*result)
    return [entry // common for entry in result] if common > 1 else result


def determined(basis: dict[int, list[int]], column: int) -> Fraction | None:
    """Read one unknown of an exact reduced system; None while it is still free."""
    row = basis.get(column)
    if row is None or row.count(0) - (not row[-1]) < len(row) - 2:  # more than one unknown
        return None
    return Fraction(row[-1], row[column])
