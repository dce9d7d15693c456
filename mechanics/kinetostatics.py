"""Force analysis of the slider-crank, group by group from the slider (domain DY-6).

Crank AB about A = (0, 0), rod BC, slider C on a guide parallel to OX. R_ij: force of link i on link j, in N; moments
counter-clockwise. Weights along -Y, joints without friction. Inertia forces join the loads (d'Alembert).
"""

from __future__ import annotations

from dataclasses import dataclass

from mechanics import slider_crank
from mechanics.checks import finite
from mechanics.slider_crank import Branch

Plane = tuple[float, float]


@dataclass(frozen=True, slots=True)
class SliderCrank:
    """Geometry, masses and load.

    Raises:
        ValueError: A mass or moment of inertia is negative, or a value not finite.
    """

    l1: float  # crank, m
    l2: float  # connecting rod, m
    m1: float = 0.0  # kg
    m2: float = 0.0
    m3: float = 0.0
    J_S1: float = 0.0  # of the crank about its mass centre, kg m^2
    J_S2: float = 0.0  # of the rod about its mass centre, kg m^2
    F3_x: float = 0.0  # force on the slider along +X, N
    S1: float = 0.5  # place of the crank's mass centre, 0 at A, 1 at B
    S2: float = 0.5  # place of the rod's mass centre, 0 at B, 1 at C
    offset: float = 0.0  # ordinate of the guide, m
    branch: Branch = "slider_right"
    g: float = 9.81  # m/s^2

    def __post_init__(self) -> None:
        units = {"m1": "kg", "m2": "kg", "m3": "kg", "J_S1": "kg m^2", "J_S2": "kg m^2"}
        for name, unit in units.items():
            if not 0 <= getattr(self, name) < float("inf"):
                raise ValueError(f"{name} = {getattr(self, name)} {unit} must be finite and not negative")
        for name, unit in (("F3_x", "N"), ("S1", ""), ("S2", ""), ("g", "m/s^2")):
            finite(name, getattr(self, name), unit)


@dataclass(frozen=True, slots=True)
class Link:
    """One moving link as a free body: joints and loads, inertia included."""

    near: Plane  # joint towards the frame, m
    centre: Plane  # mass centre, m
    far: Plane  # joint towards the slider, m
    force: Plane  # weight, applied force and -m a, N
    moment: float  # -J epsilon, N m


@dataclass(frozen=True, slots=True)
class Reactions:
    """Answer of the force analysis."""

    R01: Plane  # of the frame on the crank, N
    R12: Plane  # of the crank on the rod, N
    R23: Plane  # of the rod on the slider, N
    N03: float  # of the guide on the slider along +Y, N
    M1: float  # moment the drive gives the crank, N m


def free_bodies(machine: SliderCrank, alpha1: float, omega1: float, epsilon1: float = 0.0) -> tuple[Link, Link, Link]:
    """Cut the crank, the rod and the slider free, with weights, the load and inertia forces.

    Args:
        machine: Geometry, masses and load.
        alpha1: Crank angle, in radians.
        omega1: Crank angular velocity, in rad/s.
        epsilon1: Crank angular acceleration, in rad/s^2.

    Raises:
        ValueError: A length is not positive, or a value not finite.
        AssemblyError: The rod cannot reach the guide.
        SingularError: The rod is perpendicular to the guide.

    Source:
        Domain DY-5, DY-6.
    """
    state = alpha1, omega1, epsilon1
    pin = slider_crank.solve(machine.l1, machine.l2, *state, machine.offset, machine.branch, 0.0)
    rod = slider_crank.solve(machine.l1, machine.l2, *state, machine.offset, machine.branch, machine.S2)
    A, B, C = (0.0, 0.0), (pin.pos["S_x"], pin.pos["S_y"]), (pin.pos["slider_x"], machine.offset)
    a1 = machine.S1 * pin.acc["S_x"], machine.S1 * pin.acc["S_y"]
    a2, a3 = (rod.acc["S_x"], rod.acc["S_y"]), (rod.acc["slider_x"], 0.0)
    S1, S2 = (machine.S1 * B[0], machine.S1 * B[1]), (rod.pos["S_x"], rod.pos["S_y"])
    return (
        Link(A, S1, B, _load(machine.m1, a1, machine.g), -machine.J_S1 * epsilon1),
        Link(B, S2, C, _load(machine.m2, a2, machine.g), -machine.J_S2 * rod.acc["alpha2"]),
        Link(C, C, C, _load(machine.m3, a3, machine.g, machine.F3_x), 0.0),
    )


def _load(mass: float, acceleration: Plane, g: float, along: float = 0.0) -> Plane:
    return along - mass * acceleration[0], -mass * (acceleration[1] + g)


def solve(machine: SliderCrank, alpha1: float, omega1: float, epsilon1: float = 0.0) -> Reactions:
    """Find the reactions and the driving moment; arguments and errors as for `free_bodies`.

    Source:
        Domain DY-6: the slider along X, the rod's moments about B, the rest link by link.
    """
    crank, rod, slider = free_bodies(machine, alpha1, omega1, epsilon1)
    x = -slider.force[0]  # R23 along X
    arm = _between(rod.near, rod.far)
    about_B = _cross(_between(rod.near, rod.centre), rod.force) + rod.moment
    y = (about_B + arm[1] * x) / arm[0]  # moments about B: about_B + arm x (-R23) = 0
    R12 = x - rod.force[0], y - rod.force[1]
    R01 = R12[0] - crank.force[0], R12[1] - crank.force[1]
    about_A = _cross(crank.centre, crank.force) + crank.moment - _cross(crank.far, R12)
    return Reactions(R01, R12, (x, y), -slider.force[1] - y, -about_A)


def _between(start: Plane, end: Plane) -> Plane:
    return end[0] - start[0], end[1] - start[1]


def _cross(arm: Plane, force: Plane) -> float:
    return arm[0] * force[1] - arm[1] * force[0]
