"""Drives and reactions of a serial chain by Newton-Euler recursion in base axes (domain DY-7).

F_i, N_i: action of link i - 1 on link i, N_i about the origin of the frame whose z is the axis of joint i (O_(i-1) of
a standard table). Gravity is given as the vector g, (0, 0, -9.81) m/s^2 when z points up. Newtons, metres, radians.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics import inertia_force
from mechanics.chain import Chain, Frame, frames, joint_axes, link_motions, turned
from mechanics.dh import Matrix, Vector, check_variables
from mechanics.links import FREE, Drives, LinkMass, LinkMotion, ToolLoad
from mechanics.vectors import ZERO, add, check_vector, cross, dot, scaled, subtract

EARTH: Vector = (0.0, 0.0, -9.81)  # g when z points up, m/s^2


@dataclass(frozen=True, slots=True)
class _Body:
    """A link as the recursion meets it, in base axes."""

    mass: float
    centre: Vector  # m
    arm: Vector  # from the origin of its frame to the centre, m
    inertia: Matrix


def solve(
    chain: Chain,
    masses: Sequence[LinkMass],
    q: Sequence[float],
    qd: Sequence[float],
    qdd: Sequence[float],
    gravity: Vector = EARTH,
    friction: Sequence[float] | None = None,
    tool: ToolLoad = FREE,
) -> Drives:
    """Find what the drives must give for a motion, and the reactions in the joints.

    Args:
        chain: The table, of n rows, standard or modified.
        masses: Mass, centre and inertia of each link, ``(n,)``.
        q: Joint variables, ``(n,)``, radians or metres.
        qd: Their rates, ``(n,)``.
        qdd: Their accelerations, ``(n,)``.
        gravity: The vector g, in m/s^2.
        friction: Viscous coefficient b of each joint, ``(n,)``, in N m s or N s/m; none when left out.
        tool: What the tool exerts on its surroundings, in base axes.

    Returns:
        Torques or forces of the drives; F_i and N_i in base axes.

    Raises:
        ValueError: A vector has another length, or a value is not finite.

    Source:
        Domain DY-7.
    """
    damping = tuple(friction) if friction is not None else (0.0,) * len(chain.rows)
    check_variables(chain.rows, chain.convention, friction=damping)
    bodies = _bodies(chain, masses, q)
    check_vector("gravity", gravity, "m/s^2")
    forces, moments = _actions(chain, bodies, q, link_motions(chain, q, qd, qdd), gravity, tool)
    actions = [N if row.type == "R" else F for row, F, N in zip(chain.rows, forces, moments, strict=True)]
    axes = [axis for axis, _ in joint_axes(chain, q)]
    tau = (dot(action, axis) + b * w for action, axis, b, w in zip(actions, axes, damping, qd, strict=True))
    return Drives(tuple(tau), tuple(forces), tuple(moments))


def _actions(
    chain: Chain,
    bodies: Sequence[_Body],
    q: Sequence[float],
    motions: Sequence[LinkMotion],
    gravity: Vector,
    tool: ToolLoad,
) -> tuple[list[Vector], list[Vector]]:
    """F_i and N_i from the last link to the first."""
    force, moment = tool.force, tool.moment
    behind = frames(chain, q)[-1][9:]
    forces: list[Vector] = []
    moments: list[Vector] = []
    for (_, pivot), body, motion in reversed(list(zip(joint_axes(chain, q), bodies, motions, strict=True))):
        load = scaled(body.mass, subtract(motion.point(body.arm)[1], gravity))
        spin = inertia_force.moment(body.inertia, motion.omega, motion.epsilon)
        moment = add(moment, cross(subtract(behind, pivot), force))
        moment = subtract(add(moment, cross(subtract(body.centre, pivot), load)), spin)
        force = add(force, load)
        forces.insert(0, force)
        moments.insert(0, moment)
        behind = pivot
    return forces, moments


def _bodies(chain: Chain, masses: Sequence[LinkMass], q: Sequence[float]) -> list[_Body]:
    check_variables(chain.rows, chain.convention, q=q)
    if len(masses) != len(chain.rows):
        raise ValueError(f"{len(masses)} masses for {len(chain.rows)} links")
    bodies = []
    for at, link in zip(frames(chain, q), masses, strict=True):
        arm = turned(at, link.centre)
        bodies.append(_Body(link.mass, add(at[9:], arm), arm, _in_base(at, link.inertia)))
    return bodies


def _in_base(at: Frame, tensor: Matrix) -> Matrix:
    """R J R^T, the tensor in base axes."""
    half = [turned(at, (row[0], row[1], row[2])) for row in tensor]  # rows of J R^T
    columns = [turned(at, (x, y, z)) for x, y, z in zip(*half, strict=True)]
    return tuple(zip(*columns, strict=True))


def gravity_torques(
    chain: Chain, masses: Sequence[LinkMass], q: Sequence[float], gravity: Vector = EARTH
) -> list[float]:
    """Find what the drives give to hold the chain still: -sum m g . (d r_S/d q_j).

    Arguments and errors as for `solve`.
    """
    bodies = _bodies(chain, masses, q)
    check_vector("gravity", gravity, "m/s^2")
    held = [0.0] * len(chain.rows)
    axes = joint_axes(chain, q)
    for i, body in enumerate(bodies):
        for j, (slope, _) in enumerate(_slopes(chain, axes[: i + 1], body)):
            held[j] -= body.mass * dot(gravity, slope)
    return held


def mass_matrix(chain: Chain, masses: Sequence[LinkMass], q: Sequence[float]) -> Matrix:
    """Find the matrix M of the kinetic energy q'^T M q'/2, symmetric, ``(n, n)``.

    Args:
        chain: The table, of n rows.
        masses: Mass, centre and inertia of each link, ``(n,)``.
        q: Joint variables, ``(n,)``, radians or metres.

    Returns:
        Entries in kg m^2 (turn, turn), kg m (turn, slide) or kg (slide, slide).

    Raises:
        ValueError: A vector has another length, or a value is not finite.

    Source:
        Koenig: the sum over the links of m v_S . v_S + omega . J omega, with unit rates of the joints.
    """
    n = len(chain.rows)
    found = [[0.0] * n for _ in range(n)]
    axes = joint_axes(chain, q)
    for i, body in enumerate(_bodies(chain, masses, q)):
        slopes = _slopes(chain, axes[: i + 1], body)
        momenta = [(scaled(body.mass, v), inertia_force.momentum(body.inertia, w)) for v, w in slopes]
        for j in range(i + 1):
            for k in range(j + 1):
                found[j][k] += dot(slopes[j][0], momenta[k][0]) + dot(slopes[j][1], momenta[k][1])
                found[k][j] = found[j][k]
    return tuple(tuple(row) for row in found)


def _slopes(chain: Chain, axes: Sequence[tuple[Vector, Vector]], body: _Body) -> list[tuple[Vector, Vector]]:
    """d r_S/d q_j and d phi/d q_j of a link for the joints that move it."""
    return [
        (cross(axis, subtract(body.centre, pivot)), axis) if row.type == "R" else (axis, ZERO)
        for row, (axis, pivot) in zip(chain.rows, axes, strict=False)
    ]
