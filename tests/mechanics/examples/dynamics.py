"""Dynamics (domain DY): each example computed from its inputs."""

from __future__ import annotations

from tests.mechanics.examples.reading import Solve

PENDING = (
    "DY-1", "DY-2", "DY-4", "DY-3", "DY-5", "DY-6", "DY-7", "DY-8", "DY-9",
)  # fmt: skip

SOLVED: dict[str, Solve] = {}
