"""Drives and reactions of a serial chain by Newton-Euler recursion in base axes (domain DY-7).

F_i, N_i: action of link i - 1 on link i, N_i about the origin of the frame whose z is the axis of joint i (O_(i-1) of
a standard table). Gravity is given as the vector g, (0, 0, -9.81) m/s^2 when z points up. Newtons, metres, radians.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics import inertia_force
from mechanics.chain import Chain, Frame, frames, joint_axes, link_motions, turned
from mechanics.dh import JointType, check_variables
from mechanics.links import FREE, Drives, LinkMass, LinkMotion, ToolLoad
from mechanics.vectors import ZERO, Matrix, Vector, add, check_vector, cross, dot, scaled, subtract

EARTH: Vector = (0.0, 0.0, -9.81)  # g when z points up, m/s^2


@dataclass(frozen=True, slots=True)
class _Link:
    """A link and the joint before it, in base axes."""

    joint: JointType
    axis: Vector  # along which the joint's variable grows
    pivot: Vector  # a point of that axis, m
    origin: Vector  # of the frame, m
    mass: float
    arm: Vector  # from the origin to the centre of mass, m
    centre: Vector  # m
    inertia: Matrix  # about the centre, kg m^2


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
    check_vector("gravity", gravity, "m/s^2")
    links = _links(chain, masses, q)
    forces, moments = _actions(links, link_motions(chain, q, qd, qdd), gravity, tool)
    tau = (
        dot(N if link.joint == "R" else F, link.axis) + b * w
        for link, F, N, b, w in zip(links, forces, moments, damping, qd, strict=True)
    )
    return Drives(tuple(tau), tuple(forces), tuple(moments))


def _actions(
    links: Sequence[_Link], motions: Sequence[LinkMotion], gravity: Vector, tool: ToolLoad
) -> tuple[list[Vector], list[Vector]]:
    """F_i and N_i from the last link to the first."""
    force, moment, behind = tool.force, tool.moment, links[-1].origin
    forces: list[Vector] = []
    moments: list[Vector] = []
    for link, motion in reversed(list(zip(links, motions, strict=True))):
        load = scaled(link.mass, subtract(motion.point(link.arm)[1], gravity))
        spin = inertia_force.moment(link.inertia, motion.omega, motion.epsilon)
        moment = add(moment, cross(subtract(behind, link.pivot), force))
        moment = subtract(add(moment, cross(subtract(link.centre, link.pivot), load)), spin)
        force, behind = add(force, load), link.pivot
        forces.append(force)
        moments.append(moment)
    return forces[::-1], moments[::-1]


def _links(chain: Chain, masses: Sequence[LinkMass], q: Sequence[float]) -> list[_Link]:
    check_variables(chain.rows, chain.convention, q=q)
    if len(masses) != len(chain.rows):
        raise ValueError(f"{len(masses)} masses for {len(chain.rows)} links")
    links = []
    for row, link, at, (axis, pivot) in zip(chain.rows, masses, frames(chain, q), joint_axes(chain, q), strict=True):
        arm, origin = turned(at, link.centre), at[9:]
        inertia = _in_base(at, link.inertia)
        links.append(_Link(row.type, axis, pivot, origin, link.mass, arm, add(origin, arm), inertia))
    return links


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
    check_vector("gravity", gravity, "m/s^2")
    links = _links(chain, masses, q)
    held = [0.0] * len(links)
    for i, link in enumerate(links):
        for j, (slope, _) in enumerate(_slopes(links[: i + 1])):
            held[j] -= link.mass * dot(gravity, slope)
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
    links = _links(chain, masses, q)
    found = [[0.0] * len(links) for _ in links]
    for i, link in enumerate(links):
        slopes = _slopes(links[: i + 1])
        momenta = [(scaled(link.mass, v), inertia_force.momentum(link.inertia, w)) for v, w in slopes]
        for j in range(i + 1):
            for k in range(j + 1):
                found[j][k] += dot(slopes[j][0], momenta[k][0]) + dot(slopes[j][1], momenta[k][1])
                found[k][j] = found[j][k]
    return tuple(tuple(row) for row in found)


def _slopes(links: Sequence[_Link]) -> list[tuple[Vector, Vector]]:
    """d r_S/d q_j and d phi/d q_j of the last of the links, for each joint before it."""
    centre = links[-1].centre
    return [
        (cross(link.axis, subtract(centre, link.pivot)), link.axis) if link.joint == "R" else (link.axis, ZERO)
        for link in links
    ]
