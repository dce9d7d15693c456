"""Recursion in the frames of the links: motion and Newton-Euler drives (domain DH-9, DY-8).

Every vector of link i is given by its components in frame i, where z*, s*, J* and, behind a turn, r* are constant. A is
the pair matrix of joint i: its rotation carries components of frame i to frame i - 1, its transpose back.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.chain import pair_matrix
from mechanics.dh import Convention, Row, check_variables
from mechanics.links import FREE, REST, Drives, LinkMass, LinkMotion, ToolLoad, next_motion
from mechanics.vectors import ZERO, Matrix, Vector, add, back, check_vector, cross, dot, scaled, times


@dataclass(frozen=True, slots=True)
class _Pair:
    """Joint i seen from link i."""

    A: Matrix
    axis: Vector  # z* along which the variable grows
    shift: Vector  # r*, from O_(i-1) to O_i, m


def _pairs(rows: Sequence[Row], q: Sequence[float], convention: Convention) -> list[_Pair]:
    found = []
    for row, variable in zip(rows, q, strict=True):
        theta, d = row.moved(variable)
        A = pair_matrix(theta, d, row.a, row.alpha, convention)
        along = back(A, (0.0, 0.0, 1.0)) if convention == "standard" else (0.0, 0.0, 1.0)
        found.append(_Pair(A, scaled(row.sign, along), back(A, (A[0][3], A[1][3], A[2][3]))))
    return found


def motions(
    rows: Sequence[Row],
    q: Sequence[float],
    qd: Sequence[float],
    qdd: Sequence[float],
    convention: Convention = "standard",
) -> list[LinkMotion]:
    """Find the motion of every link in its own axes, from the first to the last.

    Args:
        rows: The table, of n rows.
        q: Joint variables, ``(n,)``, radians or metres.
        qd: Their rates, ``(n,)``.
        qdd: Their accelerations, ``(n,)``.
        convention: "standard" or "modified".

    Raises:
        ValueError: A vector has another length, or a value is not finite.

    Source:
        Domain DH-9.
    """
    check_variables(rows, convention, q=q, qd=qd, qdd=qdd)
    return _motions(rows, _pairs(rows, q, convention), qd, qdd, convention, REST)


def _motions(
    rows: Sequence[Row],
    pairs: Sequence[_Pair],
    qd: Sequence[float],
    qdd: Sequence[float],
    convention: Convention,
    motion: LinkMotion,
) -> list[LinkMotion]:
    found = []
    for row, pair, w, e in zip(rows, pairs, qd, qdd, strict=True):
        A = pair.A
        seen = LinkMotion(back(A, motion.omega), back(A, motion.epsilon), back(A, motion.v), back(A, motion.a))
        motion = next_motion(seen, row.type, convention, pair.shift, scaled(w, pair.axis), scaled(e, pair.axis))
        found.append(motion)
    return found


def drives(
    rows: Sequence[Row],
    masses: Sequence[LinkMass],
    q: Sequence[float],
    qd: Sequence[float],
    qdd: Sequence[float],
    gravity: Vector,
    friction: Sequence[float] | None = None,
    tool: ToolLoad = FREE,
) -> Drives:
    """Find the drives of a standard chain by the recursion in link frames; the base rises with -g instead of weights.

    Args:
        rows: The table, of n rows.
        masses: Mass, centre and inertia of each link, ``(n,)``.
        q: Joint variables, ``(n,)``, radians or metres.
        qd: Their rates, ``(n,)``.
        qdd: Their accelerations, ``(n,)``.
        gravity: The vector g in base axes, in m/s^2.
        friction: Viscous coefficient b of each joint, ``(n,)``, in N m s or N s/m; none when left out.
        tool: What the tool exerts on its surroundings, in the axes of the last frame.

    Returns:
        Torques or forces of the drives; F_i and N_i in the axes of frame i.

    Raises:
        ValueError: A vector has another length, or a value is not finite.

    Source:
        Domain DY-8.
    """
    damping = tuple(friction) if friction is not None else (0.0,) * len(rows)
    check_variables(rows, "standard", q=q, qd=qd, qdd=qdd, friction=damping)
    check_vector("gravity", gravity, "m/s^2")
    if len(masses) != len(rows):
        raise ValueError(f"{len(masses)} masses for {len(rows)} links")
    pairs = _pairs(rows, q, "standard")
    rising = LinkMotion(ZERO, ZERO, ZERO, scaled(-1, gravity))
    forces, moments = _actions(pairs, masses, _motions(rows, pairs, qd, qdd, "standard", rising), tool)
    actions = [N if row.type == "R" else F for row, F, N in zip(rows, forces, moments, strict=True)]
    tau = (dot(action, p.axis) + b * w for action, p, b, w in zip(actions, pairs, damping, qd, strict=True))
    return Drives(tuple(tau), tuple(forces), tuple(moments))


def _actions(
    pairs: Sequence[_Pair], masses: Sequence[LinkMass], found: Sequence[LinkMotion], tool: ToolLoad
) -> tuple[list[Vector], list[Vector]]:
    """F_i = R F_(i+1) + Q_i; N_i = R N_(i+1) + r* x R F_(i+1) + (r* + s*) x Q_i + J* eps + omega x (J* omega)."""
    F, N = tool.force, tool.moment  # already in the axes of the last frame
    forces: list[Vector] = []
    moments: list[Vector] = []
    for pair, link, motion in reversed(list(zip(pairs, masses, found, strict=True))):
        omega = motion.omega
        Q = scaled(link.mass, motion.point(link.centre)[1])
        N = add(N, add(cross(pair.shift, F), cross(add(pair.shift, link.centre), Q)))
        N = add(N, add(times(link.inertia, motion.epsilon), cross(omega, times(link.inertia, omega))))
        F = add(F, Q)
        forces.append(F)
        moments.append(N)
        F, N = times(pair.A, F), times(pair.A, N)
    return forces[::-1], moments[::-1]
