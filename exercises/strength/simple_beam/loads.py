"""Supports and loads of a beam, each with its own lines of the solution.

Places from the left end; loads positive in the sense of their class, reactions up, sagging moment positive, deflection
up. `{x}` is the place at which a line is taken; brackets <u>^n are Macaulay's (domain SM-11, SM-14).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from exercises.exercise import given
from mechanics import members
from mechanics.section import Rectangle

if TYPE_CHECKING:
    from exercises.strength.simple_beam import Givens


@dataclass(frozen=True, slots=True)
class LeftEnd:
    """Support A under the left end."""

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

    place = "s{i}"
    moment = "R_A*macaulay({x} - s{i}; 1)"
    sag = "R_A*macaulay({x} - s{i}; 3)/6"

    def at(self, length: float) -> float:
        """Give the place on a beam of this length, m."""
        return self.s


@dataclass(frozen=True, slots=True)
class RightEnd:
    """Support B under the right end: nothing is cut off behind it."""

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

    place = "s{i}"
    moment = "R_B*macaulay({x} - s{i}; 1)"
    sag = "R_B*macaulay({x} - s{i}; 3)/6"

    def at(self, length: float) -> float:
        """Give the place on a beam of this length, m."""
        return self.s


@dataclass(frozen=True, slots=True)
class Force:
    """A force downwards."""

    F: float = given(1e3, 20e3)  # N
    a: float = given(0.2, 7)  # its place, m

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
    a: float = given(0.2, 7)  # its place, m

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
    a: float = given(0.2, 5)  # its start, m
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
    a: float = given(0.2, 7)  # its place, m

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
    a: float = given(0.2, 7)  # its place, m

    total = ""
    turn = "M{i}"
    moment = "-M{i}*macaulay({x} - a{i}; 0)"
    sag = "-M{i}*macaulay({x} - a{i}; 2)/2"

    def load(self) -> members.Load:
        """Give the same load to the solvers."""
        return members.Moment(self.a, self.M)


Support: TypeAlias = LeftEnd | InsetA | RightEnd | InsetB
Load: TypeAlias = Force | Lift | Uniform | Clockwise | Counterclockwise
Couple: TypeAlias = Clockwise | Counterclockwise
OPPOSITE: Mapping[type[Load], str] = {Clockwise: Counterclockwise.turn, Counterclockwise: Clockwise.turn}


def places(givens: Givens) -> list[float]:
    """Give the places of A and B in metres."""
    return [support.at(givens.L) for support in givens.supports]


def structure(givens: Givens) -> members.Beam:
    """Give the same beam to the solvers."""
    A, B = places(givens)
    return members.Beam(
        L=givens.L,
        E=givens.E,
        supports=(members.Support(A, "pin"), members.Support(B, "roller")),
        loads=tuple(load.load() for load in givens.loads),
        section=Rectangle(givens.b, givens.h),
    )
