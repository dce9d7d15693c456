"""Six-bar linkage: a four-bar and a dyad hung between a point of its coupler and the frame, in closed form.

The four-bar as in `mechanics.four_bar`; then P + l5 e(alpha5) = Q and G + l6 e(alpha6) = Q, with G the frame pivot of
the dyad (domain VP-4, STR-8: both groups are of class II).
"""

from __future__ import annotations

from math import atan2
from typing import Literal, get_args

from mechanics import dyad, four_bar
from mechanics.checks import finite, positive
from mechanics.linkage import LinkageMotion, Singular, principal

DyadMode = Literal["Q_left_of_PG", "Q_right_of_PG"]

NAMES = dyad.Names("P", "G", "link l5", "link l6")
DEAD_NAME = "links 5 and 6 in line"


def solve(
    l1: float,
    l2: float,
    l3: float,
    l4: float,
    alpha1: float,
    dyad_pivot: tuple[float, float],
    l5: float,
    l6: float,
    omega1: float = 0.0,
    epsilon1: float = 0.0,
    mode: four_bar.Mode = "C_left_of_BD",
    coupler_point: tuple[float, float] = (0.0, 0.0),
    dyad_mode: DyadMode = "Q_left_of_PG",
) -> LinkageMotion:
    """Solve position, velocity and acceleration of all links.

    Args:
        l1, l2, l3, l4, alpha1, omega1, epsilon1, mode, coupler_point: The four-bar, as for `four_bar.solve`.
        dyad_pivot: The frame pivot G of the dyad, in metres.
        l5: Link PQ, in metres, positive.
        l6: Link GQ, in metres, positive.
        dyad_mode: On which side of the way from P to G the joint Q lies.

    Returns:
        What `four_bar.solve` gives, and ``alpha5``, ``alpha6``, ``Q_x``, ``Q_y``; the measure is the smaller of the
        two groups, with its name.

    Raises:
        ValueError: A length is not positive and finite, another value not finite, or a mode unknown.
        AssemblyError: One of the groups cannot meet; the message has the gap.
        SingularError: The two links of one of the groups are in line, or of one length over a single point.
    """
    _check(dyad_pivot, l5, l6, dyad_mode)
    base = four_bar.solve(l1, l2, l3, l4, alpha1, omega1, epsilon1, mode, coupler_point)
    dx, dy = dyad_pivot[0] - base.pos["P_x"], dyad_pivot[1] - base.pos["P_y"]
    at = dyad.vectors(dx, dy, l5, l6, dyad_mode == "Q_left_of_PG", NAMES)
    measure = dyad.measure(at[4], l5, l6, f"{DEAD_NAME} at {alpha1:g} rad")
    return _with_dyad(base, dyad_pivot, at, measure)


def _with_dyad(base: LinkageMotion, pivot: tuple[float, float], at: dyad.Vectors, measure: float) -> LinkageMotion:
    """Add the rates of the dyad to the motion of the four-bar, and Q as the end of link 6."""
    x5, y5, x6, y6, _ = at
    velocity, acceleration = (-base.vel["P_x"], -base.vel["P_y"]), (-base.acc["P_x"], -base.acc["P_y"])
    omega5, omega6, epsilon5, epsilon6 = dyad.rates(at, velocity, acceleration)
    angles = {"alpha5": principal(atan2(y5, x5)), "alpha6": principal(atan2(y6, x6))}
    square = omega6 * omega6
    return LinkageMotion(
        {**base.pos, **angles, "Q_x": pivot[0] + x6, "Q_y": pivot[1] + y6},
        {**base.vel, "alpha5": omega5, "alpha6": omega6, "Q_x": -omega6 * y6, "Q_y": omega6 * x6},
        {
            **base.acc,
            "alpha5": epsilon5,
            "alpha6": epsilon6,
            "Q_x": -epsilon6 * y6 - square * x6,
            "Q_y": epsilon6 * x6 - square * y6,
        },
        min(base.singular, Singular(measure, DEAD_NAME)),
    )


def _check(pivot: tuple[float, float], l5: float, l6: float, mode: str) -> None:
    positive("link l5", l5, "m")
    positive("link l6", l6, "m")
    finite("dyad pivot x", pivot[0], "m")
    finite("dyad pivot y", pivot[1], "m")
    if mode not in get_args(DyadMode):
        raise ValueError(f"dyad_mode must be {' or '.join(get_args(DyadMode))}, not {mode!r}")
