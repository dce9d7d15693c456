"""Serial chains by closed-form pair matrices and recursion in base axes (domain DH-2, DH-3, DH-8).

Standard and modified Denavit-Hartenberg tables; angles in radians, lengths in metres, all results in base axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import cos, sin

from mechanics.checks import finite
from mechanics.dh import Convention, Matrix, Row, Vector, check_variables

# x, y, z axes and origin of a frame, component by component: the first three rows of T, column after column.
Frame = tuple[float, float, float, float, float, float, float, float, float, float, float, float]

ZERO: Vector = (0.0, 0.0, 0.0)
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
    """Multiply the pair matrices: T = A_1 A_2 ... A_n, ``(4, 4)``.

    Args:
        chain: The table.
        q: Joint variables, ``(n,)``, radians or metres.

    Raises:
        ValueError: The number of variables is not that of the joints.
    """
    return _matrix(_frames(chain, q)[-1])


def _matrix(frame: Frame) -> Matrix:
    xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz = frame
    return (xx, yx, zx, px), (xy, yy, zy, py), (xz, yz, zz, pz), (0.0, 0.0, 0.0, 1.0)


def _frames(chain: Chain, q: Sequence[float]) -> list[Frame]:
    if len(q) != len(chain.rows):
        raise ValueError(f"q has {len(q)} values for {len(chain.rows)} joints")
    return _standard_frames(chain, q) if chain.convention == "standard" else _modified_frames(chain, q)


def _standard_frames(chain: Chain, q: Sequence[float]) -> list[Frame]:
    """T_i = T_(i-1) A_i with A_i of `pair_matrix`, written out by components: this is the inner loop of all."""
    xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz = BASE
    frames = []
    for (revolute, theta, d, a, ca, sa, sign), variable in zip(chain._constants, q, strict=True):
        if revolute:
            theta += sign * variable
        else:
            d += sign * variable
        c, s = cos(theta), sin(theta)
        sca, cca, ssa, csa = s * ca, c * ca, s * sa, c * sa
        nx, ny, nz = c * xx + s * yx, c * xy + s * yy, c * xz + s * yz
        px, py, pz = px + a * nx + d * zx, py + a * ny + d * zy, pz + a * nz + d * zz
        mx, my, mz = cca * yx - sca * xx + sa * zx, cca * yy - sca * xy + sa * zy, cca * yz - sca * xz + sa * zz
        zx, zy, zz = ssa * xx - csa * yx + ca * zx, ssa * xy - csa * yy + ca * zy, ssa * xz - csa * yz + ca * zz
        xx, xy, xz, yx, yy, yz = nx, ny, nz, mx, my, mz
        frames.append((xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz))
    return frames


def _modified_frames(chain: Chain, q: Sequence[float]) -> list[Frame]:
    xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz = BASE
    frames = []
    for (revolute, theta, d, a, ca, sa, sign), variable in zip(chain._constants, q, strict=True):
        if revolute:
            theta += sign * variable
        else:
            d += sign * variable
        c, s = cos(theta), sin(theta)
        mx, my, mz = ca * yx + sa * zx, ca * yy + sa * zy, ca * yz + sa * zz
        zx, zy, zz = ca * zx - sa * yx, ca * zy - sa * yy, ca * zz - sa * yz
        px, py, pz = px + a * xx + d * zx, py + a * xy + d * zy, pz + a * xz + d * zz
        xx, xy, xz, yx, yy, yz = (
            c * xx + s * mx, c * xy + s * my, c * xz + s * mz,
            c * mx - s * xx, c * my - s * xy, c * mz - s * xz,
        )  # fmt: skip
        frames.append((xx, xy, xz, yx, yy, yz, zx, zy, zz, px, py, pz))
    return frames


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
    _check_point(tool_point)
    frames = _frames(chain, q)
    omega, epsilon, v, a = _recursion(chain, frames, rates, accelerations)
    arm = _rotated(frames[-1], tool_point)
    return ChainMotion(
        T=_matrix(frames[-1]),
        J=_jacobian(chain, frames),
        p=_add(frames[-1][9:], arm),
        v=_add(v, _cross(omega, arm)),
        a=_add(a, _carried(omega, epsilon, arm)),
        omega=omega,
        epsilon=epsilon,
    )


def _check_point(point: Vector) -> None:
    if len(point) != 3:
        raise ValueError(f"tool_point has {len(point)} coordinates, not 3")
    for value in point:
        finite("tool_point coordinate", value, "m")


def _recursion(
    chain: Chain, frames: Sequence[Frame], rates: Sequence[float], accelerations: Sequence[float]
) -> tuple[Vector, Vector, Vector, Vector]:
    """omega, epsilon of the last link, v, a of the last origin."""
    omega, epsilon, v, a = ZERO, ZERO, ZERO, ZERO
    standard = chain.convention == "standard"
    for i, row in enumerate(chain.rows):
        before = frames[i - 1] if i else BASE
        axis = before[6:9] if standard else frames[i][6:9]
        turn, turn_rate = _scale(row.sign * rates[i], axis), _scale(row.sign * accelerations[i], axis)
        shift = _subtract(frames[i][9:], before[9:])
        carrier = omega, epsilon  # of the link that holds the shift: the one before, or already this one
        if row.type == "R":
            omega, epsilon = _add(omega, turn), _add(epsilon, _add(turn_rate, _cross(omega, turn)))
        if standard:
            carrier = omega, epsilon
        v = _add(v, _cross(carrier[0], shift))
        a = _add(a, _carried(*carrier, shift))
        if row.type == "P":
            v = _add(v, turn)
            a = _add(a, _add(turn_rate, _scale(2, _cross(omega, turn))))
    return omega, epsilon, v, a


def _jacobian(chain: Chain, frames: Sequence[Frame]) -> Matrix:
    """Columns [z x (O_n - O); z] of a turn and [z; 0] of a slide, O any point of the joint's axis."""
    holders = [BASE, *frames[:-1]] if chain.convention == "standard" else frames
    columns = []
    for row, holder in zip(chain.rows, holders, strict=True):
        axis = _scale(row.sign, holder[6:9])
        lever = _subtract(frames[-1][9:], holder[9:])
        columns.append((*_cross(axis, lever), *axis) if row.type == "R" else (*axis, *ZERO))
    return tuple(zip(*columns, strict=True))


def _rotated(frame: Frame, r: Vector) -> Vector:
    return _add(_add(_scale(r[0], frame[0:3]), _scale(r[1], frame[3:6])), _scale(r[2], frame[6:9]))


def _carried(omega: Vector, epsilon: Vector, arm: Vector) -> Vector:
    return _add(_cross(epsilon, arm), _cross(omega, _cross(omega, arm)))


def _add(u: Vector, w: Vector) -> Vector:
    return u[0] + w[0], u[1] + w[1], u[2] + w[2]


def _subtract(u: Vector, w: Vector) -> Vector:
    return u[0] - w[0], u[1] - w[1], u[2] - w[2]


def _scale(k: float, u: Vector) -> Vector:
    return k * u[0], k * u[1], k * u[2]


def _cross(u: Vector, w: Vector) -> Vector:
    return u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]
