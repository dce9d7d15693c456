"""Position errors of manipulators from small errors of what moves them (domain AC-1..4).

An error is real minus programmed, small, in radians or metres. The linear error of a point is found three ways: by
partial derivatives, by the matrices U, and by vectors without differentiation; the angular error adds small turns.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, fsum, hypot

from mechanics.checks import finite
from mechanics.manipulators.chain import Chain, frames, joint_axes, turned
from mechanics.manipulators.dh import Convention, Row, check_variables
from mechanics.manipulators.transform import moved_point, total, velocity_matrix
from mechanics.vectors import ZERO, Matrix, Vector, add, check_vector, cross, dot, scaled, subtract, times


@dataclass(frozen=True, slots=True)
class LinearError:
    """Error of a point, its parts by coordinate, and how large it can be."""

    terms: tuple[Vector, ...]  # of each coordinate, m
    dr: Vector  # m

    @property
    def size(self) -> float:
        """|dr|, m."""
        return hypot(*self.dr)

    @property
    def worst(self) -> Vector:
        """Largest error along each axis when every sign is as bad as can be, m."""
        x, y, z = (fsum(map(abs, column)) for column in zip(*self.terms, strict=True))
        return x, y, z

    @property
    def rms(self) -> Vector:
        """Root of the sum of squares along each axis, for independent random errors, m."""
        x, y, z = (hypot(*column) for column in zip(*self.terms, strict=True))
        return x, y, z


def linear(partials: Sequence[Vector], dq: Sequence[float]) -> LinearError:
    """Find the error of a point from the partial derivatives of its position.

    Args:
        partials: dr/dq_j of each coordinate, ``(n, 3)``, such as those of `rod_groups.partials`.
        dq: Errors of the coordinates, ``(n,)``, radians or metres.

    Raises:
        ValueError: Another number of errors than of derivatives, or a value not finite.

    Source:
        Domain AC-1.
    """
    if not partials or len(partials) != len(dq):
        raise ValueError(f"dq has {len(dq)} values for {len(partials)} partial derivatives")
    for j, (slope, error) in enumerate(zip(partials, dq, strict=True)):
        check_vector(f"partials[{j}]", slope, "(m or 1)")
        finite(f"dq[{j}]", error, "(rad or m)")
    return _summed([scaled(error, slope) for slope, error in zip(partials, dq, strict=True)])


def _summed(terms: Sequence[Vector]) -> LinearError:
    x, y, z = (fsum(column) for column in zip(*terms, strict=True))
    return LinearError(tuple(terms), (x, y, z))


def pose_error(
    rows: Sequence[Row], q: Sequence[float], dq: Sequence[float], convention: Convention = "standard"
) -> Matrix:
    """Find the error of the pose, dT = sum U_nj dq_j, ``(4, 4)``.

    Args:
        rows: The table, n rows.
        q: Joint variables, ``(n,)``, radians or metres.
        dq: Their errors, ``(n,)``.
        convention: "standard" or "modified".

    Raises:
        ValueError: The variables do not fit the table.

    Source:
        Domain AC-2.
    """
    check_variables(rows, convention, q=q, dq=dq)
    n = len(rows)
    return total([velocity_matrix(rows, q, n, j, convention) for j in range(1, n + 1)], dq)


def by_matrices(
    rows: Sequence[Row], q: Sequence[float], dq: Sequence[float], point: Vector, convention: Convention = "standard"
) -> Vector:
    """Find the error dr = dT r of a point of the last frame, in m; arguments and errors as for `pose_error`."""
    check_vector("point", point, "m")
    return moved_point(pose_error(rows, q, dq, convention), point)


def by_vectors(chain: Chain, q: Sequence[float], dq: Sequence[float], point: Vector = ZERO) -> LinearError:
    """Find the error of a point without differentiation.

    Args:
        chain: The table, n rows.
        q: Joint variables, ``(n,)``, radians or metres.
        dq: Their errors, ``(n,)``.
        point: In the last frame, in metres.

    Raises:
        ValueError: The variables do not fit the table.

    Source:
        Domain AC-3: dq e x rho of a turn, rho from any point of the axis to the point; dq e of a slide.
    """
    check_variables(chain.rows, chain.convention, q=q, dq=dq)
    check_vector("point", point, "m")
    last = frames(chain, q)[-1]
    tip = add(last[9:], turned(last, point))
    terms = []
    for row, error, (axis, origin) in zip(chain.rows, dq, joint_axes(chain, q), strict=True):
        arm = cross(axis, subtract(tip, origin)) if row.type == "R" else axis
        terms.append(scaled(error, arm))
    return _summed(terms)


@dataclass(frozen=True, slots=True)
class AngularError:
    """Small turn of the last link."""

    base: Vector  # in base axes, rad
    gripper: Vector  # in the axes of the last frame, rad

    @property
    def angle(self) -> float:
        """Its size, rad."""
        return hypot(*self.base)


def angular(chain: Chain, q: Sequence[float], dq: Sequence[float]) -> AngularError:
    """Add the small turns dq e of the revolute joints; slides turn nothing.

    Arguments and errors as for `by_vectors`.

    Source:
        Domain AC-4.
    """
    check_variables(chain.rows, chain.convention, q=q, dq=dq)
    turn = ZERO
    for row, error, (axis, _) in zip(chain.rows, dq, joint_axes(chain, q), strict=True):
        if row.type == "R":
            turn = add(turn, scaled(error, axis))
    last = frames(chain, q)[-1]
    x, y, z = (dot(last[3 * k : 3 * k + 3], turn) for k in range(3))
    return AngularError(turn, (x, y, z))


def turn_between(programmed: Matrix, real: Matrix) -> float:
    """Find the angle of the finite turn from one pose to another, in [0, pi].

    Args:
        programmed: The pose meant; its first three rows and columns are the rotation.
        real: The pose reached.

    Source:
        Domain AC-4: cos = (trace(R_real R_prog^T) - 1)/2, with the sine beside it for small angles.
    """
    R = [times(programmed, (row[0], row[1], row[2])) for row in real[:3]]
    sine = hypot(R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1])
    return atan2(sine, R[0][0] + R[1][1] + R[2][2] - 1)
