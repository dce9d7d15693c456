"""A mechanism followed along the values of its driver in one assembly, up to a dead position (domain VP-1).

The sign of the determinant of the equations tells the two assemblies apart that meet in a dead position: it can change
only there. So a step is taken only if it keeps the sign and turns no body far; otherwise it is halved.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

from mechanics.errors import AssemblyError, SingularError
from mechanics.planar import Joint, Motion, Pose, solve

Mechanism = Callable[[float], Sequence[Joint]]  # its joints and drivers for a value of the driver

FARTHEST = 0.5  # rad that a body may turn in one step
NARROWEST = 1e-10  # of the range: a dead position is known as well


@dataclass(frozen=True, slots=True)
class Course:
    """The motions as far as the mechanism goes, and the value of the driver where it cannot go on."""

    motions: tuple[Motion, ...]
    dead: float | None


def follow(mechanism: Mechanism, values: Sequence[float], start: Sequence[Pose]) -> Course:
    """Move a mechanism along the values of its driver and keep its assembly.

    Args:
        mechanism: Gives joints and drivers for a value of the driver; any parameter can play the driver.
        values: Values in the order in which they are passed.
        start: A guess of the poses at the first value; it chooses the assembly.

    Returns:
        A motion for each value that is reached, and the dead position that stops the mechanism, if one does.

    Raises:
        AssemblyError: The mechanism does not close at the first value.
        SingularError: The first value is a dead position.
    """
    motions = [solve(mechanism(values[0]), start)]
    narrow = NARROWEST * (max(values) - min(values))
    for before, after in pairwise(values):
        reached, motion = _advance(mechanism, before, after, motions[-1], narrow)
        if reached != after:
            return Course(tuple(motions), reached)
        motions.append(motion)
    return Course(tuple(motions), None)


def _advance(mechanism: Mechanism, before: float, after: float, motion: Motion, narrow: float) -> tuple[float, Motion]:
    """Go as far as possible in steps that are halved when one fails; the value reached, and the motion there."""
    step = after - before
    while before != after and abs(step) > narrow:
        aim = after if abs(after - before) <= abs(step) else before + step
        found = _step(mechanism, aim, motion)
        if found is None:
            step /= 2
        else:
            before, motion = aim, found
    return before, motion


def _step(mechanism: Mechanism, value: float, before: Motion) -> Motion | None:
    try:
        found = solve(mechanism(value), before.poses[1:])
    except (AssemblyError, SingularError):
        return None
    turned = max(abs(one[2] - other[2]) for one, other in zip(found.poses, before.poses, strict=True))
    kept = (found.pivot > 0) == (before.pivot > 0) and turned <= FARTHEST
    return found if kept else None
