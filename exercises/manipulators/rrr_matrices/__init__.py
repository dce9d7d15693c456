"""Matrices of the RRR group: parameters, pair matrices, their product, the point M (domain DH-2, DH-3, DH-15).

Standard (distal) Denavit-Hartenberg frames, angles in radians inside; frame 3 stands at the elbow, r_3M = (L3, 0, 0).
The coordinate q3 bends link 3 down from link 2, against z2, so that theta3 = -q3.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi, radians

from exercises.exercise import Answers, Draw, Exercise, Mistake, Steps, Values, given, option
from graders import Expression, Matrix, Quantity
from mechanics import rod_groups, transform

LENGTHS = range(200, 601, 20)  # mm
TURNS = [a for a in range(-175, 180, 5) if 15 < a % 90 < 75 and a % 15]  # of the first joint, degrees
LIFTS = [a for a in range(15, 80, 5) if a % 15]
BENDS = [a for a in range(-110, 111, 5) if a % 15 and abs(a) >= 20]
NEAR = 0.1  # no coordinate of M is shorter, m


@dataclass(frozen=True, slots=True)
class Givens:
    L1: float = given(0.2, 0.6)  # height of the second joint, m
    L2: float = given(0.2, 0.6)  # link 2, m
    L3: float = given(0.2, 0.6)  # link 3 to the point M, m
    q1: float = given(-pi, pi)  # from x0 to x1 about z0, rad
    q2: float = given(-pi, pi)  # from x1 to x2 about z1, rad
    q3: float = given(-pi, pi)  # from x2 to x3 against z2, rad
    coordinate: str = option("x", "y", "z")  # the one asked for as a formula


def draw(rng: Draw) -> Givens:
    """Draw hundredths of a metre and whole degrees, and M away from the base planes."""
    L1, L2, L3 = (length / 1000 for length in rng.sample(LENGTHS, 3))
    q1, q2, q3 = angles = [rng.pick(degrees) for degrees in (TURNS, LIFTS, BENDS)]
    givens = Givens(L1, L2, L3, radians(q1), radians(q2), radians(q3), rng.pick(("x", "y", "z")))
    if len(set(map(abs, angles))) < 3 or min(map(abs, point(givens))) <= NEAR:
        rng.reject()
    return givens


def point(givens: Givens) -> tuple[float, float, float]:
    """Find M by the printed formulas of the group."""
    lengths = {"L1": givens.L1, "L2": givens.L2, "L3": givens.L3}
    return rod_groups.direct("RRR", lengths, (givens.q1, givens.q2, givens.q3))


def oracle(givens: Givens) -> Values:
    """The same names by another way: elementary matrices one by one, on the table of the group."""
    q = (givens.q1, givens.q2, givens.q3)
    rows, tool = rod_groups.table("RRR", {"L1": givens.L1, "L2": givens.L2, "L3": givens.L3})
    T = transform.chain_pose(rows, q)
    M = dict(zip("xyz", transform.moved_point(T, tool), strict=True))
    return {
        "P": tuple((*row.moved(angle), row.a, row.alpha) for row, angle in zip(rows, q, strict=True)),
        **{f"A{i}": transform.chain_pose((row,), (q[i - 1],)) for i, row in enumerate(rows, 1)},
        "T": T,
        givens.coordinate: M[givens.coordinate],
        **{f"{name}_M": value for name, value in M.items()},
    }


TABLE = "[[q1; L1; 0; pi/2], [q2; 0; L2; 0], [-q3; 0; 0; 0]]"  # rows theta, s, a, alpha (DH-15)
PAIR = """[[cos({t}); -sin({t})*cos({k}); sin({t})*sin({k}); {a}*cos({t})],
    [sin({t}); cos({t})*cos({k}); -cos({t})*sin({k}); {a}*sin({t})],
    [0; sin({k}); cos({k}); {s}], [0; 0; 0; 1]]"""  # Rot(z, theta) Trans(z, s) Trans(x, a) Rot(x, alpha) (DH-2)
CRAIG = """[[cos({t}); -sin({t}); 0; {a}],
    [sin({t})*cos({k}); cos({t})*cos({k}); -sin({k}); -{s}*sin({k})],
    [sin({t})*sin({k}); cos({t})*sin({k}); cos({k}); {s}*cos({k})], [0; 0; 0; 1]]"""  # the modified convention


def pairs(form: str, theta: str = "P[{i};1]") -> Steps:
    """Write the three pair matrices from the rows of the table P."""
    parts = {"t": theta, "s": "P[{i};2]", "a": "P[{i};3]", "k": "P[{i};4]"}
    return {f"A{i}": form.format(**{key: part.format(i=i) for key, part in parts.items()}) for i in (1, 2, 3)}


def arm(reach: str, height: str) -> Mapping[str, str]:
    """Write the coordinates of a point at a distance from the axis of the first joint and a height (DH-15)."""
    return {"x": f"cos(q1)*({reach})", "y": f"sin(q1)*({reach})", "z": height}


FORMULAS = arm("L2*cos(q2) + L3*cos(q2 - q3)", "L1 + L2*sin(q2) + L3*sin(q2 - q3)")


def steps(givens: Givens) -> Steps:
    """The table, the matrices, their product, the formula of a coordinate, and M = T r_3M."""
    return {
        "P": TABLE,
        **pairs(PAIR),
        "T": "A1*A2*A3",
        givens.coordinate: FORMULAS[givens.coordinate],
        **column("L3*T[{row};1] + T[{row};4]"),
    }


def answers(givens: Givens) -> Answers:
    """All coordinates are asked for as numbers, one of them as a formula before."""
    return {
        "P": Matrix(3, 4, units=("deg", "m", "m", "deg"), weight=3),
        **{f"A{i}": Matrix(4, 4) for i in (1, 2, 3)},
        "T": Matrix(4, 4, weight=2),
        f"{givens.coordinate}_formula": Expression(step=givens.coordinate, called=f"{givens.coordinate}_M", weight=2),
        **{f"{name}_M": Quantity("m", rtol=0.005, atol=0.001) for name in "xyz"},
    }


def column(line: str) -> Steps:
    """Write the three coordinates of M by one line."""
    return {f"{name}_M": line.format(row=row) for row, name in enumerate("xyz", 1)}


def slip(formulas: Mapping[str, str], **lines: str) -> Mistake[Givens]:
    """Make a mistake that shows in the formula of the coordinate as well."""
    return Mistake(lambda givens: {**lines, givens.coordinate: formulas[givens.coordinate]})


EXERCISE = Exercise(
    systems=("DH-2", "DH-15"),
    givens=Givens,
    draw=draw,
    steps=steps,
    oracle=oracle,
    answers=answers,
    mistakes={
        "theta3_sign": slip(
            arm("L2*cos(q2) + L3*cos(q2 + q3)", "L1 + L2*sin(q2) + L3*sin(q2 + q3)"),
            P="[[q1; L1; 0; pi/2], [q2; 0; L2; 0], [q3; 0; 0; 0]]",
        ),
        "alpha1_sign": slip(
            arm("L2*cos(q2) + L3*cos(q2 - q3)", "L1 - L2*sin(q2) - L3*sin(q2 - q3)"),
            P="[[q1; L1; 0; -pi/2], [q2; 0; L2; 0], [-q3; 0; 0; 0]]",
        ),
        "alpha_forgotten": Mistake(P="[[q1; L1; 0; 0], [q2; 0; L2; 0], [-q3; 0; 0; 0]]"),
        "alpha2_turned": Mistake(P="[[q1; L1; 0; pi/2], [q2; 0; L2; pi/2], [-q3; 0; 0; 0]]"),
        "height_along_x": slip(
            arm("L1 + L2*cos(q2) + L3*cos(q2 - q3)", "L2*sin(q2) + L3*sin(q2 - q3)"),
            P="[[q1; 0; L1; pi/2], [q2; 0; L2; 0], [-q3; 0; 0; 0]]",
        ),
        "frame_at_point": Mistake(P="[[q1; L1; 0; pi/2], [q2; 0; L2; 0], [-q3; 0; L3; 0]]", **column("T[{row};4]")),
        "point_forgotten": slip(arm("L2*cos(q2)", "L1 + L2*sin(q2)"), x_M="T[1;4]", y_M="T[2;4]", z_M="T[3;4]"),
        "product_reversed": Mistake(T="A3*A2*A1"),
        "factors_of_craig": Mistake(**pairs(CRAIG)),
        "degrees_as_radians": Mistake(**pairs(PAIR, "(P[{i};1]*180/pi)")),
    },
    minutes=40,
)
