"""Position errors of manipulators and of the slider-crank from small errors of what moves them (domain AC-1..5).

An error is real minus programmed, small, in radians or metres. The linear error of a point is found three ways: by
partial derivatives, by the matrices U, and by vectors without differentiation; the angular error adds small turns.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, cos, fsum, hypot, sin, tan

from mechanics import slider_crank
from mechanics.chain import Chain, frames, joint_axes, turned
from mechanics.checks import finite
from mechanics.dh import Convention, Row, check_variables
from mechanics.slider_crank import Branch
from mechanics.transform import moved_point, total, velocity_matrix
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


@dataclass(frozen=True, slots=True)
class SliderError:
    """Error of the slider of a slider-crank, its coefficients, and how large it can be."""

    c_l1: float  # by the crank's length
    c_l2: float  # by the rod's length
    c_alpha: float  # by the crank's angle, m/rad
    c_offset: float  # by the ordinate of the guide
    dl3: float  # m
    worst: float  # every sign as bad as can be, m
    rms: float  # root of the sum of squares, m


def slider(
    l1: float,
    l2: float,
    alpha1: float,
    dl1: float = 0.0,
    dl2: float = 0.0,
    dalpha1: float = 0.0,
    doffset: float = 0.0,
    offset: float = 0.0,
    branch: Branch = "slider_right",
) -> SliderError:
    """Find the position error of the slider from errors of lengths and angle.

    Args:
        l1: Crank length, in metres.
        l2: Connecting-rod length, in metres.
        alpha1: Crank angle, in radians.
        dl1: Error of the crank's length, in metres.
        dl2: Error of the rod's length, in metres.
        dalpha1: Error of the crank's angle, in radians.
        doffset: Error of the guide's ordinate, in metres.
        offset: Ordinate of the guide, in metres.
        branch: The assembly, as for `slider_crank.position`.

    Raises:
        ValueError: A length is not positive, or a value not finite.
        AssemblyError: The rod cannot reach the guide.
        SingularError: The rod is perpendicular to the guide, where the coefficients grow without limit.

    Source:
        Domain AC-5: dl3/dl1 = cos(a1 - a2)/cos a2, dl3/dl2 = 1/cos a2, dl3/da1 = -l1 sin(a1 - a2)/cos a2; by the
        same closure dl3/dh = -tan a2.
    """
    errors = {"dl1": dl1, "dl2": dl2, "dalpha1": dalpha1, "doffset": doffset}
    for name, error in errors.items():
        finite(name, error, "rad" if name == "dalpha1" else "m")
    motion = slider_crank.solve(l1, l2, alpha1, offset=offset, branch=branch)
    alpha2 = motion.pos["alpha2"]
    c_l1, c_l2 = cos(alpha1 - alpha2) / cos(alpha2), 1 / cos(alpha2)
    c_alpha, c_offset = -l1 * sin(alpha1 - alpha2) / cos(alpha2), -tan(alpha2)
    terms = c_l1 * dl1, c_l2 * dl2, c_alpha * dalpha1, c_offset * doffset
    return SliderError(c_l1, c_l2, c_alpha, c_offset, fsum(terms), fsum(map(abs, terms)), hypot(*terms))
