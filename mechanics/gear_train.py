"""Gear trains, planetary ones too, as an exact system of linear equations (domain TR-1 to TR-6).

Angular velocities in rad/s about one axis direction, counter-clockwise positive. A mesh gives
(omega_a - omega_H) z_a = -(omega_b - omega_H) z_b when external, the same with + when internal.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain
from math import isfinite
from typing import get_args

from mechanics import linear
from mechanics.bevel_differential import Differential
from mechanics.checks import count
from mechanics.errors import TrainError, UndeterminedError
from mechanics.gear_pair import MeshType
from mechanics.rack import Rack
from mechanics.screw import Screw
from mechanics.worm import Worm

Equation = list[int]
REST = Fraction(0)


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
        count(f"za of the mesh {self.a}-{self.b}", self.za)
        count(f"zb of the mesh {self.a}-{self.b}", self.zb)
        if len({self.a, self.b, self.carrier}) < 3:
            on = "" if self.carrier is None else f" on {self.carrier}"
            raise ValueError(f"the mesh {self.a}-{self.b}{on} names a member twice")

    def terms(self) -> tuple[tuple[str, int], ...]:
        """Members and their multiples in Willis's equation of the mesh, whose sum is zero."""
        driven = -self.zb if self.type == "internal" else self.zb
        wheels = (self.a, self.za), (self.b, driven)
        return wheels if self.carrier is None else (*wheels, (self.carrier, -self.za - driven))


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
        TrainError: Conditions contradict one another; the message names the input that does.
        UndeterminedError: They leave members undetermined; the message names them.

    Source:
        Domain TR-1 to TR-6; Willis's equation for each mesh.
    """
    column = {member: i for i, member in enumerate(m for m in train.members if m not in train.fixed)}
    basis: dict[int, Equation] = {}
    for terms in chain((m.terms() for m in train.meshes), (d.terms() for d in train.differentials)):
        linear.extend(basis, _equation(terms, column))  # never contradicts: all members at rest meet them
    for member, speed in train.input_omega.items():
        value = _exact(speed)
        if not linear.extend(basis, _equation(((member, value.denominator),), column, value.numerator)):
            forced = linear.determined(basis, column[member]) if member in column else REST
            raise TrainError(
                f"the input omega of {member} = {speed:g} rad/s contradicts the meshes, fixed members and inputs "
                f"before it, which make it {forced} rad/s"
            )
    omega = _read(train, column, basis)
    return Speeds(omega, _ratio(train, omega), _slide(train, omega))


def _equation(terms: Iterable[tuple[str, int]], column: Mapping[str, int], right: int = 0) -> Equation:
    """Write a sum of multiples of angular velocities; those of fixed members are zero and have no column."""
    equation = [0] * len(column) + [right]
    for member, coefficient in terms:
        if member in column:
            equation[column[member]] += coefficient
    return equation


def _read(train: Train, column: Mapping[str, int], basis: dict[int, Equation]) -> dict[str, Fraction]:
    omega, free = {}, []
    for member in train.members:
        speed = linear.determined(basis, column[member]) if member in column else REST
        if speed is None:
            free.append(member)
        else:
            omega[member] = speed
    if free:
        missing = len(column) - len(basis)
        raise UndeterminedError(
            f"the motion of {', '.join(free)} is not determined: too few fixed members or inputs ({missing} missing)"
        )
    return omega


def _exact(value: float) -> Fraction:
    return Fraction(int(value)) if value == int(value) else Fraction(repr(value))


def _ratio(train: Train, omega: Mapping[str, Fraction]) -> Ratio | None:
    first = next((member for member, speed in train.input_omega.items() if speed), None)
    if first is None or train.output is None:
        return None
    of = f"omega_{first}/omega_{train.output}"
    if train.worm is not None and train.output == "wheel":
        turns = abs(omega[train.worm.on]) / train.worm.ratio
        return Ratio(of, abs(omega[first]) / turns) if turns else None
    speed = omega.get(train.output)
    return Ratio(of, omega[first] / speed) if speed else None


def _slide(train: Train, omega: Mapping[str, Fraction]) -> float | None:
    if train.rack is not None and train.output == "rack":
        return train.rack.speed(float(omega[train.rack.pinion_on]))
    if train.screw is not None and train.output == "nut":
        return train.screw.speed(float(omega[train.screw.on]))
    return None
