"""Serial chains by closed-form pair matrices and recursion in base axes (domain DH-2, DH-3, DH-8).

Standard and modified Denavit-Hartenberg tables; angles in radians, lengths in metres, all results in base axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import cos, sin

from mechanics.dh import Convention, Row, check_variables
from mechanics.links import REST, LinkMotion, next_motion
from mechanics.vectors import ZERO, Matrix, Vector, add, check_vector, scaled, subtract

# x, y, z axes and origin of a frame, component by component: the first three rows of T, column after column.
Frame = tuple[float, float, float, float, float, float, float, float, float, float, float, float]

BASE: Frame = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Chain:
    rows: tuple[Row, ...]
    convention: Convention = "standard"
    _constants: tuple[tuple[bool, float, float, float, float, float, float], ...] = field(
        init=False, repr=False, compare=False
    )

    def __post_init__(self) -> None:
        check_variables(self.rows, self.convention)
        constants = tuple((r.type == "R", r.theta, r.d, r.a, cos(r.alpha), sin(r.alpha), r.sign) for r in self.rows)
        object.__setattr__(self, "_constants", constants)


@dataclass(frozen=True, slots=True)
class ChainMotion:
    T: Matrix  # pose of the last frame, (4, 4)
    J: Matrix  # [v; omega] of the last origin by joint rates, (6, n)
    p: Vector  # tool point, m
    v: Vector  # m/s
    a: Vector  # m/s^2
    omega: Vector  # last link, rad/s
    epsilon: Vector  # rad/s^2


def pair_matrix(theta: float, d: float, a: float, alpha: float, convention: Convention = "standard") -> Matrix:
    """Write the matrix A_i of one row, ``(4, 4)``.

    Args:
        theta: Turn about z, in radians.
        d: Shift along z (s_i of the lectures), in metres.
        a: Shift along x, in metres.
        alpha: Turn about x, in radians.
        convention: "standard" (distal) or "modified" (proximal, Craig).

    Raises:
        ValueError: A value is not finite, or the convention unknown.

    Source:
        Domain DH-2; the modified form is Rot(x, alpha) Trans(x, a) Rot(z, theta) Trans(z, d) multiplied out.
    """
    check_variables([Row("R", theta, d, a, alpha)], convention)
    c, s, ca, sa = cos(theta), sin(theta), cos(alpha), sin(alpha)
    bottom = (0.0, 0.0, 0.0, 1.0)
    if convention == "standard":
        return (c, -s * ca, s * sa, a * c), (s, c * ca, -c * sa, a * s), (0.0, sa, ca, d), bottom
    return (c, -s, 0.0, a), (s * ca, c * ca, -sa, -d * sa), (s * sa, c * sa, ca, d * ca), bottom


def pose(chain: Chain, q: Sequence[float]) -> Matrix:
    """Multiply the pair matrices (forward kinematics): T = A_1 A_2 ... A_n, ``(4, 4)``.

    Args:
        chain: The table.
        q: Joint variables, ``(n,)``, radians or metres.

    Raises:
        ValueError: The number of variables is not that of the joints.
    """
    return _matrix(frames(chain, q)[-1])


def _matrix(frame: Frame) -> Matrix:
    xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz = frame
    return (xx, yx, zx, px), (xy, yy, zy, py), (xz, yz, zz, pz), (0.0, 0.0, 0.0, 1.0)


def frames(chain: Chain, q: Sequence[float]) -> list[Frame]:
    """Find the frame of every link, axes and origin in base axes; arguments and errors as for `pose`."""
    if len(q) != len(chain.rows):
        raise ValueError(f"q has {len(q)} values for {len(chain.rows)} joints")
    return _standard_frames(chain, q) if chain.convention == "standard" else _modified_frames(chain, q)


def _standard_frames(chain: Chain, q: Sequence[float]) -> list[Frame]:
    """Turn the axes x, y about z, shift, turn y, z about x; written out by components: the inner loop of all."""
    xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz = BASE
    found = []
    for (revolute, theta, d, a, ca, sa, sign), variable in zip(chain._constants, q, strict=True):
        if revolute:
            theta += sign * variable
        else:
            d += sign * variable
        c, s = cos(theta), sin(theta)
        px, py, pz = px + d * zx, py + d * zy, pz + d * zz
        xx, yx = c * xx + s * yx, c * yx - s * xx
        xy, yy = c * xy + s * yy, c * yy - s * xy
        xz, yz = c * xz + s * yz, c * yz - s * xz
        px, py, pz = px + a * xx, py + a * xy, pz + a * xz
        yx, zx = ca * yx + sa * zx, ca * zx - sa * yx
        yy, zy = ca * yy + sa * zy, ca * zy - sa * yy
        yz, zz = ca * yz + sa * zz, ca * zz - sa * yz
        found.append((xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz))
    return found


def _modified_frames(chain: Chain, q: Sequence[float]) -> list[Frame]:
    """The same four motions, those about x first."""
    xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz = BASE
    found = []
    for (revolute, theta, d, a, ca, sa, sign), variable in zip(chain._constants, q, strict=True):
        if revolute:
            theta += sign * variable
        else:
            d += sign * variable
        c, s = cos(theta), sin(theta)
        px, py, pz = px + a * xx, py + a * xy, pz + a * xz
        yx, zx = ca * yx + sa * zx, ca * zx - sa * yx
        yy, zy = ca * yy + sa * zy, ca * zy - sa * yy
        yz, zz = ca * yz + sa * zz, ca * zz - sa * yz
        px, py, pz = px + d * zx, py + d * zy, pz + d * zz
        xx, yx = c * xx + s * yx, c * yx - s * xx
        xy, yy = c * xy + s * yy, c * yy - s * xy
        xz, yz = c * xz + s * yz, c * yz - s * xz
        found.append((xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz))
    return found


def jacobian(chain: Chain, q: Sequence[float]) -> Matrix:
    """Write the Jacobian of the last origin in base axes, rows [v; omega], ``(6, n)``.

    Args:
        chain: The table.
        q: Joint variables, ``(n,)``, radians or metres.

    Raises:
        ValueError: The number of variables is not that of the joints.

    Source:
        Columns [z x (O_n - O); z] of a turn and [z; 0] of a slide, O any point of the joint's axis.
    """
    return _jacobian(chain, frames(chain, q))


def _jacobian(chain: Chain, found: Sequence[Frame]) -> Matrix:
    ex, ey, ez = found[-1][9:]
    columns = []
    for (revolute, *_, sign), holder in zip(chain._constants, _holders(chain, found), strict=True):
        zx, zy, zz, px, py, pz = holder[6:]
        x, y, z = sign * zx, sign * zy, sign * zz
        if revolute:
            rx, ry, rz = ex - px, ey - py, ez - pz
            columns.append((y * rz - z * ry, z * rx - x * rz, x * ry - y * rx, x, y, z))
        else:
            columns.append((x, y, z, 0.0, 0.0, 0.0))
    return tuple(zip(*columns, strict=True))


def _holders(chain: Chain, found: Sequence[Frame]) -> Sequence[Frame]:
    """The frames whose z axis is the axis of each joint."""
    return [BASE, *found[:-1]] if chain.convention == "standard" else found


def joint_axes(chain: Chain, q: Sequence[float]) -> list[tuple[Vector, Vector]]:
    """Find of each joint the unit vector along which its variable grows, and a point of its axis (m), in base axes."""
    holders = _holders(chain, frames(chain, q))
    return [(scaled(row.sign, at[6:9]), at[9:]) for row, at in zip(chain.rows, holders, strict=True)]


def link_motions(
    chain: Chain,
    q: Sequence[float],
    qd: Sequence[float],
    qdd: Sequence[float],
) -> list[LinkMotion]:
    """Find the motion of every link in base axes, from the first to the last (domain DH-8).

    Args:
        chain: The table, of n rows.
        q: Joint variables, ``(n,)``, radians or metres.
        qd: Their rates, ``(n,)``.
        qdd: Their accelerations, ``(n,)``.

    Raises:
        ValueError: A vector has another length, or a value is not finite.
    """
    check_variables(chain.rows, chain.convention, q=q, qd=qd, qdd=qdd)
    return _link_motions(chain, frames(chain, q), qd, qdd)


def _link_motions(chain: Chain, found: Sequence[Frame], qd: Sequence[float], qdd: Sequence[float]) -> list[LinkMotion]:
    motions, motion, origin = [], REST, ZERO
    for i, (row, at, holder) in enumerate(zip(chain.rows, found, _holders(chain, found), strict=True)):
        axis = scaled(row.sign, holder[6:9])
        rate, acceleration = scaled(qd[i], axis), scaled(qdd[i], axis)
        motion = next_motion(motion, row.type, chain.convention, subtract(at[9:], origin), rate, acceleration)
        motions.append(motion)
        origin = at[9:]
    return motions


def solve(
    chain: Chain,
    q: Sequence[float],
    qd: Sequence[float] | None = None,
    qdd: Sequence[float] | None = None,
    tool_point: Vector = ZERO,
) -> ChainMotion:
    """Solve pose, Jacobian, velocity and acceleration of a serial chain.

    Args:
        chain: The table, of n rows.
        q: Joint variables, ``(n,)``, radians or metres.
        qd: Their rates, ``(n,)``; zeros when left out.
        qdd: Their accelerations, ``(n,)``; zeros when left out.
        tool_point: A point of the last link in the axes of the last frame, ``(3,)``, in metres.

    Returns:
        The motion in base axes.

    Raises:
        ValueError: A vector has another length, or a value is not finite.

    Source:
        Domain DH-8, with z of frame i instead of i - 1 in the modified convention.
    """
    rates = tuple(qd) if qd is not None else (0.0,) * len(q)
    accelerations = tuple(qdd) if qdd is not None else (0.0,) * len(q)
    check_variables(chain.rows, chain.convention, q=q, qd=rates, qdd=accelerations)
    check_vector("tool_point", tool_point, "m")
    found = frames(chain, q)
    last = _link_motions(chain, found, rates, accelerations)[-1]
    arm = turned(found[-1], tool_point)
    v, a = last.point(arm)
    return ChainMotion(
        T=_matrix(found[-1]),
        J=_jacobian(chain, found),
        p=add(found[-1][9:], arm),
        v=v,
        a=a,
        omega=last.omega,
        epsilon=last.epsilon,
    )


def turned(frame: Frame, u: Vector) -> Vector:
    """Give a vector of a frame by its components in base axes."""
    return add(add(scaled(u[0], frame[0:3]), scaled(u[1], frame[3:6])), scaled(u[2], frame[6:9]))
