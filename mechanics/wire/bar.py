"""`solve bar`: tension and compression of a stepped bar (`mechanics.bar`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any, get_args

from mechanics.bar import AxialForce, Bar, BarSegment, BarSupport
from mechanics.bar import solve as solve_bar
from mechanics.wire.fields import Choice, ListOf, Number, Record
from mechanics.wire.refusal import Refusal

REQUEST = Record(
    "Axis x from the left end; forces and displacements positive along +x, N and sigma positive in tension.",
    {
        "segments": ListOf(
            "parts of one section and one material from the left end",
            Record(
                "",
                {
                    "L": Number("length", "m", above=0),
                    "A": Number("area of the section", "m^2", above=0),
                    "E": Number("Young's modulus", "Pa", above=0),
                    "alpha": Number("thermal expansion", "1/K", default=0.0),
                    "dT": Number("rise of temperature", "K", default=0.0),
                    "q": Number("distributed force along +x", "N/m", default=0.0),
                },
            ),
            least=1,
        ),
        "forces": ListOf(
            "concentrated forces",
            Record("", {"x": Number("place", "m"), "F": Number("force along +x", "N")}),
            default=(),
        ),
        "support": Choice("which ends are held", get_args(BarSupport), default="fixed_free"),
        "gap_right": Number("gap to the right wall, with fixed_gap only", "m", default=None, least=0),
    },
)

ANSWER = {
    "reactions": "{left, right}: forces of the supports along +x, N; 0 at a free end",
    "pieces": "[{x1, x2, N1, N2, sigma1, sigma2, elongation}] between ends of segments and forces; N is linear from "
    "N1 to N2, elongation (m) includes temperature",
    "u": "[{x, u}] at the breakpoints: displacement along +x, m",
    "gap_closed": "whether the bar touches the right wall; null without a gap",
}

EXAMPLE = {
    "segments": [{"L": 0.8, "A": 4e-4, "E": 2.1e11, "alpha": 1.2e-5, "dT": 30, "q": 0.0}],
    "forces": [{"x": 0.8, "F": 20000}],
    "support": "fixed_gap",
    "gap_right": 0.0005,
}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Solve the bar; raises ValueError."""
    if request["gap_right"] is not None and request["support"] != "fixed_gap":
        said = f"gap_right = {request['gap_right']} m contradicts the support {request['support']}, which has no gap"
        raise Refusal("contradictory", said, "gap_right")
    if request["gap_right"] is None and request["support"] == "fixed_gap":
        raise Refusal("missing_field", "the field gap_right is missing (gap to the right wall, m)", "gap_right")
    bar = Bar(
        segments=tuple(BarSegment(**segment) for segment in request["segments"]),
        forces=tuple(AxialForce(**force) for force in request["forces"]),
        support=request["support"],
        gap_right=request["gap_right"],
    )
    return asdict(solve_bar(bar))
