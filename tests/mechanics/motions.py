"""Two ways to check a motion: differences of its neighbours, the same mechanism as bodies; each gives what is off."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any

from pytest import approx

from mechanics.linkage import LinkageMotion
from mechanics.planar import Marker, Motion


def off_slopes(at: Callable[[float], LinkageMotion], step: float = 1e-5) -> list[str]:
    """Give the velocities and accelerations that are not the slopes of what is one step earlier and later."""
    before, now, after, found = at(-step), at(0.0), at(step), list[str]()
    for name in now.pos:
        moved = (after.pos[name] - before.pos[name] + pi) % (2 * pi) - pi
        changed = after.vel[name] - before.vel[name]
        size = 1 + max(abs(now.vel[name]), abs(now.acc[name]))
        found += _apart(f"velocity of {name}", moved / (2 * step), approx(now.vel[name], rel=1e-6, abs=1e-6 * size))
        found += _apart(
            f"acceleration of {name}", changed / (2 * step), approx(now.acc[name], rel=1e-5, abs=1e-5 * size)
        )
    return found


def turned_apart(closed: LinkageMotion, name: str, newton: Motion, body: int) -> list[str]:
    """Give where an angle and its rates are not those of a body."""
    turn, scale = newton.poses[body][2] - closed.pos[name], 1 + abs(closed.acc[name])
    return [
        *_apart(f"{name} itself", (turn + pi) % (2 * pi) - pi, approx(0, abs=1e-9)),
        *_apart(f"velocity of {name}", newton.rates[body][2], approx(closed.vel[name], rel=1e-8, abs=1e-9 * scale)),
        *_apart(
            f"acceleration of {name}",
            newton.accelerations[body][2],
            approx(closed.acc[name], rel=1e-7, abs=1e-8 * scale),
        ),
    ]


def moved_apart(closed: LinkageMotion, name: str, newton: Motion, marker: Marker) -> list[str]:
    """Give where the point ``name_x``, ``name_y`` and its rates are not those of a marker."""
    apart = list[str]()
    for found, values in zip(newton.point(marker), closed[:3], strict=True):
        expected = (values[f"{name}_x"], values[f"{name}_y"])
        scale = 1 + max(abs(value) for value in expected)
        apart += _apart(name, found, approx(expected, rel=1e-8, abs=1e-9 * scale))
    return apart


def _apart(name: str, found: Any, expected: Any) -> list[str]:
    return [] if found == expected else [f"{name}: {found}, expected {expected}"]
