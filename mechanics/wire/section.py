"""Cross-sections on the wire (`mechanics.section`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from mechanics.section import Circle, Rectangle, Ring, Section
from mechanics.wire.fields import Number, Record, Tagged

SECTION = Tagged(
    "cross-section, bent about its horizontal axis",
    "type",
    {
        "rect": Record("", {"b": Number("width", "m", above=0), "h": Number("height", "m", above=0)}),
        "circle": Record("", {"d": Number("diameter", "m", above=0)}),
        "ring": Record("", {"D": Number("outer diameter", "m", above=0), "d": Number("bore, below D", "m", least=0)}),
    },
    default=None,
)


def section(read: Mapping[str, Any]) -> Section:
    """Make the section that was read; raises ValueError."""
    if read["type"] == "rect":
        return Rectangle(read["b"], read["h"])
    if read["type"] == "circle":
        return Circle(read["d"])
    return Ring(read["D"], read["d"])
