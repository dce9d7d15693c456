"""Vector polygons (domain VP): each example computed from its inputs."""

from __future__ import annotations

from tests.mechanics.examples.reading import Solve

PENDING = (
    "VP-1", "VP-2", "VP-3", "VP-4", "VP-5", "VP-6", "VP-6b", "VP-7", "VP-7b", "VP-8", "VP-9",
)  # fmt: skip

SOLVED: dict[str, Solve] = {}
