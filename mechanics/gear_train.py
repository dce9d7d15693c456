"""Gear trains as an exact system of linear equations (domain TR-1 to TR-6).

Angular velocities in rad/s about one axis direction, counter-clockwise positive. A mesh gives
(omega_a - omega_H) z_a = -(omega_b - omega_H) z_b when external, the same with + when internal.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain
from math import isfinite, pi
from typing import Literal, get_args

from mechanics import linear
from mechanics.checks import positive
from mechanics.errors import TrainError

MeshType = Literal["external", "internal"]
Hand = Literal["right", "left"]
Equation = tuple[str, list[int]]


def _check_count(name: str, value: int) -> None:
    if not isinstance(value, int) or value < 1:
        raise ValueError(f"{name} = {value} must be a whole positive number")


@dataclass(frozen=True, slots=True)
class Mesh:
    a: str
    b: str
    za: int  # teeth
    zb: int
    type: MeshType = "external"
    carrier: str | None = None  # None: both axes are fixed

    def __post_init__(self) -> None:
        if self.type not in get_args(MeshType):
            raise ValueError(f"mesh type {self.type!r} of {self.a} and {self.b} must be external or internal")
        _check_count(f"za of the mesh {self.a}-{self.b}", self.za)
        _check_count(f"zb of the mesh {self.a}-{self.b}", self.zb)
        if len({self.a, self.b, self.carrier}) < 3:
            raise ValueError(f"the mesh {self.a}-{self.b} on {self.carrier} names a member twice")


@dataclass(frozen=True, slots=True)
class Differential:
    """A symmetric bevel differential: omega_left + omega_right = 2 omega_carrier."""

    left: str
    right: str
    carrier: str

    def __post_init__(self) -> None:
        if len({self.left, self.right, self.carrier}) < 3:
            raise ValueError(f"the differential {self.left}-{self.right} on {self.carrier} names a member twice")


@dataclass(frozen=True, slots=True)
class Rack:
    pinion_on: str
    pinion_z: int
    module_mm: float  # mm

    def __post_init__(self) -> None:
        _check_count("pinion_z", self.pinion_z)
        positive("module_mm", self.module_mm, "mm")


@dataclass(frozen=True, slots=True)
class Screw:
    on: str
    pitch: float  # m
    starts: int = 1
    hand: Hand = "right"

    def __post_init__(self) -> None:
        positive("pitch", self.pitch, "m")
        _check_count("starts", self.starts)
        if self.hand not in get_args(Hand):
            raise ValueError(f"hand {self.hand!r} must be right or left")


@dataclass(frozen=True, slots=True)
class Worm:
    on: str
    worm_starts: int
    wheel_z: int

    def __post_init__(self) -> None:
        _check_count("worm_starts", self.worm_starts)
        _check_count("wheel_z", self.wheel_z)


@dataclass(frozen=True, slots=True)
class Train:
    """Members, what couples them, which stand still, which are driven (rad/s), and the member asked for.

    A stage may close the train; the output may then be "rack", "nut" or "wheel".
    """

    members: tuple[str, ...]
    meshes: tuple[Mesh, ...] = ()
    fixed: tuple[str, ...] = ()
    input_omega: Mapping[str, float] = field(default_factory=dict)
    output: str | None = None
    differentials: tuple[Differential, ...] = ()
    rack: Rack | None = None
    screw: Screw | None = None
    worm: Worm | None = None

    def __post_init__(self) -> None:
        known = set(self.members)
        if len(known) < len(self.members):
            raise ValueError(f"members {', '.join(self.members)} name one twice")
        for end in known & self._ends().keys():
            raise ValueError(f"{end} is both a member and what a stage moves")
        for place, name in self._named():
            if name not in known:
                raise ValueError(f"{place} names {name}, which is not a member")
        for name, value in self.input_omega.items():
            if not isfinite(value):
                raise ValueError(f"input_omega of {name} = {value} rad/s must be finite")

    def _named(self) -> Iterator[tuple[str, str]]:
        for mesh in self.meshes:
            on = (mesh.a, mesh.b) if mesh.carrier is None else (mesh.a, mesh.b, mesh.carrier)
            yield from ((f"the mesh {mesh.a}-{mesh.b}", name) for name in on)
        for joint in self.differentials:
            on = (joint.left, joint.right, joint.carrier)
            yield from ((f"the differential {joint.left}-{joint.right}", name) for name in on)
        yield from (("fixed", name) for name in self.fixed)
        yield from (("input_omega", name) for name in self.input_omega)
        ends = self._ends()
        yield from ((f"the stage of the {end}", name) for end, name in ends.items())
        if self.output is not None and self.output not in ends:
            yield "output", self.output

    def _ends(self) -> dict[str, str]:
        """What the stages move, and the member that moves it."""
        on = {
            "rack": self.rack.pinion_on if self.rack else None,
            "nut": self.screw.on if self.screw else None,
            "wheel": self.worm.on if self.worm else None,
        }
        return {end: member for end, member in on.items() if member is not None}


@dataclass(frozen=True, slots=True)
class Ratio:
    of: str  # "omega_1/omega_H"
    exact: Fraction

    @property
    def value(self) -> float:
        return float(self.exact)


@dataclass(frozen=True, slots=True)
class Speeds:
    omega_exact: Mapping[str, Fraction]  # rad/s, every member
    ratio: Ratio | None  # first non-zero input to output; None where either stands still or the output slides
    v: float | None = None  # of the rack or nut asked for, m/s

    @property
    def omega(self) -> dict[str, float]:
        return {member: float(speed) for member, speed in self.omega_exact.items()}


def solve(train: Train) -> Speeds:
    """Solve the angular velocities of all members exactly, and what was asked of the output.

    Args:
        train: Members, meshes, differentials, fixed members, inputs, output and stages. An input in floats is taken
            as the decimal it prints as.

    Returns:
        Angular velocities as fractions (rad/s); the ratio of the first input that is not zero to the output (its
        modulus for a worm wheel); the speed of a rack or nut.

    Raises:
        TrainError: Conditions contradict one another, or leave members undetermined; the message names them.

    Source:
        Domain TR-1 to TR-6; Willis's equation for each mesh.
    """
    column = {member: i for i, member in enumerate(train.members)}
    basis: dict[int, list[int]] = {}
    for name, equation in chain(_couplings(train, column), _inputs(train, column)):
        if not linear.extend(basis, equation):
            raise TrainError(f"{name} contradicts the meshes, fixed members and inputs before it")
    found = {member: linear.determined(basis, i) for member, i in column.items()}
    free = [member for member, speed in found.items() if speed is None]
    if free:
        raise TrainError(f"the motion of {', '.join(free)} is not determined: too few fixed members or inputs")
    omega = {member: speed for member, speed in found.items() if speed is not None}
    return Speeds(omega, _ratio(train, omega), _slide(train, omega))


def _couplings(train: Train, column: Mapping[str, int]) -> Iterator[Equation]:
    for mesh in train.meshes:
        equation = [0] * (len(column) + 1)
        driven = -mesh.zb if mesh.type == "internal" else mesh.zb
        equation[column[mesh.a]] = mesh.za
        equation[column[mesh.b]] = driven
        if mesh.carrier is not None:
            equation[column[mesh.carrier]] = -mesh.za - driven
        yield f"the mesh {mesh.a}-{mesh.b}", equation
    for joint in train.differentials:
        equation = [0] * (len(column) + 1)
        equation[column[joint.left]] = equation[column[joint.right]] = 1
        equation[column[joint.carrier]] = -2
        yield f"the differential {joint.left}-{joint.right}", equation


def _inputs(train: Train, column: Mapping[str, int]) -> Iterator[Equation]:
    for member in train.fixed:
        yield f"fixed {member}", _speed_equation(column, member, Fraction(0))
    for member, speed in train.input_omega.items():
        yield f"the input omega of {member} = {speed:g} rad/s", _speed_equation(column, member, _exact(speed))


def _speed_equation(column: Mapping[str, int], member: str, speed: Fraction) -> list[int]:
    equation = [0] * (len(column) + 1)
    equation[column[member]] = speed.denominator
    equation[-1] = speed.numerator
    return equation


def _exact(value: float) -> Fraction:
    return Fraction(int(value)) if value == int(value) else Fraction(repr(value))


def _ratio(train: Train, omega: Mapping[str, Fraction]) -> Ratio | None:
    first = next((member for member, speed in train.input_omega.items() if speed), None)
    of = f"omega_{first}/omega_{train.output}"
    if first is None or train.output is None:
        return None
    if train.worm is not None and train.output == "wheel":
        worm = train.worm
        turns = abs(omega[worm.on]) * worm.worm_starts / worm.wheel_z
        return Ratio(of, abs(omega[first]) / turns) if turns else None
    speed = omega.get(train.output)
    return Ratio(of, omega[first] / speed) if speed else None


def _slide(train: Train, omega: Mapping[str, Fraction]) -> float | None:
    if train.rack is not None and train.output == "rack":
        radius = train.rack.module_mm * train.rack.pinion_z / 2000  # m
        return float(omega[train.rack.pinion_on]) * radius
    if train.screw is not None and train.output == "nut":
        lead = train.screw.pitch * train.screw.starts
        return (-lead if train.screw.hand == "right" else lead) * float(omega[train.screw.on]) / (2 * pi)
    return None
