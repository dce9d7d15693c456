"""Scheme of the four-bar linkage in one fixed pose: true scale would give the answers away."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from figures import four_bar
from figures.picture import Picture, Table, Words


def figure(givens: object, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the linkage; the figure does not depend on the givens."""
    table = Table(tuple(words["header"]), tuple(tuple(row) for row in words["rows"]))
    said = Words(words["title"], words["description"], table)
    return four_bar.draw("four-bar", said, four_bar.Names(), diagonal=True)
