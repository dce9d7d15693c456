"""The rows of a cycle: time, crank angle, position, velocity and acceleration of the slider (VP-2, (4)-(13))."""

from __future__ import annotations

from collections.abc import Callable
from math import asin, cos, sin
from typing import TypeAlias

ROWS = 36
Rows: TypeAlias = tuple[tuple[float, ...], ...]
State: TypeAlias = tuple[float, float, float]


def cycle(l1: float, l2: float, alpha0: float, omega1: float, turn: float) -> Rows:
    """Give the cycle at equal steps of time, the last row a turn after the first."""
    return _rows(alpha0, omega1, turn, lambda alpha: _motion(l1, l2, alpha, omega1, 1.0))


def steady_rod(l1: float, l2: float, alpha0: float, omega1: float, turn: float) -> Rows:
    """The slip: the rod taken to turn steadily, eps2 = 0 in (13)."""
    return _rows(alpha0, omega1, turn, lambda alpha: _motion(l1, l2, alpha, omega1, 0.0))


def long_rod(l1: float, l2: float, alpha0: float, omega1: float, turn: float) -> Rows:
    """The slip: the slider of a rod so long that it does not turn."""

    def state(alpha: float) -> State:
        return l1 * cos(alpha) + l2, -l1 * omega1 * sin(alpha), -l1 * omega1**2 * cos(alpha)

    return _rows(alpha0, omega1, turn, state)


def _rows(alpha0: float, omega1: float, turn: float, state: Callable[[float], State]) -> Rows:
    times = [turn * k / ROWS for k in range(ROWS + 1)]
    return tuple((t, alpha0 + omega1 * t, *state(alpha0 + omega1 * t)) for t in times)


def _motion(l1: float, l2: float, alpha1: float, omega1: float, turning: float) -> State:
    alpha2 = -asin(l1 * sin(alpha1) / l2)  # (4)
    omega2 = -l1 * omega1 * cos(alpha1) / (l2 * cos(alpha2))  # (8)
    epsilon2 = (l1 * omega1**2 * sin(alpha1) + l2 * omega2**2 * sin(alpha2)) / (l2 * cos(alpha2))  # (12)
    return (
        l1 * cos(alpha1) + l2 * cos(alpha2),  # (5)
        -l1 * omega1 * sin(alpha1) - l2 * omega2 * sin(alpha2),  # (9)
        -l1 * omega1**2 * cos(alpha1) - l2 * (omega2**2 * cos(alpha2) + turning * epsilon2 * sin(alpha2)),  # (13)
    )
