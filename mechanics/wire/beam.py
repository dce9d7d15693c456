"""`solve beam`: bending of a straight beam (`mechanics.beam`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from mechanics.beam import BeamResult
from mechanics.beam import solve as solve_beam
from mechanics.members import Beam, Distributed, Force, Load, Moment, Support
from mechanics.wire.fields import Choice, ListOf, Number, Record, Tagged
from mechanics.wire.refusal import Refusal
from mechanics.wire.section import SECTION, section

ROUNDING = 1e-12  # of the length

REQUEST = Record(
    "Axis x from the left end, y and v positive up. V is the sum of the upward forces left of x, M > 0 sags, "
    "EI v'' = M. Loads add up; at a load's own x the value is the one to its "
    "left, at x = 0 the one inside the beam.",
    {
        "L": Number("length of the beam", "m", above=0),
        "E": Number("Young's modulus", "Pa", above=0),
        "section": SECTION,
        "I": Number("second moment of area, where no section is given", "m^4", default=None, above=0),
        "supports": ListOf(
            "what holds the beam",
            Record(
                "",
                {
                    "x": Number("place", "m"),
                    "type": Choice("pin and roller hold v, fixed holds v and the slope", ("pin", "roller", "fixed")),
                    "settlement": Number("imposed displacement, up", "m", default=0.0),
                },
            ),
        ),
        "hinges": ListOf("places of inner hinges", Number("", "m"), default=()),
        "loads": ListOf(
            "what loads the beam",
            Tagged(
                "",
                "type",
                {
                    "force": Record("", {"x": Number("place", "m"), "F": Number("force, up", "N")}),
                    "moment": Record("", {"x": Number("place", "m"), "M": Number("couple, counter-clockwise", "N m")}),
                    "dist": Record(
                        "",
                        {
                            "x1": Number("start", "m"),
                            "x2": Number("end", "m"),
                            "w1": Number("intensity at the start, up", "N/m"),
                            "w2": Number("intensity at the end, up; linear between", "N/m"),
                        },
                    ),
                },
            ),
            default=(),
        ),
        "sample_x": ListOf("places to sample", Number("", "m"), default=(), most=1000),
    },
)

ANSWER = {
    "reactions": "[{x, Fy, M}] by rising x: force up (N) and couple (N m), M only at fixed ends, else 0",
    "samples": "[{x, V, M, v, theta}] at sample_x, in its order",
    "M_max": "largest M, N m",
    "M_min": "smallest M, N m",
    "M_abs_max": "largest |M|, N m",
    "x_M_abs_max": "its place, the leftmost on a tie, m",
    "V_abs_max": "largest |V|, N",
    "v_extreme": "signed v of the largest |v|, the leftmost on a tie, m",
    "x_v_extreme": "its place, m",
    "I": "second moment of area, m^4",
    "W": "section modulus, m^3; null without a section",
    "sigma_max": "|M|max/W, Pa; null without a section",
    "tau_max": "V Q/(I t) at the neutral axis, Pa; null without a section",
    "degree": "degree of static indeterminacy",
}

EXAMPLE = {
    "L": 4.0,
    "E": 2.1e11,
    "section": {"type": "rect", "b": 0.04, "h": 0.12},
    "supports": [{"x": 0, "type": "pin"}, {"x": 4.0, "type": "roller", "settlement": -0.001}],
    "hinges": [],
    "loads": [
        {"type": "force", "x": 1.5, "F": -5000},
        {"type": "moment", "x": 2.0, "M": 1200},
        {"type": "dist", "x1": 1.0, "x2": 3.0, "w1": -2000, "w2": -4000},
    ],
    "sample_x": [0.5, 2.5],
}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Solve the beam; raises ValueError."""
    found, L = solve_beam(_beam(request)), request["L"]
    samples = [found.at(_place(x, L)) for x in request["sample_x"]]
    return {
        "reactions": [{"x": one.x, "Fy": one.Fy, "M": one.M} for one in found.reactions],
        "samples": [{"x": one.x, "V": one.V, "M": one.M, "v": one.v, "theta": one.theta} for one in samples],
        **_extremes(found),
        "degree": found.degree,
    }


def _beam(request: Mapping[str, Any]) -> Beam:
    if (request["section"] is None) == (request["I"] is None):
        code = "missing_field" if request["I"] is None else "contradictory"
        raise Refusal(code, "give either section or I, one of the two", "I")
    L = request["L"]
    return Beam(
        L=L,
        E=request["E"],
        supports=tuple(Support(_place(one["x"], L), one["type"], one["settlement"]) for one in request["supports"]),
        loads=tuple(_load(load, L) for load in request["loads"]),
        hinges=request["hinges"],
        section=section(request["section"]) if request["section"] else None,
        I=request["I"],
    )


def _load(load: Mapping[str, Any], L: float) -> Load:
    if load["type"] == "force":
        return Force(_place(load["x"], L), load["F"])
    if load["type"] == "moment":
        return Moment(_place(load["x"], L), load["M"])
    return Distributed(_place(load["x1"], L), _place(load["x2"], L), load["w1"], load["w2"])


def _place(x: float, L: float) -> float:
    """A place that misses an end by a rounding is there: three times 0.1 is more than 0.3."""
    if L < x <= L * (1 + ROUNDING):
        return L
    return 0.0 if -L * ROUNDING <= x < 0 else x


def _extremes(found: BeamResult) -> dict[str, Any]:
    return {
        "M_max": found.M_max,
        "M_min": found.M_min,
        "M_abs_max": found.M_abs_max,
        "x_M_abs_max": found.x_M_abs_max,
        "V_abs_max": found.V_abs_max,
        "v_extreme": found.v_extreme,
        "x_v_extreme": found.x_v_extreme,
        "I": found.I,
        "W": found.W,
        "sigma_max": found.sigma_max,
        "tau_max": found.tau_max,
    }
