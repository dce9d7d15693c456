"""Where the bending moment of a beam is extreme: V and M carried from the left end from one jump to the next."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from exercises.strength._beam.members import places, structure
from exercises.strength._beam.profile import jumps
from mechanics import members

if TYPE_CHECKING:
    from exercises.strength.simple_beam import Givens


def extremes(
    supports: Sequence[float], reactions: Sequence[float], loads: Iterable[members.Load]
) -> list[tuple[float, float]]:
    """Give the places (m) where V changes sign or M jumps, with M there (N m); at a couple M before and behind it.

    Where V begins and ends it does not change sign, whatever the rounding of the reactions leaves of it.
    """
    held = [(at, R, 0.0, 0.0) for at, R in zip(supports, reactions, strict=True)]
    ordered = sorted([*held, *jumps(loads)])
    found: list[tuple[float, float]] = []
    x = V = M = w = 0.0
    for place, force, couple, load in ordered:
        if w and 0 < -V / w <= place - x:
            found.append((x - V / w, M - V * V / (2 * w)))
        M += (V + w * (place - x) / 2) * (place - x)
        V += w * (place - x)
        if couple:
            found += [(place, M), (place, M + couple)]
        elif V * (V + force) < 0 and place < ordered[-1][0]:
            found.append((place, M))
        x, V, M, w = place, V + force, M + couple, w + load
    return found


def extreme_place(givens: Givens, R_A: float, R_B: float) -> float:
    """Give the place of the largest |M|, in metres; where wrong reactions let V keep its sign, the right end."""
    found = extremes(places(givens), (R_A, R_B), structure(givens).loads)
    return max(found, key=lambda one: abs(one[1]), default=(givens.L, 0.0))[0]
