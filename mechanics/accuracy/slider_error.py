"""Position error of the slider of a slider-crank from small errors of its links and its crank angle (domain AC-5).

An error is real minus programmed, in radians or metres.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, fsum, hypot, sin, tan

from mechanics.checks import finite
from mechanics.linkages import slider_crank
from mechanics.linkages.slider_crank import Branch


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
