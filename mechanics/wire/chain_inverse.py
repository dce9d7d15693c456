"""`solve chain_inverse`: all branches of the inverse task of the six rod functional groups (`mechanics.rod_groups`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from mechanics import rod_groups
from mechanics.wire.chain import FARTHEST
from mechanics.wire.fields import ListOf, Number, Record, Tagged

_M = ListOf("the point in base axes", Number("", "m", least=-FARTHEST, most=FARTHEST), least=3, most=3)


def _length(name: str) -> Number:
    if name in ("L2", "L3"):
        return Number("arm", "m", above=0, most=FARTHEST)
    return Number("", "m", least=-FARTHEST, most=FARTHEST)


REQUEST = Tagged(
    "Three joints carry the point M; the group is a word over R (turn) and P (slide), frames and lengths are those of "
    "its standard Denavit-Hartenberg table, q is in the order of the word. A slide that carries M away from an axis is "
    "given positive.",
    "group",
    {
        word: Record("", {"lengths": Record("", {name: _length(name) for name in group.lengths}), "M": _M})
        for word, group in rod_groups.GROUPS.items()
    },
)

ANSWER = {
    "n_solutions": "number of branches that differ",
    "solutions": "[[q1, q2, q3]]: joint variables, rad in (-pi, pi] or m",
    "determinants": "det dM/dq of each solution; 0 in a singular position",
}

EXAMPLE = {"group": "RRR", "lengths": {"L1": 0.45, "L2": 0.5, "L3": 0.4}, "M": [0.58, 0.4, 0.92]}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Find all branches; raises ValueError."""
    group, lengths = request["group"], request["lengths"]
    solutions = rod_groups.inverse(group, lengths, request["M"])
    return {
        "n_solutions": len(solutions),
        "solutions": solutions,
        "determinants": [rod_groups.determinant(group, lengths, q) for q in solutions],
    }
