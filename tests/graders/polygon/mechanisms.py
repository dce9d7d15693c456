"""Mechanisms with true states for the judges of polygons; the states come from closed forms and from Newton."""

from __future__ import annotations

from functools import cache
from math import atan2, cos, hypot, sin

from graders.polygon.jets import Trio, times
from graders.polygon.mechanism import Mechanism, State
from mechanics import four_bar, slider_crank

ORIGIN: tuple[Trio, Trio] = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))


def still(value: float) -> Trio:
    return value, 0.0, 0.0


def polar(length: Trio, angle: Trio) -> tuple[Trio, Trio]:
    """Give length times the direction of an angle, with rates."""
    a, w, e = angle
    x = (cos(a), -w * sin(a), -e * sin(a) - w * w * cos(a))
    y = (sin(a), w * cos(a), e * cos(a) - w * w * sin(a))
    return times(length, x), times(length, y)


def plus(one: tuple[Trio, Trio], other: tuple[Trio, Trio]) -> tuple[Trio, Trio]:
    x, y = (tuple(a + b for a, b in zip(p, q, strict=True)) for p, q in zip(one, other, strict=True))
    return (x[0], x[1], x[2]), (y[0], y[1], y[2])


def driver(k: int) -> tuple[Trio, dict[str, Trio]]:
    alpha, omega, epsilon = 0.35 + 0.391 * k, 5.0 + 1.7 * (k % 7), 20.0 - 9.0 * (k % 5)
    names = {"alpha1": (alpha, omega, epsilon), "omega1": (omega, epsilon, 0.0), "epsilon1": still(epsilon)}
    return (alpha, omega, epsilon), names


@cache
def slider_states(offset: float = 0.0) -> tuple[State, ...]:
    found = []
    for k in range(18):
        l1, l2 = 0.05 + 0.006 * (k % 5), 0.21 + 0.017 * (k % 4)
        (alpha, omega, epsilon), names = driver(k)
        motion = slider_crank.solve(l1, l2, alpha, omega, epsilon, offset)
        slider: Trio = (motion.pos["slider_x"], motion.vel["slider_x"], motion.acc["slider_x"])
        nodes = {"A": ORIGIN, "B": polar(still(l1), (alpha, omega, epsilon)), "C": (slider, still(offset))}
        if offset:
            nodes["E"] = (still(0.0), still(offset))
        more = {"l1": still(l1), "l2": still(l2)} | ({"h": still(offset)} if offset else {})
        found.append(State(more | names, nodes))
    return tuple(found)


SLIDER = Mechanism(
    edges=(("A", "B"), ("B", "C"), ("A", "C")),
    states=slider_states,
    polygon="""l1: A > B, length l1, angle alpha1
l2: B > C, length l2, angle alpha2
l3: A > C, length l3, angle 0
closure: l1 + l2 - l3 = 0
x: l1*cos(alpha1) + l2*cos(alpha2) - l3 = 0
y: l1*sin(alpha1) + l2*sin(alpha2) = 0
unknowns: alpha2; l3""",
    velocity="""x: -l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2) - v3 = 0
y: l1*omega1*cos(alpha1) + l2*omega2*cos(alpha2) = 0""",
    acceleration="x: -l1*epsilon1*sin(alpha1) - l1*omega1^2*cos(alpha1) - l2*epsilon2*sin(alpha2)"
    """ - l2*omega2^2*cos(alpha2) - a3 = 0
y: l1*epsilon1*cos(alpha1) - l1*omega1^2*sin(alpha1) + l2*epsilon2*cos(alpha2) - l2*omega2^2*sin(alpha2) = 0""",
)
OFFSET = Mechanism(
    edges=(("A", "B"), ("B", "C"), ("A", "E"), ("E", "C")),
    states=lambda: slider_states(0.03),
    polygon="""l1: A > B, length l1, angle alpha1
l2: B > C, length l2, angle alpha2
s: E > C, length s, angle 0
h: A > E, length h, angle pi/2
closure: l1 + l2 - s - h = 0
x: l1*cos(alpha1) + l2*cos(alpha2) = s
y: l1*sin(alpha1) + l2*sin(alpha2) = h
unknowns: alpha2; s""",
)


@cache
def rocking_states() -> tuple[State, ...]:
    """A crank whose pin slides in a rocking guide (VP-1): the guide turns about D, the pin of the crank is B."""
    found = []
    for k in range(18):
        l0, l1 = 0.3 + 0.02 * (k % 6), 0.1 + 0.01 * (k % 5)
        driven, names = driver(k)
        pin = plus((still(0.0), still(l0)), polar(still(l1), driven))
        nodes = {"D": ORIGIN, "A": (still(0.0), still(l0)), "B": pin}
        found.append(State({"l0": still(l0), "l1": still(l1)} | names, nodes))
    return tuple(found)


ROCKING = Mechanism(
    edges=(("D", "A"), ("A", "B"), ("D", "B")),
    states=rocking_states,
    polygon="""l0: D > A, length l0, angle 90°
l1: A > B, length l1, angle alpha1
l2: D > B, length l2, angle alpha2
closure: l0 + l1 - l2 = 0
x: l1*cos(alpha1) - l2*cos(alpha2) = 0
y: l0 + l1*sin(alpha1) - l2*sin(alpha2) = 0
unknowns: l2; alpha2""",
    velocity="""x: -l1*omega1*sin(alpha1) - v2*cos(alpha2) + l2*omega2*sin(alpha2) = 0
y: l1*omega1*cos(alpha1) - v2*sin(alpha2) - l2*omega2*cos(alpha2) = 0""",
    acceleration="x: -l1*epsilon1*sin(alpha1) - l1*omega1^2*cos(alpha1) - a2*cos(alpha2) + 2*v2*omega2*sin(alpha2)"
    " + l2*epsilon2*sin(alpha2) + l2*omega2^2*cos(alpha2) = 0\n"
    "y: l1*epsilon1*cos(alpha1) - l1*omega1^2*sin(alpha1) - a2*sin(alpha2) - 2*v2*omega2*cos(alpha2)"
    " - l2*epsilon2*cos(alpha2) + l2*omega2^2*sin(alpha2) = 0",
)


@cache
def four_bar_states() -> tuple[State, ...]:
    found = []
    for k in range(18):
        l1, l2, l3, l4 = 0.1 + 0.003 * (k % 5), 0.26 + 0.01 * (k % 3), 0.22 + 0.006 * (k % 4), 0.3 + 0.004 * (k % 7)
        driven, names = driver(k)
        motion = four_bar.solve(l1, l2, l3, l4, *driven, "C_left_of_BD", (l2, 0.0))
        joint: tuple[Trio, Trio] = (
            (motion.pos["P_x"], motion.vel["P_x"], motion.acc["P_x"]),
            (motion.pos["P_y"], motion.vel["P_y"], motion.acc["P_y"]),
        )
        nodes = {"A": ORIGIN, "B": polar(still(l1), driven), "C": joint, "D": (still(l4), still(0.0))}
        bars = {"l1": still(l1), "l2": still(l2), "l3": still(l3), "l4": still(l4)}
        found.append(State(bars | names, nodes))
    return tuple(found)


FOUR_BAR = Mechanism(
    edges=(("A", "B"), ("B", "C"), ("D", "C"), ("A", "D")),
    states=four_bar_states,
    polygon="""l1: A > B, length l1, angle alpha1
l2: B > C, length l2, angle alpha2
l3: D > C, length l3, angle alpha3
l4: A > D, length l4, angle 0
closure: l1 + l2 - l3 - l4 = 0
x: l1*cos(alpha1) + l2*cos(alpha2) - l3*cos(alpha3) - l4 = 0
y: l1*sin(alpha1) + l2*sin(alpha2) - l3*sin(alpha3) = 0
unknowns: alpha2; alpha3""",
)


@cache
def two_loop_states() -> tuple[State, ...]:
    """The four-bar with a bar from C to a slider E on y = h6 (VP-5)."""
    found = []
    for k, state in enumerate(four_bar_states()):
        l5, h6 = 0.4 + 0.01 * (k % 5), 0.05
        (cx, cy) = state.nodes["C"]
        # sin a5 = (h6 - C_y)/l5, and its rates
        s = ((h6 - cy[0]) / l5, -cy[1] / l5, -cy[2] / l5)
        root = (1 - s[0] ** 2) ** 0.5
        reach = (l5 * root, -l5 * s[0] * s[1] / root, -l5 * (s[1] ** 2 / root**3 + s[0] * s[2] / root))
        slider = (cx[0] + reach[0], cx[1] + reach[1], cx[2] + reach[2])
        names = dict(state.names) | {"l5": still(l5), "h6": still(h6)}
        found.append(State(names, dict(state.nodes) | {"E": (slider, still(h6)), "F": (still(0.0), still(h6))}))
    return tuple(found)


TWO_LOOPS = Mechanism(
    edges=(("A", "B"), ("B", "C"), ("D", "C"), ("A", "D"), ("C", "E"), ("A", "F"), ("F", "E")),
    loops=2,
    states=two_loop_states,
    polygon="""l1: A > B, length l1, angle alpha1
l2: B > C, length l2, angle alpha2
l3: D > C, length l3, angle alpha3
l4: A > D, length l4, angle 0
l5: C > E, length l5, angle alpha5
h6: A > F, length h6, angle pi/2
s6: F > E, length s6, angle 0
closure 1: l1 + l2 - l3 - l4 = 0
closure 2: l4 + l3 + l5 - s6 - h6 = 0
x1: l1*cos(alpha1) + l2*cos(alpha2) - l3*cos(alpha3) - l4 = 0
y1: l1*sin(alpha1) + l2*sin(alpha2) - l3*sin(alpha3) = 0
x2: l4 + l3*cos(alpha3) + l5*cos(alpha5) - s6 = 0
y2: l3*sin(alpha3) + l5*sin(alpha5) - h6 = 0
unknowns: alpha2; alpha3; alpha5; s6""",
)
SYMBOLS = ("l0", "l1", "l2", "l3", "l4", "l5", "h", "h6", "alpha1", "omega1", "epsilon1")


def rigid(state: State, start: str, end: str) -> float:
    (ax, ay), (bx, by) = state.nodes[start], state.nodes[end]
    return hypot(bx[0] - ax[0], by[0] - ay[0])


def heading(state: State, start: str, end: str) -> float:
    (ax, ay), (bx, by) = state.nodes[start], state.nodes[end]
    return atan2(by[0] - ay[0], bx[0] - ax[0])
