"""Velocity methods (domain VM): each example computed from its inputs."""

from __future__ import annotations

from tests.mechanics.examples.reading import Solve

PENDING = (
    "VM-1", "VM-2", "VM-3", "VM-4", "VM-5", "VM-6",
)  # fmt: skip

SOLVED: dict[str, Solve] = {}
