"""Slips at a table of a cycle (VP-2): turns and radians, the start, the sense, units of columns, derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import cos, degrees, sin
from typing import Any

from tests.slips.slip import S

Rows = Sequence[Sequence[float]]
T, ALPHA, X, V, A = range(5)


def column(at: int, change: Callable[[float], float]) -> Callable[[Mapping[str, Any]], Rows]:
    return lambda v: tuple((*row[:at], change(row[at]), *row[at + 1 :]) for row in v["cycle"])


def rows(
    change: Callable[[Sequence[float], Mapping[str, Any]], Sequence[float]],
) -> Callable[[Mapping[str, Any]], Rows]:
    return lambda v: tuple(tuple(change(row, v)) for row in v["cycle"])


def cycle(made: Callable[[Mapping[str, Any]], Rows]) -> Mapping[str, Any]:
    return {"cycle": made}


def differences(at: int, of: int) -> Callable[[Mapping[str, Any]], Rows]:
    """Quotients of differences with the next row."""

    def made(v: Mapping[str, Any]) -> Rows:
        found = []
        for one, other in zip(v["cycle"], (*v["cycle"][1:], v["cycle"][1]), strict=True):
            step = v["cycle"][1][T] - v["cycle"][0][T]
            found.append((*one[:at], (other[of] - one[of]) / step, *one[at + 1 :]))
        return tuple(found)

    return made


def later(part: int) -> Callable[[Mapping[str, Any]], Rows]:
    """The curves begin a part of the cycle later."""

    def made(v: Mapping[str, Any]) -> Rows:
        true = v["cycle"][:-1]
        count = len(true) // part
        turned = (*true[count:], *true[:count])
        found = [(*one[:2], *other[2:]) for one, other in zip(true, turned, strict=True)]
        return (*found, (*v["cycle"][-1][:2], *found[0][2:]))

    return made


def backwards(v: Mapping[str, Any]) -> Rows:
    turned = v["cycle"][::-1]
    return tuple((*one[:2], other[X], -other[V], other[A]) for one, other in zip(v["cycle"], turned, strict=True))


def mode(at: int) -> Callable[[Mapping[str, Any]], Rows]:
    """The crank's sine and cosine of degrees taken for radians, in one column."""

    def made(v: Mapping[str, Any]) -> Rows:
        found = []
        for row in v["cycle"]:
            angle = degrees(row[ALPHA])
            l1, l2, w = v["l1"], v["l2"], v["omega1"]
            values = (l1 * cos(angle) + l2, -l1 * w * sin(angle), -l1 * w * w * cos(angle))
            found.append((*row[:at], values[at - X], *row[at + 1 :]))
        return tuple(found)

    return made


def all_in_mode(v: Mapping[str, Any]) -> Rows:
    found = []
    for row in v["cycle"]:
        angle, l1, l2, w = degrees(row[ALPHA]), v["l1"], v["l2"], v["omega1"]
        turned = -sin(angle) * l1 / l2
        c2 = (1 - turned**2) ** 0.5
        w2 = -l1 * w * cos(angle) / (l2 * c2)
        e2 = (l1 * w * w * sin(angle) + l2 * w2 * w2 * turned) / (l2 * c2)
        x, s = l1 * cos(angle) + l2 * c2, -l1 * w * sin(angle) - l2 * w2 * turned
        found.append((*row[:2], x, s, -l1 * w * w * cos(angle) - l2 * (w2 * w2 * c2 + e2 * turned)))
    return tuple(found)


def of_formula(
    position: Any = None, speed: Any = None, acceleration: Any = None
) -> Callable[[Mapping[str, Any]], Rows]:
    """Columns by other formulas of the crank angle."""

    def made(v: Mapping[str, Any]) -> Rows:
        found = []
        for row in v["cycle"]:
            a, l1, l2, w = row[ALPHA], v["l1"], v["l2"], v["omega1"]
            values = [f(a, l1, l2, w) if f else row[X + at] for at, f in enumerate((position, speed, acceleration))]
            found.append((*row[:2], *values))
        return tuple(found)

    return made


SLIPS = (
    # the speed of the crank
    S(
        "turns a minute for radians a second",
        "turns_as_radians turns_radians",
        lambda g: {"omega1": "n" if g.sense == "counterclockwise" else "-n"},
    ),
    S(
        "turns a second for radians a second",
        "turns_a_second turns_radians",
        lambda g: {"omega1": "n/60" if g.sense == "counterclockwise" else "-n/60"},
    ),
    S(
        "the other sense",
        "other_sense opposite_sign",
        lambda g: {"omega1": "-2*pi*n/60" if g.sense == "counterclockwise" else "2*pi*n/60"},
    ),
    S("sign of omega1 alone", "opposite_sign", {}, {"omega1": "-omega1"}),
    S(
        "pi for two pi",
        "factor_two factor_lost",
        lambda g: {"omega1": ("" if g.sense == "counterclockwise" else "-") + "pi*n/60"},
        {},
        "cycle",
    ),
    S("sixty forgotten", "factor_lost turns_radians", {}, {"omega1": "omega1*60"}),
    S("the pi forgotten", "pi_lost factor_lost", {}, {"omega1": "omega1/pi"}),
    S("omega1 off by ten", "power_of_ten factor_of_ten", {}, {"omega1": "omega1*10"}),
    S("omega1 in degrees a second", "degrees_radians", {}, {"omega1": "omega1*180/pi"}),
    # the cycle's length and the stroke
    S("length of the cycle upside down", "inverted_ratio upside_down", {}, {"T": "abs(omega1)/(2*pi)"}),
    S("half a turn", "factor_two factor_lost", {}, {"T": "T/2"}),
    S("two pi forgotten", "factor_lost", {}, {"T": "1/abs(omega1)"}),
    S("length of the cycle in minutes", "sixty turns_radians", {}, {"T": "T/60"}),
    S("length of the cycle in milliseconds", "kilo_prefix factor_of_ten", {}, {"T": "T*1000"}),
    S("negative length of the cycle", "opposite_sign", {}, {"T": "-T"}),
    S("crank for the stroke", "radius_for_stroke factor_two", {"H": "l1"}),
    S("rod for the stroke", "rod_for_stroke exchanged", {"H": "2*l2"}),
    S("crank and rod for the stroke", "sum_for_stroke", {"H": "l1 + l2"}),
    S("stroke in metres", "kilo_prefix factor_of_ten", {}, {"H": "H/1000"}),
    S("stroke in centimetres", "power_of_ten factor_of_ten", {}, {"H": "H/10"}),
    S("twice the stroke", "factor_two", {}, {"H": "2*H"}),
    # the table: all columns
    S("beginning a quarter later", "delayed start_at_zero", {}, cycle(later(4))),
    S("beginning a sixth later", "delayed start_at_zero", {}, cycle(later(6))),
    S("beginning half a turn later", "delayed start_at_zero", {}, cycle(later(2))),
    S("the opposite sense in the table", "reversed other_sense delayed", {}, cycle(backwards)),
    S("degrees for radians in all columns", "degrees", {}, cycle(all_in_mode)),
    S("degrees for radians in the position", "column degrees column_scale", {}, cycle(mode(X))),
    S(
        "a rod that does not turn",
        "long_rod",
        {},
        cycle(
            of_formula(
                lambda a, l1, l2, w: l1 * cos(a) + l2,
                lambda a, l1, l2, w: -l1 * w * sin(a),
                lambda a, l1, l2, w: -l1 * w * w * cos(a),
            )
        ),
    ),
    S(
        "a rod that turns steadily",
        "steady_rod",
        {"cycle": lambda l1, l2, alpha0, omega1, T: steady(l1, l2, alpha0, omega1, T)},
    ),
    S("half of the cycle only", "not_a_cycle few_rows", {}, cycle(lambda v: v["cycle"][:19])),
    S("nine rows only", "few_rows not_a_cycle", {}, cycle(lambda v: v["cycle"][::4])),
    # single columns
    S("sign of x", "column_sign", {}, cycle(column(X, lambda x: -x))),
    S("sign of v", "column_sign", {}, cycle(column(V, lambda x: -x))),
    S("sign of a", "column_sign", {}, cycle(column(A, lambda x: -x))),
    S("sign of v and a", "column_sign", {}, cycle(rows(lambda r, v: (*r[:3], -r[V], -r[A])))),
    S("x in metres", "column_unit", {}, cycle(column(X, lambda x: x / 1000))),
    S("x in centimetres", "column_unit", {}, cycle(column(X, lambda x: x / 10))),
    S("v in mm/s", "column_unit", {}, cycle(column(V, lambda x: x * 1000))),
    S("a in mm/s^2", "column_unit", {}, cycle(column(A, lambda x: x * 1000))),
    S("v and a in mm", "column_unit", {}, cycle(rows(lambda r, v: (*r[:3], r[V] * 1000, r[A] * 1000)))),
    S("x doubled", "column_scale", {}, cycle(column(X, lambda x: 2 * x))),
    S("v halved", "column_scale", {}, cycle(column(V, lambda x: x / 2))),
    S("a doubled", "column_scale", {}, cycle(column(A, lambda x: 2 * x))),
    S(
        "x from the dead centre",
        "column_shift",
        {},
        cycle(rows(lambda r, v: (*r[:2], r[X] - v["l2"] - v["l1"], *r[3:]))),
    ),
    S(
        "x from the other dead centre",
        "column_shift",
        {},
        cycle(rows(lambda r, v: (*r[:2], r[X] - v["l2"] + v["l1"], *r[3:]))),
    ),
    S(
        "x against the axis from the dead centre",
        "column_shift column column_sign",
        {},
        cycle(rows(lambda r, v: (*r[:2], v["l1"] + v["l2"] - r[X], *r[3:]))),
    ),
    S("v by the angle", "per_angle", {}, cycle(rows(lambda r, v: (*r[:3], r[V] / v["omega1"], r[A])))),
    S("a by the angle", "per_angle", {}, cycle(rows(lambda r, v: (*r[:4], r[A] / v["omega1"] ** 2)))),
    S("a by the angle once", "per_angle", {}, cycle(rows(lambda r, v: (*r[:4], r[A] / v["omega1"])))),
    S(
        "v and a by the angle",
        "per_angle",
        {},
        cycle(rows(lambda r, v: (*r[:3], r[V] / v["omega1"], r[A] / v["omega1"] ** 2))),
    ),
    S("v as quotients of differences", "quotients", {}, cycle(differences(V, X))),
    S("a as quotients of differences", "quotients", {}, cycle(differences(A, V))),
    S("v taken for the acceleration", "not_the_rate column", {}, cycle(rows(lambda r, v: (*r[:4], r[V])))),
    S("x taken for the speed", "not_the_rate column", {}, cycle(rows(lambda r, v: (*r[:3], r[X], r[A])))),
    S("the rod forgotten in x", "column_shift column", {}, cycle(of_formula(lambda a, l1, l2, w: l1 * cos(a)))),
    S(
        "the rod's term forgotten in v",
        "column not_the_rate",
        {},
        cycle(of_formula(None, lambda a, l1, l2, w: -l1 * w * sin(a))),
    ),
    S(
        "the rod's term forgotten in a",
        "column not_the_rate",
        {},
        cycle(of_formula(None, None, lambda a, l1, l2, w: -l1 * w * w * cos(a))),
    ),
    S(
        "cosine for sine in v",
        "column not_the_rate",
        {},
        cycle(of_formula(None, lambda a, l1, l2, w: -l1 * w * cos(a))),
    ),
    S("stroke of the crank, x in metres", "radius_for_stroke", {"H": "l1"}, cycle(column(X, lambda x: x / 1000))),
)


def steady(l1: float, l2: float, alpha0: float, omega1: float, turn: float) -> Rows:
    """The acceleration without the term of eps2."""
    found = []
    for k in range(37):
        a = alpha0 + omega1 * turn * k / 36
        s2 = -l1 * sin(a) / l2
        c2 = (1 - s2 * s2) ** 0.5
        w2 = -l1 * omega1 * cos(a) / (l2 * c2)
        x, v = l1 * cos(a) + l2 * c2, -l1 * omega1 * sin(a) - l2 * w2 * s2
        found.append((turn * k / 36, a, x, v, -l1 * omega1**2 * cos(a) - l2 * w2 * w2 * c2))
    return tuple(found)
