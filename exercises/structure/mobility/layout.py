"""Where the parts of a mechanism lie on the sheet: the figure draws it, the oracle moves it. Sheet units, y upwards."""

from __future__ import annotations

from cmath import phase
from collections.abc import Sequence
from dataclasses import dataclass, field
from math import pi
from typing import Literal, TypeAlias

from exercises.structure.mobility.parts import Dyad, Part, Place, Start, Strut, Triad
from figures.plane import unit

COLUMN = 138.0
CAM_CENTRE, CAM_RADIUS, ROLLER = 7 + 5j, 34.0, 12.0
LEVER = 98 + 4j  # pivot of the cam's lever
GEARS = (30.0, 44.0)
PRESSURE = pi / 2 - pi / 9  # direction of the common normal of the teeth, 20 degrees off the tangent
NORMAL = 1.2  # direction from the centre of the cam to its contact
FRAME = "0"
Side: TypeAlias = Literal["left", "right"]


@dataclass(slots=True)
class Node:
    """A joint: its kind (R, P or H), the links that meet, its place and direction."""

    kind: str
    links: list[str]
    at: complex
    angle: float = 0.0


@dataclass(slots=True)
class Layout:
    """All of a mechanism on the sheet.

    Attributes:
        nodes: Joints in the order in which they were laid out.
        rods: The course of each link that is drawn as a line.
        discs: Cams, rollers, gears: link, centre, radius.
        blocks: Sliders: place, direction, and whether their guide is the frame.
        shape: Kind of the start, for its cam or gears.
    """

    shape: str
    nodes: list[Node] = field(default_factory=list)
    rods: list[tuple[str, tuple[complex, ...]]] = field(default_factory=list)
    blocks: list[tuple[str, complex, float, bool]] = field(default_factory=list)
    discs: list[tuple[str, complex, float]] = field(default_factory=list)
    count: int = 0
    joint: Node | None = None  # where a part may attach: at this joint …
    spot: tuple[str, complex] = ("", 0j)  # … or at this place of this link
    column: float = 0.0

    def link(self) -> str:
        """Number the next link."""
        self.count += 1
        return str(self.count)

    def revolute(self, at: complex, *links: str) -> Node:
        """Lay out a revolute joint."""
        node = Node("R", list(links), at)
        self.nodes.append(node)
        return node

    def attach(self, place: Place, link: str) -> complex:
        """Attach a link at the last joint, or at a joint of its own on the last link."""
        if place == "joint" and self.joint is not None:
            self.joint.links.append(link)
            return self.joint.at
        owner, at = self.spot
        self.joint = self.revolute(at, owner, link)
        return at


def lay_out(parts: Sequence[Part], side: Side) -> Layout:
    """Lay out a mechanism, starting on the left or on the right of the sheet."""
    first = parts[0]
    assert isinstance(first, Start)
    sheet = Layout(first.type)
    _start(sheet, first)
    for part in parts[1:]:
        sheet.column += COLUMN
        match part:
            case Dyad(type="swing", place=place):
                _swing(sheet, place)
            case Dyad(type=kind, place=place) if kind.startswith("rocker"):
                _rocker(sheet, place, kind == "rocker_up")
            case Dyad(type=kind, place=place):
                _slider(sheet, place, kind == "slider_upright")
            case Triad(type=kind, place=place):
                _triad(sheet, place, kind == "up")
            case Strut(place=place):
                _strut(sheet, place)
    sheet.rods = [(link, points if _carries(sheet, link, points[-1]) else points[:-1]) for link, points in sheet.rods]
    return sheet if side == "left" else _mirrored(sheet)


def _mirrored(sheet: Layout) -> Layout:
    def turned(at: complex) -> complex:
        return -at.conjugate()

    for node in sheet.nodes:
        node.at, node.angle = turned(node.at), pi - node.angle
    sheet.rods = [(link, tuple(map(turned, points))) for link, points in sheet.rods]
    sheet.blocks = [(link, turned(at), (pi - angle) % pi, grounded) for link, at, angle, grounded in sheet.blocks]
    sheet.discs = [(link, turned(at), radius) for link, at, radius in sheet.discs]
    return sheet


def _carries(sheet: Layout, link: str, end: complex) -> bool:
    """Tell whether a rod is needed to its end: for a joint there, or for a block that slides along it."""
    slides = any(node.kind == "P" and link in node.links for node in sheet.nodes)
    return slides or any(node.at == end and link in node.links for node in sheet.nodes)


def _start(sheet: Layout, start: Start) -> None:
    first = sheet.link()
    sheet.revolute(0j, FRAME, first)
    if start.type == "crank":
        sheet.rods.append((first, (0j, 26 + 70j)))
        sheet.spot = (first, 26 + 70j)
    elif start.type == "gears":
        _gears(sheet, first)
    else:
        _cam(sheet, first, start.type == "roller")
    sheet.column = sheet.spot[1].real - 12


def _gears(sheet: Layout, first: str) -> None:
    second, centre = sheet.link(), complex(sum(GEARS), 0)
    sheet.discs += [(first, 0j, GEARS[0]), (second, centre, GEARS[1])]
    sheet.nodes.append(Node("H", [first, second], complex(GEARS[0], 0), PRESSURE))
    sheet.revolute(centre, FRAME, second)
    sheet.spot = (second, centre + 28 * unit(1.2))


def _cam(sheet: Layout, first: str, roller: bool) -> None:
    """A disc, and a bent lever that rests on it with a point or with a roller."""
    contact = CAM_CENTRE + CAM_RADIUS * unit(NORMAL)
    end, touching = contact, sheet.link()
    sheet.discs.append((first, CAM_CENTRE, CAM_RADIUS))
    sheet.nodes.append(Node("H", [first, touching], contact, NORMAL))
    lever = touching
    if roller:
        end, lever = contact + ROLLER * unit(NORMAL), sheet.link()
        sheet.discs.append((touching, end, ROLLER))
        sheet.revolute(end, touching, lever)
    sheet.revolute(LEVER, FRAME, lever)
    tip = LEVER + 26 + 72j
    sheet.rods.append((lever, (end, LEVER, tip)))
    sheet.spot = (lever, tip)


def _rocker(sheet: Layout, place: Place, up: bool) -> None:
    rod, rocker = sheet.link(), sheet.link()
    start = sheet.attach(place, rod)
    joint = complex(sheet.column - 8, 92 if start.imag < 80 else 70)
    pivot = complex(sheet.column + 10, 168) if up else complex(sheet.column, 0)
    sheet.rods += [(rod, (start, joint)), (rocker, (pivot, joint, joint + 0.5 * (joint - pivot)))]
    sheet.revolute(pivot, FRAME, rocker)
    sheet.joint = sheet.revolute(joint, rod, rocker)
    sheet.spot = (rocker, joint + 0.5 * (joint - pivot))


def _slider(sheet: Layout, place: Place, upright: bool) -> None:
    rod, block = sheet.link(), sheet.link()
    start = sheet.attach(place, rod)
    height = (132 if start.imag < 106 else 80) if upright else 20
    at = complex(sheet.column, height)
    sheet.rods.append((rod, (start, at)))
    sheet.joint = sheet.revolute(at, rod, block)
    angle = pi / 2 if upright else 0.0
    sheet.nodes.append(Node("P", [FRAME, block], at, angle))
    sheet.blocks.append((block, at, angle, True))
    sheet.spot = (rod, start + 0.42 * (at - start))


def _swing(sheet: Layout, place: Place) -> None:
    block, rocker = sheet.link(), sheet.link()
    at = sheet.attach(place, block)
    pivot = complex(sheet.column - 92, -26)
    along = (at - pivot) / abs(at - pivot)
    tip = at + 62 * along
    angle = phase(along)
    sheet.rods.append((rocker, (pivot, at, tip)))
    sheet.nodes.append(Node("P", [block, rocker], at, angle))
    sheet.blocks.append((block, at, angle, False))
    sheet.revolute(pivot, FRAME, rocker)
    sheet.spot = (rocker, tip)


def _triad(sheet: Layout, place: Place, up: bool) -> None:
    one, two, three = sheet.link(), sheet.link(), sheet.link()
    start = sheet.attach(place, one)
    first, second = complex(sheet.column - 40, 118), complex(sheet.column + 36, 78)
    pivot = complex(sheet.column + 52, 172) if up else complex(sheet.column + 44, 0)
    sheet.rods += [(one, (start, first)), (two, (first, second)), (three, (second, pivot))]
    sheet.revolute(first, one, two)
    sheet.revolute(second, two, three)
    sheet.revolute(pivot, FRAME, three)


def _strut(sheet: Layout, place: Place) -> None:
    bar = sheet.link()
    start = sheet.attach(place, bar)
    pivot = complex(sheet.column - 30, 0)
    sheet.rods.append((bar, (start, pivot)))
    sheet.revolute(pivot, FRAME, bar)
