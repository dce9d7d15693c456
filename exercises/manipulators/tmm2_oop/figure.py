"""Scheme of the manipulator in one fixed pose; the polygon is the student's to draw."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from figures import planar_arm
from figures.picture import Picture, Table, Words


def figure(givens: Any, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the arm; only the kind of slide and of angle depend on the givens."""
    table = Table(tuple(words["header"]), tuple(tuple(row) for row in words["rows"]))
    said = Words(words["title"], words["description"], table)
    return planar_arm.draw("tmm2-oop", said, "OOP", givens.slide == "across", givens.measured == "relative")


def polygon(givens: Any, title: str, vectors: Sequence[tuple[str, str, str]]) -> Picture:
    """Draw a student's vectors between the nodes, in the same pose."""
    return planar_arm.draw_polygon("tmm2-oop-polygon", title, "OOP", givens.slide == "across", vectors)
