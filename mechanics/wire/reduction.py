"""`solve reduction`: a slider-crank reduced to its crank, and its equation of motion (`mechanics.reduction`)."""

from __future__ import annotations

from collections.abc import Mapping
from math import radians
from typing import Any, get_args

from mechanics.reduction import slider_crank_machine
from mechanics.slider_crank import Branch
from mechanics.wire.fields import Choice, Number, Record

REQUEST = Record(
    "Crank about the origin, guide parallel to OX at y = offset, angles counter-clockwise from +x. "
    "J epsilon + J' omega^2/2 = M.",
    {
        "l1": Number("crank", "m", above=0),
        "l2": Number("connecting rod", "m", above=0),
        "offset": Number("ordinate of the guide", "m", default=0.0),
        "branch": Choice("side of the slider", get_args(Branch), default="slider_right"),
        "alpha1": Number("crank angle", "rad"),
        "omega1": Number("angular velocity of the crank", "rad/s", default=0.0),
        "point_S_fraction_of_l2": Number("mass centre of the rod: 0 at the crank pin, 1 at the slider", default=0.5),
        "m2": Number("mass of the rod", "kg", default=0.0, least=0),
        "m3": Number("mass of the slider", "kg", default=0.0, least=0),
        "J1": Number("moment of inertia of the crank about its axis", "kg m^2", default=0.0, least=0),
        "J2": Number("moment of inertia of the rod about its mass centre", "kg m^2", default=0.0, least=0),
        "F3_x": Number("force on the slider along +x", "N", default=0.0),
        "M1": Number("moment on the crank, counter-clockwise", "N m", default=0.0),
    },
)

ANSWER = {
    "J_reduced": "reduced moment of inertia, kg m^2",
    "dJ_reduced": "its derivative by alpha1, kg m^2/rad",
    "M_reduced": "reduced moment, N m",
    "epsilon1": "angular acceleration of the crank, rad/s^2",
}

EXAMPLE = {
    "l1": 0.1,
    "l2": 0.3,
    "offset": 0.0,
    "branch": "slider_right",
    "alpha1": radians(40),
    "omega1": 20.0,
    "point_S_fraction_of_l2": 0.4,
    "m2": 1.2,
    "m3": 2.0,
    "J1": 0.05,
    "J2": 0.008,
    "F3_x": -500.0,
    "M1": 30.0,
}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Reduce the machine; raises ValueError."""
    state = {name: value for name, value in request.items() if name != "omega1"}
    found = slider_crank_machine(**state)
    return {
        "J_reduced": found.J,
        "dJ_reduced": found.dJ,
        "M_reduced": found.M,
        "epsilon1": found.epsilon(request["omega1"]),
    }
