"""Manipulators by homogeneous matrices (domain DH): each example computed from its inputs."""

from __future__ import annotations

from tests.mechanics.examples.reading import Solve

PENDING = (
    "DH-2", "DH-3", "DH-1", "DH-11", "DH-21", "DH-12", "DH-22", "DH-13", "DH-23", "DH-14", "DH-24", "DH-15",
    "DH-25", "DH-16", "DH-26", "DH-6", "DH-7", "DH-8", "DH-9", "DH-5",
)  # fmt: skip

SOLVED: dict[str, Solve] = {}
