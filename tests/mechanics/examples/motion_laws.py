"""Motion laws (domain ML): each example computed from its inputs."""

from __future__ import annotations

from tests.mechanics.examples.reading import Solve

PENDING = (
    "ML-1", "ML-2", "ML-3", "ML-4",
)  # fmt: skip

SOLVED: dict[str, Solve] = {}
