"""Scheme and vector polygon in one fixed pose; only the sense of rotation is that of the variant."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from figures import slider_crank
from figures.picture import Picture, Table, Words

if TYPE_CHECKING:
    from exercises.linkages.slider_crank_cycle import Givens


def figure(givens: Givens, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the mechanism with the sense of its crank."""
    table = Table(tuple(words["header"]), tuple(tuple(row) for row in words["rows"]))
    said = Words(words["title"], f"{words['senses'][givens.sense]} {words['description']}", table)
    names = slider_crank.Names(vectors=("l1", "l2", "x"), angles=("α", "α2"))
    return slider_crank.draw("slider-crank-cycle", said, names, "ccw" if givens.sense == "counterclockwise" else "cw")
