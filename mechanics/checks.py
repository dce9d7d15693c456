"""Refusals of impossible numbers, worded with the value and its unit."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from math import fsum

_LARGEST = sys.float_info.max


def finite(name: str, value: float, unit: str) -> None:
    """Refuse a number that is not finite.

    Raises:
        ValueError: The value is NaN, infinite or beyond the range of floats.
    """
    if not abs(value) <= _LARGEST:
        raise ValueError(f"{name} = {value} {unit}".rstrip() + " must be finite")


def positive(name: str, value: float, unit: str) -> None:
    """Refuse a number that is not positive and finite.

    Raises:
        ValueError: The value is zero, negative, NaN, infinite or beyond the range of floats.
    """
    if not 0 < value <= _LARGEST:
        raise ValueError(f"{name} = {value} {unit}".rstrip() + " must be positive and finite")


def in_range(total: float) -> None:
    """Refuse an answer beyond the range of floats, such as follows from numbers of 1e308 or 1e-308.

    Args:
        total: Sum of all numbers of the answer that may be.

    Raises:
        ValueError: The sum is NaN or infinite.
    """
    if not abs(total) <= _LARGEST:
        raise ValueError("on the way to the answer a number leaves the range of floats")


def summed(values: Iterable[float]) -> float:
    """Add numbers without rounding on the way.

    Raises:
        ValueError: The sum, or a number in it, is beyond the range of floats.
    """
    try:
        total = fsum(values)
    except (OverflowError, ValueError):  # infinities of both signs, or a sum too large on the way
        total = float("nan")
    in_range(total)
    return total


def place(name: str, x: float, length: float) -> None:
    """Refuse a place outside a member that runs from 0 to its length, in metres.

    Raises:
        ValueError: The place is not finite or not in 0 .. length.
    """
    if not 0 <= x <= length:
        raise ValueError(f"{name} at x = {x} m must lie on the member, 0 .. {length} m")


def count(name: str, value: int) -> None:
    """Refuse what is no whole positive number (teeth, starts, stages).

    Raises:
        ValueError: The value is not an integer, or below 1.
    """
    if not isinstance(value, int) or value < 1:
        raise ValueError(f"{name} = {value} must be a whole positive number")
