"""Where the beam sags most: slope and deflection carried from A over the stretches of V and M."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from exercises.strength._beam.members import places, structure
from exercises.strength._beam.profile import Stretch, stretches

if TYPE_CHECKING:
    from exercises.strength.beam_deflection import Givens

PARTS, HALVINGS = 16, 60


def deepest(givens: Givens, R_A: float, R_B: float, C: float) -> float:
    """Give the place of the largest |v|, in metres."""
    return max(extremes(givens, R_A, R_B, C), key=lambda one: abs(one[1]))[0]


def extremes(givens: Givens, R_A: float, R_B: float, C: float) -> list[tuple[float, float]]:
    """Give the places (m) where the slope changes its sign, and the right end, with EI v there (N m^3)."""
    A, B = places(givens)
    held = [(A, R_A, 0.0, 0.0), (B, R_B, 0.0, 0.0)]
    found: list[tuple[float, float]] = []
    slope, sag = C, 0.0
    for one in stretches(givens.L, held, structure(givens).loads):
        found += [(one.start + t, _sag(one, slope, sag, t)) for t in _level(one, slope)]
        length = one.end - one.start
        slope, sag = _slope(one, slope, length), _sag(one, slope, sag, length)
    return [*found, (givens.L, sag)]


def _slope(one: Stretch, slope: float, t: float) -> float:
    return slope + t * (one.M + t * (one.V / 2 + t * one.w / 6))


def _sag(one: Stretch, slope: float, sag: float, t: float) -> float:
    return sag + t * (slope + t * (one.M / 2 + t * (one.V / 6 + t * one.w / 24)))


def _level(one: Stretch, slope: float) -> Iterator[float]:
    """Find where the slope, a cubic, changes its sign: bracketed on a grid, then bisected."""
    length = one.end - one.start
    for low, high in pairwise(length * share / PARTS for share in range(PARTS + 1)):
        first = _slope(one, slope, low)
        if first == 0:  # at a load in the middle of a symmetric beam
            yield low
        elif first * _slope(one, slope, high) < 0:
            yield _bisected(one, slope, low, high)


def _bisected(one: Stretch, slope: float, low: float, high: float) -> float:
    falls = _slope(one, slope, low) > 0
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        if (_slope(one, slope, middle) > 0) == falls:
            low = middle
        else:
            high = middle
    return (low + high) / 2
