"""Mobility of a drawn mechanism: what the formula counts, what really moves, and the passive constraints between them.

Lengths in metres; a drawn position is enough, no dimensions are named. Link "0" is the frame (domain STR-2..6).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from math import atan2, hypot
from typing import Any, TypeAlias

from mechanics import planar, spatial
from mechanics.checks import finite
from mechanics.freedom import Closure, Freedom, free_directions, freedom
from mechanics.structure import CLASSES, FRAME, Pair, count_loops, expanded, planar_mobility, spatial_mobility
from mechanics.vectors import Vector

Point: TypeAlias = tuple[float, ...]
PLANAR = {"R": 5, "P": 5, "H": 4}  # H: higher pair
MADE: dict[str, Callable[[planar.Marker, planar.Marker], planar.Joint]] = {
    "R": planar.Revolute,
    "P": planar.Prismatic,
    "H": planar.Contact,
}


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint as drawn.

    Attributes:
        kind: Letter of the pair: R, P, H in the plane (H a higher pair); a key of `structure.CLASSES` in space.
        links: The links that meet; m of them make m - 1 pairs.
        at: Its place, m; for a higher pair the point of contact. None where no pose is given.
        direction: Guide (P), common normal (H), axis (space). A revolute joint in the plane needs none.
        second: Second axis of a universal joint, on the other links.
        pitch: Advance of a screw in one turn, m.
    """

    kind: str
    links: tuple[str, ...]
    at: Point | None = None
    direction: Point | None = None
    second: Point | None = None
    pitch: float = 0.0


@dataclass(frozen=True, slots=True)
class Mobility:
    """Counts of a mechanism; the last three are None where a joint has no place."""

    moving: int
    classes: dict[int, int]
    formula: int
    loops: int
    instantaneous: int | None = None
    true: int | None = None
    rank: int | None = field(default=None, repr=False)

    @property
    def passive(self) -> int | None:
        """Give the number of passive constraints: true mobility less the formula's."""
        return None if self.true is None else self.true - self.formula


def plane(links: Sequence[str], joints: Sequence[Joint]) -> Mobility:
    """Count the mobility of a planar mechanism and move it.

    Args:
        links: All links, the frame "0" among them.
        joints: Joints of kind R, P or H between them.

    Raises:
        ValueError: An unknown link or kind, a joint of fewer than two links, a missing frame, a direction that is
            missing or zero, or a number that is not finite.
    """
    pairs = _pairs(links, joints, PLANAR)
    classes = dict(Counter(pair.klass for pair in pairs))
    formula = planar_mobility(len(links) - 1, classes.get(5, 0), classes.get(4, 0))
    found = _freedom(joints, lambda: (_plane_closure(links, joints), 3 * (len(links) - 1)))
    return Mobility(len(links) - 1, classes, formula, count_loops(pairs), *found)


def space(links: Sequence[str], joints: Sequence[Joint]) -> Mobility:
    """Count the mobility of a spatial mechanism and, where axes are given, move it; arguments as for `plane`."""
    pairs = _pairs(links, joints, CLASSES)
    classes = dict(Counter(pair.klass for pair in pairs))
    formula = spatial_mobility(len(links) - 1, classes)
    found = _freedom(joints, lambda: (_space_closure(links, joints), 6 * (len(links) - 1)))
    return Mobility(len(links) - 1, classes, formula, count_loops(pairs), *found)


def local_freedoms(links: Sequence[str], joints: Sequence[Joint], in_space: bool = False) -> dict[str, int]:
    """Find links that move on their own and move nothing else: a roller about its pin, a coupler between two spheres.

    Args:
        links: All links, the frame "0" among them.
        joints: Their joints, each with its place.
        in_space: Whether the joints are those of `space` instead of `plane`.

    Returns:
        The number of local freedoms by link, for links in two joints or more that have any.

    Raises:
        ValueError: As for `plane`, or a joint has no place.

    Source:
        Domain STR-2 (spin of a coupler), STR-4 (roller): subtract them from the mobility to get the useful one.
    """
    import numpy as np

    _pairs(links, joints, CLASSES if in_space else PLANAR)
    for number, joint in enumerate(joints, 1):
        if joint.at is None:
            raise ValueError(f"joint {number}: local freedoms need the place of every joint")
    size = 6 if in_space else 3
    closure = (_space_closure if in_space else _plane_closure)(links, joints)
    slopes = closure(np.zeros(size * (len(links) - 1)))[1]
    found = {}
    for number, link in enumerate(link for link in links if link != FRAME):
        if sum(link in joint.links for joint in joints) >= 2:
            found[link] = free_directions(slopes[:, size * number : size * (number + 1)], size).shape[0]
    return {link: count for link, count in found.items() if count}


def _freedom(joints: Sequence[Joint], model: Any) -> tuple[int | None, int | None, int | None]:
    if any(joint.at is None for joint in joints):
        return None, None, None
    closure, coordinates = model()
    found: Freedom = freedom(closure, coordinates)
    return found.instantaneous, found.true, found.rank


def _pairs(links: Sequence[str], joints: Sequence[Joint], kinds: dict[str, int]) -> list[Pair]:
    if FRAME not in links:
        raise ValueError(f'the frame "{FRAME}" is not among the links {", ".join(links)}')
    if len(set(links)) != len(links):
        raise ValueError("a link is named twice")
    pairs: list[Pair] = []
    for number, joint in enumerate(joints, 1):
        if joint.kind not in kinds:
            raise ValueError(f"joint {number}: kind {joint.kind!r} is none of {', '.join(kinds)}")
        for link in joint.links:
            if link not in links:
                raise ValueError(f"joint {number}: {link!r} is no link of the mechanism")
        pairs += expanded(joint.links, kinds[joint.kind])
        _check_place(number, joint, 2 if kinds is PLANAR else 3)
    joined = {link for joint in joints for link in joint.links}
    for link in links:
        if link not in joined and len(links) > 1:
            raise ValueError(f"link {link!r} is in no joint")
    return pairs


def _check_place(number: int, joint: Joint, size: int) -> None:
    for name, values in (("at", joint.at), ("dir", joint.direction), ("dir2", joint.second)):
        if values is not None and len(values) != size:
            raise ValueError(f"joint {number}: {name} needs {size} numbers, not {len(values)}")
        for value in values or ():
            finite(f"joint {number}: {name}", value, "m")
    finite(f"joint {number}: pitch", joint.pitch, "m")
    needed = joint.kind in "PH" if size == 2 else joint.kind not in "SB"
    if joint.at is not None and needed and not hypot(*(joint.direction or (0.0,))):
        raise ValueError(f"joint {number}: a pair of kind {joint.kind} needs a direction that is not zero")


def _to_scale(joints: Sequence[Joint]) -> list[Joint]:
    """Measure places from the middle of the mechanism in parts of its size: ranks must not hang on where it stands."""
    axes = list(zip(*(joint.at or () for joint in joints), strict=True))
    middle = [(min(axis) + max(axis)) / 2 for axis in axes]
    size = max((max(axis) - min(axis) for axis in axes), default=0.0) or 1.0

    def placed(joint: Joint) -> Joint:
        at = tuple((x - centre) / size for x, centre in zip(joint.at or (), middle, strict=True))
        return replace(joint, at=at, pitch=joint.pitch / size)

    return [placed(joint) for joint in joints]


def _plane_closure(links: Sequence[str], joints: Sequence[Joint]) -> Closure:
    """Write the constraints with the joints of `mechanics.planar`, to scale."""
    import numpy as np

    numbers = {link: number for number, link in enumerate([FRAME, *(link for link in links if link != FRAME)])}
    coordinates = 3 * (len(links) - 1)
    made = [one for joint in _to_scale(joints) for one in _plane_joints(joint, numbers)]

    def closure(at: Any) -> tuple[Any, Any]:
        poses = [planar.FRAME, *(tuple(at[i : i + 3]) for i in range(0, coordinates, 3))]
        rows = [row for one in made for row in one.rows(poses, [planar.FRAME] * len(poses))]
        slopes = np.zeros((len(rows), coordinates))
        for number, row in enumerate(rows):
            for coordinate, slope in row.slopes.items():
                slopes[number, coordinate] = slope
        return np.array([row.residual for row in rows]), slopes

    return closure


def _plane_joints(joint: Joint, numbers: dict[str, int]) -> list[planar.Joint]:
    x, y = joint.at or (0.0, 0.0)
    angle = atan2(joint.direction[1], joint.direction[0]) if joint.direction else 0.0
    markers = [planar.Marker(numbers[link], x, y, angle) for link in joint.links]
    return [MADE[joint.kind](markers[0], other) for other in markers[1:]]


def _space_closure(links: Sequence[str], joints: Sequence[Joint]) -> Closure:
    """Write the constraints with the pairs of `mechanics.spatial`, to scale."""
    numbers = {link: number for number, link in enumerate([FRAME, *(link for link in links if link != FRAME)])}
    pairs = [
        spatial.spatial_pair(
            joint.kind,
            (numbers[joint.links[0]], numbers[other]),
            _vector(joint.at) or (0.0, 0.0, 0.0),
            _vector(joint.direction),
            _vector(joint.second),
            joint.pitch,
        )
        for joint in _to_scale(joints)
        for other in joint.links[1:]
    ]
    return lambda at: spatial.closure(pairs, len(links) - 1, at)


def _vector(values: Point | None) -> Vector | None:
    if values is None:
        return None
    x, y, z = values
    return x, y, z
