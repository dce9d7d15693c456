"""Mobility of a drawn mechanism: what the formula counts, what really moves, and the passive constraints between them.

Lengths in metres; a drawn position is enough, no dimensions are named. Link "0" is the frame (domain STR-2..6).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from math import atan2, hypot, pi, sqrt
from typing import Any, TypeAlias

from mechanics import planar
from mechanics.checks import finite
from mechanics.freedom import Closure, Freedom, freedom
from mechanics.structure import CLASSES, FRAME, Pair, count_loops, expanded, planar_mobility, spatial_mobility

Point: TypeAlias = tuple[float, ...]
PLANAR = {"R": 5, "P": 5, "H": 4}  # H: higher pair
MADE: dict[str, Callable[[planar.Marker, planar.Marker], planar.Joint]] = {
    "R": planar.Revolute,
    "P": planar.Prismatic,
    "H": planar.Contact,
}
DIFFERENCE = 1e-6  # of the size, for slopes in space


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


def _size(joints: Sequence[Joint]) -> float:
    places = [joint.at for joint in joints if joint.at is not None]
    spans = [max(axis) - min(axis) for axis in zip(*places, strict=True)]
    return max(spans, default=0.0) or 1.0


def _plane_closure(links: Sequence[str], joints: Sequence[Joint]) -> Closure:
    """Write the constraints with the joints of `mechanics.planar`, lengths over the size of the mechanism."""
    import numpy as np

    numbers = {link: number for number, link in enumerate([FRAME, *(link for link in links if link != FRAME)])}
    size, coordinates = _size(joints), 3 * (len(links) - 1)
    made = [one for joint in joints for one in _plane_joints(joint, numbers, size)]

    def closure(at: Any) -> tuple[Any, Any]:
        poses = [planar.FRAME, *(tuple(at[i : i + 3]) for i in range(0, coordinates, 3))]
        rows = [row for one in made for row in one.rows(poses, [planar.FRAME] * len(poses))]
        slopes = np.zeros((len(rows), coordinates))
        for number, row in enumerate(rows):
            for coordinate, slope in row.slopes.items():
                slopes[number, coordinate] = slope
        return np.array([row.residual for row in rows]), slopes

    return closure


def _plane_joints(joint: Joint, numbers: dict[str, int], size: float) -> list[planar.Joint]:
    x, y = (value / size for value in joint.at or (0.0, 0.0))
    angle = atan2(joint.direction[1], joint.direction[0]) if joint.direction else 0.0
    markers = [planar.Marker(numbers[link], x, y, angle) for link in joint.links]
    return [MADE[joint.kind](markers[0], other) for other in markers[1:]]


def _space_closure(links: Sequence[str], joints: Sequence[Joint]) -> Closure:
    """Write the gaps of all pairs for bodies displaced by (translation, rotation vector); slopes by differences."""
    import numpy as np

    numbers = {link: number for number, link in enumerate([FRAME, *(link for link in links if link != FRAME)])}
    size, coordinates = _size(joints), 6 * (len(links) - 1)

    def gaps(at: Any) -> Any:
        bodies = [_displaced(np.zeros(6)), *(_displaced(at[i : i + 6]) for i in range(0, coordinates, 6))]
        found = [
            gap
            for joint in joints
            for other in joint.links[1:]
            for gap in _gaps(joint, size, bodies[numbers[joint.links[0]]], bodies[numbers[other]])
        ]
        return np.array(found)

    def closure(at: Any) -> tuple[Any, Any]:
        steps = np.eye(coordinates) * DIFFERENCE
        columns = [(gaps(at + step) - gaps(at - step)) / (2 * DIFFERENCE) for step in steps]
        return gaps(at), np.array(columns).T

    return closure


def _displaced(twist: Any) -> tuple[Any, Any]:
    """Give translation and rotation matrix of a body (Rodrigues)."""
    import numpy as np

    x, y, z = twist[3:]
    angle = sqrt(x * x + y * y + z * z)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    if angle < 1e-9:
        return twist[:3], np.eye(3) + cross
    return twist[:3], np.eye(3) + np.sin(angle) / angle * cross + (1 - np.cos(angle)) / angle**2 * cross @ cross


def _gaps(joint: Joint, size: float, one: tuple[Any, Any], other: tuple[Any, Any]) -> list[float]:
    """Give the gaps of one pair: as many as its class."""
    import numpy as np

    (ta, ra), (tb, rb) = one, other
    place = np.array(joint.at) / size
    u = np.array(joint.direction or (0.0, 0.0, 1.0), float)
    u /= np.linalg.norm(u)
    e = np.cross(u, np.eye(3)[int(np.argmin(np.abs(u)))])
    e /= np.linalg.norm(e)
    f = np.cross(u, e)
    shift = tb + rb @ place - ta - ra @ place
    across = [ra @ e @ shift, ra @ f @ shift]
    tilt = [ra @ e @ (rb @ u), ra @ f @ (rb @ u)]
    match joint.kind:
        case "R":
            return [*shift, *tilt]
        case "P":
            return [*across, *tilt, ra @ e @ (rb @ f)]
        case "C":
            return [*across, *tilt]
        case "H":
            turn = atan2(ra @ f @ (rb @ e), ra @ e @ (rb @ e))
            return [*across, *tilt, ra @ u @ shift - joint.pitch / size * turn / (2 * pi)]
        case "U":
            second = np.array(joint.second, float) if joint.second else e
            return [*shift, ra @ u @ (rb @ second) / float(np.linalg.norm(second))]
        case "S":
            return [*shift]
        case "E":
            return [ra @ u @ shift, *tilt]
        case "L":
            return [ra @ u @ shift, ra @ u @ (rb @ e)]
        case _:  # "B": a ball stays in the tangent plane of the other body
            return [ra @ u @ shift]
