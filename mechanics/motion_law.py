"""Laws by which drives move: sinusoidal starting and braking, and the drive of a constant output speed (ML-1, ML-3).

Travel and speeds in the unit of the coordinate (m or rad) and seconds. Acceleration starts and ends at zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import acos, cos, hypot, pi, sin, sqrt

from mechanics.checks import finite, positive
from mechanics.errors import SingularError


@dataclass(frozen=True, slots=True)
class State:
    """Coordinate and its two rates at one time."""

    q: float
    q_dot: float
    q_ddot: float


@dataclass(frozen=True, slots=True)
class DriveLaw:
    """A travel with sinusoidal acceleration at both ends and a cruise between; negative travel runs back."""

    travel: float
    v_peak: float  # speed of the cruise, or the largest reached, positive
    a_max: float  # positive
    v_start: float  # speed at both ends, along the travel
    t_acc: float  # s
    t_total: float  # s

    @property
    def t_cruise(self) -> float:
        """Time at constant speed, s; 0 where the travel is too short for it."""
        return self.t_total - 2 * self.t_acc

    def at(self, t: float) -> State:
        """Find the motion at a time, in seconds.

        Raises:
            ValueError: The time is not in 0 .. t_total.

        Source:
            Domain ML-1 (3.5)-(3.7); braking is starting, seen backwards from the end.
        """
        if not 0 <= t <= self.t_total:
            raise ValueError(f"t = {t} s must lie in 0 .. {self.t_total} s")
        if t > self.t_total - self.t_acc:
            there = self._starting(self.t_total - t)
            found = State(abs(self.travel) - there.q, there.q_dot, -there.q_ddot)
        elif t < self.t_acc:
            found = self._starting(t)
        else:
            found = State(self._starting(self.t_acc).q + self.v_peak * (t - self.t_acc), self.v_peak, 0.0)
        back = self.travel < 0
        return State(-found.q, -found.q_dot, -found.q_ddot) if back else found

    def _starting(self, t: float) -> State:
        if not self.t_acc:
            return State(self.v_start * t, self.v_start, 0.0)
        rate = pi / self.t_acc
        gain = self.a_max / rate
        return State(
            self.v_start * t + gain * (t - sin(rate * t) / rate),
            self.v_start + gain * (1 - cos(rate * t)),
            self.a_max * sin(rate * t),
        )

    def table(self, steps: int) -> tuple[tuple[float, State], ...]:
        """Sample the whole travel at equal steps of time, both ends included.

        Raises:
            ValueError: Fewer than one step.
        """
        if steps < 1:
            raise ValueError(f"{steps} steps: at least 1 is needed")
        times = [self.t_total * i / steps for i in range(steps)] + [self.t_total]
        return tuple((t, self.at(t)) for t in times)


def drive_law(travel: float, v_max: float, a_max: float, v_start: float = 0.0) -> DriveLaw:
    """Find the shortest travel law within a largest speed and acceleration.

    Args:
        travel: The way dq, positive or negative, not zero.
        v_max: Largest speed, positive.
        a_max: Largest acceleration, positive.
        v_start: Speed at both ends along the travel, from 0 up to v_max.

    Raises:
        ValueError: The travel is zero, a limit not positive, a value not finite, or v_start not in 0 .. v_max.

    Source:
        Domain ML-1 (3.3), (3.4); a travel too short for v_max reaches sqrt(v_start^2 + 2 a_max |dq|/pi).
    """
    positive("v_max", v_max, "")
    positive("a_max", a_max, "")
    positive("|travel|", abs(travel), "")
    if not 0 <= v_start <= v_max:
        raise ValueError(f"v_start = {v_start} must lie in 0 .. v_max = {v_max}")
    way = abs(travel)
    v_peak = min(v_max, hypot(v_start, sqrt(2 / pi * a_max) * sqrt(way)))
    t_acc = pi * (v_peak - v_start) / (2 * a_max)
    cruise = max(0.0, way - (v_start + v_peak) * t_acc)
    return DriveLaw(travel, v_peak, a_max, v_start, t_acc, 2 * t_acc + cruise / v_peak)


@dataclass(frozen=True, slots=True)
class Extension:
    """Length of a linear drive and its rates."""

    length: float  # AB, m
    rate: float  # m/s
    acceleration: float  # m/s^2


def constant_output(AC: float, BC: float, beta: float, omega: float) -> Extension:
    """Find how a linear drive AB must move so that BC turns about C with constant angular velocity.

    Args:
        AC: Distance of the fixed pivots, in metres, positive.
        BC: Length of the driven link, in metres, positive.
        beta: Angle ACB, beta0 + omega t, in radians, any finite value.
        omega: Angular velocity of BC, in rad/s.

    Raises:
        ValueError: A length is not positive, or a value not finite.
        SingularError: A and B coincide, where the drive has no direction.

    Source:
        Domain ML-3: AB^2 = AC^2 + BC^2 - 2 AC BC cos beta, differentiated twice.
    """
    positive("AC", AC, "m")
    positive("BC", BC, "m")
    finite("beta", beta, "rad")
    finite("omega", omega, "rad/s")
    length = hypot(AC - BC, 2 * sqrt(AC) * sqrt(BC) * sin(beta / 2))  # keeps its digits where B comes near A
    if length <= 1e-12 * (AC + BC):
        raise SingularError(f"A and B coincide at beta = {beta:g} rad: the drive has no direction")
    rate = AC * BC * omega * sin(beta) / length
    return Extension(length, rate, (AC * BC * omega**2 * cos(beta) - rate**2) / length)


def fastest_extension(AC: float, BC: float, omega: float) -> tuple[float, float]:
    """Find the angle beta (rad) at which |AB'| is largest, and that speed (m/s); AC and BC in m, omega in rad/s.

    Raises:
        ValueError: A length is not positive, or the angular velocity not finite.

    Source:
        Domain ML-3: cos beta = min(AC, BC)/max(AC, BC), speed |omega| min(AC, BC).
    """
    positive("AC", AC, "m")
    positive("BC", BC, "m")
    finite("omega", omega, "rad/s")
    short, long = sorted((AC, BC))
    return acos(short / long), abs(omega) * short
