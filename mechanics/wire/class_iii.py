"""The class III unit on the wire (`mechanics.class_iii`): a kind of `solve linkage`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from mechanics.class_iii import BRANCHES, DEAD_NAME, Assembly, Unit, assemblies, assembly, constraint, newton
from mechanics.wire.fields import ListOf, Number, Record, Whole
from mechanics.wire.place import Place
from mechanics.wire.refusal import Refusal

PIVOTS = {"A": "of leg AB", "D": "of leg DC", "G": "of leg GF", "K": "of leg KH"}
LENGTHS = {
    "l_AB": "leg",
    "l_BC": "side of link 2",
    "l_BE": "side of link 2",
    "l_CE": "side of link 2",
    "l_CD": "leg",
    "l_EF": "side of link 4",
    "l_EH": "side of link 4",
    "l_FH": "side of link 4",
    "l_FG": "leg",
    "l_HK": "leg",
}

REQUEST = Record(
    "ternary links B-C-E and E-F-H hinged at E, held by legs AB, DC, GF, KH; angles here in [0, 2 pi)",
    {
        **{name: Place(f"frame pivot {doc}") for name, doc in PIVOTS.items()},
        **{name: Number(doc, "m", above=0) for name, doc in LENGTHS.items()},
        "sigma2": Whole("1 where C is counter-clockwise from EB, else -1", least=-1, most=1, default=1),
        "sigma4": Whole("1 where E is counter-clockwise from FH, else -1", least=-1, most=1, default=1),
        "alpha5": Number("angle of GF at which Phi is asked for", "rad", default=None),
        "x0": ListOf("start alpha5, alpha4, alpha2 of Newton's method", Number("", "rad"), None, least=3, most=3),
    },
)

ANSWER = {
    "assemblies": "class_iii: [{alpha5, alpha4, alpha2, branch, F, E, C, measure}] sorted by alpha5: all real "
    "assemblies, or with x0 the one reached; branch is the sign of link 4, then of link 2; singular is that of the "
    "assembly nearest to a dead position, null where there is none",
    "phi": "class_iii with alpha5: constraint function of each branch, m^2; null where the branch does not exist",
    "steps": "class_iii with x0: alpha5, alpha4, alpha2 after each step of Newton's method",
}


def solve(fields: Mapping[str, Any]) -> dict[str, Any]:
    """Find the assemblies; raises ValueError."""
    geometry: dict[str, Any] = {name: complex(*fields[name]) for name in PIVOTS}
    geometry |= {name: value for name, value in fields.items() if name not in ("alpha5", "x0", *PIVOTS)}
    unit = Unit(**geometry)
    if fields["x0"] is not None:
        if fields["alpha5"] is not None:
            raise Refusal("contradictory", "alpha5 and x0 exclude each other: ask for Phi or for a start", "alpha5")
        steps = newton(unit, fields["x0"])
        return {**_listed([assembly(unit, steps[-1])]), "steps": [list(angles) for angles in steps[1:]]}
    if fields["alpha5"] is None:
        return _listed(assemblies(unit))
    phi = {branch: constraint(unit, fields["alpha5"], branch) for branch in BRANCHES}
    return {**_listed(assemblies(unit)), "phi": phi}


def _listed(found: tuple[Assembly, ...] | list[Assembly]) -> dict[str, Any]:
    nearest = {"measure": min(one.measure for one in found), "name": DEAD_NAME} if found else None
    return {"assemblies": [_one(one) for one in found], "singular": nearest}


def _one(one: Assembly) -> dict[str, Any]:
    return {name: [part.real, part.imag] if isinstance(part, complex) else part for name, part in one._asdict().items()}
