"""Inertia force and moment of a rigid body (domain DY-5), and of point masses together (BV-1).

The tensor is about the centre of mass, in the axes in which angular velocity and acceleration are written; it holds
the products of inertia with minus: [[Jx, -Jxy, -Jxz], [-Jxy, Jy, -Jyz], [-Jxz, -Jyz, Jz]].
"""

from __future__ import annotations

from collections.abc import Sequence

from mechanics.checks import finite
from mechanics.vectors import ZERO, Matrix, Vector, add, check_vector, cross, scaled, times


def force(mass: float, acceleration: Vector) -> Vector:
    """Find the inertia force -m a_S, in N, from kg and m/s^2."""
    return scaled(-mass, acceleration)


def momentum(tensor: Matrix, omega: Vector) -> Vector:
    """Find the angular momentum K = J omega, in kg m^2/s."""
    return times(tensor, omega)


def moment(tensor: Matrix, omega: Vector, epsilon: Vector) -> Vector:
    """Find the inertia moment -(J epsilon + omega x (J omega)), in N m; in the plane -J_S epsilon is left."""
    return scaled(-1, add(times(tensor, epsilon), cross(omega, momentum(tensor, omega))))


def of_point_masses(
    masses: Sequence[float], places: Sequence[Vector], accelerations: Sequence[Vector]
) -> tuple[Vector, Vector]:
    """Find main vector and main moment about the origin of the inertia forces of point masses.

    Args:
        masses: m_k, in kilograms.
        places: r_k, in metres.
        accelerations: a_k, in m/s^2.

    Returns:
        P = -sum m_k a_k (N) and M_O = sum r_k x (-m_k a_k) (N m).

    Raises:
        ValueError: There are not as many places and accelerations as masses, or a number is not finite.

    Source:
        Domain BV-1.
    """
    if not len(masses) == len(places) == len(accelerations):
        raise ValueError(f"{len(masses)} masses, {len(places)} places and {len(accelerations)} accelerations")
    main, about_origin = ZERO, ZERO
    for m, place, a in zip(masses, places, accelerations, strict=True):
        finite("mass", m, "kg")
        check_vector("place", place, "m")
        check_vector("acceleration", a, "m/s^2")
        main = add(main, force(m, a))
        about_origin = add(about_origin, cross(place, force(m, a)))
    return main, about_origin
