"""Structure and mobility (domain STR): each example computed from its inputs."""

from __future__ import annotations

from tests.mechanics.examples.reading import Solve

PENDING = (
    "STR-2", "STR-3", "STR-4", "STR-5", "STR-6", "STR-8", "STR-9",
)  # fmt: skip

SOLVED: dict[str, Solve] = {}
