"""True states of the slider-crank for the judge of its polygon: nodes and givens with their rates."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from graders import States
from graders.polygon.jets import Trio
from graders.polygon.mechanism import Mechanism, State
from mechanics import slider_crank
from mechanics.linkage import LinkageMotion

KEPT = 20  # of the drawn states those farthest from a dead position
NODES = ("A", "B", "C")
POLYGON = """l1: A > B, length l1, angle alpha1
l2: B > C, length l2, angle alpha2
l3: A > C, length l3, angle 0
closure: l1 + l2 - l3 = 0
x: l1*cos(alpha1) + l2*cos(alpha2) - l3 = 0
y: l1*sin(alpha1) + l2*sin(alpha2) = 0
unknowns: alpha2; l3"""
VELOCITY = """x: -l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2) - v3 = 0
y: l1*omega1*cos(alpha1) + l2*omega2*cos(alpha2) = 0"""
ACCELERATION = (
    "x: -l1*epsilon1*sin(alpha1) - l1*omega1^2*cos(alpha1)"
    " - l2*epsilon2*sin(alpha2) - l2*omega2^2*cos(alpha2) - a3 = 0\n"
    "y: l1*epsilon1*cos(alpha1) - l1*omega1^2*sin(alpha1)"
    " + l2*epsilon2*cos(alpha2) - l2*omega2^2*sin(alpha2) = 0"
)


def mechanism(states: States) -> Mechanism:
    """Give the mechanism over the drawn points of the givens' domain."""
    return _mechanism(states.names, states.points)


@lru_cache(maxsize=64)
def _mechanism(names: tuple[str, ...], points: tuple[tuple[float, ...], ...]) -> Mechanism:
    @lru_cache(maxsize=1)
    def states() -> tuple[State, ...]:
        return true_states([dict(zip(names, point, strict=True)) for point in points])

    return Mechanism(
        (("A", "B"), ("B", "C"), ("A", "C")), POLYGON, states, velocity=VELOCITY, acceleration=ACCELERATION
    )


def true_states(givens: list[dict[str, float]]) -> tuple[State, ...]:
    """Move the mechanism at each of the givens; the states nearest a dead position are left out."""
    moved = [(given, _moved(**given)) for given in givens]
    moved.sort(key=lambda pair: -pair[1].singular.measure)
    return tuple(_state(given, motion) for given, motion in moved[:KEPT])


def _moved(l1: float, l2: float, alpha1: float, omega1: float, epsilon1: float) -> LinkageMotion:
    return slider_crank.solve(l1, l2, alpha1, omega1, epsilon1, point_S_fraction_of_l2=0.0)


def _state(given: Mapping[str, float], motion: LinkageMotion) -> State:
    omega, epsilon = given["omega1"], given["epsilon1"]
    names: dict[str, Trio] = {name: (value, 0.0, 0.0) for name, value in given.items()}
    names |= {"alpha1": (given["alpha1"], omega, epsilon), "omega1": (omega, epsilon, 0.0)}
    rest = (0.0, 0.0, 0.0)
    pin = (_trio(motion, "S_x"), _trio(motion, "S_y"))
    return State(names, {"A": (rest, rest), "B": pin, "C": (_trio(motion, "slider_x"), rest)})


def _trio(motion: LinkageMotion, name: str) -> Trio:
    return motion.pos[name], motion.vel[name], motion.acc[name]
