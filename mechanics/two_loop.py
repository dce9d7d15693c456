"""Four-bar whose rocker end moves a slider by a bar: two loops, two groups of class II, in closed form (domain VP-5).

The four-bar as in `mechanics.four_bar`; bar l5 from the rocker end C to a slider on y = h6. Closure of the second
loop: l4 + l3 e(alpha3) + l5 e(alpha5) = s6 + i h6.
"""

from __future__ import annotations

from math import cos, sin

from mechanics import four_bar, slider_crank
from mechanics.checks import finite, in_range, positive
from mechanics.linkage import LinkageMotion, Singular


def solve(
    l1: float,
    l2: float,
    l3: float,
    l4: float,
    l5: float,
    h6: float,
    alpha1: float,
    omega1: float = 0.0,
    epsilon1: float = 0.0,
    mode: four_bar.Mode = "C_left_of_BD",
    branch: slider_crank.Branch = "slider_right",
) -> LinkageMotion:
    """Solve position, velocity and acceleration, group after group.

    Args:
        l1: Crank length, in metres, positive.
        l2: Coupler length, in metres, positive.
        l3: Rocker length, in metres, positive.
        l4: Distance of the frame pivots A = (0, 0) and D = (l4, 0), in metres, positive.
        l5: Bar from the rocker end C to the slider, in metres, positive.
        h6: Ordinate of the slider's guide, in metres.
        alpha1: Crank angle, in radians.
        omega1: Crank angular velocity, in rad/s.
        epsilon1: Crank angular acceleration, in rad/s^2.
        mode: The assembly of the four-bar, as for `four_bar.position`.
        branch: The assembly of the slider, as for `slider_crank.position`.

    Returns:
        ``alpha2``, ``alpha3``, ``alpha5``, ``s6`` and their rates; the measure is the smaller of the two groups, with
        its name.

    Raises:
        ValueError: A length is not positive and finite, another value not finite, or a mode or branch unknown.
        AssemblyError: One of the groups cannot close; the message has the gap.
        SingularError: Coupler and rocker are in line, or the bar is perpendicular to the guide.

    Source:
        Domain VP-5: the rocker is the crank of a slider-crank with its pivot at D.
    """
    positive("bar l5", l5, "m")
    finite("h6", h6, "m")
    alpha2, alpha3, omega2, omega3, epsilon2, epsilon3 = four_bar.motion(l1, l2, l3, l4, alpha1, omega1, epsilon1, mode)
    in_range(alpha3 + omega3 + epsilon3)
    alpha5, s6, omega5, v6, epsilon5, p6 = slider_crank.motion(l3, l5, alpha3, omega3, epsilon3, h6, branch)
    first = Singular(abs(sin(alpha3 - alpha2)), four_bar.DEAD_NAME)
    return LinkageMotion(
        {"alpha2": alpha2, "alpha3": alpha3, "alpha5": alpha5, "s6": l4 + s6},
        {"alpha2": omega2, "alpha3": omega3, "alpha5": omega5, "s6": v6},
        {"alpha2": epsilon2, "alpha3": epsilon3, "alpha5": epsilon5, "s6": p6},
        min(first, Singular(abs(cos(alpha5)), "bar 5 perpendicular to the guide")),
    )
