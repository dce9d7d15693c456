"""Accuracy (domain AC): each example computed from its inputs."""

from __future__ import annotations

from tests.mechanics.examples.reading import Solve

PENDING = (
    "AC-1", "AC-2", "AC-3", "AC-4", "AC-5",
)  # fmt: skip

SOLVED: dict[str, Solve] = {}
