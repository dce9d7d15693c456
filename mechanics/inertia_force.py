"""Inertia force and moment of a rigid body (domain DY-5).

The tensor is about the centre of mass, in the axes in which angular velocity and acceleration are written; it holds
the products of inertia with minus: [[Jx, -Jxy, -Jxz], [-Jxy, Jy, -Jyz], [-Jxz, -Jyz, Jz]].
"""

from __future__ import annotations

from mechanics.vectors import Matrix, Vector, add, cross, scaled, times


def force(mass: float, acceleration: Vector) -> Vector:
    """Find the inertia force -m a_S, in N, from kg and m/s^2."""
    return scaled(-mass, acceleration)


def momentum(tensor: Matrix, omega: Vector) -> Vector:
    """Find the angular momentum K = J omega, in kg m^2/s."""
    return times(tensor, omega)


def moment(tensor: Matrix, omega: Vector, epsilon: Vector) -> Vector:
    """Find the inertia moment -(J epsilon + omega x (J omega)), in N m; in the plane -J_S epsilon is left."""
    return scaled(-1, add(times(tensor, epsilon), cross(omega, momentum(tensor, omega))))
