"""`solve shaft`: torsion of a stepped round shaft (`mechanics.shaft`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any, get_args

from mechanics.members import Segment, Shaft, ShaftSupport, Torque
from mechanics.shaft import solve as solve_shaft
from mechanics.wire.fields import Choice, ListOf, Number, Record

REQUEST = Record(
    "Axis x from the left end, torques and rotations positive about +x.",
    {
        "G": Number("shear modulus", "Pa", above=0),
        "segments": ListOf(
            "cylindrical parts from the left end",
            Record(
                "",
                {
                    "L": Number("length", "m", above=0),
                    "D": Number("outer diameter", "m", above=0),
                    "d": Number("bore, below D", "m", default=0.0, least=0),
                },
            ),
            least=1,
        ),
        "torques": ListOf(
            "external torques",
            Record("", {"x": Number("place", "m"), "T": Number("torque about +x", "N m")}),
            default=(),
        ),
        "support": Choice("which ends are held; free_free must balance", get_args(ShaftSupport), default="fixed_free"),
        "tau_allow": Number("allowable shear stress", "Pa", default=None, above=0),
        "theta_allow_rad_per_m": Number("allowable twist", "rad/m", default=None, above=0),
        "design_bore_ratio": Number("bore over outer diameter of the shaft to size", default=0.0, least=0, below=1),
    },
)

ANSWER = {
    "reactions": "{left, right}: torques of the supports about +x, N m; 0 at a free end",
    "pieces": "[{x1, x2, D, d, T, tau_max, twist, twist_per_m}]; T is the sum of the external torques, reaction "
    "included, to the right of the section",
    "phi": "[{x, phi}] at the breakpoints, rad; zero at the fixed end, at the left end of a free shaft",
    "T_abs_max": "largest |T|, N m",
    "tau_abs_max": "largest shear stress, Pa",
    "design": "{D_strength, D_stiffness, D_required} of a uniform shaft under the same torques, m, which between two "
    "fixed ends shares them by lengths; null without an allowable value",
}

EXAMPLE = {
    "G": 8e10,
    "segments": [{"L": 0.5, "D": 0.05, "d": 0.0}, {"L": 0.4, "D": 0.04, "d": 0.02}],
    "torques": [{"x": 0.5, "T": 900}, {"x": 0.9, "T": -300}],
    "support": "fixed_free",
    "tau_allow": 6e7,
    "theta_allow_rad_per_m": 0.0087,
    "design_bore_ratio": 0.0,
}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Solve the shaft; raises ValueError."""
    shaft = Shaft(
        G=request["G"],
        segments=tuple(Segment(**segment) for segment in request["segments"]),
        torques=tuple(Torque(**torque) for torque in request["torques"]),
        support=request["support"],
        tau_allow=request["tau_allow"],
        theta_allow_rad_per_m=request["theta_allow_rad_per_m"],
        design_bore_ratio=request["design_bore_ratio"],
    )
    return asdict(solve_shaft(shaft))
