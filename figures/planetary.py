"""An epicyclic train from the side: central wheels on one axis, one planet, the carrier about the first shaft."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from figures import gears
from figures.canvas import Drawing, Line, Piece
from figures.joints import ground_line
from figures.label import point, symbol
from figures.lines import axis
from figures.picture import Picture, Words
from figures.placing import Spot, place

WIDTH = 572.0
HEIGHT = 150.0  # of the largest wheel above the axis
FIRST, SECOND = 0.0, 118.0  # planes of the two meshes
ARM = -58.0  # plane of the carrier's arm
LEFT, RIGHT = -196.0, 120.0  # ends of the shafts; the right one beside the last plane
SLEEVE = 11.0  # half the width of the carrier's hollow shaft
SMALLEST = 24.0  # radius at which a wheel can still be seen


@dataclass(frozen=True, slots=True)
class Wheels:
    """Pitch radii in any one unit, and names: first central wheel, planet, second rim of the planet, last wheel.

    The second rim is None where one planet meshes with both central wheels; `ring` tells that the last has internal
    teeth.
    """

    names: tuple[str, ...]
    first: float
    planet: float
    second: float | None
    last: float
    ring: bool


def draw(
    prefix: str,
    words: Words,
    wheels: Wheels,
    fixed: Literal["first", "last"],
    speeds: tuple[str, str, str] = ("", "", ""),
) -> Picture:
    """Draw an epicyclic train.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        wheels: The wheels; radii that differ too much are drawn nearer to one another.
        fixed: The central wheel that is held.
        speeds: Names of the speeds of the first wheel, the last wheel and the carrier; an empty one is left out.

    Raises:
        ValueError: A radius is not positive.
    """
    first, planet, second, last = _fitted(wheels)
    height = (first + planet) * 1j
    plane = SECOND if wheels.second is not None else FIRST
    pieces: list[Piece] = [axis(LEFT - 20, plane + RIGHT + 20)]
    pieces += _central(first, plane, last, wheels.ring)
    pieces += _planet(height, planet, second, plane)
    pieces += _carrier(height)
    held = LEFT if fixed == "first" else plane + RIGHT
    pieces += ground_line(held - 26j, held + 26j) if fixed == "last" else ground_line(held + 26j, held - 26j)
    pieces += _named(wheels, pieces, (first, planet, second, last), plane)
    pieces += _spoken(speeds, pieces, plane, height)
    return Picture(Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH), words.table)


def _fitted(wheels: Wheels) -> tuple[float, float, float | None, float]:
    """Scale the radii; both meshes keep one distance of the axes."""
    if min(wheels.first, wheels.planet, wheels.second or 1.0, wheels.last) <= 0:
        raise ValueError("a wheel has a radius that is not positive")
    distance = wheels.first + wheels.planet
    reach = distance + max(wheels.planet, wheels.second or 0.0)
    scale = HEIGHT / reach
    axes = distance * scale
    first = min(max(wheels.first * scale, SMALLEST), axes - SMALLEST)
    second = None if wheels.second is None else min(max(wheels.second * scale, SMALLEST), axes - SMALLEST)
    rim = axes - first if second is None else second
    return first, axes - first, second, axes + rim if wheels.ring else axes - rim


def _central(first: float, plane: float, last: float, ring: bool) -> list[Piece]:
    """Draw the two central wheels; the shaft of the first runs to the left, that of the last to the right."""
    wheel = gears.ring(complex(plane, 0), last, 1) if ring else gears.wheel(complex(plane, 0), last)
    start = plane + (gears.WEB if ring else 0.0)
    return [
        gears.shaft(complex(LEFT, 0), complex(FIRST, 0)),
        *gears.wheel(complex(FIRST, 0), first),
        *wheel,
        gears.shaft(complex(start, 0), complex(plane + RIGHT, 0)),
        gears.bearing(complex(plane + RIGHT - 40, 0)),
        gears.bearing(complex(LEFT + 34, 0)),
    ]


def _planet(height: complex, planet: float, second: float | None, plane: float) -> list[Piece]:
    end = plane + 10 if second is not None else 12.0
    marks = [gears.shaft(ARM - 14 + height, end + height), *gears.wheel(FIRST + height, planet)]
    return [*marks, *(gears.wheel(plane + height, second) if second is not None else ())]


def _carrier(height: complex) -> list[Piece]:
    """Draw the arm with its bearing on the planet's shaft, and the hollow shaft around the first one."""
    sleeve = complex(0, SLEEVE)
    arms = (Line("f-link", (ARM + sleeve, ARM + height - 9j)), Line("f-link", (ARM - sleeve, ARM - sleeve - 16j)))
    tubes = tuple(Line("f-thick", (ARM + way * sleeve, ARM - 58 + way * sleeve)) for way in (1, -1))
    return [*arms, *tubes, gears.bearing(ARM + height)]


def _named(
    wheels: Wheels, pieces: Sequence[Piece], radii: tuple[float, float, float | None, float], plane: float
) -> list[Piece]:
    first, planet, second, last = radii
    height = (first + planet) * 1j
    tops = [FIRST - first * 1j, FIRST + height + planet * 1j]
    tops += [plane + height + second * 1j] if second is not None else []
    tops.append(complex(plane, -last))
    found: list[Piece] = []
    for name, top in zip(wheels.names, tops, strict=True):
        way = 1 if top.imag > 0 else -1
        aside: list[Spot] = [(top - 14 - way * 24j - 5j, "end"), (top + 14 - way * 24j - 5j, "start")]
        spots: list[Spot] = [*aside] if top.imag > 0 else [(top + way * 18j - 6j, "middle"), *aside]
        found += place(symbol(name), spots, [*pieces, *found], top)
    arm = ARM + 0.7 * (first + planet) * 1j
    return found + list(place(point("H"), [(arm - 12 - 5j, "end")], [*pieces, *found], arm))


def _spoken(speeds: tuple[str, str, str], pieces: Sequence[Piece], plane: float, height: complex) -> list[Piece]:
    first, last, carrier = speeds
    found: list[Piece] = []
    for name, at in ((first, LEFT + 12 + 16j), (last, plane + RIGHT - 8 + 16j), (carrier, ARM - 40 + 22j)):
        if name:
            spots: list[Spot] = [(at + rise, "middle") for rise in (0j, 12j, -46j, 24j)]
            found += place(symbol(name, "vel"), spots, [*pieces, *found])
    return found
