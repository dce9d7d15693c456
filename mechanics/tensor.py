"""Symmetric tensors of stress and strain: components on x, y, z, principal values and directions (domain SM-15)."""

from __future__ import annotations

from collections.abc import Sequence
from math import fsum, hypot, sqrt

from mechanics.checks import finite
from mechanics.vectors import Vector, cross

Matrix = tuple[Vector, Vector, Vector]

# Components that differ by less than this part of the largest are equal, as symmetry wants them.
_SYMMETRIC = 1e-9
_SWEEPS = 30  # Jacobi's method doubles its digits with each: five are enough


def symmetric(rows: Sequence[Sequence[float]], name: str, unit: str) -> Matrix:
    """Take a symmetric tensor, (3, 3).

    Raises:
        ValueError: It is not of three rows of three, not finite, or not symmetric.
    """
    if len(rows) != 3 or any(len(row) != 3 for row in rows):
        raise ValueError(f"{name} must have three rows of three components")
    for row in rows:
        for value in row:
            finite(f"{name} component", value, unit)
    largest = max(abs(value) for row in rows for value in row)
    for i, j in ((0, 1), (1, 2), (0, 2)):
        if abs(rows[i][j] - rows[j][i]) > _SYMMETRIC * largest:
            raise ValueError(
                f"{name} must be symmetric: {'xyz'[i]}{'xyz'[j]} = {rows[i][j]} {unit} is not {rows[j][i]} {unit}"
            )
    (a, b, c), (_, d, e), (_, _, f) = rows
    return (a, b, c), (b, d, e), (c, e, f)


def invariants(tensor: Matrix) -> Vector:
    """Return the trace, the sum of the principal minors and the determinant."""
    (a, b, c), (_, d, e), (_, _, f) = tensor
    minors = fsum((a * d, d * f, a * f, -b * b, -e * e, -c * c))
    return a + d + f, minors, fsum((a * d * f, 2 * b * c * e, -a * e * e, -d * c * c, -f * b * b))


def dot(one: Sequence[float], other: Sequence[float]) -> float:
    """Return the scalar product."""
    return fsum(a * b for a, b in zip(one, other, strict=True))


def unit(vector: Sequence[float]) -> Vector:
    """Return the direction of a vector (3,), of length 1.

    Raises:
        ValueError: It is not of three components, not finite, or zero.
    """
    if len(vector) != 3:
        raise ValueError(f"a normal has three components, not {len(vector)}")
    length = hypot(*vector)
    finite("length of the normal", length, "")
    if not length:
        raise ValueError("the normal must not be zero")
    x, y, z = (component / length for component in vector)
    return x, y, z


def principal(tensor: Matrix) -> tuple[Vector, Matrix]:
    """Find principal values and directions by Jacobi's rotations.

    Returns:
        The principal values, largest first, and their directions as rows in the same order: of length 1, mutually
        perpendicular, a right-handed set; the largest component of the first two is positive.

    Source:
        Golub, Van Loan, Matrix Computations, 4th ed., section 8.5: cyclic Jacobi method.
    """
    a = [list(row) for row in tensor]
    v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    scale = max(abs(value) for row in a for value in row)
    for _ in range(_SWEEPS):
        if abs(a[0][1]) + abs(a[0][2]) + abs(a[1][2]) <= 1e-17 * scale:
            break
        for p, q in ((0, 1), (0, 2), (1, 2)):
            _rotate(a, v, p, q)
    order = sorted(range(3), key=lambda i: -a[i][i])
    first, second = (_upright([row[i] for row in v]) for i in order[:2])
    values = (a[order[0]][order[0]], a[order[1]][order[1]], a[order[2]][order[2]])
    return values, (first, second, cross(first, second))


def _rotate(a: list[list[float]], v: list[list[float]], p: int, q: int) -> None:
    """Turn the plane of p and q until the component pq is zero."""
    if not a[p][q]:
        return
    ratio = (a[q][q] - a[p][p]) / 2 / a[p][q]
    tangent = (1 if ratio >= 0 else -1) / (abs(ratio) + hypot(1.0, ratio))
    cosine = 1 / sqrt(1 + tangent * tangent)
    sine = tangent * cosine
    for row in (*a, *v):
        row[p], row[q] = cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]
    for k in range(3):
        a[p][k], a[q][k] = cosine * a[p][k] - sine * a[q][k], sine * a[p][k] + cosine * a[q][k]
    a[p][q] = a[q][p] = 0.0


def _upright(direction: Sequence[float]) -> Vector:
    sign = -1.0 if max(direction, key=abs) < 0 else 1.0
    x, y, z = (sign * component for component in direction)
    return x, y, z
