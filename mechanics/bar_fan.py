"""Bars from fixed points to one common joint: forces and displacement by compatibility (domain SM-18).

Axes x to the right, y up; the angle of a bar is that of the direction from the joint to its fixed point,
counter-clockwise from +x. N > 0 is tension; the load and the displacement of the joint are given on x and y.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import cos, fsum, hypot, pi, sin

from mechanics.checks import finite, in_range, positive
from mechanics.errors import UnstableError

# A fan whose stiffness across its bars is this part of that along them moves freely across.
_FLAT = 1e-12


@dataclass(frozen=True, slots=True)
class FanBar:
    """One bar of the fan."""

    angle: float  # from the joint to the fixed point, rad
    length: float  # m
    EA: float  # axial stiffness, N
    free: float = 0.0  # elongation of the unloaded bar (alpha dT l, or how much too long it was made), m

    def __post_init__(self) -> None:
        finite("bar angle", self.angle, "rad")
        positive("bar length", self.length, "m")
        positive("axial stiffness E A", self.EA, "N")
        finite("free elongation", self.free, "m")
        positive("stiffness E A/l of a bar", self.EA / self.length, "N/m")


@dataclass(frozen=True, slots=True)
class FanResult:
    """The solved fan."""

    N: tuple[float, ...]  # axial forces in the order of the bars, N
    ux: float  # displacement of the joint, m
    uy: float  # m


def solve(bars: Sequence[FanBar], Fx: float, Fy: float) -> FanResult:
    """Solve a fan of any number of bars under a force (N) at the joint.

    Raises:
        UnstableError: The bars lie on one line, the joint can move across it.
        ValueError: The force is not finite, or the answer beyond the range of floats.

    Source:
        Compatibility: a bar grows by -(ux cos a + uy sin a), N = EA/l (growth - free elongation); equilibrium of the
        joint gives two equations for ux, uy (domain SM-18 in general position); their determinant by Cauchy-Binet,
        sum of k_i k_j sin^2(a_i - a_j), which has nothing to cancel.
    """
    finite("force Fx", Fx, "N")
    finite("force Fy", Fy, "N")
    stiff = [(bar.EA / bar.length, cos(bar.angle), sin(bar.angle), bar.free) for bar in bars]
    across = (k * other * sin(bar.angle - one.angle) ** 2 for (k, bar), (other, one) in _pairs(bars))
    determinant, total = fsum(across), fsum(k for k, _, _, _ in stiff)
    if not determinant > _FLAT * total * total:
        raise UnstableError(f"unstable fan: its {len(bars)} bars lie on one line, the joint can move across it")
    x = Fx - fsum(k * free * c for k, c, _, free in stiff)
    y = Fy - fsum(k * free * s for k, _, s, free in stiff)
    ux = fsum(k * s * (x * s - y * c) for k, c, s, _ in stiff) / determinant
    uy = fsum(k * c * (y * c - x * s) for k, c, s, _ in stiff) / determinant
    forces = tuple(-k * (ux * c + uy * s + free) for k, c, s, free in stiff)
    in_range(hypot(ux, uy) + fsum(map(abs, forces)))
    return FanResult(forces, ux, uy)


def _pairs(bars: Sequence[FanBar]) -> Iterator[tuple[tuple[float, FanBar], tuple[float, FanBar]]]:
    return combinations(((bar.EA / bar.length, bar) for bar in bars), 2)


@dataclass(frozen=True, slots=True)
class ThreeBars:
    """The symmetric truss of three bars under a pull along the middle one."""

    N_middle: float  # N
    N_side: float  # N
    u: float  # displacement of the joint along the load, m


def three_bars(P: float, angle: float, length: float, EA: float) -> ThreeBars:
    """Solve the truss of a middle bar and two side bars of equal axial stiffness by its closed form.

    Args:
        P: Load on the joint away from the supports, N.
        angle: Between a side bar and the middle one, rad, at least 0 and below pi/2.
        length: Of the middle bar, m, positive; the side bars reach the same level.
        EA: Axial stiffness of each bar, N, positive.

    Raises:
        ValueError: A value is not finite, not positive or out of its range.

    Source:
        Domain SM-18: N_m = P/(1 + 2 cos^3 a), N_s = N_m cos^2 a, u = N_m l/(E A).
    """
    finite("load P", P, "N")
    positive("length l", length, "m")
    positive("axial stiffness E A", EA, "N")
    if not 0 <= angle < pi / 2:
        raise ValueError(f"angle {angle} rad of the side bars must be at least 0 and below pi/2")
    cosine = cos(angle)
    middle = P / (1 + 2 * cosine * cosine * cosine)
    return ThreeBars(middle, middle * cosine * cosine, middle * length / EA)
