"""One mass on a spring and a damper: steady vibration under force and base excitation, isolation (domain BV-8..10).

Stiffness c in N/m, damping b in N s/m, circular frequencies in rad/s. The phase is the lag of the answer behind its
cause, in [0, pi].
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import atan2, fsum, hypot, log2, sin, sqrt

from mechanics.checks import finite, positive
from mechanics.errors import SingularError

NEAR = 1e-3  # of the stiffness: with less left of it, c - m omega^2 is taken exactly, since its digits cancel


@dataclass(frozen=True, slots=True)
class Oscillator:
    """A mass on a spring and a viscous damper.

    Raises:
        ValueError: Mass or stiffness is not positive, the damping negative, or a value not finite.
    """

    m: float  # mass, kg
    c: float  # stiffness, N/m
    b: float = 0.0  # damping, N s/m

    def __post_init__(self) -> None:
        positive("mass m", self.m, "kg")
        positive("stiffness c", self.c, "N/m")
        if not 0 <= self.b < float("inf"):
            raise ValueError(f"damping b = {self.b} N s/m must be finite and not negative")

    @property
    def omega0(self) -> float:
        """Natural frequency, rad/s (6.30)."""
        return sqrt(self.c / self.m)

    @property
    def n(self) -> float:
        """Damping coefficient, 1/s (6.31)."""
        return self.b / (2 * self.m)

    @property
    def damping_ratio(self) -> float:
        """Damping over the critical one."""
        return self.n / self.omega0

    @property
    def isolates_from(self) -> float:
        """The frequency above which less force reaches the base than acts on the mass, rad/s."""
        return sqrt(2) * self.omega0

    @property
    def peak(self) -> float | None:
        """Resonance: the frequency of the largest amplitude under a force, rad/s; None when strongly damped."""
        square = self.omega0**2 - 2 * self.n**2
        return sqrt(square) if square > 0 else None


@dataclass(frozen=True, slots=True)
class Forced:
    """Answer to a force F0 cos(omega t) on the mass."""

    amplitude: float  # X0, m
    phase: float  # lag behind the force, rad
    force_to_base: float  # R0, N
    transmissibility: float  # R0/F0


@dataclass(frozen=True, slots=True)
class Shaken:
    """Answer to a base that moves by xi0 cos(omega t)."""

    amplitude: float  # of the mass, m
    relative: float  # of the mass against the base, m
    phase: float  # lag of the mass behind the base, rad
    transmissibility: float  # amplitude over xi0


def force(oscillator: Oscillator, F0: float, omega: float) -> Forced:
    """Find the steady answer to a harmonic force: amplitude, phase, transmissibility.

    Args:
        oscillator: Mass, spring, damper.
        F0: Amplitude of the force, N, positive.
        omega: Its frequency, rad/s, not negative.

    Raises:
        ValueError: A value is not finite or out of its range.
        SingularError: Resonance without damping: the amplitude grows without bound.

    Source:
        Domain BV-9 (6.32): X0 = (F0/m)/sqrt((omega0^2 - omega^2)^2 + 4 n^2 omega^2).
    """
    positive("amplitude F0", F0, "N")
    stiff, viscous = _reduced(oscillator, omega)
    dynamic = hypot(stiff, viscous)
    R0 = F0 * hypot(oscillator.c, viscous) / dynamic
    return Forced(F0 / dynamic, atan2(viscous, stiff), R0, R0 / F0)


def base(oscillator: Oscillator, xi0: float, omega: float) -> Shaken:
    """Find the steady answer to a base that shakes harmonically by xi0 (m); arguments and errors as for `force`.

    Source:
        Domain BV-10: X = xi0 k_R; X_rel = xi0 omega^2/sqrt((omega0^2 - omega^2)^2 + 4 n^2 omega^2).
    """
    positive("base_amplitude", xi0, "m")
    stiff, viscous = _reduced(oscillator, omega)
    dynamic = hypot(stiff, viscous)
    share = hypot(oscillator.c, viscous) / dynamic
    lag = atan2(viscous, stiff) - atan2(viscous, oscillator.c)
    return Shaken(xi0 * share, xi0 * oscillator.m * omega**2 / dynamic, lag, share)


def _reduced(oscillator: Oscillator, omega: float) -> tuple[float, float]:
    """Give c - m omega^2 and b omega, both N/m."""
    if not 0 <= omega < float("inf"):
        raise ValueError(f"frequency omega = {omega} rad/s must be finite and not negative")
    stiff, viscous = oscillator.c - oscillator.m * omega**2, oscillator.b * omega
    if abs(stiff) < NEAR * oscillator.c:
        stiff = float(Fraction(oscillator.c) - Fraction(oscillator.m) * Fraction(omega) ** 2)
    if hypot(stiff, viscous) <= 1e-12 * oscillator.c:
        raise SingularError(f"resonance at {omega} rad/s without damping: the amplitude has no bound")
    finite("dynamic stiffness", hypot(stiff, viscous), "N/m")
    return stiff, viscous


def polyharmonic(mean: float, amplitudes: Sequence[float], omega1: float, phases: Sequence[float], t: float) -> float:
    """Evaluate x = X_0 + sum X_k sin(k omega1 t + alpha_k) (BV-8); SI units.

    Raises:
        ValueError: There are not as many phases as amplitudes.
    """
    if len(amplitudes) != len(phases):
        raise ValueError(f"{len(phases)} phases for {len(amplitudes)} amplitudes")
    waves = (X * sin(k * omega1 * t + a) for k, (X, a) in enumerate(zip(amplitudes, phases, strict=True), 1))
    return fsum([mean, *waves])


def rms(mean: float, amplitudes: Sequence[float]) -> float:
    """Give the root mean square of a polyharmonic process, sqrt(X_0^2 + sum X_k^2/2) (BV-8)."""
    return sqrt(fsum([mean**2, *(X**2 / 2 for X in amplitudes)]))


def octaves(low: float, high: float) -> float:
    """Give the width of a band of frequencies in octaves, log2(high/low) (BV-8).

    Raises:
        ValueError: A frequency is not positive and finite.
    """
    positive("lower frequency", low, "Hz")
    positive("upper frequency", high, "Hz")
    return log2(high / low)
