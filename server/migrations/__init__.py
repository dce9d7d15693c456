"""Versions of the store's tables; the name of each file begins with its number."""

from __future__ import annotations

from importlib.resources import files


def newest() -> str:
    """Give the number of the newest version."""
    return max(file.name[:4] for file in (files("server") / "migrations" / "versions").iterdir() if file.name[0] == "0")
