"""The planar arm of laboratory TMM-2 in one fixed pose: revolutes O and slides P in the order of its word.

The base A stands at the origin of x and y; angles are counter-clockwise. Nothing is to scale, so nothing is told.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import pi, radians
from typing import Literal

from figures.canvas import Drawing, Piece
from figures.joints import gripper, ground, ground_line, revolute, slider
from figures.label import Label, point, symbol
from figures.lines import arc, thin, thin_arrow
from figures.members import link
from figures.picture import Picture, Words
from figures.placing import Spot, place, written
from figures.plane import Point, direction, left_of, unit
from figures.polygon import RING, between

WIDTH = 572.0
Word = Literal["OOP", "OPO", "POO"]
FIRST, BEND = radians(24), radians(50)  # the running direction, and what a revolute adds to it
LENGTHS = {"OOP": (170.0, 150.0, 120.0), "OPO": (160.0, 120.0, 150.0), "POO": (110.0, 170.0, 150.0)}
NAMES = {"OOP": ("l_AB", "l_BC", "h3"), "OPO": ("l_AB", "h2", "l_CD"), "POO": ("h1", "l_BC", "l_CD")}
SIDEWAYS = {"OOP": -pi / 2, "OPO": pi / 2, "POO": pi / 2}  # of a slide across, from its running direction


@dataclass(frozen=True, slots=True)
class _Pose:
    """The nodes A, B, C, D and the directions of the three parts."""

    nodes: tuple[Point, Point, Point, Point]
    angles: tuple[float, float, float]


def _pose(word: Word, across: bool) -> _Pose:
    turned = SIDEWAYS[word] if across else 0.0
    angles = {
        "OOP": (FIRST, FIRST + BEND, FIRST + BEND + turned),
        "OPO": (FIRST, FIRST + turned, FIRST + BEND),
        "POO": (turned, FIRST, FIRST + BEND),
    }[word]
    nodes = [0j]
    for length, angle in zip(LENGTHS[word], angles, strict=True):
        nodes.append(nodes[-1] + length * unit(angle))
    return _Pose((nodes[0], nodes[1], nodes[2], nodes[3]), angles)


@lru_cache(maxsize=64)  # all that there are: the pose is fixed
def draw(prefix: str, words: Words, word: Word, across: bool, relative: bool) -> Picture:
    """Draw the scheme of the arm.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        word: Its joints from the base on.
        across: Whether the slide runs at a right angle to the link that holds it (POO: along y instead of x).
        relative: Whether the last turn is measured from the link before instead of from x.
    """
    pose = _pose(word, across)
    pieces: list[Piece] = [*_axes(), *_parts(word, pose)]
    arcs = list(_arcs(word, pose, relative))
    for _, marks in arcs:
        pieces += marks
    pieces += _joints(word, pose)
    for (label, spots), _ in arcs:
        pieces += place(label, spots, pieces)
    for label, spots in _labels(word, pose):
        pieces += place(label, spots, pieces)
    return Picture(Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH), words.table)


def draw_polygon(prefix: str, title: str, word: Word, across: bool, vectors: Sequence[tuple[str, str, str]]) -> Picture:
    """Draw vectors between the nodes of the arm, each with its name; the foot E of D lies on x.

    Args:
        prefix: The id of the figure on its page.
        title: What it shows.
        word: The joints of the arm.
        across: As for the scheme.
        vectors: Name, start and end of each vector; one with an unknown node is left out.
    """
    pose = _pose(word, across)
    nodes = dict(zip("ABCD", pose.nodes, strict=True)) | {"E": complex(pose.nodes[3].real, 0)}
    return between(prefix, title, nodes, vectors, _axes(), WIDTH)


def _axes() -> tuple[Piece, ...]:
    tips = 330 + 0j, 250j
    names = (written(symbol(name, "thin"), tip + 12 - 6j, "middle") for name, tip in zip("xy", tips, strict=True))
    return tuple(piece for tip in tips for piece in thin_arrow(0j, tip)) + tuple(p for name in names for p in name)


def _parts(word: Word, pose: _Pose) -> tuple[Piece, ...]:
    a, b, c, d = pose.nodes
    last = pose.angles[2]
    frame = ground(a) if word != "POO" else _guide(pose)
    return (*frame, *([link(a, b)] if word != "POO" else []), link(b, c), link(c, d), gripper(d, last))


def _guide(pose: _Pose) -> tuple[Piece, ...]:
    """The guide of a base slide, on the right of its direction."""
    a, b = pose.nodes[:2]
    along, aside = unit(pose.angles[0]), 9 * unit(pose.angles[0] - pi / 2)
    if pose.angles[0]:
        return ground_line(b + 60 * along - aside, a - 14 * along - aside)
    return ground_line(a - 14 * along + aside, b + 60 * along + aside)


def _joints(word: Word, pose: _Pose) -> list[Piece]:
    a, b, c, _ = pose.nodes
    slide = {"OOP": c, "OPO": b, "POO": b}[word]
    angle = pose.angles["OPO".index("P") if word == "OPO" else word.index("P")]
    pins = {"OOP": (a, b), "OPO": (a, c), "POO": (b, c)}[word]
    return [slider(slide, angle, 34, 18), *(mark for at in pins for mark in revolute(at))]


Named = tuple[Label, list[Spot]]


def _arcs(word: Word, pose: _Pose, relative: bool) -> Iterable[tuple[Named, tuple[Piece, ...]]]:
    """Arcs of the turns from their zero directions; the head of each is its positive sense."""
    a, b, c, _ = pose.nodes
    first, second, third = pose.angles
    turns = {
        "OOP": (("Θ1", a, 0.0, first), ("Θ2", b, first if relative else 0.0, second)),
        "OPO": (("Θ1", a, 0.0, first), ("Θ3", c, first if relative else 0.0, third)),
        "POO": (("Θ2", b, 0.0, second), ("Θ3", c, second if relative else 0.0, third)),
    }[word]
    for name, at, start, end in turns:
        zero = () if at == a else (thin(at, at + 84 * unit(start)),)
        middle = unit((start + end) / 2)
        spots: list[Spot] = [(at + far * middle - 6j, "middle") for far in (74, 66, 82, 90)]
        yield (symbol(name), spots), (*zero, *arc(at, 54, start, end))


def _labels(word: Word, pose: _Pose) -> Iterable[Named]:
    a, b, c, d = pose.nodes
    for name, at in zip("ABCD", (a, b, c, d), strict=True):
        yield point(name), [(at + far * unit(turn) - 6j, "middle") for far in (22, 28, 34) for turn in RING]
    for name, start, end in zip(NAMES[word], (a, b, c), (b, c, d), strict=True):
        aside = unit(direction(start, end) + pi / 2)
        yield (
            symbol(name),
            [
                (left_of(start, end, off, share) - 5j + (8 * aside.real if off > 0 else -8 * aside.real), "middle")
                for off in (16, -18, 24, -26)
                for share in (0.55, 0.65, 0.4, 0.75)
            ],
        )
