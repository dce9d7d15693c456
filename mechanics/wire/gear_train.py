"""`solve gear_train`: angular velocities of a train, exactly (`mechanics.gear_train`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, get_args

from mechanics.bevel_differential import Differential
from mechanics.gear_pair import MeshType
from mechanics.gear_train import Mesh, Train
from mechanics.gear_train import solve as solve_train
from mechanics.rack import Rack
from mechanics.screw import Hand, Screw
from mechanics.wire.fields import Choice, ListOf, MapOf, Number, Record, Text, Whole
from mechanics.wire.refusal import Refusal, below_foreign, shown
from mechanics.worm import Worm

LARGEST = 40  # members
MOST_TEETH = 10_000


def _teeth(doc: str) -> Whole:
    return Whole(doc, 1, MOST_TEETH)


REQUEST = Record(
    "Angular velocities about one axis direction, counter-clockwise positive. A mesh gives (omega_a - omega_H) za = "
    "-(omega_b - omega_H) zb when external, the same with + when internal; without a carrier the axes are fixed. An "
    "input is taken as the decimal it prints as. At most one of rack, screw and worm is asked for as the output.",
    {
        "members": ListOf("all members, carriers among them", Text(""), least=1, most=LARGEST),
        "meshes": ListOf(
            "gears in mesh",
            Record(
                "",
                {
                    "a": Text("member with the first wheel"),
                    "b": Text("member with the other"),
                    "za": _teeth("teeth of the first wheel"),
                    "zb": _teeth("teeth of the other"),
                    "type": Choice("kind of mesh; of an internal one either wheel is the ring", get_args(MeshType),
                                   default="external"),
                    "carrier": Text("member that carries both axes; null for fixed axes", default=None),
                },
            ),
            default=(),
            most=2 * LARGEST,
        ),
        "fixed": ListOf("members that stand still", Text(""), default=(), most=LARGEST),
        "input_omega": MapOf("driven members and their angular velocities", Number("", "rad/s"), default={},
                             most=LARGEST),
        "output": Text('member asked for; or "rack", "nut", "wheel" with the stage that moves it', default=None),
        "differentials": ListOf(
            "symmetric bevel differentials: omega_left + omega_right = 2 omega_carrier",
            Record("", {"left": Text("side"), "right": Text("other side"), "carrier": Text("carrier")}),
            default=(),
            most=LARGEST,
        ),
        "rack": Record(
            "rack driven by a pinion: v = omega r",
            {
                "pinion_on": Text("member with the pinion"),
                "pinion_z": _teeth("its teeth"),
                "module_mm": Number("module", "mm", above=0),
            },
            default=None,
        ),
        "screw": Record(
            "screw whose nut is kept from turning: v = -lead omega/2 pi for a right hand",
            {
                "on": Text("member that is the screw"),
                "pitch": Number("distance of neighbouring threads", "m", above=0),
                "starts": Whole("starts; the lead is pitch times starts", 1, 100, default=1),
                "hand": Choice("sense of the thread", get_args(Hand), default="right"),
            },
            default=None,
        ),
        "worm": Record(
            "worm that drives a wheel; their axes cross, so the ratio has no sign",
            {
                "on": Text("member that is the worm"),
                "worm_starts": Whole("its starts", 1, 100),
                "wheel_z": _teeth("teeth of the wheel"),
            },
            default=None,
        ),
    },
)  # fmt: skip

ANSWER = {
    "omega": "{member: angular velocity, rad/s}",
    "omega_exact": "{member: the same as a fraction, such as 200/9}",
    "ratio": "{of, value, exact} of the first input that is not zero to the output, its modulus for a wheel; null "
    "where there is no such input or the output stands still",
    "v": "speed of the rack or nut asked for, m/s, instead of a ratio",
}

EXAMPLE = {
    "members": ["1", "2", "3", "H"],
    "meshes": [
        {"a": "1", "b": "2", "za": 20, "zb": 25, "type": "external", "carrier": "H"},
        {"a": "2", "b": "3", "za": 25, "zb": 70, "type": "internal", "carrier": "H"},
    ],
    "fixed": ["3"],
    "input_omega": {"1": 100},
    "output": "H",
}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Solve the train; raises ValueError."""
    for name in request["input_omega"]:
        if name not in request["members"]:
            at = below_foreign("input_omega", name)
            raise Refusal("unknown_field", f"there is no field {at}: {shown(name)} is not a member", at)
    found = solve_train(_train(request))
    omega = {"omega": found.omega, "omega_exact": {name: str(speed) for name, speed in found.omega_exact.items()}}
    if found.v is not None:
        return {**omega, "v": found.v}
    ratio = found.ratio
    said = None if ratio is None else {"of": ratio.of, "value": ratio.value, "exact": str(ratio.exact)}
    return {**omega, "ratio": said}


def _train(request: Mapping[str, Any]) -> Train:
    rack, screw, worm = request["rack"], request["screw"], request["worm"]
    return Train(
        members=request["members"],
        meshes=tuple(Mesh(**mesh) for mesh in request["meshes"]),
        fixed=request["fixed"],
        input_omega=request["input_omega"],
        output=request["output"],
        differentials=tuple(Differential(**one) for one in request["differentials"]),
        rack=Rack(**rack) if rack else None,
        screw=Screw(**screw) if screw else None,
        worm=Worm(**worm) if worm else None,
    )
