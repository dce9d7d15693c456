"""Sections put together from rectangles and discs, solid or cut out: I, T, box and any other that a plumb line halves
(domain SM-12).

Heights y are counted up from a level of one's own choice. Parts at the same height stand side by side, so that their
widths add up; a hole takes its width away. Bending is about the horizontal axis through the centroid.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise
from math import acos, pi, sqrt

from mechanics.checks import finite, positive, summed

# A neutral axis this near to an edge, in parts of the height, is at the edge: the narrower side carries the stress.
_EDGE = 1e-9


@dataclass(frozen=True, slots=True)
class Block:
    """A rectangle."""

    b: float  # width, m
    h: float  # height, m
    y: float  # height of its centre, m
    hole: bool = False

    def __post_init__(self) -> None:
        positive("width b", self.b, "m")
        positive("height h", self.h, "m")
        finite("height of the centre y", self.y, "m")

    @property
    def half(self) -> float:
        """Half of its height, m."""
        return self.h / 2

    @property
    def area(self) -> float:
        """Area, m^2."""
        return self.b * self.h

    @property
    def own_moment(self) -> float:
        """Second moment of area about its own horizontal axis, b h^3/12, m^4."""
        return self.b * self.h * self.h * self.h / 12

    def width(self, y: float) -> float:
        """Return its width (m) at a height y (m)."""
        return self.b if abs(y - self.y) <= self.half else 0.0

    def moment_above(self, y: float) -> float:
        """Return the first moment (m^3) about a height y (m) of what lies above it."""
        top, bottom = self.y + self.half - y, max(self.y - self.half - y, 0.0)
        return self.b * (top - bottom) * (top + bottom) / 2 if top > 0 else 0.0


@dataclass(frozen=True, slots=True)
class Disc:
    """A full circle."""

    d: float  # diameter, m
    y: float  # height of its centre, m
    hole: bool = False

    def __post_init__(self) -> None:
        positive("diameter d", self.d, "m")
        finite("height of the centre y", self.y, "m")

    @property
    def half(self) -> float:
        """Its radius, m."""
        return self.d / 2

    @property
    def area(self) -> float:
        """Area, m^2."""
        return pi * self.d * self.d / 4

    @property
    def own_moment(self) -> float:
        """Second moment of area about its own horizontal axis, pi d^4/64, m^4."""
        return pi * self.d * self.d * self.d * self.d / 64

    def width(self, y: float) -> float:
        """Return its chord (m) at a height y (m)."""
        r, u = self.half, y - self.y
        return 2 * sqrt((r - u) * (r + u)) if abs(u) < r else 0.0

    def moment_above(self, y: float) -> float:
        """Return the first moment (m^3) about a height y (m) of what lies above it: 2/3 c^3 - u A of the segment."""
        r, u = self.half, y - self.y
        if abs(u) >= r:
            return max(-u, 0.0) * self.area
        half_chord = sqrt((r - u) * (r + u))
        segment = r * r * acos(u / r) - u * half_chord
        return 2 * half_chord * half_chord * half_chord / 3 - u * segment


Part = Block | Disc


@dataclass(frozen=True, slots=True)
class Composed:
    """A section of parts; the properties are those of `mechanics.section.Rectangle`.

    Raises:
        ValueError: There is no solid part, a hole is wider than the material beside it, or no material is at the
            neutral axis.

    Source:
        Parallel-axis theorem: I = sum of (I_own + A (y - y_c)^2), holes negative.
    """

    parts: tuple[Part, ...]
    area: float = field(init=False)  # m^2
    centroid: float = field(init=False)  # height of the neutral axis, m
    second_moment: float = field(init=False)  # m^4
    top: float = field(init=False)  # height of the highest fibre over the neutral axis, m
    bottom: float = field(init=False)  # depth of the lowest fibre under the neutral axis, m

    def __post_init__(self) -> None:
        solid = [part for part in self.parts if not part.hole]
        if not solid:
            raise ValueError("a composed section needs at least one solid part")
        self._require_material()
        area = summed(_signed(part) for part in self.parts)
        positive("area of the section", area, "m^2")
        base = solid[0].y
        centroid = base + summed(_signed(part) * (part.y - base) for part in self.parts) / area
        moments = [_sign(part) * (part.own_moment + part.area * (part.y - centroid) ** 2) for part in self.parts]
        values = {
            "area": area,
            "centroid": centroid,
            "second_moment": summed(moments),
            "top": max(part.y + part.half for part in solid) - centroid,
            "bottom": centroid - min(part.y - part.half for part in solid),
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)
        positive("second moment of area", self.second_moment, "m^4")
        positive("width of the material at the neutral axis", self.neutral_width, "m")

    def _require_material(self) -> None:
        edges = sorted({part.y + side * part.half for part in self.parts for side in (-1, 0, 1)})
        scale = max(part.width(part.y) for part in self.parts)
        for low, high in pairwise(edges):
            for y in (low + _EDGE * (high - low), (low + high) / 2, high - _EDGE * (high - low)):
                if self.width(y) < -_EDGE * scale:
                    raise ValueError(f"a hole at the height y = {y} m is wider than the material beside it")

    def width(self, y: float) -> float:
        """Return the width of the material (m) at a height y (m)."""
        return summed(_sign(part) * part.width(y) for part in self.parts)

    @property
    def section_modulus(self) -> float:
        """Section modulus of the farthest fibre, the smaller of the two, m^3."""
        return self.second_moment / max(self.top, self.bottom)

    @property
    def moduli(self) -> tuple[float, float]:
        """Section moduli of the highest and of the lowest fibre, m^3."""
        return self.second_moment / self.top, self.second_moment / self.bottom

    @property
    def first_moment(self) -> float:
        """First moment of the part above the neutral axis, m^3."""
        return summed(_sign(part) * part.moment_above(self.centroid) for part in self.parts)

    @property
    def neutral_width(self) -> float:
        """Width of the material at the neutral axis, at an edge that of the narrower side, m."""
        step = _EDGE * (self.top + self.bottom)
        return min(self.width(self.centroid - step), self.width(self.centroid + step))


def _sign(part: Part) -> int:
    return -1 if part.hole else 1


def _signed(part: Part) -> float:
    return _sign(part) * part.area


def i_section(b: float, h: float, flange: float, web: float) -> Composed:
    """Put an I-section together, without fillets.

    Args:
        b: Width of the flanges, m.
        h: Whole height, m, more than two flanges.
        flange: Thickness of each flange, m.
        web: Thickness of the web, m, at most b.

    Raises:
        ValueError: A size is not positive and finite or does not fit.
    """
    _require_fit(web, b, "web", "width b")
    positive("height h less two flanges", h - 2 * flange, "m")
    arm = (h - flange) / 2
    return Composed((Block(b, flange, -arm), Block(web, h - 2 * flange, 0.0), Block(b, flange, arm)))


def t_section(b: float, h: float, flange: float, web: float) -> Composed:
    """Put a T-section together: the flange (width b, m) above, the web below it; heights from the foot of the web.

    Raises:
        ValueError: A size is not positive and finite or does not fit.
    """
    _require_fit(web, b, "web", "width b")
    positive("height h less the flange", h - flange, "m")
    return Composed((Block(web, h - flange, (h - flange) / 2), Block(b, flange, h - flange / 2)))


def box(b: float, h: float, wall: float, flange: float) -> Composed:
    """Put a rectangular tube together: two walls (each `wall` thick, m) between two flanges; b wide, h high (m).

    Raises:
        ValueError: A size is not positive and finite or does not fit.
    """
    positive("wall", wall, "m")
    return i_section(b, h, flange, 2 * wall)


def _require_fit(part: float, whole: float, name: str, other: str) -> None:
    if not 0 < part <= whole:
        raise ValueError(f"{name} = {part} m must be positive and at most the {other} = {whole} m")
