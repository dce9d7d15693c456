"""Scheme of the slider-crank with the letters of its nodes; the polygon is the student's to draw."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from figures import slider_crank
from figures.picture import Picture, Table, Words


def figure(givens: object, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the mechanism in one fixed pose; the figure does not depend on the givens."""
    table = Table(tuple(words["header"]), tuple(tuple(row) for row in words["rows"]))
    said = Words(words["title"], words["description"], table)
    names = slider_crank.Names(angles=("α1", ""))
    return slider_crank.draw("slider-crank-polygon", said, names, polygon=False)


def polygon(givens: object, title: str, vectors: Sequence[tuple[str, str, str]]) -> Picture:
    """Draw a student's vectors between the nodes, in the same pose."""
    return slider_crank.draw_polygon("slider-crank-own-polygon", title, vectors)
