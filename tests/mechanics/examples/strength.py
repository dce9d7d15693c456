"""Strength of materials (domain SM): each example computed from its inputs."""

from __future__ import annotations

from tests.mechanics.examples.reading import Solve

PENDING = (
    "SM-1", "SM-2", "SM-3", "SM-4", "SM-5", "SM-6", "SM-7", "SM-8", "SM-9", "SM-10", "SM-11", "SM-12", "SM-13",
    "SM-14", "SM-15", "SM-16", "SM-17", "SM-18",
)  # fmt: skip

SOLVED: dict[str, Solve] = {}
