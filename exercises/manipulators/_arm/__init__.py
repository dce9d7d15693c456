"""The planar arm of laboratory TMM-2: three links, its formulas written side by side of the vector polygon.

Angles counter-clockwise from OX, radians inside. The polygon goes A, B, C, D along the arm and back by x_D and y_D.
The underscore keeps the folder off the shelf.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from exercises.exercise import Mistake, Steps
from graders import Expression, Grader, Polygon, Quantity, Rates, Text

NODES = ("A", "B", "C", "D", "E")  # E: the foot of D on the x axis
WITHOUT_KEY = ("polygon", "velocities", "accelerations")


@dataclass(frozen=True, slots=True)
class Side:
    """A side of the polygon: a link or a slide, with its direction and the rates of both as a student types them.

    Attributes:
        length: Name of the length; `{length}_d` and `{length}_dd` are its rates where it slides.
        angle: Name of the direction from +X; "0" or "pi/2" for a slide along an axis of the frame.
        spin: Its angular velocity, empty for a fixed direction.
        surge: Its angular acceleration.
        slides: Whether the length changes.
    """

    length: str
    angle: str
    spin: str = ""
    surge: str = ""
    slides: bool = False


Sides = tuple[Side, Side, Side]
Part = tuple[Side, ...]  # of a polygon
Term = tuple[str, str]  # what it is, and the term with its sign
REPORT = {  # sections of report TMM-2 (RP-1) and the answers that fill them
    4: ("aim",),
    7: ("polygon",),
    8: ("polygon",),
    9: ("alpha3", "x_D", "y_D"),
    10: ("velocities", "accelerations"),
    11: ("omega3", "epsilon3", "v_C", "a_C"),
    12: (
        *(f"{name}{more}" for name in ("v_x", "v_y", "a_x", "a_y") for more in ("_formula", "")),
        *("v_D", "a_D"),
    ),
    13: ("k_v", "conclusions"),
}
FIXED = {"0": "x", "pi/2": "y"}
AXES = {"x": ("cos", "sin", "-"), "y": ("sin", "cos", "+")}  # along the side, across it, sign of what turns


def _speeds(side: Side, axis: str) -> Iterator[Term]:
    _, across, sign = AXES[axis]
    if side.slides and (part := _along(f"{side.length}_d", side, axis)):
        yield "sliding", part
    if side.spin:
        yield "turning", f"{sign}{side.length}*{side.spin}*{across}({side.angle})"


def _accelerations(side: Side, axis: str) -> Iterator[Term]:
    along, across, sign = AXES[axis]
    if side.slides and (part := _along(f"{side.length}_dd", side, axis)):
        yield "pushing", part
    if side.spin:
        yield "tangential", f"{sign}{side.length}*{side.surge}*{across}({side.angle})"
        yield "centripetal", f"-{side.length}*{side.spin}^2*{along}({side.angle})"
    if side.slides and side.spin:
        yield "coriolis", f"{sign}2*{side.length}_d*{side.spin}*{across}({side.angle})"


RATES = (_speeds, _accelerations)


def _along(length: str, side: Side, axis: str) -> str:
    """Write the projection of a length along a side; none on the axis to which the side is square."""
    if side.angle in FIXED:
        return f"+{length}" if FIXED[side.angle] == axis else ""
    return f"+{length}*{AXES[axis][0]}({side.angle})"


def _sum(terms: Iterable[Term], without: tuple[str, ...] = ()) -> str:
    text = "".join(term for kind, term in terms if kind not in without)
    return text[:1].removeprefix("+") + text[1:].replace("+", " + ").replace("-", " - ") or "0"


def place(sides: Iterable[Side], axis: str) -> str:
    """Write a coordinate of the end of some sides (domain VP-1 (2.4))."""
    return _sum([("", _along(side.length, side, axis)) for side in sides])


def speed(sides: Iterable[Side], axis: str, without: tuple[str, ...] = ()) -> str:
    """Write a component of the velocity (2.5), some kinds of terms left out: sliding, turning."""
    return _sum([term for side in sides for term in _speeds(side, axis)], without)


def acceleration(sides: Iterable[Side], axis: str, without: tuple[str, ...] = ()) -> str:
    """Write a component of the acceleration (2.6), some kinds left out: pushing, tangential, centripetal, coriolis."""
    return _sum([term for side in sides for term in _accelerations(side, axis)], without)


def gripper(sides: Sides, without: tuple[str, ...] = ()) -> Steps:
    """Write velocity and acceleration of the gripper D, some kinds of terms left out."""
    rates = (("v", speed), ("a", acceleration))
    return {f"{letter}_{axis}": write(sides, axis, without) for letter, write in rates for axis in AXES}


def steps(directions: Steps, sides: Sides) -> Steps:
    """Write all steps: directions and turning of the links, places, velocities and accelerations of nodes.

    Args:
        directions: The steps alpha2, alpha3, omega3 and epsilon3 as far as the arm has them.
        sides: AB, BC and CD.
    """
    near = sides[:2]
    first = next(side for side in sides if side.spin and not side.slides)  # the link that the observation doubles
    across = [f"{AXES[axis][2]} {first.length}*{first.spin}*{AXES[axis][1]}({first.angle})" for axis in AXES]
    return {
        **directions,
        "x_D": place(sides, "x"),
        "y_D": place(sides, "y"),
        "v_Cx": speed(near, "x"),
        "v_Cy": speed(near, "y"),
        "v_C": "sqrt(v_Cx^2 + v_Cy^2)",
        "a_Cx": acceleration(near, "x"),
        "a_Cy": acceleration(near, "y"),
        "a_C": "sqrt(a_Cx^2 + a_Cy^2)",
        **gripper(sides),
        "v_D": "sqrt(v_x^2 + v_y^2)",
        "a_D": "sqrt(a_x^2 + a_y^2)",
        "k_v": f"sqrt((v_x {across[0]})^2 + (v_y {across[1]})^2)/v_D",
    }


@lru_cache(maxsize=16)  # all sides that the arms have, and those up to C
def terms(sides: Part) -> tuple[tuple[str, ...], ...]:
    """Give the terms of every component of place, velocity and acceleration of the end of some sides.

    First x and y; then velocity and acceleration along x, and both along y.
    """
    places = (tuple(place((side,), axis) for side in sides) for axis in AXES)
    rates = ([term for side in sides for _, term in kind(side, axis)] for axis in AXES for kind in RATES)
    return (*places, *map(tuple, rates))


def called(component: str) -> tuple[str, ...]:
    """Give the rates that a component of the velocity or acceleration of D is."""
    letter, _, axis = component.partition("_")
    first = (f"{axis}_D_d", f"{axis}_d")
    return first if letter == "v" else (*(f"{rate}d" for rate in first), f"v_{axis}_d")


def answers() -> dict[str, Grader]:
    """Ask for sections 4 to 13 of the report in their order."""
    formulas = [f"{letter}_{axis}" for letter in "va" for axis in AXES]
    parts = [(f"{name}_formula", Expression(name, rates=called(name))) for name in formulas]
    numbers = [(name, Quantity("m/s" if name[0] == "v" else "m/s^2")) for name in formulas]
    return {
        "aim": Text(step="x_D", weight=0.0),
        "polygon": Polygon(NODES, step="x_D", weight=4.0),
        "alpha3": Quantity("deg"),
        "x_D": Quantity("m"),
        "y_D": Quantity("m"),
        "velocities": Rates("polygon", 1, step="v_x", weight=2.0),
        "accelerations": Rates("polygon", 2, step="a_x", weight=2.0),
        "omega3": Quantity("rad/s"),
        "epsilon3": Quantity("rad/s^2"),
        "v_C": Quantity("m/s"),
        "a_C": Quantity("m/s^2"),
        **dict(pair for formula, number in zip(parts, numbers, strict=True) for pair in (formula, number)),
        "v_D": Quantity("m/s"),
        "a_D": Quantity("m/s^2"),
        "k_v": Quantity("1"),
        "conclusions": Text(step="x_D", weight=0.0),
    }


def references(judged_by: Callable[..., Any]) -> dict[str, Callable[..., Any]]:
    """Give what the answers without a key are judged by; a text is judged by the lecturer."""
    return dict.fromkeys(WITHOUT_KEY, judged_by) | dict.fromkeys(("aim", "conclusions"), lambda *_: "")


def slips(sides_of: Callable[[Any], Sides], carried: bool = True) -> dict[str, Mistake[Any]]:
    """Name the slips that the arms of the laboratory share.

    Args:
        sides_of: Gives the sides of a variant.
        carried: Whether the slide is carried by a turning link, so that there is a Coriolis term to lose.
    """
    lost = {"centripetal_lost": ("a", "centripetal"), "slide_taken_as_fixed": ("v", "sliding")}
    if carried:
        lost["coriolis_lost"] = ("a", "coriolis")
    found = {name: _losing(sides_of, *what) for name, what in lost.items()}
    return {**found, "components_added": Mistake(v_D="abs(v_x) + abs(v_y)", a_D="abs(a_x) + abs(a_y)")}


def _losing(sides_of: Callable[[Any], Sides], letter: str, kind: str) -> Mistake[Any]:
    return Mistake(lambda givens: _without(sides_of(givens), letter, kind))


def _without(sides: Sides, letter: str, kind: str) -> Steps:
    """Write velocities or accelerations of the nodes C and D without one kind of terms, where there are any."""
    write = speed if letter == "v" else acceleration
    near = {f"{letter}_C{axis}": write(sides[:2], axis, (kind,)) for axis in AXES}
    return near | {f"{letter}_{axis}": write(sides, axis, (kind,)) for axis in AXES}
