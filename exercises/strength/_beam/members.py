"""Supports and loads of a beam, each with its own lines of the solution.

Places from the left end; loads positive in the sense of their class, reactions up, sagging moment positive, deflection
up. `{x}` is the place at which a line is taken; brackets <u>^n are Macaulay's (domain SM-11, SM-14).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, Protocol, TypeAlias

from exercises.exercise import Draw, given
from mechanics import members
from mechanics.section import Section


@dataclass(frozen=True, slots=True)
class LeftEnd:
    """Support A under the left end."""

    name: ClassVar[str] = "A"
    holds: ClassVar[members.SupportType] = "pin"
    place = "0"
    moment = "R_A*{x}"
    sag = "R_A*{x}^3/6"

    def at(self, length: float) -> float:
        """Give the place on a beam of this length, m."""
        return 0.0


@dataclass(frozen=True, slots=True)
class InsetA:
    """Support A with an overhang to the left of it."""

    s: float = given(0.5, 2.5)  # its place, m

    name: ClassVar[str] = "A"
    holds: ClassVar[members.SupportType] = "pin"
    place = "s{i}"
    moment = "R_A*macaulay({x} - s{i}; 1)"
    sag = "R_A*macaulay({x} - s{i}; 3)/6"

    def at(self, length: float) -> float:
        """Give the place on a beam of this length, m."""
        return self.s


@dataclass(frozen=True, slots=True)
class RightEnd:
    """Support B under the right end: nothing is cut off behind it."""

    name: ClassVar[str] = "B"
    holds: ClassVar[members.SupportType] = "roller"
    place = "L"
    moment = ""
    sag = ""

    def at(self, length: float) -> float:
        """Give the place on a beam of this length, m."""
        return length


@dataclass(frozen=True, slots=True)
class InsetB:
    """Support B with an overhang to the right of it."""

    s: float = given(2, 7)  # its place, m

    name: ClassVar[str] = "B"
    holds: ClassVar[members.SupportType] = "roller"
    place = "s{i}"
    moment = "R_B*macaulay({x} - s{i}; 1)"
    sag = "R_B*macaulay({x} - s{i}; 3)/6"

    def at(self, length: float) -> float:
        """Give the place on a beam of this length, m."""
        return self.s


@dataclass(frozen=True, slots=True)
class ClampedLeft:
    """A wall A at the left end; M_A is the bending moment beside it."""

    name: ClassVar[str] = "A"
    holds: ClassVar[members.SupportType] = "fixed"
    place = "0"
    moment = "R_A*{x} + M_A"
    sag = "R_A*{x}^3/6 + M_A*{x}^2/2"

    def at(self, length: float) -> float:
        """Give the place on a beam of this length, m."""
        return 0.0


@dataclass(frozen=True, slots=True)
class ClampedRight:
    """A wall B at the right end: nothing is cut off behind it."""

    name: ClassVar[str] = "B"
    holds: ClassVar[members.SupportType] = "fixed"
    place = "L"
    moment = ""
    sag = ""

    def at(self, length: float) -> float:
        """Give the place on a beam of this length, m."""
        return length


@dataclass(frozen=True, slots=True)
class Force:
    """A force downwards."""

    F: float = given(1e3, 20e3)  # N
    a: float = given(0, 7)  # its place, m

    total = "F{i}"
    turn = "F{i}*({x} - a{i})"
    moment = "-F{i}*macaulay({x} - a{i}; 1)"
    sag = "-F{i}*macaulay({x} - a{i}; 3)/6"

    def load(self) -> members.Load:
        """Give the same load to the solvers."""
        return members.Force(self.a, -self.F)


@dataclass(frozen=True, slots=True)
class Lift:
    """A force upwards."""

    F: float = given(1e3, 20e3)  # N
    a: float = given(0, 7)  # its place, m

    total = "-F{i}"
    turn = "-F{i}*({x} - a{i})"
    moment = "F{i}*macaulay({x} - a{i}; 1)"
    sag = "F{i}*macaulay({x} - a{i}; 3)/6"

    def load(self) -> members.Load:
        """Give the same load to the solvers."""
        return members.Force(self.a, self.F)


@dataclass(frozen=True, slots=True)
class Uniform:
    """A uniform load downwards on a part of the beam."""

    q: float = given(1e3, 12e3)  # N/m
    a: float = given(0, 5)  # its start, m
    c: float = given(0.5, 7)  # its end, m

    total = "q{i}*(c{i} - a{i})"
    turn = "q{i}*(c{i} - a{i})*({x} - (a{i} + c{i})/2)"
    moment = "-q{i}/2*(macaulay({x} - a{i}; 2) - macaulay({x} - c{i}; 2))"
    sag = "-q{i}/24*(macaulay({x} - a{i}; 4) - macaulay({x} - c{i}; 4))"

    def load(self) -> members.Load:
        """Give the same load to the solvers."""
        return members.Distributed(self.a, self.c, -self.q, -self.q)


@dataclass(frozen=True, slots=True)
class Clockwise:
    """A couple that turns clockwise: M jumps up behind it."""

    M: float = given(1e3, 20e3)  # N m
    a: float = given(0, 7)  # its place, m

    total = ""
    turn = "-M{i}"
    moment = "M{i}*macaulay({x} - a{i}; 0)"
    sag = "M{i}*macaulay({x} - a{i}; 2)/2"

    def load(self) -> members.Load:
        """Give the same load to the solvers."""
        return members.Moment(self.a, -self.M)


@dataclass(frozen=True, slots=True)
class Counterclockwise:
    """A couple that turns counter-clockwise: M jumps down behind it."""

    M: float = given(1e3, 20e3)  # N m
    a: float = given(0, 7)  # its place, m

    total = ""
    turn = "M{i}"
    moment = "-M{i}*macaulay({x} - a{i}; 0)"
    sag = "-M{i}*macaulay({x} - a{i}; 2)/2"

    def load(self) -> members.Load:
        """Give the same load to the solvers."""
        return members.Moment(self.a, self.M)


Support: TypeAlias = LeftEnd | InsetA | RightEnd | InsetB | ClampedLeft | ClampedRight
Load: TypeAlias = Force | Lift | Uniform | Clockwise | Counterclockwise
Couple: TypeAlias = Clockwise | Counterclockwise
OPPOSITE: Mapping[type[Load], str] = {Clockwise: Counterclockwise.turn, Counterclockwise: Clockwise.turn}


def drawn_loads(rng: Draw, at: list[float]) -> tuple[Load, ...]:
    """Draw a force, a uniform load and, four times of five, a third load; named from left to right.

    Takes four places in metres: of the force, of two ends of the uniform load and of the third load.
    """
    start, end = sorted(at[1:3])
    found: list[Load] = [
        Force(1e3 * rng.pick(range(2, 16)), at[0]),
        Uniform(1e3 * rng.pick(range(2, 11)), start, end),
    ]
    third = rng.pick((None, Force, Lift, Clockwise, Counterclockwise))
    if third:
        found.append(third(1e3 * rng.pick(range(2, 16)), at[3]))
    return tuple(sorted(found, key=lambda load: load.a))


class Loaded(Protocol):
    """The givens of a beam: what holds it and what it carries."""

    @property
    def supports(self) -> tuple[Support, ...]: ...
    @property
    def loads(self) -> tuple[Load, ...]: ...
    @property
    def L(self) -> float: ...


def places(givens: Loaded) -> list[float]:
    """Give the places of the supports in metres."""
    return [support.at(givens.L) for support in givens.supports]


def structure(
    givens: Loaded, E: float = 2e11, section: Section | None = None, second_moment: float | None = None
) -> members.Beam:
    """Give the same beam to the solvers; without a section its forces do not depend on the stiffness."""
    held = zip(givens.supports, places(givens), strict=True)
    return members.Beam(
        L=givens.L,
        E=E,
        supports=tuple(members.Support(x, support.holds) for support, x in held),
        loads=tuple(load.load() for load in givens.loads),
        section=section,
        I=second_moment if section or second_moment else 1e-5,
    )
