"""`solve chain`: motion of a serial chain (`mechanics.chain`); with masses, its drives (`mechanics.newton_euler`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from math import pi
from typing import Any, get_args

from mechanics import chain, newton_euler
from mechanics.chain import Chain
from mechanics.dh import Convention, JointType, Row
from mechanics.links import LinkMass, check_inertia
from mechanics.wire.fields import NEEDED, Choice, ListOf, Number, Record
from mechanics.wire.refusal import Refusal

FARTHEST = 1e9  # rad or m: beyond it a turn has no digits left
MOST = 30  # joints


def _bounded(doc: str, unit: str, default: Any = NEEDED) -> Number:
    return Number(doc, unit, default=default, least=-FARTHEST, most=FARTHEST)


def _vector(doc: str, unit: str, default: Any = NEEDED) -> ListOf:
    return ListOf(doc, _bounded("", unit), default=default, least=3, most=3)


@dataclass(frozen=True, slots=True)
class _Tensor:
    """An inertia tensor: three rows, or its three principal moments when they lie along the axes."""

    doc: str = "inertia tensor as 3 rows of 3, products with minus; or the 3 principal moments along the axes"
    default: Any = NEEDED

    def read(self, value: Any, place: str) -> tuple[tuple[float, ...], ...]:
        """Read the tensor as three rows."""
        number = _bounded("", "kg m^2")
        if isinstance(value, list | tuple) and value and isinstance(value[0], list | tuple):
            rows = ListOf("", ListOf("", number, least=3, most=3), least=3, most=3).read(value, place)
        else:
            moments = ListOf("", number, least=3, most=3).read(value, place)
            rows = tuple(tuple(moments[i] if i == j else 0.0 for j in range(3)) for i in range(3))
        try:
            check_inertia(rows)
        except ValueError as error:
            raise Refusal("out_of_range", f"{place}: {error}", place) from None
        return rows

    def schema(self) -> dict[str, Any]:
        """Describe both forms."""
        number = {"type": "number"}
        row = {"type": "array", "items": number, "minItems": 3, "maxItems": 3}
        return {"type": "array", "items": {"anyOf": [row, number]}, "minItems": 3, "maxItems": 3, "x-unit": "kg m^2"}


REQUEST = Record(
    "Denavit-Hartenberg table: standard is Rz(theta) Tz(d) Tx(a) Rx(alpha), modified Rx(alpha) Tx(a) Rz(theta) Tz(d). "
    "The joint variable is added to theta (R) or d (P). With the masses, which come all four together, the drives are "
    "found too, without friction.",
    {
        "convention": Choice("standard (distal) or modified (proximal, Craig)", get_args(Convention), "standard"),
        "rows": ListOf(
            "joints with the links behind them",
            Record(
                "",
                {
                    "type": Choice("turn or slide", get_args(JointType)),
                    "theta": _bounded("turn about z", "rad", 0.0),
                    "d": _bounded("shift along z", "m", 0.0),
                    "a": _bounded("shift along x", "m", 0.0),
                    "alpha": _bounded("turn about x", "rad", 0.0),
                },
            ),
            least=1,
            most=MOST,
        ),
        "q": ListOf("joint variables", _bounded("", "rad or m"), least=1, most=MOST),
        "qd": ListOf("their rates; zeros when left out", _bounded("", "rad/s or m/s"), None, least=1, most=MOST),
        "qdd": ListOf("their second rates; zeros when left out", _bounded("", "rad/s^2 or m/s^2"), None, 1, MOST),
        "tool_point": _vector("point of the last link in its frame", "m", (0.0, 0.0, 0.0)),
        "mass": ListOf("mass of each link", Number("", "kg", least=0, most=FARTHEST), None, 1, MOST),
        "com_in_link_frame": ListOf("centre of mass of each link in its frame", _vector("", "m"), None, 1, MOST),
        "inertia_about_com_link_axes": ListOf("of each link about its centre of mass", _Tensor(), None, 1, MOST),
        "gravity_vector": _vector("g itself in base axes, such as [0, 0, -9.81]", "m/s^2", None),
    },
)
HEAVY = ("mass", "com_in_link_frame", "inertia_about_com_link_axes", "gravity_vector")

ANSWER = {
    "T": "pose of the last frame, (4, 4)",
    "J": "Jacobian of the last origin in base axes, rows [v; omega], (6, n)",
    "p": "tool point, m",
    "v": "its velocity, m/s",
    "a": "its acceleration, m/s^2",
    "omega": "angular velocity of the last link, rad/s",
    "epsilon": "its angular acceleration, rad/s^2",
    "tau": "with masses: torques (N m) or forces (N) of the drives",
    "gravity_tau": "with masses: what the drives give to hold the chain still",
    "mass_matrix": "with masses: M of the kinetic energy q'^T M q'/2, (n, n)",
}

EXAMPLE = {
    "convention": "standard",
    "rows": [
        {"type": "R", "theta": 0, "d": 0.4, "a": 0.0, "alpha": pi / 2},
        {"type": "P", "theta": 0, "d": 0.1, "a": 0.2, "alpha": 0},
    ],
    "q": [0.3, 0.2],
    "qd": [1, 0.1],
    "qdd": [0, 0],
    "tool_point": [0.05, 0, 0],
    "mass": [4.0, 2.0],
    "com_in_link_frame": [[0, -0.2, 0], [-0.1, 0, 0]],
    "inertia_about_com_link_axes": [[[0.03, 0, 0], [0, 0.02, 0], [0, 0, 0.03]], [0.01, 0.02, 0.02]],
    "gravity_vector": [0, 0, -9.81],
}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Solve the chain; raises ValueError."""
    table = Chain(tuple(Row(**row) for row in request["rows"]), request["convention"])
    rest = (0.0,) * len(table.rows)
    q, qd, qdd = request["q"], request["qd"] or rest, request["qdd"] or rest
    found = asdict(chain.solve(table, q, qd, qdd, request["tool_point"]))
    masses = _masses(request, len(table.rows))
    if masses is None:
        return found
    gravity = request["gravity_vector"]
    return {
        **found,
        "tau": newton_euler.solve(table, masses, q, qd, qdd, gravity).tau,
        "gravity_tau": newton_euler.gravity_torques(table, masses, q, gravity),
        "mass_matrix": newton_euler.mass_matrix(table, masses, q),
    }


def _masses(request: Mapping[str, Any], count: int) -> list[LinkMass] | None:
    given = [name for name in HEAVY if request[name] is not None]
    if not given:
        return None
    for name in HEAVY:
        if request[name] is None:
            raise Refusal("missing_field", f"the field {name} is missing: it comes together with {given[0]}", name)
    for name in HEAVY[:3]:
        if len(request[name]) != count:
            raise Refusal("out_of_range", f"{name} has {len(request[name])} entries for {count} links", name)
    return [LinkMass(*link) for link in zip(*(request[name] for name in HEAVY[:3]), strict=True)]
