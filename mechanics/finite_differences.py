"""Derivatives of sampled angles by finite differences, and the rates of the coupling link (domain ML-2).

Samples stand at equal steps tau (s). Central formulas err by order tau^2, and so does the one-sided formula at ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot

from mechanics.checks import finite, positive


@dataclass(frozen=True, slots=True)
class CouplingRates:
    """Angular velocity and acceleration at the inner samples, from turns about two perpendicular axes."""

    omega: tuple[float, ...]  # rad/s
    epsilon: tuple[float, ...]  # rad/s^2; the product of the two rates is neglected


def first(samples: Sequence[float], tau: float) -> tuple[float, ...]:
    """Find the first derivative at every sample.

    Args:
        samples: Values at equal steps, at least three.
        tau: The step, in seconds, positive.

    Raises:
        ValueError: Too few samples, a value not finite, or the step not positive.

    Source:
        Domain ML-2: (y_(i+1) - y_(i-1))/(2 tau); at the ends (-3 y0 + 4 y1 - y2)/(2 tau).
    """
    _check(samples, tau)
    inner = [(after - before) / (2 * tau) for before, after in zip(samples, samples[2:], strict=False)]
    return (_end(samples[0], samples[1], samples[2], tau), *inner, _end(samples[-1], samples[-2], samples[-3], -tau))


def _end(y0: float, y1: float, y2: float, tau: float) -> float:
    return (-3 * y0 + 4 * y1 - y2) / (2 * tau)


def second(samples: Sequence[float], tau: float) -> tuple[float, ...]:
    """Find the second derivative at the inner samples, (y_(i+1) - 2 y_i + y_(i-1))/tau^2.

    Arguments and errors as for `first`; the answer has two values fewer than the samples.
    """
    _check(samples, tau)
    triples = zip(samples, samples[1:], samples[2:], strict=False)
    return tuple((before - 2 * here + after) / tau**2 for before, here, after in triples)


def coupling_link(alpha: Sequence[float], beta: Sequence[float], tau: float) -> CouplingRates:
    """Find angular velocity and acceleration of a link from its two sampled angles.

    Args:
        alpha: Samples of the first angle, ``(n,)``, in radians.
        beta: Samples of the second angle, ``(n,)``, in radians.
        tau: Time between two samples, in seconds.

    Raises:
        ValueError: The angles are not sampled equally often, or as for `first`.

    Source:
        Domain ML-2: omega = sqrt(alpha'^2 + beta'^2), epsilon = sqrt(alpha''^2 + beta''^2).
    """
    if len(alpha) != len(beta):
        raise ValueError(f"alpha has {len(alpha)} samples and beta {len(beta)}")
    rates = zip(first(alpha, tau)[1:-1], first(beta, tau)[1:-1], strict=True)
    slopes = zip(second(alpha, tau), second(beta, tau), strict=True)
    return CouplingRates(tuple(hypot(*pair) for pair in rates), tuple(hypot(*pair) for pair in slopes))


def _check(samples: Sequence[float], tau: float) -> None:
    positive("tau", tau, "s")
    if len(samples) < 3:
        raise ValueError(f"{len(samples)} samples: finite differences need at least 3")
    for i, value in enumerate(samples):
        finite(f"samples[{i}]", value, "")
