"""Cross-sections on the wire (`mechanics.section`, `mechanics.composed`)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from mechanics.composed import Block, Composed, Disc, Part, box, i_section, t_section
from mechanics.section import Circle, Rectangle, Ring, Section
from mechanics.wire.fields import Flag, Kind, ListOf, Number, Record, Tagged

_WIDTH, _HEIGHT = Number("width", "m", above=0), Number("height", "m", above=0)
_FLANGED = Record(
    "",
    {
        "b": Number("width of the flange", "m", above=0),
        "h": Number("whole height", "m", above=0),
        "flange": Number("thickness of the flange", "m", above=0),
        "web": Number("thickness of the web", "m", above=0),
    },
)
_PLACE: Mapping[str, Kind] = {
    "y": Number("height of its centre over a level of your choice", "m"),
    "hole": Flag("whether it is cut out", default=False),
}
_PARTS = Tagged(
    "",
    "type",
    {
        "rect": Record("", {"b": _WIDTH, "h": _HEIGHT, **_PLACE}),
        "circle": Record("", {"d": Number("diameter", "m", above=0), **_PLACE}),
    },
)

SECTION = Tagged(
    "cross-section, bent about the horizontal axis through its centroid",
    "type",
    {
        "rect": Record("", {"b": _WIDTH, "h": _HEIGHT}),
        "circle": Record("", {"d": Number("diameter", "m", above=0)}),
        "ring": Record("", {"D": Number("outer diameter", "m", above=0), "d": Number("bore, below D", "m", least=0)}),
        "I": _FLANGED,
        "T": _FLANGED,
        "box": Record(
            "",
            {
                "b": _WIDTH,
                "h": _HEIGHT,
                "wall": Number("thickness of each side wall", "m", above=0),
                "flange": Number("thickness of top and bottom", "m", above=0),
            },
        ),
        "composed": Record("", {"parts": ListOf("solid parts and holes, side by side at one height", _PARTS, least=1)}),
    },
    default=None,
)

_MAKERS: Mapping[str, Callable[..., Section]] = {
    "rect": Rectangle,
    "circle": Circle,
    "ring": Ring,
    "I": i_section,
    "T": t_section,
    "box": box,
}


def section(read: Mapping[str, Any]) -> Section:
    """Make the section that was read; raises ValueError."""
    sizes = {name: value for name, value in read.items() if name != "type"}
    if read["type"] == "composed":
        return Composed(tuple(_part(**part) for part in sizes["parts"]))
    return _MAKERS[read["type"]](**sizes)


def _part(type: str, y: float, hole: bool, **sizes: float) -> Part:
    return Block(sizes["b"], sizes["h"], y, hole) if type == "rect" else Disc(sizes["d"], y, hole)
