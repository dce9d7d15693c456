"""Gears: the kinematic scheme from the side, and the front view with true teeth or with pitch and tip circles.

In the scheme wheels are lines across level shafts. In the front view lengths are in modules times ``module``.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import acos, cos, pi, radians, sqrt, tan

from figures.canvas import Circle, Line, Piece, Strokes
from figures.plane import Point, direction, unit

PRESSURE_ANGLE = radians(20)
RIM = 9.0  # half the width of a wheel's face in the scheme
WEB = 22.0  # from the plane of an internal mesh to the web of its ring


def shaft(start: Point, end: Point) -> Line:
    """A level shaft."""
    return Line("f-link", (start, end))


def bearing(at: Point) -> Strokes:
    """A bearing: a short stroke on each side of the shaft."""
    return Strokes("f-thick", tuple((at + rise - 8, at + rise + 8) for rise in (6j, -6j)))


def wheel(at: Point, radius: float) -> tuple[Piece, ...]:
    """A wheel fixed to a level shaft, with its face at both ends."""
    top = radius * 1j
    faces = tuple((at + end - RIM, at + end + RIM) for end in (top, -top))
    return (Line("f-thick", (at - top, at + top)), Strokes("f-thick", faces), fastening(at))


def ring(at: Point, radius: float, side: float) -> tuple[Piece, ...]:
    """A wheel with internal teeth: its web stands aside of the plane of the mesh.

    Args:
        at: The point of the axis in the plane of the mesh.
        radius: Its pitch radius.
        side: +1 for a web (and shaft) on the right of the mesh, -1 on the left.
    """
    web, top = at + side * WEB, radius * 1j
    cup = (at - side * RIM + top, web + top, web - top, at - side * RIM - top)
    return (Line("f-thick", cup), fastening(web))


def fastening(at: Point) -> Strokes:
    """The small cross of a wheel fixed to its shaft."""
    return Strokes("f-hatch", ((at - 4 - 4j, at + 4 + 4j), (at - 4 + 4j, at + 4 - 4j)))


@dataclass(frozen=True, slots=True)
class Gear:
    """A gear in front view: ``turn`` is the angle of the middle of one of its teeth, radians."""

    centre: Point
    teeth: int
    module: float
    turn: float = 0.0
    internal: bool = False

    @property
    def pitch_radius(self) -> float:
        """Half of the module times the number of teeth."""
        return self.module * self.teeth / 2

    @property
    def tip_radius(self) -> float:
        """Where the teeth end: a module outside the pitch circle, inside it for a ring."""
        return self.pitch_radius + (-self.module if self.internal else self.module)

    @property
    def root_radius(self) -> float:
        """Where the gaps end, 1.25 modules on the other side of the pitch circle."""
        return self.pitch_radius + 1.25 * (self.module if self.internal else -self.module)


def _involute(angle: float) -> float:
    return tan(angle) - angle


def half_tooth(gear: Gear, radius: float) -> float:
    """Half of the angle a tooth takes at a radius; of the gap's involute for a ring.

    Args:
        gear: The gear.
        radius: Where; below the base circle the flank is radial.

    Source:
        Involute of the base circle r_b = r cos 20°: psi = pi/(2 z) + inv 20° - inv(acos(r_b/r)).
    """
    base = gear.pitch_radius * cos(PRESSURE_ANGLE)
    slope = acos(base / max(radius, base))
    spread = pi / (2 * gear.teeth) + _involute(PRESSURE_ANGLE) - _involute(slope)
    return pi / gear.teeth - spread if gear.internal else spread


def toothed(gear: Gear) -> tuple[Piece, ...]:
    """The true outline of the teeth, with the pitch circle."""
    low, high = gear.root_radius, gear.tip_radius
    radii = [low + (high - low) * i / 4 for i in range(5)]
    flank = [(radius, max(half_tooth(gear, radius), 0.0)) for radius in radii]
    points: list[Point] = []
    for tooth in range(gear.teeth):
        middle = gear.turn + 2 * pi * tooth / gear.teeth
        points += [gear.centre + radius * unit(middle - half) for radius, half in flank]
        points += [gear.centre + radius * unit(middle + half) for radius, half in reversed(flank)]
    return (Line("f-o", tuple(points), closed=True), pitch_circle(gear))


def plain(gear: Gear) -> tuple[Piece, ...]:
    """The gear as its tip circle and its pitch circle."""
    return (Circle("f-thick", gear.centre, gear.tip_radius), pitch_circle(gear))


def pitch_circle(gear: Gear) -> Circle:
    """The pitch circle."""
    return Circle("f-axis", gear.centre, gear.pitch_radius)


def meshed(driver: Gear, teeth: int, towards: float, internal: bool = False) -> Gear:
    """The partner of a gear, in mesh with it: its tooth stands in the driver's gap on the line of centres.

    Args:
        driver: The gear that is there already, with external teeth.
        teeth: The partner's number of teeth; more than the driver's when ``internal``.
        towards: The direction from the driver's centre to the pitch point, radians.
        internal: Whether the partner is a ring around the driver.

    Raises:
        ValueError: A ring is not larger than its pinion.
    """
    if internal and teeth <= driver.teeth:
        raise ValueError(f"a ring of {teeth} teeth does not hold a gear of {driver.teeth}")
    distance = driver.module * (driver.teeth - teeth if internal else driver.teeth + teeth) / 2
    centre = driver.centre + distance * unit(towards)
    contact = towards if internal else towards + pi
    # phase of the driver at the pitch point, in teeth; the partner is half a tooth off
    phase = (towards - driver.turn) * driver.teeth / (2 * pi)
    turn = contact - (phase + 0.5) * 2 * pi / teeth if internal else contact + (phase + 0.5) * 2 * pi / teeth
    return Gear(centre, teeth, driver.module, turn, internal)


def hub(gear: Gear, radius: float = 5.0) -> tuple[Piece, ...]:
    """The shaft of a gear in front view."""
    return (Circle("f-o", gear.centre, radius),)


def rim_hatch(gear: Gear, middle: float) -> Strokes:
    """The hatching outside a third of the rim of a fixed wheel, around the direction ``middle``."""
    outer = (gear.root_radius + gear.module if gear.internal else gear.tip_radius) + 1
    count = max(3, int(outer * 2 * pi / 3 / 7))
    feet = [middle + 2 * pi / 3 * (i / (count - 1) - 0.5) for i in range(count)]
    out = 8 * sqrt(2)
    starts = [gear.centre + outer * unit(foot) for foot in feet]
    return Strokes("f-hatch", tuple((at, at + out * unit(direction(gear.centre, at) + pi / 4)) for at in starts))
