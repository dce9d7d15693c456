"""The true motion of the arm: bodies, joints and drivers solved by Newton's method, no formula of the steps."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import hypot
from typing import TypeAlias

from exercises.exercise import Steps, Values
from exercises.manipulators._arm import Side, Sides, acceleration, place, speed
from figures.machine import Drive, Link, Machine, Pair, Plotted
from graders import States
from graders.polygon.jets import Trio
from graders.polygon.mechanism import Mechanism, State
from mechanics.planar import Driver, Joint, Marker, Motion, Prismatic, Revolute, solve

KEPT = 20  # states are enough to judge by
SPAN = 2.0  # s of the motion that the laboratory shows
EDGES = (("A", "B"), ("B", "C"), ("C", "D"), ("A", "D"), ("A", "E"), ("E", "D"))
REST: Trio = (0.0, 0.0, 0.0)
Numbers: TypeAlias = Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Arm:
    """Three pairs from the frame on, and the name of the length from the last one to the gripper (or none)."""

    pairs: tuple[Pair, Pair, Pair]
    tip: str = ""

    def nodes(self, numbers: Numbers) -> tuple[Marker, Marker, Marker]:
        """Give the nodes B, C and D as points of bodies."""
        second, third = self.pairs[1:]
        return _base(1, second, numbers), _base(2, third, numbers), Marker(3, _length(self.tip, numbers))

    def move(self, numbers: Numbers) -> Motion:
        """Solve the motion at given coordinates and rates, SI units."""
        joints: list[Joint] = []
        for body, pair in enumerate(self.pairs, 1):
            base, driven = _base(body - 1, pair, numbers), _rates(numbers, pair.coordinate)
            joints.append((Revolute if pair.kind == "turn" else Prismatic)(base, Marker(body)))
            start = Marker(pair.datum) if pair.kind == "turn" else base
            joints.append(Driver(pair.kind, start, Marker(body), *driven))
        return solve(joints, ((0.0, 0.0, 0.0),) * 3)


def _length(name: str, numbers: Numbers) -> float:
    return numbers[name] if name else 0.0


def _base(body: int, pair: Pair, numbers: Numbers) -> Marker:
    return Marker(body, _length(pair.behind, numbers), 0.0, pair.turn)


def _rates(numbers: Numbers, name: str) -> Trio:
    """Give a given with its rates, zeros where the task names none."""
    rate, surge = (f"{name}d", "") if name.endswith("_d") else (f"{name}_d", f"{name}_dd")
    return numbers[name], numbers.get(rate, 0.0), numbers.get(surge, 0.0)


def oracle(arm: Arm, numbers: Numbers, doubled: str) -> Values:
    """Give the results by Newton's method and linear equations for the rates.

    Args:
        arm: The arm as bodies.
        numbers: The givens, SI units.
        doubled: Name of the length that the observation doubles.
    """
    motion, longer = arm.move(numbers), {**numbers, doubled: 2 * numbers[doubled]}
    _, c, d = (motion.point(marker) for marker in arm.nodes(numbers))
    speed_then = hypot(*arm.move(longer).point(arm.nodes(longer)[2])[1])
    return {
        "alpha3": motion.poses[3][2], "omega3": motion.rates[3][2], "epsilon3": motion.accelerations[3][2],
        "x_D": d[0][0], "y_D": d[0][1], "v_x": d[1][0], "v_y": d[1][1], "a_x": d[2][0], "a_y": d[2][1],
        "v_C": hypot(*c[1]), "a_C": hypot(*c[2]), "v_D": hypot(*d[1]), "a_D": hypot(*d[2]),
        "k_v": speed_then / hypot(*d[1]),
    }  # fmt: skip


def mechanism(arm: Arm, sides: Sides, steps: Steps, states: States) -> Mechanism:
    """Give the mechanism over the drawn points of the givens' domain; its polygon goes back by x_D and y_D."""
    directions = {side.angle: steps[side.angle] for side in sides if side.angle in steps}
    lines = [
        f"l{i}: {start} > {end}, length {side.length}, angle {side.angle}"
        for i, (start, end, side) in enumerate(zip("ABC", "BCD", sides, strict=True), 1)
    ]
    lines += ["r_x: A > E, length x_D, angle 0", "r_y: E > D, length y_D, angle 90°"]
    lines += ["closure: l1 + l2 + l3 - r_x - r_y = 0"]
    lines += [f"{axis}: {place(sides, axis)} - {axis}_D = 0" for axis in "xy"]
    return Mechanism(
        EDGES,
        "\n".join([*lines, "unknowns: x_D; y_D"]),
        _states(arm, sides, states.names, states.points[:KEPT]),
        velocity="\n".join(f"{axis}: {speed(sides, axis)} - v_{axis} = 0" for axis in "xy"),
        acceleration="\n".join(f"{axis}: {acceleration(sides, axis)} - a_{axis} = 0" for axis in "xy"),
        places=(("x_D", "D", 0), ("y_D", "D", 1)),
        derived=tuple((name, line) for name, line in directions.items() if isinstance(line, str)),
    )


def machine(arm: Arm, sides: Sides) -> Machine:
    """Give the arm as the page of the laboratory moves it."""
    links = tuple(
        Link(side.length, start, end, side.slides, _called(side))
        for side, start, end in zip(sides, "ABC", "BCD", strict=True)
    )
    drives = tuple(Drive(name, f"{name}_d", f"{name}_dd") for name in (pair.coordinate for pair in arm.pairs))
    plotted = Plotted("x", "x_D", "v_x", "a_x"), Plotted("y", "y_D", "v_y", "a_y")
    return Machine(drives, arm.pairs, links, plotted, SPAN, arm.tip)


def _called(side: Side) -> tuple[str, str, str]:
    """Give the names of a direction and of its rates that the task has beside the givens."""
    if not side.angle.startswith("alpha"):
        return "", "", ""
    own = side.spin.startswith("omega")
    return side.angle, side.spin if own else "", side.surge if own else ""


@lru_cache(maxsize=512)  # sixteen sets of points for each topology of the three arms
def _states(
    arm: Arm, sides: Sides, names: tuple[str, ...], points: tuple[tuple[float, ...], ...]
) -> Callable[[], tuple[State, ...]]:
    @lru_cache(maxsize=1)
    def moved() -> tuple[State, ...]:
        return tuple(_state(arm, sides, dict(zip(names, point, strict=True))) for point in points)

    return moved


def _state(arm: Arm, sides: Sides, numbers: Numbers) -> State:
    motion = arm.move(numbers)
    named = {name: _rates(numbers, name) for name in numbers}
    for body, side in enumerate(sides, 1):
        named |= _derived(side, *(each[body][2] for each in (motion.poses, motion.rates, motion.accelerations)))
    b, c, d = (_point(motion, marker) for marker in arm.nodes(numbers))
    return State(named, {"A": (REST, REST), "B": b, "C": c, "D": d, "E": (d[0], REST)})


def _derived(side: Side, angle: float, omega: float, epsilon: float) -> dict[str, Trio]:
    """Give what the task calls the direction of a link and its turning, where these are no givens."""
    named: dict[str, Trio] = {side.angle: (angle, omega, epsilon)} if side.angle.startswith("alpha") else {}
    if side.spin.startswith("omega"):
        named |= {side.spin: (omega, epsilon, 0.0), side.surge: (epsilon, 0.0, 0.0)}
    return named


def _point(motion: Motion, marker: Marker) -> tuple[Trio, Trio]:
    at, velocity, push = motion.point(marker)
    return (at[0], velocity[0], push[0]), (at[1], velocity[1], push[1])
