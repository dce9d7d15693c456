"""The wheels of a train in the order of the flow of power; a mesh owns its lines (domain TR-3, TR-4)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

from exercises.exercise import each, given, option

Kind: TypeAlias = Literal["external", "internal"]


@dataclass(frozen=True, slots=True)
class Lines:
    """What a mesh of the wheels i-1 and i adds to the solution."""

    ratio: str
    inverse: str
    distance: str  # of the axes, in halves of the module
    size: str = "z{i}/z{i-1}"


LINES: Mapping[Kind, Lines] = {
    "external": Lines("(-z{i}/z{i-1})", "(-z{i-1}/z{i})", "z{i-1} + z{i}"),
    "internal": Lines("(z{i}/z{i-1})", "(z{i-1}/z{i})", "z{i} - z{i-1}"),
}


@dataclass(frozen=True, slots=True)
class Input:
    """The first wheel, on the input shaft."""

    z: int = given(12, 120, integer=True)  # teeth


@dataclass(frozen=True, slots=True)
class Coupled:
    """A wheel on the shaft of the wheel before it."""

    z: int = given(12, 120, integer=True)  # teeth


@dataclass(frozen=True, slots=True)
class Mesh:
    """A wheel in mesh with the wheel before it; the larger wheel of an internal mesh is the ring."""

    z: int = given(12, 120, integer=True)  # teeth
    type: Kind = option("external", "internal")


@dataclass(frozen=True, slots=True)
class Coaxial:
    """A wheel in mesh with the wheel before it, on the axis of the first one; its teeth are sought."""

    type: Kind = option("external", "internal")


Wheel: TypeAlias = Input | Coupled | Mesh | Coaxial


def kinds(wheels: Sequence[Wheel]) -> list[Kind]:
    """Give the kinds of the meshes in order."""
    return [wheel.type for wheel in wheels if isinstance(wheel, Mesh | Coaxial)]


def each_mesh(wheels: Sequence[Wheel], line: Callable[[Lines], str], kind: Kind | None = None) -> list[str]:
    """Write one line for each mesh; all meshes as of one kind, if it is named."""

    def text(wheel: Wheel) -> str:
        return line(LINES[kind or wheel.type]) if isinstance(wheel, Mesh | Coaxial) else ""

    return list(filter(None, each(wheels, text)))


def coaxial_line(wheels: Sequence[Wheel], last: Kind) -> dict[str, str]:
    """Write the sought teeth of a last mesh of this kind from equal distances of the axes; nothing if none are sought.

    Source:
        Domain TR-4: z1 + z2 = z3 + z4 (external), z1 + z2 = z4 - z3 (internal).
    """
    if not isinstance(wheels[-1], Coaxial):
        return {}
    first = each_mesh(wheels, lambda mesh: mesh.distance)[0]
    return {"z4": f"{first} {'-' if last == 'external' else '+'} z3"}
