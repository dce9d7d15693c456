"""Two ways to check a motion: differences of its neighbours in time, and the same mechanism as bodies."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import pytest

from mechanics.linkage import LinkageMotion
from mechanics.planar import Marker, Motion


def rates_are_slopes(at: Callable[[float], LinkageMotion], step: float = 1e-5) -> None:
    """Assert that velocities and accelerations are the slopes of what is one step earlier and later."""
    before, now, after = at(-step), at(0.0), at(step)
    for name in now.pos:
        moved = (after.pos[name] - before.pos[name] + pi) % (2 * pi) - pi
        changed = after.vel[name] - before.vel[name]
        size = 1 + max(abs(now.vel[name]), abs(now.acc[name]))
        assert moved / (2 * step) == pytest.approx(now.vel[name], rel=1e-6, abs=1e-6 * size), name
        assert changed / (2 * step) == pytest.approx(now.acc[name], rel=1e-5, abs=1e-5 * size), name


def turns_alike(closed: LinkageMotion, name: str, newton: Motion, body: int, ahead: float = 0.0) -> None:
    """Assert that an angle and its rates are those of a body that is `ahead` of it."""
    turn = newton.poses[body][2] - ahead - closed.pos[name]
    assert (turn + pi) % (2 * pi) - pi == pytest.approx(0, abs=1e-9), name
    scale = 1 + abs(closed.acc[name])
    assert newton.rates[body][2] == pytest.approx(closed.vel[name], rel=1e-8, abs=1e-9 * scale), name
    assert newton.accelerations[body][2] == pytest.approx(closed.acc[name], rel=1e-7, abs=1e-8 * scale), name


def moves_alike(closed: LinkageMotion, name: str, newton: Motion, marker: Marker) -> None:
    """Assert that the point ``name_x``, ``name_y`` and its rates are those of a marker."""
    for found, values in zip(newton.point(marker), closed[:3], strict=True):
        expected = (values[f"{name}_x"], values[f"{name}_y"])
        scale = 1 + max(abs(value) for value in expected)
        assert found == pytest.approx(expected, rel=1e-8, abs=1e-9 * scale), name
