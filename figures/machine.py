"""The machine of a laboratory as its page moves it: joints, sides and driven coordinates, told by the givens alone.

Nothing here is a formula of a step: a page builds the true motion from it by nested turns and shifts.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class Pair:
    """A driven joint of a chain.

    Attributes:
        kind: A turn, or a slide along a guide of the body before.
        coordinate: Name of the driven coordinate.
        behind: Name of the length from the joint before to this one, empty where they coincide.
        datum: Number of the body from which a turn is measured, 0 for the frame.
        turn: Direction of the guide in the body before, radians.
    """

    kind: Literal["turn", "slide"]
    coordinate: str
    behind: str = ""
    datum: int = 0
    turn: float = 0.0


@dataclass(frozen=True, slots=True)
class Drive:
    """A coordinate that moves by constant acceleration: its name, and those of its rate and of the rate of that."""

    name: str
    rate: str
    surge: str


@dataclass(frozen=True, slots=True)
class Link:
    """A link or a slide between two nodes.

    Attributes:
        length: Name of its length.
        start: Its first node.
        end: Its last node.
        slides: Whether the length is a driven coordinate.
        called: What the task calls its direction and the two rates of it, empty where these are no names of their own.
    """

    length: str
    start: str
    end: str
    slides: bool = False
    called: tuple[str, str, str] = ("", "", "")


@dataclass(frozen=True, slots=True)
class Plotted:
    """A coordinate of the last node: its name, and those of its rates."""

    axis: Literal["x", "y"]
    name: str
    rate: str
    surge: str


@dataclass(frozen=True, slots=True)
class Machine:
    """A chain from the frame to its last node.

    Attributes:
        drives: The driven coordinates.
        pairs: The driven joints from the frame on; body i stands behind pair i.
        links: The links and slides in the order of the chain.
        plotted: What is plotted of the last node.
        span: Time of the motion shown, s.
        tip: Name of the length from the last pair to the next node, empty where the body ends in its pair.
        rod: Name of the length of a rod from there to a guide along x through the first node, empty without one.
    """

    drives: tuple[Drive, ...]
    pairs: tuple[Pair, ...]
    links: tuple[Link, ...]
    plotted: tuple[Plotted, ...]
    span: float
    tip: str = ""
    rod: str = ""
