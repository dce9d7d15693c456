"""`solve linkage`: planar linkages and joints between shafts in closed form, a module of `mechanics` for each kind."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, get_args

from mechanics import (
    four_bar,
    geneva,
    hooke_joint,
    inverted_slider,
    manipulator,
    six_bar,
    slider_crank,
    two_loop,
    variable_length_link,
)
from mechanics.linkage import LinkageMotion
from mechanics.wire import class_iii
from mechanics.wire.fields import Choice, Kind, ListOf, Number, Record, Tagged, Text, Whole
from mechanics.wire.place import Place


def _length(doc: str) -> Number:
    return Number(doc, "m", above=0)


RATES: dict[str, Kind] = {
    "omega1": Number("angular velocity of the driver", "rad/s", default=0.0),
    "epsilon1": Number("angular acceleration of the driver", "rad/s^2", default=0.0),
}
DRIVER: dict[str, Kind] = {"alpha1": Number("crank angle from +X", "rad"), **RATES}
BARS: dict[str, Kind] = {
    "l1": _length("crank AB"),
    "l2": _length("coupler BC"),
    "l3": _length("rocker DC"),
    "l4": _length("frame AD"),
    **DRIVER,
    "mode": Choice("on which side of the way from B to D the joint C lies", get_args(four_bar.Mode), "C_left_of_BD"),
}
COUPLER: dict[str, Kind] = {
    "coupler_point": Record(
        "point P of the coupler",
        {"u": Number("along BC from B", "m"), "v": Number("to the left of BC", "m")},
        default={"u": 0.0, "v": 0.0},
    )
}
BRANCH = Choice("whether the rod points towards +X or -X", get_args(slider_crank.Branch), "slider_right")
LONGEST_WORD = 20  # joints of a manipulator
JOINTS = ListOf("joint variables in the order of the word, rad or m", Number(""), least=1, most=LONGEST_WORD)


def _rates_of_joints(doc: str) -> ListOf:
    return ListOf(doc, Number(""), default=None, least=1, most=LONGEST_WORD)


REQUEST = Tagged(
    "Angles counter-clockwise from +X, crank pivot at the origin. Rates are those of the driver.",
    "kind",
    {
        "slider_crank": Record(
            "l1 e(alpha1) + l2 e(alpha2) = x + i offset",
            {
                "l1": _length("crank"),
                "l2": _length("connecting rod"),
                "offset": Number("ordinate of the guide", "m", default=0.0),
                "branch": BRANCH,
                **DRIVER,
                "point_S_fraction_of_l2": Number("place of S on the rod, 0 at the crank pin", default=0.5),
            },
        ),
        "four_bar": Record("l1 e(alpha1) + l2 e(alpha2) = l4 + l3 e(alpha3)", {**BARS, **COUPLER}),
        "inverted_slider": Record(
            "guide_pivot + s e(phi) = l1 e(alpha1)",
            {
                "l1": _length("crank"),
                "guide_pivot": Place("frame pivot of the guide"),
                "guide_point_distance": Number("place of P on the guide from its pivot", "m", default=0.0),
                **DRIVER,
            },
        ),
        "variable_length_link": Record(
            "A = (0, 0), C = (AC, 0), B above AC",
            {
                "AC": _length("distance of the frame pivots"),
                "BC": _length("lever"),
                "l_AB": _length("driving link"),
                "dl_AB": Number("its rate", "m/s", default=0.0),
                "ddl_AB": Number("its second rate", "m/s^2", default=0.0),
            },
        ),
        "manipulator": Record(
            "chain of joints from the origin, the running direction from +X",
            {
                "type": Text("word over R (revolute) and P (prismatic), such as RPR", most=LONGEST_WORD),
                "q": JOINTS,
                "qd": _rates_of_joints("rates of q; none are zeros"),
                "qdd": _rates_of_joints("second rates of q; none are zeros"),
                "lengths": ListOf("fixed link behind each R, in order", Number("", "m"), (), most=LONGEST_WORD),
                "delta": Number("direction of a slide from the running direction", "rad", default=0.0),
                "angles": Choice("what an R is measured from", get_args(manipulator.Angles), "relative"),
            },
        ),
        "six_bar": Record(
            "the four-bar, then P + l5 e(alpha5) = Q and G + l6 e(alpha6) = Q",
            {
                **BARS,
                **COUPLER,
                "dyad": Record(
                    "group hung from P",
                    {"pivot": Place("frame pivot G"), "l5": _length("link PQ"), "l6": _length("link GQ")},
                ),
                "dyad_mode": Choice(
                    "on which side of the way from P to G the joint Q lies", get_args(six_bar.DyadMode), "Q_left_of_PG"
                ),
            },
        ),
        "two_loop": Record(
            "the four-bar, then l4 + l3 e(alpha3) + l5 e(alpha5) = s6 + i h6",
            {
                **BARS,
                "l5": _length("bar from C to the slider"),
                "h6": Number("ordinate of the guide", "m"),
                "branch": BRANCH,
            },
        ),
        "hooke_joint": Record(
            "tan gamma2 = tan gamma1/cos beta, gamma2 continuous",
            {
                "shaft_angle_beta": Number("angle between the shafts", "rad"),
                "gamma1": Number("angle of the driving shaft", "rad"),
                **RATES,
            },
        ),
        "geneva": Record(
            "outer slots, angles from the line of centres",
            {
                "slots": Whole("number of slots", least=3, most=1000),
                "centre_distance": _length("distance of the pivots"),
                **DRIVER,
            },
        ),
        "class_iii": class_iii.REQUEST,
    },
)

ANSWER = {
    "pos": "positions by name (m; rad in (-pi, pi]): alpha2, slider_x, S_x, S_y (slider_crank); alpha2, alpha3, P_x, "
    "P_y (four_bar); phi, s, P_x, P_y (inverted_slider); beta = angle ACB, alpha = angle BAC, B_x, B_y "
    "(variable_length_link); p_x, p_y (manipulator); those of four_bar and alpha5, alpha6, Q_x, Q_y (six_bar); alpha2, "
    "alpha3, alpha5, s6 (two_loop); gamma2 (hooke_joint: not reduced, in the half-turn of gamma1); phi (geneva)",
    "vel": "velocities by the same names, m/s, rad/s",
    "acc": "accelerations by the same names, m/s^2, rad/s^2",
    "singular": "{measure, name}: 0 in the dead position of that name, 1 farthest from it",
    **class_iii.ANSWER,
}

EXAMPLE = {
    "kind": "four_bar",
    "l1": 0.1,
    "l2": 0.26,
    "l3": 0.22,
    "l4": 0.3,
    "alpha1": 1.0,
    "omega1": 12.0,
    "epsilon1": -8.0,
    "mode": "C_left_of_BD",
    "coupler_point": {"u": 0.1, "v": 0.05},
}


def _coupler(request: dict[str, Any]) -> dict[str, Any]:
    point = request.pop("coupler_point")
    return {**request, "coupler_point": (point["u"], point["v"])}


def _six_bar(request: dict[str, Any]) -> LinkageMotion:
    dyad = request.pop("dyad")
    return six_bar.solve(**_coupler(request), dyad_pivot=dyad["pivot"], l5=dyad["l5"], l6=dyad["l6"])


KINDS: dict[str, Callable[[dict[str, Any]], LinkageMotion]] = {
    "slider_crank": lambda request: slider_crank.solve(**request),
    "four_bar": lambda request: four_bar.solve(**_coupler(request)),
    "inverted_slider": lambda request: inverted_slider.solve(**request),
    "variable_length_link": lambda request: variable_length_link.solve(**request),
    "manipulator": lambda request: manipulator.solve(**request),
    "six_bar": _six_bar,
    "two_loop": lambda request: two_loop.solve(**request),
    "hooke_joint": lambda request: hooke_joint.solve(**request),
    "geneva": lambda request: geneva.solve(**request),
}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Solve the linkage of the kind asked for; raises ValueError."""
    fields = dict(request)
    kind = fields.pop("kind")
    if kind == "class_iii":
        return class_iii.solve(fields)
    motion = KINDS[kind](fields)
    return {**motion._asdict(), "singular": motion.singular._asdict()}
