"""A position of a laboratory machine at true scale, drawn as nested turns and shifts of its givens.

No place of a node is computed, so none stands in the figure: each body is drawn along its own x axis, inside the turn
or shift of its pair. A rod to a guide is its circle: the node lies where the circle meets the guide, on the right.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees

from figures.canvas import coordinate
from figures.label import escaped
from figures.machine import Machine

SIZE = 100.0  # user units to the farthest place the chain can reach
ROOM = 14.0
PIN = '<circle class="f-o" r="4"/>'
BLOCK = '<rect class="f-body" x="-11" y="-6.5" width="22" height="13"/>'
FORK = '<path class="f-thick" d="M9-6H0V6H9"/>'


def coordinate_at(machine: Machine, values: Mapping[str, float], name: str, t: float) -> float:
    """Give a driven coordinate by constant acceleration, t seconds after the moment of the givens, SI units."""
    drive = next(one for one in machine.drives if one.name == name)
    return values[name] + values.get(drive.rate, 0.0) * t + values.get(drive.surge, 0.0) * t * t / 2


def draw(machine: Machine, values: Mapping[str, float], t: float, prefix: str, title: str) -> str:
    """Draw the machine t seconds after the moment of the givens.

    Args:
        machine: What moves.
        values: The givens, SI units.
        t: The time, s.
        prefix: The id of the figure on its page.
        title: What it shows.

    Returns:
        The SVG text, at a scale that is the same for all times of the span.
    """
    scale = SIZE / _reach(machine, values)
    axes = f'<path class="f-axis" d="M{-SIZE:.0f} 0H{SIZE:.0f}M0 {-SIZE:.0f}V{SIZE:.0f}"/>'
    inner = axes + _Pose(machine, values, t, scale).marks()
    view = f"{-SIZE - ROOM:.0f} {-SIZE - ROOM:.0f} {2 * (SIZE + ROOM):.0f} {2 * (SIZE + ROOM):.0f}"
    return (
        f'<svg class="fig" viewBox="{view}" role="img" aria-labelledby="{prefix}-t">'
        f'<title id="{prefix}-t">{escaped(title)}</title>{inner}</svg>'
    )


def _reach(machine: Machine, values: Mapping[str, float]) -> float:
    """The longest the chain becomes while it moves."""
    times = (0.0, machine.span / 2, machine.span)
    return sum(
        max(abs(coordinate_at(machine, values, link.length, t)) for t in times) if link.slides else values[link.length]
        for link in machine.links
    )


@dataclass(frozen=True, slots=True)
class _Pose:
    """The machine at one moment."""

    machine: Machine
    values: Mapping[str, float]
    t: float
    scale: float

    def marks(self, turns: tuple[float, ...] = ()) -> str:
        """Draw body `len(turns)` in its own axes, and inside it all that it carries; turns are those of SVG."""
        body, pairs = len(turns), self.machine.pairs
        pin = PIN if body and pairs[body - 1].kind == "turn" else ""
        if body == len(pairs):
            return self._bar(self.machine.tip) + pin + self._end()
        pair = pairs[body]
        q = coordinate_at(self.machine, self.values, pair.coordinate, self.t)
        base = self._bar(pair.behind) + pin + f'<g transform="translate({self._length(pair.behind)} 0)'
        if pair.kind == "slide":
            turn, far = -degrees(pair.turn), coordinate(q * self.scale)
            carried = f'<g transform="translate({far} 0)">{self.marks((*turns, turn))}</g>'
            return f'{base} rotate({turn:.0f})"><path class="f-link" d="M0 0H{far}"/>{BLOCK}{carried}</g>'
        back = "".join(f" rotate({-turn:.2f})" for turn in reversed(turns[pair.datum :]))
        return f'{base}{back} rotate({-degrees(q):.2f})">{self.marks((*turns, -degrees(q)))}</g>'

    def _length(self, name: str) -> str:
        return coordinate(self.values[name] * self.scale if name else 0.0)

    def _bar(self, name: str) -> str:
        return f'<path class="f-link" d="M0 0H{self._length(name)}"/>' if name else ""

    def _end(self) -> str:
        rod = self.machine.rod
        mark = f'<circle class="f-hid" r="{self._length(rod)}"/>{PIN}' if rod else FORK
        return f'<g transform="translate({self._length(self.machine.tip)} 0)">{mark}</g>'
