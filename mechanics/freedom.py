"""Free directions of constraints, and which of them are finite motions (domain STR-5).

A free direction of the linearized constraints counts only if finite steps along it close again.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias

Vector: TypeAlias = Any  # (m,) array of floats
Closure: TypeAlias = Callable[[Vector], tuple[Vector, Any]]  # coordinates -> gaps (m,) and their slopes (m, n)

RANK = 1e-6  # of the largest singular value
STEPS = 8  # along a free direction
PACES = (0.06, 0.006)  # length of a step over the size of the mechanism; the short one where the long one fails
CLOSED = 1e-11
ROUNDS = 60
PATIENCE = 8  # rounds that may pass without halving the gaps
MIXES = 3
SHARE = 0.3  # of a step that must be left after closing again, or nothing moved
LEFT = 0.01  # of a step: less is what closing to within CLOSED leaves of a locked direction


@dataclass(frozen=True, slots=True)
class Freedom:
    """Free directions at the drawn position, those that are finite motions, and the rank of the constraints there."""

    instantaneous: int
    true: int
    rank: int


def freedom(closure: Closure, coordinates: int) -> Freedom:
    """Count the free directions of a mechanism and those that lead to finite motions.

    Args:
        closure: Gives the gaps of all constraints and their slopes; the drawn position is zero.
        coordinates: Number of coordinates.
    """
    import numpy as np

    _, slopes = closure(np.zeros(coordinates))
    free = free_directions(slopes, coordinates)
    rank = coordinates - free.shape[0]
    if rank == slopes.shape[0] or not free.shape[0]:  # independent constraints: every free direction is a motion
        return Freedom(free.shape[0], free.shape[0], rank)
    for step in PACES:
        reached = _fewest(closure, free, step)
        if reached:
            return Freedom(free.shape[0], reached, rank)
    return Freedom(free.shape[0], 0, rank)


def _fewest(closure: Closure, free: Any, step: float) -> int:
    """The fewest freedoms at the places that walks reach; 0 where all spring back. What has moved has at least one."""
    import numpy as np

    fewest, place = 0, np.zeros(free.shape[1])
    for direction in _directions(free):
        at = _walk(closure, direction, step)
        if at is None:
            continue
        found = at.size - _rank(closure(at)[1])
        if not fewest or found < fewest:
            fewest, place = found, at
        if fewest == 1:
            break
    return _moved(closure, place) if fewest > 1 else fewest


def _moved(closure: Closure, at: Vector) -> int:
    """Count the directions that the mechanism follows from a place it has reached; of the free ones some may be locked.

    Steps along all free directions are closed again. What is left of them, seen along the free directions, spans the
    finite motions: a step within them is kept whole, one along a locked direction springs back.
    """
    import numpy as np

    free = free_directions(closure(at)[1], at.size)
    most = 0
    for step in PACES:
        reached = [_closed(closure, at + sign * step * direction) for direction in free for sign in (1.0, -1.0)]
        kept = np.array([(there - at) / step for there in reached if there is not None]).reshape(-1, at.size) @ free.T
        most = max(most, int((np.linalg.svd(kept, compute_uv=False) > SHARE).sum()))
        if most == free.shape[0]:
            break
    return max(1, most)


def _directions(free: Any) -> list[Vector]:
    """Mix the free directions, so that a branch of the motion is met whichever basis was found."""
    import numpy as np

    count = free.shape[0]
    if count == 1:
        return [free[0], -free[0]]
    mixes = [np.cos(np.arange(count) * (1 + turn) * 2.399 + turn) for turn in range(min(count, MIXES))]
    chosen = [mix @ free for mix in mixes] + list(free if count <= MIXES else ())
    return [sign * one / np.linalg.norm(one) for one in chosen for sign in (1.0, -1.0)]


def free_directions(slopes: Any, coordinates: int) -> Any:
    """Give a basis of the directions that change no gap, ``(free, n)``."""
    import numpy as np

    if not slopes.shape[0]:
        return np.eye(coordinates)
    _, values, rows = np.linalg.svd(slopes)
    return rows[_above(values) :]


def _rank(slopes: Any) -> int:
    """The rank alone: without a basis it takes a tenth of the time or less."""
    import numpy as np

    return _above(np.linalg.svd(slopes, compute_uv=False))


def _above(values: Any) -> int:
    return int((values > RANK * max(values[0], 1e-300)).sum())


def _walk(closure: Closure, direction: Vector, step: float) -> Vector | None:
    """Walk along a free direction; the place reached, or None if the first step springs back.

    Where it springs back, what is left of it is tried once more: of a mixture of locked directions and motions, the
    motions are left.
    """
    import numpy as np

    start = np.zeros(direction.size)
    at, ahead, turned = start, direction, False
    for _ in range(STEPS):
        there = _closed(closure, at + step * ahead)
        if there is None:
            break
        way = there - at
        length = np.linalg.norm(way)
        if length < SHARE * step or way @ ahead < SHARE * step:
            if turned or not length > LEFT * step or at is not start:
                break
            turned = True
        else:
            at = there
        ahead = way / length
    return at if np.any(at) else None


def _closed(closure: Closure, at: Vector) -> Vector | None:
    """Close the gaps by least squares (Gauss-Newton); None if they stay open."""
    import numpy as np

    least, since = float("inf"), 0
    for _ in range(ROUNDS):
        gaps, slopes = closure(at)
        widest = np.max(np.abs(gaps), initial=0.0)
        if widest < CLOSED:
            return at
        least, since = (widest, 0) if widest < least / 2 else (least, since + 1)
        if since > PATIENCE:
            return None
        at = at - np.linalg.lstsq(slopes, gaps, rcond=1e-9)[0]
    return None
