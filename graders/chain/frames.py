"""Frames of a table of rows (theta, d, a, alpha): the product of its elementary turns and shifts.

standard: A_i = Rot(z, theta) Trans(z, d) Trans(x, a) Rot(x, alpha). modified: A_i = Rot(x, alpha) Trans(x, a)
Rot(z, theta) Trans(z, d). A frame is its rotation by rows and its origin: (xx, yx, zx, px, xy, yy, zy, py, ...), the
first three rows of the homogeneous matrix.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import cos, sin
from typing import Literal, TypeAlias

Convention = Literal["standard", "modified"]
Vector: TypeAlias = tuple[float, float, float]
Frame: TypeAlias = tuple[float, float, float, float, float, float, float, float, float, float, float, float]
Row: TypeAlias = Sequence[float]  # theta, d, a, alpha

BASE: Frame = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)


def frame_of(matrix: Sequence[Sequence[float]]) -> Frame:
    """Take the frame out of a homogeneous matrix, ``(4, 4)``."""
    (a, b, c, x), (d, e, f, y), (g, h, i, z) = matrix[:3]
    return (a, b, c, x, d, e, f, y, g, h, i, z)


def frames(rows: Iterable[Row], convention: Convention) -> Iterator[Frame]:
    """Give the frame of each link in the base, one after the other."""
    link = BASE
    for row in rows:
        link = times(link, _pair(row, convention))
        yield link


def _pair(row: Row, convention: Convention) -> Frame:
    theta, d, a, alpha = row
    about_z, about_x = _screw_z(theta, d), _screw_x(alpha, a)
    return times(about_z, about_x) if convention == "standard" else times(about_x, about_z)


def _screw_z(angle: float, shift: float) -> Frame:
    c, s = cos(angle), sin(angle)
    return (c, -s, 0.0, 0.0, s, c, 0.0, 0.0, 0.0, 0.0, 1.0, shift)


def _screw_x(angle: float, shift: float) -> Frame:
    c, s = cos(angle), sin(angle)
    return (1.0, 0.0, 0.0, shift, 0.0, c, -s, 0.0, 0.0, s, c, 0.0)


def times(one: Frame, other: Frame) -> Frame:
    """Multiply two frames."""
    a, b, c, x, d, e, f, y, g, h, i, z = one
    p, q, r, u, j, k, m, v, n, o, t, w = other
    return (
        a * p + b * j + c * n, a * q + b * k + c * o, a * r + b * m + c * t, a * u + b * v + c * w + x,
        d * p + e * j + f * n, d * q + e * k + f * o, d * r + e * m + f * t, d * u + e * v + f * w + y,
        g * p + h * j + i * n, g * q + h * k + i * o, g * r + h * m + i * t, g * u + h * v + i * w + z,
    )  # fmt: skip


def seen_from(one: Frame, other: Frame) -> Frame:
    """Give the second frame in the axes of the first: R^T (R', p' - p)."""
    a, b, c, x, d, e, f, y, g, h, i, z = one
    return times((a, d, g, 0.0, b, e, h, 0.0, c, f, i, 0.0), (*other[:3], other[3] - x, *_moved(other, y, z)))


def _moved(frame: Frame, y: float, z: float) -> tuple[float, float, float, float, float, float, float, float]:
    _, _, _, _, d, e, f, v, g, h, i, w = frame
    return (d, e, f, v - y, g, h, i, w - z)


def axis_z(frame: Frame) -> Vector:
    """Give the direction of z."""
    return frame[2], frame[6], frame[10]


def origin(frame: Frame) -> Vector:
    """Give the origin."""
    return frame[3], frame[7], frame[11]


def carried(frame: Frame, point: Vector) -> Vector:
    """Give a point of a frame in the base: R r + p."""
    a, b, c, x, d, e, f, y, g, h, i, z = frame
    r, s, t = point
    return a * r + b * s + c * t + x, d * r + e * s + f * t + y, g * r + h * s + i * t + z
