"""The arm in one fixed pose: the figure shows how the coordinates are measured, not their values."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from figures import rod_group
from figures.picture import Picture, Table, Words


def figure(givens: object, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the arm with the base frame; the figure does not depend on the givens."""
    table = Table(tuple(words["header"]), tuple(tuple(row) for row in words["rows"]))
    said = Words(words["title"], words["description"], table)
    return rod_group.draw("rrr-inverse", said, rod_group.Names(), frames=(0,))
