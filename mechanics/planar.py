"""Any planar mechanism: bodies, revolute and prismatic joints, drivers; Newton for the position, linear equations
for velocities and accelerations. No closed form is used: this is the independent way to check them (domain VP-1).

Body 0 is the frame. Every other body i has the pose (x, y, phi): metres, radians counter-clockwise from +X. A joint
connects two markers, each a point and a direction fixed to its body.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, hypot, pi, sin
from typing import Literal, Protocol

from mechanics import linear
from mechanics.checks import finite, positive
from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import Singular, principal

Pose = tuple[float, float, float]
Poses = Sequence[Pose]

FRAME: Pose = (0.0, 0.0, 0.0)
CLOSED = 1e-12  # gap against the size of the mechanism; one more step of Newton then reaches rounding
DEAD_NAME = "the drivers do not determine the velocities"
DEAD = 1e-5  # pivot of the rates below which they are noise: the position is then known to 1e-6 at best
STEPS, HALVINGS = 100, 40
QUARTER = pi / 2


@dataclass(frozen=True, slots=True)
class Marker:
    body: int
    u: float = 0.0  # point in body axes, m
    v: float = 0.0
    angle: float = 0.0  # direction in body axes, rad


@dataclass(frozen=True, slots=True)
class Row:
    """One scalar equation g(q) = 0 at a state: g'' = slopes q'' + drift, where drift holds the squares of rates."""

    residual: float
    slopes: dict[int, float]  # coordinate number to dg/dq
    drift: float = 0.0
    rate: float = 0.0  # demanded slopes q'
    acceleration: float = 0.0  # demanded g''


class Joint(Protocol):
    def rows(self, poses: Poses, rates: Poses) -> list[Row]: ...


@dataclass(frozen=True, slots=True)
class _Point:
    """A marker at a state: its place, and what its body's rotation makes of it."""

    x: float
    y: float
    body: int
    arm: tuple[float, float]  # from the body's origin
    omega: float

    def slopes(self, nx: float, ny: float, sign: float) -> dict[int, float]:
        """d(sign n . point)/dq for a constant n; nothing for the frame."""
        if self.body == 0:
            return {}
        first = 3 * (self.body - 1)
        turn = nx * -self.arm[1] + ny * self.arm[0]
        return {first: sign * nx, first + 1: sign * ny, first + 2: sign * turn}

    def velocity(self, rates: Poses) -> tuple[float, float]:
        vx, vy, omega = rates[self.body]
        return vx - omega * self.arm[1], vy + omega * self.arm[0]

    def centripetal(self) -> tuple[float, float]:
        return -(self.omega**2) * self.arm[0], -(self.omega**2) * self.arm[1]


def _at(marker: Marker, poses: Poses, rates: Poses) -> _Point:
    x, y, phi = poses[marker.body]
    c, s = cos(phi), sin(phi)
    arm = (c * marker.u - s * marker.v, s * marker.u + c * marker.v)
    return _Point(x + arm[0], y + arm[1], marker.body, arm, rates[marker.body][2])


def _relative_turn(a: Marker, b: Marker, poses: Poses) -> tuple[float, dict[int, float]]:
    slopes = {3 * m.body - 1: sign for m, sign in ((a, -1.0), (b, 1.0)) if m.body}
    return poses[b.body][2] + b.angle - poses[a.body][2] - a.angle, slopes


def _relative_shift(a: Marker, b: Marker, turned: float, poses: Poses, rates: Poses) -> Row:
    """The component of b - a along the direction of a, turned by `turned` and carried by the body of a."""
    pa, pb = _at(a, poses, rates), _at(b, poses, rates)
    direction = poses[a.body][2] + a.angle + turned
    nx, ny = cos(direction), sin(direction)
    dx, dy = pb.x - pa.x, pb.y - pa.y
    slopes = pb.slopes(nx, ny, 1.0)
    for coordinate, slope in pa.slopes(nx, ny, -1.0).items():
        slopes[coordinate] = slopes.get(coordinate, 0.0) + slope
    if a.body:
        slopes[3 * a.body - 1] += -ny * dx + nx * dy
    (vax, vay), (vbx, vby) = pa.velocity(rates), pb.velocity(rates)
    (cax, cay), (cbx, cby) = pa.centripetal(), pb.centripetal()
    spin = pa.omega
    drift = nx * (cbx - cax) + ny * (cby - cay) - spin**2 * (nx * dx + ny * dy)
    drift += 2 * spin * (-ny * (vbx - vax) + nx * (vby - vay))
    return Row(nx * dx + ny * dy, slopes, drift)


@dataclass(frozen=True, slots=True)
class Revolute:
    """The points of two markers coincide."""

    a: Marker
    b: Marker

    def rows(self, poses: Poses, rates: Poses) -> list[Row]:
        pa, pb = _at(self.a, poses, rates), _at(self.b, poses, rates)
        ca, cb = pa.centripetal(), pb.centripetal()
        return [
            Row(pb.x - pa.x, pb.slopes(1.0, 0.0, 1.0) | pa.slopes(1.0, 0.0, -1.0), cb[0] - ca[0]),
            Row(pb.y - pa.y, pb.slopes(0.0, 1.0, 1.0) | pa.slopes(0.0, 1.0, -1.0), cb[1] - ca[1]),
        ]


@dataclass(frozen=True, slots=True)
class Prismatic:
    """The point of b stays on the line of a, and the directions of a and b stay parallel."""

    a: Marker
    b: Marker

    def rows(self, poses: Poses, rates: Poses) -> list[Row]:
        return [_relative_shift(self.a, self.b, QUARTER, poses, rates), Row(*_relative_turn(self.a, self.b, poses))]


@dataclass(frozen=True, slots=True)
class Contact:
    """A higher pair of curvature zero: the point of b stays on the tangent, its normal the direction of a."""

    a: Marker
    b: Marker

    def rows(self, poses: Poses, rates: Poses) -> list[Row]:
        return [_relative_shift(self.a, self.b, 0.0, poses, rates)]


@dataclass(frozen=True, slots=True)
class Driver:
    """Hold a relative coordinate at a value with a given rate and acceleration.

    "turn": angle from the direction of a to that of b (rad). "slide": travel of the point of b from the point of a
    along the direction of a (m).
    """

    kind: Literal["turn", "slide"]
    a: Marker
    b: Marker
    value: float
    rate: float = 0.0
    acceleration: float = 0.0

    def rows(self, poses: Poses, rates: Poses) -> list[Row]:
        if self.kind == "turn":
            angle, slopes = _relative_turn(self.a, self.b, poses)
            return [Row(angle - self.value, slopes, 0.0, self.rate, self.acceleration)]
        along = _relative_shift(self.a, self.b, 0.0, poses, rates)
        return [Row(along.residual - self.value, along.slopes, along.drift, self.rate, self.acceleration)]


@dataclass(frozen=True, slots=True)
class Motion:
    """Poses, rates and accelerations by body; entry 0 is the frame."""

    poses: tuple[Pose, ...]
    rates: tuple[Pose, ...]
    accelerations: tuple[Pose, ...]
    pivot: float  # smallest of the scaled equations, with the sign of their determinant, which tells assemblies apart

    @property
    def singular(self) -> Singular:
        """Give the distance to a dead position: the smallest pivot, 0 where the drivers leave a velocity open."""
        return Singular(min(1.0, abs(self.pivot)), DEAD_NAME)

    def point(self, marker: Marker) -> tuple[tuple[float, float], tuple[float, float], tuple[float, float]]:
        """Position (m), velocity (m/s) and acceleration (m/s^2) of a point of a body."""
        at = _at(marker, self.poses, self.rates)
        ax, ay, epsilon = self.accelerations[marker.body]
        cx, cy = at.centripetal()
        acceleration = (ax - epsilon * at.arm[1] + cx, ay + epsilon * at.arm[0] + cy)
        return (at.x, at.y), at.velocity(self.rates), acceleration


def solve(joints: Sequence[Joint], start: Sequence[Pose]) -> Motion:
    """Solve position, velocity and acceleration of a mechanism.

    Args:
        joints: Joints and drivers; together as many equations as there are coordinates.
        start: A guess of the pose of each moving body, ``(n, 3)``; it chooses the assembly.

    Returns:
        The motion of all bodies, the frame first.

    Raises:
        ValueError: The number of equations is not three for each moving body, or a guess is not finite.
        AssemblyError: Newton's method ends away from closure; the message has the gap that is left.
        SingularError: The mechanism closes, but its velocities are not determined.
    """
    for i, pose in enumerate(start):
        for name, value, unit in zip(("x", "y", "phi"), pose, ("m", "m", "rad"), strict=True):
            finite(f"guess {name} of body {i + 1}", value, unit)
    poses = assemble(joints, start)
    still = _rows(joints, poses, (FRAME,) * len(poses))
    rates, pivot = _rates(still, [row.rate for row in still])
    moving = _rows(joints, poses, rates)
    accelerations, _ = _rates(moving, [row.acceleration - row.drift for row in moving])
    return Motion(poses, rates, accelerations, pivot)


def _rates(rows: list[Row], right: list[float]) -> tuple[tuple[Pose, ...], float]:
    try:
        values, pivot = linear.solve_with_pivot(_slopes(rows), right, DEAD)
    except SingularError:
        raise SingularError(f"dead position: {DEAD_NAME} here") from None
    return _by_body(values), pivot


def assemble(joints: Sequence[Joint], start: Sequence[Pose]) -> tuple[Pose, ...]:
    """Close the mechanism by Newton's method with step halving; arguments and errors as for `solve`."""
    poses = _by_body([value for pose in start for value in pose])
    size = 1.0 + max(abs(value) for pose in poses for value in pose)
    still = (FRAME,) * len(poses)
    rows = _rows(joints, poses, still)
    gap = _gap(rows)
    for _ in range(STEPS):
        step = _newton_step(rows)
        if step is None:
            break
        if gap <= CLOSED * size:
            last = _moved(poses, step, 1.0)
            return last if _gap(_rows(joints, last, still)) < gap else poses
        for halving in range(HALVINGS):
            tried = _moved(poses, step, 0.5**halving)
            new_rows = _rows(joints, tried, still)
            if _gap(new_rows) < gap:
                break
        else:
            break
        poses, rows, gap = tried, new_rows, _gap(new_rows)
    if gap <= CLOSED * size:
        return poses
    raise AssemblyError(f"the mechanism cannot be assembled from this guess: its joints stay {gap:.4g} (m, rad) apart")


def _newton_step(rows: list[Row]) -> tuple[Pose, ...] | None:
    try:
        return _by_body(linear.solve(_slopes(rows), [-row.residual for row in rows]))
    except SingularError:
        return None


def _moved(poses: Poses, step: Poses, part: float) -> tuple[Pose, ...]:
    return tuple(
        (x + part * dx, y + part * dy, phi + part * turn)
        for (x, y, phi), (dx, dy, turn) in zip(poses, step, strict=True)
    )


def _gap(rows: list[Row]) -> float:
    return hypot(*(row.residual for row in rows))


def _rows(joints: Sequence[Joint], poses: Poses, rates: Poses) -> list[Row]:
    rows = [row for joint in joints for row in joint.rows(poses, rates)]
    coordinates = 3 * (len(poses) - 1)
    if len(rows) != coordinates:
        raise ValueError(f"{len(rows)} equations of joints and drivers for {coordinates} coordinates")
    return rows


def _slopes(rows: list[Row]) -> list[list[float]]:
    return [[row.slopes.get(i, 0.0) for i in range(len(rows))] for row in rows]


def _by_body(values: Sequence[float]) -> tuple[Pose, ...]:
    moving = zip(values[::3], values[1::3], values[2::3], strict=True)
    return (FRAME, *moving)


@dataclass(frozen=True, slots=True)
class SliderCrank:
    rod_angle: float  # alpha2, rad, in (-pi, pi]
    slider: float  # l3, m
    rod_speed: float  # omega2, rad/s
    slider_speed: float  # v3, m/s
    rod_acceleration: float  # eps2, rad/s^2
    slider_acceleration: float  # p3, m/s^2


def slider_crank(
    l1: float,
    l2: float,
    alpha1: float,
    omega1: float,
    eps1: float = 0.0,
    offset: float = 0.0,
    branch: Literal["slider_right", "slider_left"] = "slider_right",
) -> SliderCrank:
    """Move a slider-crank (domain VP-2, VP-3) as three bodies, three revolutes, one slide and one driver.

    Args:
        l1: Crank length, in metres.
        l2: Connecting-rod length, in metres.
        alpha1: Crank angle from +X, in radians.
        omega1: Crank angular velocity, in rad/s.
        eps1: Crank angular acceleration, in rad/s^2.
        offset: Ordinate of the guide, in metres.
        branch: Whether the slider is to the right or to the left of the crank pin.

    Returns:
        Angle of the rod from +X, coordinate of the slider, and their rates.

    Raises:
        ValueError: A length is not positive and finite, another value not finite, or the branch unknown.
        AssemblyError: The rod cannot reach the guide.
        SingularError: The rod is perpendicular to the guide.
    """
    motion = slider_crank_motion(l1, l2, alpha1, omega1, eps1, offset, branch)
    rod, block = 2, 3
    return SliderCrank(
        rod_angle=principal(motion.poses[rod][2]),
        slider=motion.poses[block][0],
        rod_speed=motion.rates[rod][2],
        slider_speed=motion.rates[block][0],
        rod_acceleration=motion.accelerations[rod][2],
        slider_acceleration=motion.accelerations[block][0],
    )


def slider_crank_motion(
    l1: float,
    l2: float,
    alpha1: float,
    omega1: float,
    eps1: float = 0.0,
    offset: float = 0.0,
    branch: Literal["slider_right", "slider_left"] = "slider_right",
) -> Motion:
    """Move a slider-crank and give every body: 1 crank, 2 rod, 3 slider; arguments and errors as for `slider_crank`."""
    positive("crank l1", l1, "m")
    positive("rod l2", l2, "m")
    for name, value, unit in (("alpha1", alpha1, "rad"), ("omega1", omega1, "rad/s"), ("offset", offset, "m")):
        finite(name, value, unit)
    finite("eps1", eps1, "rad/s^2")
    if branch not in ("slider_right", "slider_left"):
        raise ValueError(f"branch must be slider_right or slider_left, not {branch!r}")
    crank, rod, slider = Marker(1), Marker(2), Marker(3)
    joints: list[Joint] = [
        Revolute(Marker(0), crank),
        Revolute(Marker(1, l1), rod),
        Revolute(Marker(2, l2), slider),
        Prismatic(Marker(0, 0.0, offset), slider),
        Driver("turn", Marker(0), crank, alpha1, omega1, eps1),
    ]
    pin_x, pin_y = l1 * cos(alpha1), l1 * sin(alpha1)
    rod_start, reach = (0.0, l2) if branch == "slider_right" else (pi, -l2)
    return solve(joints, [(0.0, 0.0, alpha1), (pin_x, pin_y, rod_start), (pin_x + reach, offset, 0.0)])
