"""Homogeneous matrices: elementary ones, their products, and the derivative matrices U and V of a chain.

The independent way to check a chain: elementary matrices are multiplied one by one (domain DH-1, DH-5 to DH-7).
Matrices are ``(4, 4)`` tuples of rows; lengths in metres, angles in radians; frames and joints are numbered from 1.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from math import cos, sin

from mechanics.dh import Convention, JointType, Row, check_variables
from mechanics.vectors import Matrix, Vector, cross, dot

IDENTITY: Matrix = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))
ZERO: Matrix = ((0.0,) * 4,) * 4
RIGID = 1e-9  # how far R^T R of a rigid transform may be from the identity


def rot_z(angle: float) -> Matrix:
    """Turn about z by an angle in radians."""
    c, s = cos(angle), sin(angle)
    return (c, -s, 0.0, 0.0), (s, c, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0)


def rot_x(angle: float) -> Matrix:
    """Turn about x by an angle in radians."""
    c, s = cos(angle), sin(angle)
    return (1.0, 0.0, 0.0, 0.0), (0.0, c, -s, 0.0), (0.0, s, c, 0.0), (0.0, 0.0, 0.0, 1.0)


def trans_z(shift: float) -> Matrix:
    """Shift along z, in metres."""
    return (1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, shift), (0.0, 0.0, 0.0, 1.0)


def trans_x(shift: float) -> Matrix:
    """Shift along x, in metres."""
    return (1.0, 0.0, 0.0, shift), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0)


def product(*matrices: Matrix) -> Matrix:
    """Multiply matrices in the order given; none makes the identity."""
    return reduce(_times, matrices, IDENTITY)


def _times(left: Matrix, right: Matrix) -> Matrix:
    columns = tuple(zip(*right, strict=True))
    return tuple(tuple(sum(x * y for x, y in zip(row, column, strict=True)) for column in columns) for row in left)


def total(matrices: Sequence[Matrix], factors: Sequence[float]) -> Matrix:
    """Add matrices with their factors."""
    return tuple(
        tuple(sum(k * m[i][j] for m, k in zip(matrices, factors, strict=True)) for j in range(4)) for i in range(4)
    )


def moved_point(matrix: Matrix, point: Sequence[float]) -> Vector:
    """Carry a point, whose fourth coordinate is 1: R r + p (domain DH-1, DH-3); with a U or V it gives a rate."""
    x, y, z = (sum(m * r for m, r in zip(row, (*point, 1.0), strict=True)) for row in matrix[:3])
    return x, y, z


def rigid_inverse(matrix: Matrix) -> Matrix:
    """Invert a rigid transform: [[R^T, -R^T p], [0, 1]].

    Raises:
        ValueError: Not a rigid transform: R^T R is not the identity, det R not +1, or the last row not 0 0 0 1.

    Source:
        Domain DH-1.
    """
    x, y, z, p = ((column[0], column[1], column[2]) for column in zip(*matrix, strict=True))
    measures = (dot(x, x) - 1, dot(y, y) - 1, dot(z, z) - 1, dot(x, y), dot(y, z), dot(z, x))
    if max(map(abs, measures)) > RIGID or dot(x, cross(y, z)) < 0 or tuple(matrix[3]) != (0, 0, 0, 1):
        raise ValueError("not a rigid transform: R^T R = I, det R = +1 and a last row 0 0 0 1 are needed")
    return (*((*axis, -dot(axis, p)) for axis in (x, y, z)), (0.0, 0.0, 0.0, 1.0))


def chain_pose(rows: Sequence[Row], q: Sequence[float], convention: Convention = "standard") -> Matrix:
    """Multiply the elementary matrices of every row one by one.

    Args:
        rows: The table, n rows.
        q: Joint variables, ``(n,)``, radians or metres.
        convention: "standard" or "modified".

    Returns:
        Pose of the last frame, ``(4, 4)``.

    Raises:
        ValueError: The variables do not fit the table, or the convention is unknown.
    """
    check_variables(rows, convention, q=q)
    factors = (_factors(row, variable, convention) for row, variable in zip(rows, q, strict=True))
    return product(*(matrix for pair in factors for matrix in pair))


def _factors(row: Row, variable: float, convention: Convention) -> tuple[Matrix, ...]:
    theta, d = row.moved(variable)
    about_z, about_x = (rot_z(theta), trans_z(d)), (trans_x(row.a), rot_x(row.alpha))
    return (*about_z, *about_x) if convention == "standard" else (*about_x[::-1], *about_z)


def joint_operator(joint: JointType, sign: float = 1.0) -> Matrix:
    """Omega with dA/dq = Omega A (standard) or A Omega (modified); `sign` -1 where the table holds -q (domain DH-5)."""
    if joint == "R":
        return (0.0, -sign, 0.0, 0.0), (sign, 0.0, 0.0, 0.0), ZERO[0], ZERO[0]
    return ZERO[0], ZERO[0], (0.0, 0.0, 0.0, sign), ZERO[0]


def velocity_matrix(
    rows: Sequence[Row], q: Sequence[float], i: int, j: int, convention: Convention = "standard"
) -> Matrix:
    """U_ij = dT_i/dq_j = A_1 ... A_(j-1) Omega_j A_j ... A_i, zero for j > i (domain DH-6)."""
    return _derivative(rows, q, i, (j,), convention)


def acceleration_matrix(
    rows: Sequence[Row], q: Sequence[float], i: int, j: int, k: int, convention: Convention = "standard"
) -> Matrix:
    """V_ijk = d2T_i/dq_j dq_k (domain DH-7): the operators stand before A_j and A_k, behind them when modified."""
    return _derivative(rows, q, i, (j, k), convention)


def _derivative(rows: Sequence[Row], q: Sequence[float], i: int, by: tuple[int, ...], convention: Convention) -> Matrix:
    check_variables(rows, convention, q=q)
    if not all(1 <= number <= len(rows) for number in (i, *by)):
        raise ValueError(f"frame {i} and joints {by} must lie in 1 .. {len(rows)}")
    if max(by) > i:
        return ZERO
    factors: list[Matrix] = []
    for number, (row, variable) in enumerate(zip(rows[:i], q[:i], strict=True), start=1):
        operators = [joint_operator(row.type, row.sign)] * by.count(number)
        pair = _factors(row, variable, convention)
        factors += [*operators, *pair] if convention == "standard" else [*pair, *operators]
    return product(*factors)


def point_motion(
    rows: Sequence[Row],
    q: Sequence[float],
    qd: Sequence[float],
    qdd: Sequence[float],
    point: Vector,
    convention: Convention = "standard",
) -> tuple[Vector, Vector, Vector]:
    """Move a point of the last link of a chain by the matrices U and V.

    Args:
        rows: The table, n rows.
        q: Joint variables, ``(n,)``, radians or metres.
        qd: Their rates, ``(n,)``.
        qdd: Their accelerations, ``(n,)``.
        point: In the last frame, in metres.
        convention: "standard" or "modified".

    Returns:
        Position (m), velocity (m/s) and acceleration (m/s^2) in base axes.

    Raises:
        ValueError: The variables do not fit the table.

    Source:
        Domain DH-6, DH-7: T' = sum U_j q_j', T'' = sum U_j q_j'' + sum V_jk q_j' q_k'.
    """
    check_variables(rows, convention, q=q, qd=qd, qdd=qdd)
    n = len(rows)
    joints = range(1, n + 1)
    first = [velocity_matrix(rows, q, n, j, convention) for j in joints]
    second = [acceleration_matrix(rows, q, n, j, k, convention) for j in joints for k in joints]
    squares = [x * y for x in qd for y in qd]
    return (
        moved_point(chain_pose(rows, q, convention), point),
        moved_point(total(first, qd), point),
        moved_point(total(first + second, [*qdd, *squares]), point),
    )
