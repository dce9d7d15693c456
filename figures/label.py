"""Labels: names with subscripts, points, numbers with units, and the room they take on the sheet."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import Literal

from figures.plane import Box, Point

Anchor = Literal["start", "middle", "end"]

# The larger sizes, of narrow screens: what has room there has room everywhere.
SYMBOL_SIZE = 23
NUMBER_SIZE = 19

_NARROW = frozenset(" .,:;'′|il-·\u00a0\u202f()[]")
_WIDE = frozenset("mwMWØΩω%@ЖШЩ")


def escaped(text: str) -> str:
    """The text fit for XML: markup escaped, characters that XML cannot hold replaced."""
    held = "".join(c if c >= " " and not "\ud800" <= c <= "\udfff" and c not in "\ufffe\uffff" else " " for c in text)
    return escape(held)


@dataclass(frozen=True, slots=True)
class Label:
    """A text of the drawing language: its letters, its subscript and the classes that set its face."""

    text: str
    index: str = ""
    classes: str = ""
    arrow: str = ""  # the vector style whose arrow stands above, if any

    @property
    def size(self) -> int:
        """The height of its face on a narrow screen, in user units."""
        return NUMBER_SIZE if "n" in self.classes.split() else SYMBOL_SIZE

    @property
    def width(self) -> float:
        """A width it does not exceed, in user units."""
        return self.size * (_ems(self.text) + 0.7 * _ems(self.index))

    def svg(self) -> str:
        """The content of the text element."""
        if not self.index:
            return escaped(self.text)
        upright = "s up" if self.index[0].isdigit() else "s"
        return f'{escaped(self.text)}<tspan class="{upright}" dy="5">{escaped(self.index)}</tspan>'

    def box(self, at: Point, anchor: Anchor) -> Box:
        """The room it takes with its base line at ``at``."""
        left = at.real - {"start": 0.0, "middle": 0.5, "end": 1.0}[anchor] * self.width
        low = (0.34 if self.index else 0.14 if self.size == NUMBER_SIZE else 0.2) * self.size
        rise = 22.0 if self.arrow else 0.74 * self.size
        return Box(left, at.imag - low, left + self.width, at.imag + rise)


def _ems(text: str) -> float:
    return sum(0.33 if c in _NARROW else 0.92 if c in _WIDE else 0.62 for c in text)


def symbol(name: str, style: str = "", arrow: bool = False) -> Label:
    """A quantity in italics: ``F1``, ``R_A``, ``z2'`` and ``-T2`` get their subscripts.

    Args:
        name: Letters, then an index set apart by being a digit or by an underscore.
        style: ``pos``, ``vel``, ``acc``, ``load`` or ``thin`` for the colour of such a line; ink otherwise.
        arrow: Whether the arrow of a vector, in the same style, stands above.
    """
    name = name.replace("'", "′").replace("-", "−")
    cut = next((at for at, c in enumerate(name) if c.isdigit() or c == "_"), len(name))
    if cut == 0:
        return Label(name, classes=f"t-{style}" if style else "", arrow=style if arrow else "")
    index = name[cut:].removeprefix("_")
    return Label(name[:cut], index, f"t-{style}" if style else "", style if arrow else "")


def point(name: str) -> Label:
    """The upright name of a point."""
    return Label(name, classes="r")


def number(text: str) -> Label:
    """A number with its unit, or the number of a link, in the face of the interface."""
    return Label(text, classes="n")
