"""The wheels of an epicyclic train in the order in which they mesh; each class owns its words (domain TR-5)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from exercises.exercise import given
from mechanics.willis import Stage


@dataclass(frozen=True, slots=True)
class Sun:
    """The first central wheel, external teeth."""

    z: int = given(12, 160, integer=True)  # teeth


@dataclass(frozen=True, slots=True)
class Planet:
    """A planet in mesh with the first central wheel."""

    z: int = given(12, 160, integer=True)  # teeth


@dataclass(frozen=True, slots=True)
class Block:
    """The second rim of the planet."""

    z: int = given(12, 160, integer=True)  # teeth


@dataclass(frozen=True, slots=True)
class Outer:
    """The last central wheel, external teeth."""

    z: int = given(12, 160, integer=True)  # teeth


@dataclass(frozen=True, slots=True)
class Ring:
    """The last central wheel, internal teeth."""

    z: int = given(12, 160, integer=True)  # teeth


Wheel: TypeAlias = Sun | Planet | Block | Outer | Ring


def stages(wheels: tuple[Wheel, ...]) -> tuple[Stage, Stage]:
    """Give the two meshes as seen from the carrier."""
    z = [wheel.z for wheel in wheels]
    return Stage(z[0], z[1]), Stage(z[-2], z[-1], "internal" if isinstance(wheels[-1], Ring) else "external")


def inversion(wheels: tuple[Wheel, ...]) -> str:
    """Write the ratio seen from the carrier, u0 = (omega_1 - omega_H)/(omega_n - omega_H)."""
    sign = "-" if isinstance(wheels[-1], Ring) else ""
    if len(wheels) == 3:
        return f"{sign}z3/z1"
    return f"{sign}(z2*z4)/(z1*z3)"
