"""Torsion of stepped round shafts: torques, stresses, twists, sizes (domain SM-7 to SM-10).

Axis x from the left end. External torques positive about +x; the torque T in a section is the sum of the external
torques to its right, the reaction included; twist phi positive about +x, d(phi)/dx = T/(G J_p).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from math import fsum, pi

from mechanics.checks import finite, in_range, positive
from mechanics.errors import UnbalancedError
from mechanics.members import Segment, Shaft, Torque
from mechanics.section import Ring

__all__ = [
    "Design",
    "Piece",
    "Segment",
    "Shaft",
    "ShaftReactions",
    "ShaftResult",
    "Torque",
    "Turn",
    "required_diameter_stiffness",
    "required_diameter_strength",
    "solve",
]

# A free shaft is in balance when its torques cancel to this part of the largest.
_BALANCED = 1e-9


@dataclass(frozen=True, slots=True)
class ShaftReactions:
    """What the supports do to the shaft; zero at a free end."""

    left: float  # about +x, N m
    right: float  # about +x, N m


@dataclass(frozen=True, slots=True)
class Piece:
    """A stretch of one diameter and one torque."""

    x1: float  # start, m
    x2: float  # end, m
    D: float  # outer diameter, m
    d: float  # bore, m
    T: float  # torque, N m
    tau_max: float  # magnitude of the stress at the surface, Pa
    twist: float  # of the end against the start, rad
    twist_per_m: float  # rad/m


@dataclass(frozen=True, slots=True)
class Turn:
    """The rotation of a section."""

    x: float  # place, m
    phi: float  # about +x, rad


@dataclass(frozen=True, slots=True)
class Design:
    """Least outer diameters of a uniform shaft for the same torques; None where no limit is given."""

    D_strength: float | None  # m
    D_stiffness: float | None  # m
    D_required: float  # the larger, m


@dataclass(frozen=True, slots=True)
class ShaftResult:
    """The solved shaft."""

    reactions: ShaftReactions
    pieces: tuple[Piece, ...]  # cut at the ends of segments and at torques
    phi: tuple[Turn, ...]  # at the ends of pieces; zero at a fixed end, at the left end of a free shaft
    T_abs_max: float  # N m
    tau_abs_max: float  # Pa
    design: Design | None  # None where no limit is given


def solve(shaft: Shaft) -> ShaftResult:
    """Solve a stepped shaft, fixed at one end, at both or at none.

    Raises:
        UnbalancedError: The torques of a shaft free at both ends do not cancel.
        ValueError: The answer is beyond the range of floating-point numbers.

    Source:
        Domain SM-7, SM-8, SM-10: tau = T/W_p, twist = T l/(G J_p); fixed at both ends: the twists add up to zero.
    """
    places = sorted({*shaft.ends, *(torque.x for torque in shaft.torques)})
    rings = _rings(shaft, places)
    twists = [
        (right - left) / (shaft.G * ring.torsion_constant)
        for (left, right), ring in zip(pairwise(places), rings, strict=True)
    ]
    reactions, torques = _torques(shaft, places, twists)
    pieces = tuple(map(_piece, pairwise(places), rings, torques, twists))
    phi = _rotations(shaft, places, [piece.twist for piece in pieces])
    in_range(sum([turn.phi for turn in phi]) + sum([piece.tau_max for piece in pieces]))
    return ShaftResult(
        reactions,
        pieces,
        phi,
        max([abs(piece.T) for piece in pieces]),
        max([piece.tau_max for piece in pieces]),
        _design(shaft, places, torques),
    )


def _rings(shaft: Shaft, places: Sequence[float]) -> list[Ring]:
    found = []
    index = 0
    for right in places[1:]:
        segment = shaft.segments[index]
        found.append(Ring(segment.D, segment.d))
        positive("torsional stiffness G J_p", shaft.G * found[-1].torsion_constant, "N m^2")
        index += right >= shaft.ends[index + 1]
    return found


def _torques(shaft: Shaft, places: Sequence[float], twists: Sequence[float]) -> tuple[ShaftReactions, list[float]]:
    """Reactions, and the torque between neighbouring places; `twists` are those of a unit torque."""
    total = fsum(torque.T for torque in shaft.torques)
    outer = [fsum(torque.T for torque in shaft.torques if torque.x > x) for x in places[:-1]]
    if shaft.support == "free_free":
        _require_balance(shaft, total)
        return ShaftReactions(0.0, 0.0), outer
    right = 0.0
    if shaft.support == "free_fixed":
        right = -total
    elif shaft.support == "fixed_fixed":
        right = -fsum(T * twist for T, twist in zip(outer, twists, strict=True)) / fsum(twists)
    left = 0.0 if shaft.support == "free_fixed" else -total - right
    return ShaftReactions(left, right), [T + right for T in outer]


def _require_balance(shaft: Shaft, total: float) -> None:
    largest = max((abs(torque.T) for torque in shaft.torques), default=0.0)
    if abs(total) > _BALANCED * largest:
        raise UnbalancedError(f"the torques of a free shaft must cancel, their sum is {total} N m")


def _piece(ends: tuple[float, float], ring: Ring, T: float, unit_twist: float) -> Piece:
    x1, x2 = ends
    twist = T * unit_twist
    return Piece(x1, x2, ring.D, ring.d, T, abs(T) / ring.torsion_modulus, twist, twist / (x2 - x1))


def _rotations(shaft: Shaft, places: Sequence[float], twists: Sequence[float]) -> tuple[Turn, ...]:
    if shaft.support == "free_fixed":
        turns = [-phi for phi in accumulate(reversed(twists), initial=0.0)][::-1]
    else:
        turns = list(accumulate(twists, initial=0.0))
    return tuple(map(Turn, places, turns))


def _design(shaft: Shaft, places: Sequence[float], torques: Sequence[float]) -> Design | None:
    """Size the uniform shaft; fixed at both ends it shares the torques by lengths alone."""
    tau, theta = shaft.tau_allow, shaft.theta_allow_rad_per_m
    if tau is None and theta is None:
        return None
    if shaft.support == "fixed_fixed":
        _, torques = _torques(shaft, places, [right - left for left, right in pairwise(places)])
    T = max(map(abs, torques))
    strength = None if tau is None else required_diameter_strength(T, tau, shaft.design_bore_ratio)
    stiffness = None if theta is None else required_diameter_stiffness(T, shaft.G, theta, shaft.design_bore_ratio)
    return Design(strength, stiffness, max(strength or 0.0, stiffness or 0.0))


def required_diameter_strength(torque: float, tau_allow: float, bore_ratio: float = 0.0) -> float:
    """Return the least outer diameter (m) whose stress stays within the allowable one.

    Args:
        torque: Largest torque, N m, of either sign.
        tau_allow: Allowable shear stress, Pa, positive.
        bore_ratio: Bore over outer diameter, at least 0 and below 1.

    Raises:
        ValueError: A value is not finite, not positive or out of its range.

    Source:
        Domain SM-9: D^3 = 16 T/(pi tau_allow (1 - ratio^4)).
    """
    positive("allowable stress tau_allow", tau_allow, "Pa")
    return float((16 * abs(torque) / (pi * tau_allow * _full(torque, bore_ratio))) ** (1 / 3))


def required_diameter_stiffness(torque: float, G: float, theta_allow: float, bore_ratio: float = 0.0) -> float:
    """Return the least outer diameter (m) whose twist per metre stays within the allowable one.

    Args:
        torque: Largest torque, N m, of either sign.
        G: Shear modulus, Pa, positive.
        theta_allow: Allowable twist, rad/m, positive.
        bore_ratio: Bore over outer diameter, at least 0 and below 1.

    Raises:
        ValueError: A value is not finite, not positive or out of its range.

    Source:
        Domain SM-9: D^4 = 32 T/(pi G theta_allow (1 - ratio^4)).
    """
    positive("shear modulus G", G, "Pa")
    positive("allowable twist theta_allow", theta_allow, "rad/m")
    return float((32 * abs(torque) / (pi * G * theta_allow * _full(torque, bore_ratio))) ** (1 / 4))


def _full(torque: float, ratio: float) -> float:
    """The part of a full section's J_p that a bore leaves."""
    finite("torque", torque, "N m")
    if not 0 <= ratio < 1:
        raise ValueError(f"bore ratio {ratio} must be at least 0 and below 1")
    return (1 - ratio) * (1 + ratio) * (1 + ratio * ratio)
