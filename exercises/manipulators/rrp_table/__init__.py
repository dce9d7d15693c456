"""Table of the RRP group with a free choice of frames, its matrices and the point M (domain DH-2, DH-3, DH-13).

Standard (distal) Denavit-Hartenberg frames, angles in radians inside. Printed are frame 0 and z3: M lies on it at the
distance d from the origin of frame 3, r_3M = (0, 0, d). The task says from where q2 is measured and on which side of
the slide M stands. In DH-13 q2 is measured from the vertical down and M stands on the left.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, radians

from exercises.exercise import Draw, Exercise, Mistake, Steps, Values, given, option
from exercises.givens import numbers
from exercises.manipulators._tables import MODIFIED, PAIR, motion, pairs
from graders import DHTable, Matrix, Quantity, States
from graders.chain.motion import Motion
from mechanics import rod_groups, transform
from mechanics.dh import Row
from mechanics.vectors import Vector

LENGTHS = range(300, 801, 20)  # mm
OFFSETS = range(80, 201, 10)  # mm
SLIDES = range(320, 901, 20)  # mm
TURNS = [a for a in range(-175, 180, 5) if 15 < a % 90 < 75 and a % 15]  # degrees
LIFTS = [a for a in range(20, 71, 5) if a % 15]
NEAR = 0.1  # no coordinate of M is shorter, m
THETA = {"down": "q2", "up": "pi - q2", "level_up": "q2 + pi/2", "level_down": "pi/2 - q2"}
TURNED = {"down": (0.0, 1.0), "up": (pi, -1.0), "level_up": (pi / 2, 1.0), "level_down": (pi / 2, -1.0)}


@dataclass(frozen=True, slots=True)
class Givens:
    L1: float = given(0.3, 0.8)  # height of the second joint, m
    d: float = given(0.08, 0.2)  # from the slide to the point M, m
    q1: float = given(-pi, pi)  # from x0 to the plane of the slide about z0, rad
    q2: float = given(-pi, pi)  # to the slide from where the task says, rad
    q3: float = given(0.3, 0.9)  # way of the slide from the second joint, m
    measure: str = option("down", "up", "level_up", "level_down")
    side: str = option("left", "right")  # of M, for one who looks along the slide


def draw(rng: Draw) -> Givens:
    """Draw hundredths of a metre and whole degrees, and M away from the base planes."""
    L1, d, q3 = (rng.pick(lengths) / 1000 for lengths in (LENGTHS, OFFSETS, SLIDES))
    q1, q2 = rng.pick(TURNS), rng.pick(LIFTS)
    measure, side = rng.pick(tuple(THETA)), rng.pick(("left", "right"))
    givens = Givens(L1, d, radians(q1), radians(q2), q3, measure, side)
    return rng.reject() if min(map(abs, point(givens))) <= NEAR else givens


def point(givens: Givens) -> Vector:
    """Find M by the printed formulas of the group, with its q2 and its side."""
    offset, sign = TURNED[givens.measure]
    lengths = {"L1": givens.L1, "d": givens.d if givens.side == "left" else -givens.d}
    return rod_groups.direct("RRP", lengths, (givens.q1, offset + sign * givens.q2, givens.q3))


def oracle(givens: Givens) -> Values:
    """The same names by another way: elementary matrices one by one, the point by the formulas of the group."""
    offset, sign = TURNED[givens.measure]
    side = pi / 2 if givens.side == "left" else -pi / 2
    rows = (Row("R", d=givens.L1, alpha=pi / 2), Row("R", offset, alpha=pi / 2, sign=sign), Row("P", alpha=side))
    q = (givens.q1, givens.q2, givens.q3)
    return {
        "P": tuple((*row.moved(variable), row.a, row.alpha) for row, variable in zip(rows, q, strict=True)),
        **{f"A{i}": transform.chain_pose((row,), (q[i - 1],)) for i, row in enumerate(rows, 1)},
        "T": transform.chain_pose(rows, q),
        **dict(zip(("x_M", "y_M", "z_M"), point(givens), strict=True)),
    }


def table(givens: Givens) -> str:
    """Write the table, rows theta, s, a, alpha, with z1 to the right of one who looks along the arm (DH-13)."""
    side = "pi/2" if givens.side == "left" else "-pi/2"
    return f"[[q1; L1; 0; pi/2], [{THETA[givens.measure]}; 0; 0; pi/2], [0; q3; 0; {side}]]"


def coordinates(line: str) -> Steps:
    """Write the coordinates of M from the rows of T."""
    return {f"{name}_M": line.format(row=row) for row, name in enumerate("xyz", 1)}


def steps(givens: Givens) -> Steps:
    """The table, the matrices, their product, and M = T r_3M."""
    return {"P": table(givens), **pairs(PAIR, 3), "T": "A1*A2*A3", **coordinates("d*T[{row};3] + T[{row};4]")}


def arm(givens: Givens, values: Values, states: States) -> Motion:
    """Give the true motion, which any table of the task must describe."""
    return motion(table(givens), "RRP", (0.0, 0.0, givens.d), numbers(givens), states)


def pair(old: str, new: str) -> Steps:
    """Write the pair matrices with a slip in their form."""
    return pairs(PAIR.replace(old, new), 3)


EXERCISE = Exercise(
    systems=("DH-2", "DH-3", "DH-13"),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers={
        "P": DHTable("RRP", weight=3),
        **{f"A{i}": Matrix(4, 4) for i in (1, 2, 3)},
        "T": Matrix(4, 4, weight=2),
        **{f"{name}_M": Quantity("m", rtol=0.005, atol=0.001) for name in "xyz"},
    },
    references={"P": arm},
    mistakes={
        "factors_of_craig": Mistake(**pairs(MODIFIED, 3)),
        "turned_other_way": Mistake(**pair("sin({k})", "-sin({k})")),
        "rotation_transposed": Mistake(
            **pairs(
                """[[cos({t}); sin({t}); 0; {a}*cos({t})],
                [-sin({t})*cos({k}); cos({t})*cos({k}); sin({k}); {a}*sin({t})],
                [sin({t})*sin({k}); -cos({t})*sin({k}); cos({k}); {s}], [0; 0; 0; 1]]""",
                3,
            )
        ),
        "degrees_as_radians": Mistake(**pair("{t}", "({t}*180/pi)")),
        "product_reversed": Mistake(T="A3*A2*A1"),
        "point_forgotten": Mistake(**coordinates("T[{row};4]")),
        "point_along_x": Mistake(**coordinates("d*T[{row};1] + T[{row};4]")),
        "point_behind": Mistake(**coordinates("T[{row};4] - d*T[{row};3]")),
    },
    minutes=40,
)
