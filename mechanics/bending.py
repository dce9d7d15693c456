"""Stress, curvature and size of a section in pure bending (domain SM-12).

M > 0 sags; heights y are counted up from the neutral axis, so a sagging moment presses the upper fibres: the stress is
positive in tension, sigma = -M y/I.
"""

from __future__ import annotations

from math import inf, pi

from mechanics.checks import finite, positive
from mechanics.section import Section


def normal_stress(M: float, y: float, section: Section) -> float:
    """Return the bending stress (Pa, tension positive) at a height y (m, up) under a moment M (N m).

    Raises:
        ValueError: A value is not finite.
    """
    finite("bending moment M", M, "N m")
    finite("height y", y, "m")
    return -M * y / section.second_moment


def curvature_radius(M: float, stiffness: float) -> float:
    """Return the radius of curvature EI/M (m), with the sign of M; infinite without a moment.

    Raises:
        ValueError: The moment is not finite, or the bending stiffness E I (N m^2) not positive.
    """
    finite("bending moment M", M, "N m")
    positive("bending stiffness E I", stiffness, "N m^2")
    return stiffness / M if M else inf


def required_modulus(M: float, sigma_allow: float) -> float:
    """Return the least section modulus (m^3) whose stress stays within the allowable one.

    Args:
        M: Largest bending moment, N m, of either sign.
        sigma_allow: Allowable stress, Pa, positive.

    Raises:
        ValueError: A value is not finite, or the stress not positive.

    Source:
        Domain SM-12: W = |M|/sigma.
    """
    finite("bending moment M", M, "N m")
    positive("allowable stress sigma_allow", sigma_allow, "Pa")
    return abs(M) / sigma_allow


def required_diameter(M: float, sigma_allow: float, bore_ratio: float = 0.0) -> float:
    """Return the least outer diameter (m) of a round section, with a bore in a given ratio to it.

    Args:
        M: Bending moment, in N m; its sign does not matter.
        sigma_allow: Allowable stress, in Pa.
        bore_ratio: Inner over outer diameter, from 0 to below 1.

    Raises:
        ValueError: A value is not finite, not positive or out of its range.

    Source:
        Domain SM-12: W = pi D^3 (1 - ratio^4)/32.
    """
    if not 0 <= bore_ratio < 1:
        raise ValueError(f"bore ratio {bore_ratio} must be at least 0 and below 1")
    left = (1 - bore_ratio) * (1 + bore_ratio) * (1 + bore_ratio * bore_ratio)
    return float((32 * required_modulus(M, sigma_allow) / (pi * left)) ** (1 / 3))


def required_height(M: float, sigma_allow: float, width_ratio: float) -> float:
    """Return the least height h (m) of a rectangle whose width is a given part of it; M in N m, stress in Pa.

    Raises:
        ValueError: A value is not finite, or the stress or the ratio not positive.

    Source:
        Domain SM-12: W = b h^2/6 with b = ratio h.
    """
    positive("width over height", width_ratio, "")
    return float((6 * required_modulus(M, sigma_allow) / width_ratio) ** (1 / 3))
