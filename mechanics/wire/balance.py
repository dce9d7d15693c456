"""`solve balance`: corrections of a rotor, counterweights of a four-bar (`mechanics.balancing`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from mechanics import balancing
from mechanics.balancing import FourBarLinks, Plane, PointMass
from mechanics.wire.fields import ListOf, Number, Record, Tagged

LENGTHS = ("l1", "l2", "l3", "l4")
MASSES = ("m1", "m2", "m3")
CENTRES = ("s1", "s2", "s3")
LINKS = {"1": "crank AB", "2": "coupler BC", "3": "rocker CD", "4": "frame AD"}

REQUEST = Tagged(
    "Axis of the rotor x; angles counter-clockwise in the plane across it. Residuals are over omega^2.",
    "kind",
    {
        "rotor": Record(
            "balance in one plane (statically) or in two",
            {
                "masses": ListOf(
                    "masses on the rotor",
                    Record(
                        "",
                        {
                            "m": Number("mass", "kg", least=0),
                            "r": Number("distance from the axis", "m", least=0),
                            "angle": Number("direction", "rad"),
                            "x": Number("place along the axis", "m", default=0.0),
                        },
                    ),
                    least=1,
                ),
                "planes": ListOf(
                    "planes of correction",
                    Record(
                        "",
                        {
                            "x": Number("place along the axis", "m"),
                            "r": Number("radius at which a mass is added", "m", above=0),
                        },
                    ),
                    least=1,
                    most=2,
                ),
            },
        ),
        "four_bar": Record(
            "counterweights behind the pivots A (0, 0) and D (l4, 0)",
            {
                **{name: Number(f"length of the {LINKS[name[1]]}", "m", above=0) for name in LENGTHS},
                **{name: Number(f"mass of the {LINKS[name[1]]}", "kg", least=0) for name in MASSES},
                "s1": Number("from A to the crank's mass centre", "m"),
                "s2": Number("from B to the coupler's mass centre", "m"),
                "s3": Number("from D to the rocker's mass centre", "m"),
                "e1": Number("from A to the crank's counterweight", "m", above=0),
                "e3": Number("from D to the rocker's counterweight", "m", above=0),
            },
        ),
    },
    otherwise="rotor",
)

ANSWER = {
    "corrections": "[{mr, m, angle}] in the planes: unbalance (kg m), mass to add (kg), direction (rad in (-pi, pi])",
    "residual_force": "|sum m r| that is left, kg m",
    "residual_moment": "|sum x m r| about x = 0 that is left, kg m^2",
    "static": "whether a couple is left: one plane balances statically only",
    "m1k": "counterweight of the crank, kg; negative on the crank's own side",
    "m2k": "counterweight of the rocker, kg; negative on the rocker's own side",
    "x_S": "abscissa of the fixed mass centre, m from A towards D",
    "y_S": "its ordinate, m",
}

EXAMPLE = {
    "masses": [
        {"m": 0.2, "r": 0.05, "angle": 0.7, "x": 0.1},
        {"m": 0.1, "r": 0.06, "angle": 2.5, "x": 0.3},
    ],
    "planes": [{"x": 0.0, "r": 0.08}, {"x": 0.4, "r": 0.08}],
}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Balance the rotor or the four-bar; raises ValueError."""
    if request["kind"] == "rotor":
        masses = [PointMass(**mass) for mass in request["masses"]]
        return asdict(balancing.balance(masses, [Plane(**plane) for plane in request["planes"]]))
    links = FourBarLinks(**{name: request[name] for name in (*LENGTHS, *MASSES, *CENTRES)})
    found = balancing.four_bar(links, request["e1"], request["e3"])
    return {"m1k": found.m1k, "m2k": found.m2k, "x_S": found.x_S, "y_S": found.y_S}
