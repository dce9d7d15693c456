"""A planar mechanism: rods, blocks on guides, cams and gears, its links numbered and its joints lettered."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import pi

from figures.canvas import Circle, Drawing, Line, Piece
from figures.joints import ground, ground_line, revolute, slider
from figures.label import number, point
from figures.lines import axis
from figures.picture import Picture, Words
from figures.placing import Spot, place
from figures.plane import Point, direction, unit

WIDTH = 572.0
GUIDE = 44.0
SHARES = (0.5, 0.35, 0.65, 0.2, 0.8)  # along a rod, where its number may stand
RING = tuple(k * pi / 4 for k in (2, 0, 4, 6, 1, 3, 7, 5))


@dataclass(frozen=True, slots=True)
class Pin:
    """A revolute joint: its letter, whether it stands on the frame (and on which side), how many links meet."""

    name: str
    at: Point
    base: float | None = None  # direction of the frame's base, radians
    links: int = 2


@dataclass(frozen=True, slots=True)
class Block:
    """A slider: place, direction of its guide, whether the guide is the frame, its number."""

    at: Point
    angle: float
    grounded: bool
    name: str


@dataclass(frozen=True, slots=True)
class Disc:
    """A cam, a roller or a gear: a circle, its number; a gear has its pitch circle only."""

    centre: Point
    radius: float
    name: str
    gear: bool = False


@dataclass(frozen=True, slots=True)
class Rod:
    """A link drawn as a line through its points, and its number."""

    points: tuple[Point, ...]
    name: str


@dataclass(frozen=True, slots=True)
class Contact:
    """A higher pair and its letter."""

    name: str
    at: Point
    normal: float


def draw(
    prefix: str,
    words: Words,
    rods: Sequence[Rod],
    pins: Sequence[Pin],
    blocks: Sequence[Block] = (),
    discs: Sequence[Disc] = (),
    contacts: Sequence[Contact] = (),
) -> Picture:
    """Draw a mechanism; all labels stand clear of its lines where there is room.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        rods: Links drawn as lines.
        pins: Revolute joints.
        blocks: Sliders.
        discs: Cams, rollers and gears.
        contacts: Higher pairs.
    """
    pieces: list[Piece] = [piece for disc in discs for piece in _disc(disc)]
    pieces += [piece for pin in pins if pin.base is not None for piece in ground(pin.at, pin.base)]
    pieces += [piece for block in blocks for piece in _guide(block)]
    pieces += [Line("f-link", rod.points) for rod in rods]
    pieces += [slider(block.at, block.angle, 34, 18) for block in blocks]
    pieces += [piece for pin in pins for piece in revolute(pin.at, double=pin.links > 2)]
    for pin in pins:
        pieces += place(point(pin.name), _around(pin.at, 0.0), pieces, pin.at)
    pieces += _contact_names(contacts, pieces)
    for name, places, target in _numbers(rods, blocks, discs):
        pieces += place(number(name), [(at, "middle") for at in places], pieces, target)
    return Picture(Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH), words.table)


def _disc(disc: Disc) -> tuple[Piece, ...]:
    if not disc.gear:
        return (Circle("f-body", disc.centre, disc.radius),)
    cross = 8 * unit(0.0)
    circles = (Circle("f-thick", disc.centre, disc.radius + 3), Circle("f-axis", disc.centre, disc.radius))
    return (*circles, axis(disc.centre - cross, disc.centre + cross))


def _guide(block: Block) -> tuple[Piece, ...]:
    if not block.grounded:
        return ()
    along, below = GUIDE * unit(block.angle), 9 * unit(block.angle - pi / 2)
    return ground_line(block.at - along + below, block.at + along + below)


def _around(at: Point, first: float) -> list[Spot]:
    return [(at + far * unit(first + turn) - 6j, "middle") for far in (19, 25, 31) for turn in RING]


def _contact_names(contacts: Iterable[Contact], pieces: list[Piece]) -> list[Piece]:
    found: list[Piece] = []
    for contact in contacts:
        found += place(point(contact.name), _around(contact.at, contact.normal), [*pieces, *found], contact.at)
    return found


def _numbers(
    rods: Iterable[Rod], blocks: Iterable[Block], discs: Iterable[Disc]
) -> Iterable[tuple[str, list[Point], Point]]:
    """Give for each link the places where its number may stand, best first, and a point of the link."""
    for rod in rods:
        start, end = rod.points[:2]
        yield rod.name, [spot for share in SHARES for spot in _beside(rod, share)], (start + end) / 2
    for block in blocks:
        sides = [unit(block.angle + turn) for turn in (pi / 4, 3 * pi / 4, -pi / 4, -3 * pi / 4, 0.0, pi)]
        corner = block.at + complex(9, 6) * unit(block.angle)
        yield block.name, [block.at + far * side - 5j for far in (26, 32) for side in sides], corner
    for disc in discs:
        spots = [disc.centre + (disc.radius + 14) * unit(turn) - 5j for turn in (4.0, 5.0, 3.4, 5.6, 2.4, 1.0)]
        inside = [disc.centre + disc.radius * 0.65 * unit(turn) - 5j for turn in (2.6, 0.5, 3.6)]
        yield disc.name, [*spots, *inside], disc.centre + 0.8 * disc.radius * unit(2.6)


def _beside(rod: Rod, share: float) -> list[Point]:
    start, end = rod.points[0], rod.points[1]
    middle, across = start + share * (end - start), unit(direction(start, end) + pi / 2)
    return [middle + 13 * across - 5j, middle - 13 * across - 5j]
