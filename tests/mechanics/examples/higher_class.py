"""Mechanisms of a higher class (domain HC): each example computed from its inputs."""

from __future__ import annotations

from tests.mechanics.examples.reading import Solve

PENDING = (
    "HC-1", "HC-2", "HC-3", "HC-4",
)  # fmt: skip

SOLVED: dict[str, Solve] = {}
