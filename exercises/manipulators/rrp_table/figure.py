"""The arm with the printed axes in one fixed pose: it shows how q2 is measured and where M stands, not the values."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, cast

from figures import rrp_arm
from figures.picture import Picture, Table, Words

if TYPE_CHECKING:
    from exercises.manipulators.rrp_table import Givens


def figure(givens: Givens, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the arm; the figure depends on the givens by the zero and the sense of q2 and the side of M alone."""
    measured, stands = words["measure"][givens.measure], words["side"][givens.side]
    rows = tuple(tuple(cell.replace("{measure}", measured) for cell in row) for row in words["rows"])
    described = words["description"].replace("{measure}", measured).replace("{side}", stands)
    said = Words(words["title"], described, Table(tuple(words["header"]), rows))
    measure, side = cast("rrp_arm.Measure", givens.measure), cast("rrp_arm.Side", givens.side)
    return rrp_arm.draw("rrp-table", said, measure, side)
