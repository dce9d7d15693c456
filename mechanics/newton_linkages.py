"""Named linkages as bodies, joints and a driver for Newton's method: the independent way to check closed forms."""

from __future__ import annotations

from math import atan2, cos, hypot, pi, sin
from typing import Literal

from mechanics.checks import finite, positive
from mechanics.errors import AssemblyError
from mechanics.planar import Driver, Joint, Marker, Motion, Pose, Revolute, solve

GUESSES = (0.9, 0.3, 1.6, 2.2, 2.8, 0.05)  # angles of the coupler from BD from which Newton's method is started


def four_bar_motion(
    l1: float,
    l2: float,
    l3: float,
    l4: float,
    alpha1: float,
    omega1: float,
    eps1: float = 0.0,
    mode: Literal["C_left_of_BD", "C_right_of_BD"] = "C_left_of_BD",
) -> Motion:
    """Move a four-bar linkage (domain VP-4): 1 crank from A, 2 coupler from B, 3 rocker from D.

    Args:
        l1: Crank length, in metres.
        l2: Coupler length, in metres.
        l3: Rocker length, in metres.
        l4: Distance of the frame pivots A = (0, 0) and D = (l4, 0), in metres.
        alpha1: Crank angle from +X, in radians.
        omega1: Crank angular velocity, in rad/s.
        eps1: Crank angular acceleration, in rad/s^2.
        mode: On which side of the way from B to D the joint C lies.

    Returns:
        The motion of all bodies.

    Raises:
        ValueError: A length is not positive and finite, another value not finite, or the mode unknown.
        AssemblyError: No guess closes in this assembly.
        SingularError: Coupler and rocker are in line.
    """
    for name, length in (("crank l1", l1), ("coupler l2", l2), ("rocker l3", l3), ("frame l4", l4)):
        positive(name, length, "m")
    for name, value, unit in (("alpha1", alpha1, "rad"), ("omega1", omega1, "rad/s"), ("eps1", eps1, "rad/s^2")):
        finite(name, value, unit)
    if mode not in ("C_left_of_BD", "C_right_of_BD"):
        raise ValueError(f"mode must be C_left_of_BD or C_right_of_BD, not {mode!r}")
    crank, coupler, rocker = Marker(1), Marker(2), Marker(3)
    joints: list[Joint] = [
        Revolute(Marker(0), crank),
        Revolute(Marker(1, l1), coupler),
        Revolute(Marker(0, l4), rocker),
        Revolute(Marker(2, l2), Marker(3, l3)),
        Driver("turn", Marker(0), crank, alpha1, omega1, eps1),
    ]
    side = 1.0 if mode == "C_left_of_BD" else -1.0
    pin = (l1 * cos(alpha1), l1 * sin(alpha1))
    failed = AssemblyError("coupler and rocker do not meet in this assembly")
    for guess in GUESSES:
        try:
            motion = solve(joints, _start(pin, alpha1, l2, l4, side * guess))
        except AssemblyError as error:
            failed = error
            continue
        if side * _left_of_diagonal(motion, pin, l2, l4) > 0:
            return motion
    raise failed


def _start(pin: tuple[float, float], alpha1: float, l2: float, l4: float, turn: float) -> list[Pose]:
    """Turn the coupler from BD; the rocker points from D to its end."""
    coupler = atan2(-pin[1], l4 - pin[0]) + turn
    end = (pin[0] + l2 * cos(coupler), pin[1] + l2 * sin(coupler))
    rocker = atan2(end[1], end[0] - l4) if hypot(end[0] - l4, end[1]) else pi / 2
    return [(0.0, 0.0, alpha1), (*pin, coupler), (l4, 0.0, rocker)]


def _left_of_diagonal(motion: Motion, pin: tuple[float, float], l2: float, l4: float) -> float:
    (cx, cy), _, _ = motion.point(Marker(2, l2))
    return (l4 - pin[0]) * (cy - pin[1]) + pin[1] * (cx - pin[0])
