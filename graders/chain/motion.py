"""The true motion of a chain's links, handed to the judge as numbers, and how far a table agrees with it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import takewhile
from math import hypot

from graders.chain.frames import Convention, Frame, Row, Vector, axis_z, carried, frames, origin, seen_from

SAME = 1e-9  # of the scale of a position; of 1 in a rotation
Rows = Sequence[Row]


@dataclass(frozen=True, slots=True)
class Axis:
    """A joint axis in the base: a point of it, m, and its direction; of a slide only the direction counts."""

    point: Vector
    direction: Vector


@dataclass(frozen=True, slots=True)
class Motion:
    """What a table is judged against: poses of the links and joint axes at states of the chain, in base axes.

    Attributes:
        names: The symbols of the table, in the order of the numbers of a point.
        points: Values of the symbols at each state, rad and m; only the joint variables differ between states.
        links: For each state a frame fixed to each link 1 to n.
        axes: For each state the axis of each joint 1 to n.
        tool: Coordinates of the tool point in the last frame, as they are printed, m; None where the whole last frame
            is printed: then it is that of the last link in `links`.
        targets: For each state the true place of the tool point, m.
        table: A right table, as a student could type it.
    """

    names: tuple[str, ...]
    points: tuple[tuple[float, ...], ...]
    links: tuple[tuple[Frame, ...], ...]
    axes: tuple[tuple[Axis, ...], ...]
    tool: Vector | None
    targets: tuple[Vector, ...]
    table: str

    def first(self, count: int) -> Motion:
        """Give the same with fewer states."""
        cut = {name: getattr(self, name)[:count] for name in ("points", "links", "axes", "targets")}
        return replace(self, **cut)


@dataclass(frozen=True, slots=True)
class Agreement:
    """How far a table agrees: leading rows whose frames are fixed to their links on the joint axes, and the tool."""

    rows: int
    tool: bool


def agreement(table: Sequence[Rows], motion: Motion, joints: str, convention: Convention) -> Agreement:
    """Compare a table, given by its rows at each state, with the true motion.

    Args:
        table: Rows (theta, d, a, alpha) at each state of the motion.
        motion: The true motion.
        joints: Word over R and P.
        convention: Which elementary matrices make the frames.
    """
    scale = _scale(motion)
    agreed, first, tool = len(joints), list[Frame](), True
    for state, rows in enumerate(table):
        made = list(frames(rows[:agreed], convention))
        fixed = [seen_from(link, frame) for link, frame in zip(motion.links[state], made, strict=False)]
        first = first or fixed
        agreed = _leading(_same(a, b, scale) for a, b in zip(fixed, first, strict=False))
        if state == 0:
            agreed = min(agreed, _on_axes(made, motion.axes[0], joints, convention, scale))
        if not agreed:
            return Agreement(0, False)
        tool = tool and agreed == len(joints) and _keeps_tool(made[-1], motion, state, scale)
    return Agreement(agreed, tool)


def _leading(agree: Iterable[bool]) -> int:
    return sum(1 for _ in takewhile(bool, agree))


def _scale(motion: Motion) -> float:
    places = [p for links in motion.links for frame in links for p in origin(frame)]
    return max([1e-3, *map(abs, places), *(abs(p) for target in motion.targets for p in target)])


def _same(one: Frame, other: Frame, scale: float) -> bool:
    places = all(abs(a - b) <= SAME * scale for a, b in zip(origin(one), origin(other), strict=True))
    return places and all(abs(a - b) <= SAME for at, (a, b) in enumerate(zip(one, other, strict=True)) if at % 4 != 3)


def _on_axes(made: Sequence[Frame], axes: Sequence[Axis], joints: str, convention: Convention, scale: float) -> int:
    """Count the leading frames whose z stands on its joint axis: the next one in the standard convention."""
    ahead = 1 if convention == "standard" else 0
    for at, frame in enumerate(made):
        if at + ahead < len(joints) and not _on(frame, axes[at + ahead], joints[at + ahead] == "R", scale):
            return at
    return len(made)


def _on(frame: Frame, axis: Axis, turns: bool, scale: float) -> bool:
    if hypot(*_cross(axis_z(frame), axis.direction)) > SAME:
        return False
    x, y, z = (a - b for a, b in zip(origin(frame), axis.point, strict=True))
    return not turns or hypot(*_cross((x, y, z), axis.direction)) <= SAME * scale


def _keeps_tool(last: Frame, motion: Motion, state: int, scale: float) -> bool:
    if motion.tool is None:
        return _same(last, motion.links[state][-1], scale)
    place = carried(last, motion.tool)
    return all(abs(a - b) <= SAME * scale for a, b in zip(place, motion.targets[state], strict=True))


def _cross(u: Vector, w: Vector) -> Vector:
    return u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]
