"""What the judge of a polygon is handed: the graph of the mechanism and its true motion in plain numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from graders.polygon.drawn import Drawn
from graders.polygon.jets import Trio


@dataclass(frozen=True, slots=True)
class State:
    """One true state of the mechanism, SI units.

    Attributes:
        names: What the task names, each with its rate and the rate of that.
        nodes: Coordinates x and y of every node, each with its rates.
    """

    names: Mapping[str, Trio]
    nodes: Mapping[str, tuple[Trio, Trio]]


@dataclass(frozen=True, slots=True)
class Mechanism:
    """A mechanism with nodes, the links or guides that join them, and how it truly moves.

    Attributes:
        edges: Pairs of nodes that a link, a guide or the frame joins.
        loops: How many independent polygons it has: k = p - n + 1.
        polygon: A polygon that is right for it, as a student could type it.
        velocity: The differentiated projections of that polygon.
        acceleration: The projections differentiated twice.
        states: Gives true states, at least sixteen, none near a dead position.
        derived: Names of the task that follow from others, with their formulas, in the order of solving.
        places: Coordinates of nodes that the task names: the name, the node, 0 for x and 1 for y.
        own: The student's polygon, beside which derivatives are judged; None for the one above.
    """

    edges: tuple[tuple[str, str], ...]
    polygon: str
    states: Callable[[], tuple[State, ...]]
    loops: int = 1
    velocity: str = ""
    acceleration: str = ""
    derived: tuple[tuple[str, str], ...] = ()
    places: tuple[tuple[str, str, int], ...] = ()
    own: Drawn | None = None

    @property
    def nodes(self) -> tuple[str, ...]:
        """Give the letters of the nodes."""
        return tuple(dict.fromkeys(node for edge in self.edges for node in edge))

    def beside(self, own: Drawn) -> Mechanism:
        """Give the same mechanism beside the polygon that the student drew for it."""
        return replace(self, own=own)

    def alone(self) -> Mechanism:
        """Give the same mechanism without the student's polygon."""
        return replace(self, own=None) if self.own else self
