"""Drives of a serial chain by Lagrange's equations in the matrices U and V: the independent way to Newton-Euler.

With the matrix H_i of second moments of link i (of r r^T dm, r = (x, y, z, 1) in its frame) the kinetic energy is
sum tr(T_i' H_i T_i'^T)/2, so that tau_j = sum_i tr(U_ij H_i T_i''^T) - m_i g . U_ij r_S (domain DH-6, DH-7).
"""

from __future__ import annotations

from collections.abc import Sequence

from mechanics.dh import Convention, Row, check_variables
from mechanics.links import LinkMass
from mechanics.transform import acceleration_matrix, moved_point, product, total, velocity_matrix
from mechanics.vectors import Matrix, Vector


def second_moments(link: LinkMass) -> Matrix:
    """Integrate r r^T dm over a link, r = (x, y, z, 1) in its frame, ``(4, 4)``, from the tensor and the centre."""
    half = sum(link.inertia[i][i] for i in range(3)) / 2
    m, c = link.mass, link.centre
    inner = [[(half if i == j else 0.0) - link.inertia[i][j] + m * c[i] * c[j] for j in range(3)] for i in range(3)]
    return (*((*row, m * x) for row, x in zip(inner, c, strict=True)), (*(m * x for x in c), m))


def torques(
    rows: Sequence[Row],
    masses: Sequence[LinkMass],
    q: Sequence[float],
    qd: Sequence[float],
    qdd: Sequence[float],
    gravity: Vector,
    convention: Convention = "standard",
) -> list[float]:
    """Find what the drives give, ``(n,)``; arguments and errors as for `newton_euler.solve`."""
    check_variables(rows, convention, q=q, qd=qd, qdd=qdd)
    n = len(rows)
    found = [0.0] * n
    for i, link in enumerate(masses, start=1):
        joints = range(1, i + 1)
        U = [velocity_matrix(rows, q, i, j, convention) for j in joints]
        V = [acceleration_matrix(rows, q, i, j, k, convention) for j in joints for k in joints]
        second = total(U + V, [*qdd[:i], *(x * y for x in qd[:i] for y in qd[:i])])
        for j, slope in enumerate(U):
            weight = sum(g * r for g, r in zip(gravity, moved_point(slope, link.centre), strict=True))
            found[j] += _trace(slope, second_moments(link), second) - link.mass * weight
    return found


def mass_matrix(
    rows: Sequence[Row], masses: Sequence[LinkMass], q: Sequence[float], convention: Convention = "standard"
) -> Matrix:
    """Find M_jk = sum_i tr(U_ij H_i U_ik^T), ``(n, n)``; arguments and errors as for `newton_euler.mass_matrix`."""
    n = len(rows)
    found = [[0.0] * n for _ in range(n)]
    for i, link in enumerate(masses, start=1):
        U = [velocity_matrix(rows, q, i, j, convention) for j in range(1, i + 1)]
        for j in range(i):
            for k in range(i):
                found[j][k] += _trace(U[j], second_moments(link), U[k])
    return tuple(tuple(row) for row in found)


def _trace(left: Matrix, moments: Matrix, right: Matrix) -> float:
    """tr(left moments right^T)."""
    rows = zip(product(left, moments), right, strict=True)
    return sum(x * y for row, other in rows for x, y in zip(row, other, strict=True))
