"""V and M along a beam, carried from the left end from one jump to the next: dV/dx = w, dM/dx = V (domain SM-11)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TypeAlias

from mechanics import members

Jump: TypeAlias = tuple[float, float, float, float]  # place (m), jump of V (N), of M (N m), of dV/dx (N/m)
Rows: TypeAlias = tuple[tuple[float, ...], ...]

SLIVER = 1e-9  # of the length: two places that differ by a rounding are one


@dataclass(frozen=True, slots=True)
class Stretch:
    """A part of the beam without a jump inside: its ends (m), V (N), M (N m) and the load (N/m, up) at its start."""

    start: float
    end: float
    V: float
    M: float
    w: float


def jumps(loads: Iterable[members.Load]) -> Iterator[Jump]:
    """Give what each load changes at its places."""
    for load in loads:
        match load:
            case members.Force(x=x, F=F):
                yield x, F, 0.0, 0.0
            case members.Moment(x=x, M=M):
                yield x, 0.0, -M, 0.0
            case members.Distributed(x1=start, x2=end, w1=w):
                yield from ((start, 0.0, 0.0, w), (end, 0.0, 0.0, -w))


def stretches(length: float, held: Iterable[Jump], loads: Iterable[members.Load]) -> list[Stretch]:
    """Cut the beam where something jumps, and carry V and M over it.

    Args:
        length: The length of the beam, m.
        held: What the supports change.
        loads: What the beam carries.
    """
    found: list[Stretch] = []
    x = V = M = w = 0.0
    for place, force, couple, load in [*sorted([*held, *jumps(loads)]), (length, 0.0, 0.0, 0.0)]:
        if place - x > SLIVER * length:
            found.append(Stretch(x, place, V, M, w))
        M += (V + w * (place - x) / 2) * (place - x)
        V += w * (place - x)
        x, V, M, w = place, V + force, M + couple, w + load
    return found


def shear_rows(found: Iterable[Stretch]) -> Rows:
    """Write V as rows of start, end and coefficients of powers of the distance from the start."""
    return tuple((one.start, one.end, one.V, one.w, 0.0) for one in found)


def moment_rows(found: Iterable[Stretch]) -> Rows:
    """Write M in the same way."""
    return tuple((one.start, one.end, one.M, one.V, one.w / 2) for one in found)
