"""The box over which the tests of solutions compare."""

from __future__ import annotations

from math import pi

from graders.language import Symbols, parse
from graders.language.tree import Relation
from graders.solutions.scene import scene_of

RANGES = {
    "l1": (0.04, 0.12), "l2": (0.1, 0.6), "l4": (0.1, 0.6), "r3": (0.1, 0.6), "a1": (0.0, 2 * pi), "a2": (-1.2, 1.2),
    "phi": (-pi, pi), "psi": (-pi, pi), "e": (0.0, 0.03), "l3": (0.05, 0.7), "x": (0.1, 2.0), "y": (-2.0, 2.0),
    "z": (-2.0, 2.0), "a": (0.1, 1.0), "b": (0.1, 1.0), "w1": (1.0, 40.0), "w2": (-40.0, 40.0), "w3": (-40.0, 40.0),
    "s": (0.0, 1.0),
}  # fmt: skip
SYMBOLS = Symbols(RANGES)
SCENE = scene_of(tuple(RANGES), tuple(RANGES.values()), b"tests")


def relation(text: str) -> Relation:
    """Read a relation."""
    found = parse(text, SYMBOLS)
    assert isinstance(found, Relation)
    return found
