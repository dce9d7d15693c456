"""The mechanism as laid out; its joints lettered, its links numbered, the frame 0."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi
from string import ascii_uppercase
from typing import TYPE_CHECKING, Any

from exercises.structure.mobility.layout import FRAME, Layout, Node, lay_out
from figures import mechanism
from figures.picture import Picture, Table, Words

if TYPE_CHECKING:
    from exercises.structure.mobility import Givens

HIGH = 140.0  # a pivot above hangs from its base


def figure(givens: Givens, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the mechanism."""
    sheet = lay_out(givens.parts, givens.side)
    names = _letters(sheet.nodes)
    rows = tuple((names[at], words["kinds"][node.kind], ", ".join(node.links)) for at, node in enumerate(sheet.nodes))
    said = Words(words["title"], words["description"], Table(tuple(words["header"]), rows))
    return mechanism.draw(
        "mobility",
        said,
        [mechanism.Rod(points, link) for link, points in sheet.rods],
        [_pin(names[at], node) for at, node in enumerate(sheet.nodes) if node.kind == "R"],
        [mechanism.Block(at, angle, grounded, link) for link, at, angle, grounded in sheet.blocks],
        _discs(sheet),
        [mechanism.Contact(names[at], node.at, node.angle) for at, node in enumerate(sheet.nodes) if node.kind == "H"],
    )


def _letters(nodes: list[Node]) -> list[str]:
    """Letter the joints; a guide takes the letter of the joint in its block, with a mark."""
    letters = iter(ascii_uppercase)
    at_place: dict[complex, str] = {}
    names = []
    for node in nodes:
        if node.kind == "P":
            names.append("")
            continue
        at_place[node.at] = next(letters)
        names.append(at_place[node.at])
    return [name or at_place[node.at] + "′" for name, node in zip(names, nodes, strict=True)]


def _pin(name: str, node: Node) -> mechanism.Pin:
    base = None
    if FRAME in node.links:
        base = pi if node.at.imag > HIGH else 0.0
    return mechanism.Pin(name, node.at, base, len(node.links))


def _discs(sheet: Layout) -> list[mechanism.Disc]:
    return [mechanism.Disc(at, radius, link, sheet.shape == "gears") for link, at, radius in sheet.discs]
