"""Beams and shafts as they are given: geometry, supports, loads (SI; domain SM-7, SM-11).

They hold no solution and no formula of one.

Axis x from the left end, y and v positive up. Forces positive up, moments positive counter-clockwise, torques positive
about +x. Both `beam` and `shaft` and their independent oracle `frame` read these.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal, get_args

from mechanics.checks import finite, place, positive
from mechanics.section import Ring, Section

SupportType = Literal["pin", "roller", "fixed"]
ShaftSupport = Literal["fixed_free", "free_fixed", "free_free", "fixed_fixed"]

# Supports closer than this part of the length count as one: their reactions would be all rounding.
CLOSE = 1e-6


@dataclass(frozen=True, slots=True)
class Support:
    """A point that holds the beam: pin and roller hold v, fixed holds v and the slope."""

    x: float  # place, m
    type: SupportType = "pin"
    settlement: float = 0.0  # imposed displacement, up, m

    def __post_init__(self) -> None:
        finite("support place x", self.x, "m")
        finite(f"settlement of the support at x = {self.x} m,", self.settlement, "m")
        if self.type not in get_args(SupportType):
            raise ValueError(f"support type {self.type!r} at x = {self.x} m must be pin, roller or fixed")


@dataclass(frozen=True, slots=True)
class Force:
    """A concentrated force."""

    x: float  # place, m
    F: float  # force, up, N

    def __post_init__(self) -> None:
        finite("force place x", self.x, "m")
        finite(f"force at x = {self.x} m, F", self.F, "N")


@dataclass(frozen=True, slots=True)
class Moment:
    """A concentrated couple."""

    x: float  # place, m
    M: float  # moment, counter-clockwise, N m

    def __post_init__(self) -> None:
        finite("moment place x", self.x, "m")
        finite(f"moment at x = {self.x} m, M", self.M, "N m")


@dataclass(frozen=True, slots=True)
class Distributed:
    """A load spread over a stretch, linear from one intensity to the other."""

    x1: float  # start, m
    x2: float  # end, m
    w1: float  # intensity at the start, up, N/m
    w2: float  # intensity at the end, up, N/m

    def __post_init__(self) -> None:
        finite("distributed load start x1", self.x1, "m")
        finite("distributed load end x2", self.x2, "m")
        finite(f"distributed load from x1 = {self.x1} m, w1", self.w1, "N/m")
        finite(f"distributed load from x1 = {self.x1} m, w2", self.w2, "N/m")
        if not self.x1 < self.x2:
            raise ValueError(f"distributed load from x1 = {self.x1} m must end to the right of it, not at {self.x2} m")


Load = Force | Moment | Distributed


@dataclass(frozen=True, slots=True)
class Beam:
    """A straight beam of constant section.

    Exactly one of `section` and `I` is given. A hinge lies inside the beam, not at a fixed support; a couple does not
    act at a hinge, since it would not be known on which side.

    Raises:
        ValueError: A value is not finite, not positive where it must be, out of its place or contradictory.
    """

    L: float  # length, m
    E: float  # Young's modulus, Pa
    supports: tuple[Support, ...]
    loads: tuple[Load, ...] = ()
    hinges: tuple[float, ...] = ()  # places, m
    section: Section | None = None
    I: float | None = None  # second moment of area, m^4
    second_moment: float = field(init=False)  # I as given or of the section, m^4

    def __post_init__(self) -> None:
        positive("length L", self.L, "m")
        positive("Young's modulus E", self.E, "Pa")
        if (self.section is None) == (self.I is None):
            raise ValueError("give either the section or the second moment of area I, one of the two")
        second_moment = self.section.second_moment if self.section else self.I or 0.0
        positive("second moment of area I", second_moment, "m^4")
        positive("bending stiffness E I", self.E * second_moment, "N m^2")
        object.__setattr__(self, "second_moment", second_moment)
        _check_supports(self)
        _check_hinges(self)
        for load in self.loads:
            _check_load(load, self)


def _check_supports(beam: Beam) -> None:
    places = sorted(support.x for support in beam.supports)
    for x in places:
        place("support", x, beam.L)
    for left, right in pairwise(places):
        if right - left < CLOSE * beam.L:
            raise ValueError(f"supports at x = {left} m and {right} m must be at least {CLOSE * beam.L:g} m apart")


def _check_hinges(beam: Beam) -> None:
    if not beam.hinges:
        return
    fixed = {support.x for support in beam.supports if support.type == "fixed"}
    for x in beam.hinges:
        if not 0 < x < beam.L:
            raise ValueError(f"hinge at x = {x} m must lie inside the beam, 0 .. {beam.L} m")
        if x in fixed:
            raise ValueError(f"hinge at x = {x} m is at a fixed support: it is not known which side is held")
    if len(set(beam.hinges)) < len(beam.hinges):
        raise ValueError(f"hinges at x = {sorted(beam.hinges)} m must be at different places")


def _check_load(load: Load, beam: Beam) -> None:
    if isinstance(load, Distributed):
        place("distributed load start", load.x1, beam.L)
        place("distributed load end", load.x2, beam.L)
        return
    place("load", load.x, beam.L)
    if isinstance(load, Moment) and load.x in beam.hinges:
        raise ValueError(f"moment {load.M} N m at x = {load.x} m acts at a hinge: it is not known on which side")


@dataclass(frozen=True, slots=True)
class Reaction:
    """What a support does to the beam."""

    x: float  # place, m
    Fy: float  # force, up, N
    M: float  # moment, counter-clockwise, N m; zero but at a fixed support


@dataclass(frozen=True, slots=True)
class Segment:
    """A cylindrical part of a stepped shaft."""

    L: float  # length, m
    D: float  # outer diameter, m
    d: float = 0.0  # bore, m

    def __post_init__(self) -> None:
        positive("segment length L", self.L, "m")
        Ring(self.D, self.d)


@dataclass(frozen=True, slots=True)
class Torque:
    """An external torque."""

    x: float  # place, m
    T: float  # torque, about +x, N m

    def __post_init__(self) -> None:
        finite("torque place x", self.x, "m")
        finite(f"torque at x = {self.x} m, T", self.T, "N m")


@dataclass(frozen=True, slots=True)
class Shaft:
    """A stepped shaft, its segments laid from the left end; a torque a rounding away from an end of one is at that end.

    Raises:
        ValueError: A value is not finite, not positive where it must be, out of its place or unknown.
    """

    G: float  # shear modulus, Pa
    segments: tuple[Segment, ...]
    torques: tuple[Torque, ...]
    support: ShaftSupport = "fixed_free"
    tau_allow: float | None = None  # allowable shear stress, Pa
    theta_allow_rad_per_m: float | None = None  # allowable twist, rad/m
    design_bore_ratio: float = 0.0  # bore over outer diameter of the shaft to design
    ends: tuple[float, ...] = field(init=False)  # where the segments end, m, in order, 0 first

    def __post_init__(self) -> None:
        positive("shear modulus G", self.G, "Pa")
        if self.support not in get_args(ShaftSupport):
            raise ValueError(f"shaft support {self.support!r} must be one of {', '.join(get_args(ShaftSupport))}")
        if not self.segments:
            raise ValueError("a shaft needs at least one segment")
        object.__setattr__(self, "ends", _ends(self.segments))
        object.__setattr__(self, "torques", tuple(_placed(torque, self.ends) for torque in self.torques))
        _check_limits(self)


def _ends(segments: tuple[Segment, ...]) -> tuple[float, ...]:
    ends = [0.0]
    for segment in segments:
        ends.append(ends[-1] + segment.L)
    positive("length of the shaft", ends[-1], "m")
    return tuple(ends)


def _placed(torque: Torque, ends: tuple[float, ...]) -> Torque:
    # The sum of printed lengths may miss a printed place by a rounding: 0.1 + 0.2 is not 0.3.
    end = min(ends, key=lambda end: abs(end - torque.x))
    if abs(end - torque.x) <= 1e-12 * ends[-1]:
        return Torque(end, torque.T)
    place("torque", torque.x, ends[-1])
    return torque


def _check_limits(shaft: Shaft) -> None:
    if shaft.tau_allow is not None:
        positive("allowable stress tau_allow", shaft.tau_allow, "Pa")
    if shaft.theta_allow_rad_per_m is not None:
        positive("allowable twist theta_allow_rad_per_m", shaft.theta_allow_rad_per_m, "rad/m")
    if not 0 <= shaft.design_bore_ratio < 1:
        raise ValueError(f"bore ratio design_bore_ratio = {shaft.design_bore_ratio} must be at least 0 and below 1")
