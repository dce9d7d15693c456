"""Lines of the solution of a shaft, from its free end to the wall, and the slips made in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import pi
from typing import TYPE_CHECKING

from exercises.exercise import Steps, each
from exercises.strength.stepped_shaft.parts import Torque, Tube

if TYPE_CHECKING:
    from exercises.strength.stepped_shaft import Givens

WIDE = 0.6  # a bore of this part of the diameter takes an eighth of J


def order(givens: Givens) -> Sequence[int]:
    """Give the numbers of the segments from the free end to the wall."""
    numbers = range(1, len(givens.segments) + 1)
    return numbers[::-1] if givens.wall == "left" else numbers


def acting(givens: Givens) -> list[str]:
    """Write the torques as they enter T: the sum of those to the right of a section, less those to the left."""
    return each(givens.torques, lambda torque: torque.about_x if givens.wall == "left" else torque.against_x)


def summed(givens: Givens, terms: Sequence[str]) -> Steps:
    """Write T of each segment: that of the segment before it and the torque between them."""
    found: dict[str, str] = {}
    before = ""
    for number in order(givens):
        term = terms[number - 1]
        found[f"T{number}"] = f"{before} + {term}".replace("+ -", "- ") if before else term
        before = f"T{number}"
    return found


def per_segment(givens: Givens, name: str, line: Callable[..., str]) -> Steps:
    """Write one line a segment, named by its number."""
    return {f"{name}{i}": text for i, text in enumerate(each(givens.segments, line), 1)}


def largest(givens: Givens, line: str) -> str:
    """Write the largest of one line taken in all segments."""
    return f"max({'; '.join(each(givens.segments, lambda _: line))})"


def twist(givens: Givens, torque: str = "T{i}") -> str:
    """Write the rotation of the free end; a shaft held on its right turns against the sum."""
    found = " + ".join(each(givens.segments, lambda _: torque + "*l{i}/(G*J{i})"))
    return found if givens.wall == "left" else f"-({found})"


def inner_torques(torques: Sequence[Torque], wall: str) -> list[float]:
    """Give T of each segment in N m."""
    values = [torque.value for torque in torques]
    if wall == "left":
        return [sum(values[i:]) for i in range(len(values))]
    return [-sum(values[: i + 1]) for i in range(len(values))]


def stress(T: float, outer: float, bore: float) -> float:
    """Give the largest shear stress of a round section, in the unit of T over that of the diameters cubed."""
    return 16 * abs(T) / (pi * outer**3 * (1 - (bore / outer) ** 4))


def moduli(givens: Givens, change: Callable[[str], str]) -> Steps:
    """A slip in J and W of every segment."""
    return {
        **per_segment(givens, "J", lambda segment: change(segment.J)),
        **per_segment(givens, "W", lambda segment: change(segment.W)),
    }


def by_radius(line: str) -> str:
    """The radius in the place of the diameter."""
    return line.replace("D{i}", "(D{i}/2)").replace("d{i}", "(d{i}/2)")


def read_as_inner(givens: Givens) -> Steps:
    """The torque at the end of a segment taken for T in it."""
    return {f"T{i}": term for i, term in enumerate(acting(givens), 1)}


def unsigned_torques(givens: Givens) -> Steps:
    """All torques added, whatever their sense."""
    return summed(givens, each(givens.torques, lambda _: "M{i}"))


def difference(givens: Givens) -> Steps:
    """W of a tube as a difference of two W; it is seen only where a tube decides."""
    parts = [segment.part() for segment in givens.segments]
    found = inner_torques(givens.torques, givens.wall)
    stresses = [stress(T, part.D, part.d) for T, part in zip(found, parts, strict=True)]
    decides = givens.segments[stresses.index(max(stresses))]
    return per_segment(givens, "W", lambda segment: segment.W_difference) if isinstance(decides, Tube) else {}


def bores_ignored(givens: Givens) -> Steps:
    """Tubes taken as solid; it is seen where a bore is wide enough to matter."""
    parts = [segment.part() for segment in givens.segments]
    if not any(part.d > WIDE * part.D for part in parts):
        return {}
    names = [f"D{i}" if isinstance(one, Tube) else f"d{i}" for i, one in enumerate(givens.segments, 1)]
    return {
        **{f"J{i}": f"pi*{name}^4/32" for i, name in enumerate(names, 1)},
        **{f"W{i}": f"pi*{name}^3/16" for i, name in enumerate(names, 1)},
    }


def unsigned_twist(givens: Givens) -> Steps:
    """All twists added; no occasion where all T have one sign."""
    found = inner_torques(givens.torques, givens.wall)
    return {"phi": twist(givens, "abs(T{i})")} if min(found) < 0 < max(found) else {}


def largest_load(givens: Givens) -> Steps:
    """The largest external torque for the largest T; no occasion where they are equal."""
    loads = [torque.M for torque in givens.torques]
    inner = max(map(abs, inner_torques(givens.torques, givens.wall)))
    return {"T_max": largest(givens, "M{i}")} if abs(max(loads) - inner) > 0.04 * inner else {}
