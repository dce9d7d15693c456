"""The solvers by name. Each is a module of this package, imported when it is asked for; this is the one list of them.

A solver's module holds its table of fields `REQUEST`, the meaning of what it answers `ANSWER`, a request to try
`EXAMPLE`, and `solve`, which takes what the table has read. Whatever it raises as a ValueError is a refusal: its code
is that of the error, `out_of_range` without one.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from math import isfinite
from typing import Any, Protocol, cast

from mechanics.wire import reading
from mechanics.wire.fields import Record, Tagged, described
from mechanics.wire.refusal import Refusal, below, shown

SOLVERS = {
    "beam": "bending of a straight beam: reactions, V, M, deflection, stresses, exact extremes",
    "shaft": "torsion of a stepped round shaft: reactions, torques, stresses, twists, sizes",
    "bar": "tension and compression of a stepped bar: forces, stresses, displacements, temperature, gap",
    "linkage": "planar linkages, manipulators, joints of shafts: positions, velocities, accelerations, dead positions",
    "gear_train": "gear trains, planetary ones too: exact angular velocities, ratio; rack, screw, worm, differentials",
    "mobility": "structure: mobility by formula, loops, true mobility and passive constraints of a drawn mechanism",
    "balance": "balancing of a rotor in one or two planes; counterweights of a four-bar",
    "vibration": "one mass on spring and damper: amplitude, phase, transmissibility under force or base excitation",
    "chain": "serial chain by Denavit-Hartenberg: pose, Jacobian, motion of the tool point, drives",
    "chain_inverse": "inverse task of the six rod functional groups: all branches",
    "reduction": "slider-crank reduced to its crank: inertia, moment, acceleration",
}
LONGEST_ID = 200  # characters


class Solver(Protocol):
    """The module of a solver."""

    REQUEST: Record | Tagged
    ANSWER: Mapping[str, str]
    EXAMPLE: Mapping[str, Any]

    def solve(self, request: Mapping[str, Any]) -> dict[str, Any]:
        """Answer a request that the table has read; raises ValueError."""
        ...


def load(name: str) -> Solver:
    """Find a solver.

    Raises:
        Refusal: `unknown_solver`.
    """
    if name not in SOLVERS:
        raise Refusal("unknown_solver", f"there is no solver {shown(name)}; there are {', '.join(SOLVERS)}")
    return cast(Solver, import_module(f"mechanics.wire.{name}"))


def schema(name: str) -> dict[str, Any]:
    """Describe the requests of a solver by JSON Schema; raises Refusal for an unknown one."""
    dialect = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": name}
    return {**dialect, **described(load(name).REQUEST)}


def solve(name: str, request: Mapping[str, Any]) -> dict[str, Any]:
    """Answer a request, `id` apart.

    Args:
        name: The solver.
        request: The object as JSON holds it.

    Raises:
        Refusal: With the code of what is wrong.
    """
    solver = load(name)
    read = solver.REQUEST.read(request, "")
    try:
        found = solver.solve(read)
    except Refusal:
        raise
    except ValueError as error:
        raise Refusal(getattr(error, "code", "out_of_range"), str(error)) from None
    except ArithmeticError:
        raise Refusal("out_of_range", "on the way to the answer a number leaves the range of floats") from None
    _require_finite(found, "")
    return found


def answer(name: str, raw: bytes) -> dict[str, Any]:
    """Answer the text of a request, with its `id`; a refusal is an answer too."""
    identity: dict[str, Any] = {}
    try:
        request = reading.read(raw)
        identity = identified(request)
        return {**identity, **solve(name, without_id(request))}
    except Refusal as refusal:
        return {**identity, "error": {"code": refusal.code, "message": refusal.message}}


def identified(request: Mapping[str, Any]) -> dict[str, Any]:
    """Give the `id` of a request as it goes back, or nothing if it has none.

    Raises:
        Refusal: `wrong_type` or `not_finite`; an id is a short text, a number or null.
    """
    if "id" not in request:
        return {}
    found = request["id"]
    if isinstance(found, str) and len(found) > LONGEST_ID:
        raise Refusal("out_of_range", f"id has at most {LONGEST_ID} characters, not {len(found)}", "id")
    if isinstance(found, bool) or not isinstance(found, str | int | float | None):
        raise Refusal("wrong_type", f"id = {shown(found)} must be a text, a number or null", "id")
    if isinstance(found, float) and not isfinite(found):
        raise Refusal("not_finite", f"id = {shown(found)} must be finite", "id")
    return {"id": found}


def without_id(request: dict[str, Any]) -> dict[str, Any]:
    """Leave the `id` out, in place; an object in which a name stands twice stays one."""
    request.pop("id", None)
    return request


def _require_finite(value: Any, place: str) -> None:
    if isinstance(value, float) and not isfinite(value):
        raise Refusal("out_of_range", f"{place} of the answer is beyond the range of floats")
    if isinstance(value, Mapping):
        for name, one in value.items():
            _require_finite(one, below(place, name))
    elif isinstance(value, list | tuple):
        for at, one in enumerate(value):
            _require_finite(one, f"{place}[{at}]")
