"""Where the bending moment of a beam is extreme: V and M carried from the left end from one jump to the next."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, TypeAlias

from exercises.strength.simple_beam.loads import places, structure
from mechanics import members

if TYPE_CHECKING:
    from exercises.strength.simple_beam import Givens

Jump: TypeAlias = tuple[float, float, float, float]  # place (m), jump of V (N), of M (N m), of dV/dx (N/m)


def extremes(
    supports: Sequence[float], reactions: Sequence[float], loads: Iterable[members.Load]
) -> list[tuple[float, float]]:
    """Give the places (m) where V changes sign or M jumps, with M there (N m); at a couple M before and behind it.

    Where V begins and ends it does not change sign, whatever the rounding of the reactions leaves of it.
    """
    held = [(at, R, 0.0, 0.0) for at, R in zip(supports, reactions, strict=True)]
    jumps = sorted([*held, *_jumps(loads)])
    found: list[tuple[float, float]] = []
    x = V = M = w = 0.0
    for place, force, couple, load in jumps:
        if w and 0 < -V / w <= place - x:
            found.append((x - V / w, M - V * V / (2 * w)))
        M += (V + w * (place - x) / 2) * (place - x)
        V += w * (place - x)
        if couple:
            found += [(place, M), (place, M + couple)]
        elif V * (V + force) < 0 and place < jumps[-1][0]:
            found.append((place, M))
        x, V, M, w = place, V + force, M + couple, w + load
    return found


def _jumps(loads: Iterable[members.Load]) -> Iterator[Jump]:
    for load in loads:
        match load:
            case members.Force(x=x, F=F):
                yield x, F, 0.0, 0.0
            case members.Moment(x=x, M=M):
                yield x, 0.0, -M, 0.0
            case members.Distributed(x1=start, x2=end, w1=w):
                yield from ((start, 0.0, 0.0, w), (end, 0.0, 0.0, -w))


def extreme_place(givens: Givens, R_A: float, R_B: float) -> float:
    """Give the place of the largest |M|, in metres; where wrong reactions let V keep its sign, the right end."""
    found = extremes(places(givens), (R_A, R_B), structure(givens).loads)
    return max(found, key=lambda one: abs(one[1]), default=(givens.L, 0.0))[0]
