"""Named linkages as bodies, joints and a driver for Newton's method: the independent way to check closed forms
(domain VP-1)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import atan2, cos, hypot, pi, sin
from typing import Literal

from mechanics.checks import finite, positive
from mechanics.errors import AssemblyError
from mechanics.planar import Driver, Joint, Marker, Motion, Pose, Prismatic, Revolute, solve

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
    _driver(alpha1, omega1, eps1)
    if mode not in ("C_left_of_BD", "C_right_of_BD"):
        raise ValueError(f"mode must be C_left_of_BD or C_right_of_BD, not {mode!r}")
    joints = four_bar_joints(l1, l2, l3, l4, alpha1, omega1, eps1)
    side = 1.0 if mode == "C_left_of_BD" else -1.0
    pin = (l1 * cos(alpha1), l1 * sin(alpha1))
    starts = [_start(pin, alpha1, l2, l4, side * guess) for guess in GUESSES]
    return _first(joints, starts, lambda motion: side * _left_of_diagonal(motion, pin, l2, l4) > 0)


def four_bar_joints(
    l1: float, l2: float, l3: float, l4: float, alpha1: float, omega1: float, eps1: float
) -> list[Joint]:
    """Give joints and driver of a four-bar linkage; bodies and arguments as for `four_bar_motion`."""
    crank, coupler, rocker = Marker(1), Marker(2), Marker(3)
    return [
        Revolute(Marker(0), crank),
        Revolute(Marker(1, l1), coupler),
        Revolute(Marker(0, l4), rocker),
        Revolute(Marker(2, l2), Marker(3, l3)),
        Driver("turn", Marker(0), crank, alpha1, omega1, eps1),
    ]


def _start(pin: tuple[float, float], alpha1: float, l2: float, l4: float, turn: float) -> list[Pose]:
    """Turn the coupler from BD; the rocker points from D to its end."""
    coupler = atan2(-pin[1], l4 - pin[0]) + turn
    end = (pin[0] + l2 * cos(coupler), pin[1] + l2 * sin(coupler))
    rocker = atan2(end[1], end[0] - l4) if hypot(end[0] - l4, end[1]) else pi / 2
    return [(0.0, 0.0, alpha1), (*pin, coupler), (l4, 0.0, rocker)]


def _left_of_diagonal(motion: Motion, pin: tuple[float, float], l2: float, l4: float) -> float:
    (cx, cy), _, _ = motion.point(Marker(2, l2))
    return (l4 - pin[0]) * (cy - pin[1]) + pin[1] * (cx - pin[0])


def inverted_slider_motion(
    l1: float,
    alpha1: float,
    omega1: float,
    eps1: float = 0.0,
    guide_pivot: tuple[float, float] = (0.0, 0.0),
) -> Motion:
    """Move a crank with a rocking slide (domain VP-1): 1 crank, 2 block on the crank pin, 3 guide from its pivot.

    Args:
        l1: Crank length, in metres.
        alpha1: Crank angle from +X, in radians.
        omega1: Crank angular velocity, in rad/s.
        eps1: Crank angular acceleration, in rad/s^2.
        guide_pivot: The frame pivot of the guide, in metres.

    Raises:
        ValueError: The length is not positive and finite, or another value not finite.
        SingularError: The crank pin is on the pivot of the guide.
    """
    positive("crank l1", l1, "m")
    _driver(alpha1, omega1, eps1)
    for axis, value in zip("xy", guide_pivot, strict=True):
        finite(f"guide_pivot {axis}", value, "m")
    joints: list[Joint] = [
        Revolute(Marker(0), Marker(1)),
        Revolute(Marker(1, l1), Marker(2)),
        Revolute(Marker(0, *guide_pivot), Marker(3)),
        Prismatic(Marker(3), Marker(2)),
        Driver("turn", Marker(0), Marker(1), alpha1, omega1, eps1),
    ]
    pin = (l1 * cos(alpha1), l1 * sin(alpha1))
    toward = atan2(pin[1] - guide_pivot[1], pin[0] - guide_pivot[0])
    return solve(joints, [(0.0, 0.0, alpha1), (*pin, toward), (*guide_pivot, toward)])


def variable_length_link_motion(AC: float, BC: float, l_AB: float, dl_AB: float, ddl_AB: float = 0.0) -> Motion:
    """Move a triangle with a linear drive (domain VP-9 mirrored): 1 cylinder from A, 2 piston at B, 3 lever from C.

    Args:
        AC: Distance of the frame pivots A = (0, 0) and C = (AC, 0), in metres.
        BC: Length of the lever, in metres.
        l_AB: Length of the drive, in metres.
        dl_AB: Its rate, in m/s.
        ddl_AB: Its second rate, in m/s^2.

    Raises:
        ValueError: A length is not positive and finite, or a rate not finite.
        AssemblyError: No guess closes with B above AC.
        SingularError: The three points are in line.
    """
    for name, length in (("AC", AC), ("BC", BC), ("l_AB", l_AB)):
        positive(name, length, "m")
    finite("dl_AB", dl_AB, "m/s")
    finite("ddl_AB", ddl_AB, "m/s^2")
    cylinder, piston, lever = Marker(1), Marker(2), Marker(3)
    joints: list[Joint] = [
        Revolute(Marker(0), cylinder),
        Prismatic(cylinder, piston),
        Revolute(piston, Marker(3, BC)),
        Revolute(Marker(0, AC), lever),
        Driver("slide", cylinder, piston, l_AB, dl_AB, ddl_AB),
    ]

    def start(guess: float) -> list[Pose]:
        end = (l_AB * cos(guess), l_AB * sin(guess))
        return [(0.0, 0.0, guess), (*end, guess), (AC, 0.0, atan2(end[1], end[0] - AC))]

    return _first(joints, [start(guess) for guess in GUESSES], lambda motion: motion.point(Marker(2))[0][1] > 0)


def manipulator_motion(
    word: str,
    q: Sequence[float],
    qd: Sequence[float],
    qdd: Sequence[float],
    lengths: Sequence[float],
    delta: float = 0.0,
    absolute: bool = False,
) -> Motion:
    """Move an open chain (domain VP-6 to VP-8): a body and a driver for each joint.

    Args:
        word: Joints from the base, R and P.
        q: Joint variables, ``(n,)``, radians for R, metres for P.
        qd: Their rates.
        qdd: Their second rates.
        lengths: The fixed link behind each R, in order, in metres.
        delta: Direction of a slide from the running direction, in radians.
        absolute: Whether the angle of an R is measured from +X.

    Returns:
        The motion; the tip is the origin of one more body, the last.
    """
    joints: list[Joint] = []
    links, end = iter(lengths), Marker(0)  # the end of the chain so far
    for body, (joint, value, rate, second) in enumerate(zip(word, q, qd, qdd, strict=True), 1):
        if joint == "R":
            held = Marker(0) if absolute else Marker(end.body)
            joints += [Revolute(end, Marker(body)), Driver("turn", held, Marker(body), value, rate, second)]
            end = Marker(body, next(links))
        else:
            guide = Marker(end.body, end.u, end.v, delta)
            joints += [Prismatic(guide, Marker(body, angle=delta))]
            joints += [Driver("slide", guide, Marker(body, angle=delta), value, rate, second)]
            end = Marker(body)
    tip = len(word) + 1
    joints += [Revolute(end, Marker(tip)), Driver("turn", Marker(0), Marker(tip), 0.0)]
    return solve(joints, [(0.1 * i, 0.1 * i, 0.0) for i in range(1, tip + 1)])


def six_bar_motion(
    bars: tuple[float, float, float, float],
    alpha1: float,
    omega1: float,
    eps1: float,
    coupler_point: tuple[float, float],
    dyad_pivot: tuple[float, float],
    dyad: tuple[float, float],
    mode: Literal["C_left_of_BD", "C_right_of_BD"] = "C_left_of_BD",
    dyad_mode: Literal["Q_left_of_PG", "Q_right_of_PG"] = "Q_left_of_PG",
) -> Motion:
    """Move a four-bar with a dyad on its coupler: 1 to 3 as in the four-bar, 4 link PQ from P, 5 GQ (domain STR-8).

    Args:
        bars: l1 to l4, in metres.
        alpha1: Crank angle from +X, in radians.
        omega1: Crank angular velocity, in rad/s.
        eps1: Crank angular acceleration, in rad/s^2.
        coupler_point: P in the axes of the coupler, in metres.
        dyad_pivot: The frame pivot G, in metres.
        dyad: l5 and l6, in metres.
        mode: On which side of the way from B to D the joint C lies.
        dyad_mode: On which side of the way from P to G the joint Q lies.

    Raises:
        AssemblyError: No guess closes in this assembly.
        SingularError: The links of one of the groups are in line.
    """
    base = four_bar_motion(*bars, alpha1, omega1, eps1, mode)
    (px, py), _, _ = base.point(Marker(2, *coupler_point))
    (gx, gy), (l5, l6) = dyad_pivot, dyad
    side = 1.0 if dyad_mode == "Q_left_of_PG" else -1.0
    joints = four_bar_joints(*bars, alpha1, omega1, eps1)
    joints += [
        Revolute(Marker(2, *coupler_point), Marker(4)),
        Revolute(Marker(0, gx, gy), Marker(5)),
        Revolute(Marker(4, l5), Marker(5, l6)),
    ]

    def start(guess: float) -> list[Pose]:
        first = atan2(gy - py, gx - px) + side * guess
        end = (px + l5 * cos(first), py + l5 * sin(first))
        return [*base.poses[1:], (px, py, first), (gx, gy, atan2(end[1] - gy, end[0] - gx))]

    def left(motion: Motion) -> bool:
        (qx, qy), _, _ = motion.point(Marker(4, l5))
        return side * ((gx - px) * (qy - py) - (gy - py) * (qx - px)) > 0

    return _first(joints, [start(guess) for guess in GUESSES], left)


def two_loop_motion(
    bars: tuple[float, float, float, float],
    l5: float,
    h6: float,
    alpha1: float,
    omega1: float,
    eps1: float = 0.0,
    mode: Literal["C_left_of_BD", "C_right_of_BD"] = "C_left_of_BD",
    branch: Literal["slider_right", "slider_left"] = "slider_right",
) -> Motion:
    """Move a four-bar with a slider on its rocker (domain VP-5): 1 to 3 as in the four-bar, 4 bar from C, 5 slider.

    Args:
        bars: l1 to l4, in metres.
        l5: Bar from the rocker end C to the slider, in metres.
        h6: Ordinate of the guide, in metres.
        alpha1: Crank angle from +X, in radians.
        omega1: Crank angular velocity, in rad/s.
        eps1: Crank angular acceleration, in rad/s^2.
        mode: On which side of the way from B to D the joint C lies.
        branch: Whether the slider is to the right or to the left of C.

    Raises:
        AssemblyError: One of the groups cannot close.
        SingularError: Coupler and rocker are in line, or the bar is perpendicular to the guide.
    """
    base = four_bar_motion(*bars, alpha1, omega1, eps1, mode)
    (cx, cy), _, _ = base.point(Marker(3, bars[2]))
    joints = four_bar_joints(*bars, alpha1, omega1, eps1)
    joints += [
        Revolute(Marker(3, bars[2]), Marker(4)),
        Revolute(Marker(4, l5), Marker(5)),
        Prismatic(Marker(0, 0.0, h6), Marker(5)),
    ]
    angle, reach = (0.0, l5) if branch == "slider_right" else (pi, -l5)
    return solve(joints, [*base.poses[1:], (cx, cy, angle), (cx + reach, h6, 0.0)])


def _driver(alpha1: float, omega1: float, eps1: float) -> None:
    for name, value, unit in (("alpha1", alpha1, "rad"), ("omega1", omega1, "rad/s"), ("eps1", eps1, "rad/s^2")):
        finite(name, value, unit)


def _first(joints: list[Joint], starts: list[list[Pose]], wanted: Callable[[Motion], bool]) -> Motion:
    """Give the first motion in the wanted assembly that a start leads to."""
    failed = AssemblyError("no start closes in this assembly")
    for start in starts:
        try:
            motion = solve(joints, start)
        except AssemblyError as error:
            failed = error
            continue
        if wanted(motion):
            return motion
    raise failed
