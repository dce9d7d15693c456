"""Vectors of three components and what multiplies them: the arithmetic of spatial motion and forces."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

from mechanics.checks import finite

Vector = tuple[float, float, float]
Matrix = tuple[tuple[float, ...], ...]  # rows; the functions here take the first three of each

ZERO: Vector = (0.0, 0.0, 0.0)


def add(u: Vector, w: Vector) -> Vector:
    """Add two vectors."""
    return u[0] + w[0], u[1] + w[1], u[2] + w[2]


def subtract(u: Vector, w: Vector) -> Vector:
    """Subtract the second vector from the first."""
    return u[0] - w[0], u[1] - w[1], u[2] - w[2]


def scaled(k: float, u: Vector) -> Vector:
    """Multiply a vector by a number."""
    return k * u[0], k * u[1], k * u[2]


def dot(u: Sequence[float], w: Sequence[float]) -> float:
    """Multiply two vectors into a number."""
    return u[0] * w[0] + u[1] * w[1] + u[2] * w[2]


def cross(u: Vector, w: Vector) -> Vector:
    """Multiply two vectors into the vector perpendicular to both."""
    return u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]


def unit(u: Vector) -> Vector:
    """Give the direction of a vector that is not zero, of length 1."""
    length = hypot(*u)
    return u[0] / length, u[1] / length, u[2] / length


def times(matrix: Matrix, u: Vector) -> Vector:
    """Multiply the first three rows and columns of a matrix by a vector."""
    return dot(matrix[0], u), dot(matrix[1], u), dot(matrix[2], u)


def back(matrix: Matrix, u: Vector) -> Vector:
    """Multiply the transpose of the first three rows and columns of a matrix by a vector."""
    (xx, yx, zx), (xy, yy, zy), (xz, yz, zz) = matrix[0][:3], matrix[1][:3], matrix[2][:3]
    x, y, z = u
    return xx * x + xy * y + xz * z, yx * x + yy * y + yz * z, zx * x + zy * y + zz * z


def check_vector(name: str, u: Sequence[float], unit: str) -> None:
    """Refuse what is not three finite numbers.

    Raises:
        ValueError: Another number of components, or one not finite.
    """
    if len(u) != 3:
        raise ValueError(f"{name} has {len(u)} components, not 3")
    for axis, value in zip("xyz", u, strict=True):
        finite(f"{name} {axis}", value, unit)
