"""Average shear of bolts, rivets and short blocks (domain SM-6): the stress taken as uniform over the sheared area."""

from __future__ import annotations

from math import ceil, pi

from mechanics.checks import finite, positive

# A count of bolts that exceeds a whole number by less than this part is that number.
_ROUNDING = 1e-9
_MOST = 10**9


def stress(force: float, diameter: float, planes: int = 1, bolts: int = 1) -> float:
    """Return the average shear stress (Pa, with the sign of the force) in round bolts.

    Args:
        force: The force they carry together, N.
        diameter: Of each bolt, m, positive.
        planes: Sections in which each is sheared, at least 1.
        bolts: How many share the force, at least 1.

    Raises:
        ValueError: A value is not finite, not positive or below 1.

    Source:
        Domain SM-6: tau = Q/(i n A).
    """
    finite("shearing force", force, "N")
    positive("bolt diameter d", diameter, "m")
    for name, count in (("shear planes", planes), ("bolts", bolts)):
        if count < 1:
            raise ValueError(f"{count} {name}: there must be at least 1")
    return force / (planes * bolts * pi * diameter * diameter / 4)


def strain(tau: float, G: float) -> float:
    """Return the shear strain gamma = tau/G (rad) for a stress (Pa) and a shear modulus (Pa).

    Raises:
        ValueError: The stress is not finite, or the modulus not positive.
    """
    finite("shear stress tau", tau, "Pa")
    positive("shear modulus G", G, "Pa")
    return tau / G


def shift(tau: float, G: float, height: float) -> float:
    """Return how far one face slides over the other (m): ds = gamma h; tau and G in Pa, height in m.

    Raises:
        ValueError: A value is not finite, or the modulus or the height not positive.
    """
    positive("height h", height, "m")
    return strain(tau, G) * height


def bolts_needed(force: float, diameter: float, tau_allow: float, planes: int = 1) -> int:
    """Return the least number of bolts (diameter in m) to carry a force (N) within the allowable stress (Pa).

    Raises:
        ValueError: A value is not finite, not positive or below 1, or the number is absurd (over a milliard).
    """
    positive("allowable stress tau_allow", tau_allow, "Pa")
    share = abs(stress(force, diameter, planes)) / tau_allow
    if not share <= _MOST:
        raise ValueError(f"the force {force} N would take {share} bolts of {diameter} m")
    return max(1, ceil(share * (1 - _ROUNDING)))


def required_diameter(force: float, tau_allow: float, planes: int = 1, bolts: int = 1) -> float:
    """Return the least diameter (m) of bolts whose stress stays within the allowable one (Pa) under a force (N).

    Raises:
        ValueError: A value is not finite, not positive or below 1.
    """
    positive("allowable stress tau_allow", tau_allow, "Pa")
    return float((abs(stress(force, 1.0, planes, bolts)) / tau_allow) ** 0.5)
