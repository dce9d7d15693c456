"""Writes `docs/reference/compare.md` from the code: ``uv run python -m tests.docs.compare_reference``."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from graders import comparison
from graders.comparison.outcome import Why
from graders.comparison.request import MOST_ITEMS, MOST_VARS

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reference" / "compare.md"
KINDS = {
    "expression": "formulas, equal as functions on the whole box",
    "equation": "one equation each, equal if they have the same solutions; `solve_for` names the unknown",
    "system": "a list of equations each, the same number of them; `solve_for` lists the unknowns",
    "matrix": "matrices of formulas, entry by entry",
    "quantity": "numbers with units; `rtol` is relative to `a`, angles modulo a turn",
    "inequality": "an inequality or a chain each, equal if they hold at the same points, borders included",
    "unordered_list": "a list of formulas each, equal in some order",
}
CODES = {
    Why.EQUAL: "`equal`",
    Why.VALUE: "`different`: another value at the witness; of a quantity its `a` and `b` in SI units",
    Why.UNDEFINED: "`different`: only one of the two has a value at the witness and around it",
    Why.LOST: "`different`: the witness solves `a`, not `b`",
    Why.SURPLUS: "`different`: the witness solves `b`, not `a`",
    Why.SHAPE: "`different`: readable, but no formula, equation, inequality or matrix of this shape",
    Why.COUNT: "`different`: another number of items",
    Why.DIMENSION: "`different`: amounts of different quantities",
    Why.UNDECIDED: "`undecided`: neither could be proved",
    Why.NOWHERE: "`undecided`: neither has a value anywhere on the domain",
}
REFUSALS = {
    "bad_json, too_large": "the line is no JSON object, or too long",
    "unknown_kind": "there is no such kind",
    "unknown_field, missing_field, repeated_field": "a field that the kind has not, that is not there, or stands twice",
    "wrong_type, not_finite, out_of_range": "a value of another type; an infinite bound; bounds in reverse order",
    "unreadable_bound": "a bound that is no constant expression",
    "unknown_symbol": "a name that is none, or an unknown without a range",
    "contradictory": "names that cannot be told apart when typed",
}
EXAMPLES: tuple[dict[str, Any], ...] = (
    {"kind": "expression", "a": "-l1*ω1*sin(α1)", "b": "l1 ω1 cos(α1 + π/2)",
     "vars": {"l1": [0.05, 0.2], "omega1": ["1", "40"], "alpha1": ["0", "2*pi"]}},
    {"kind": "equation", "a": "l1*cos(a1) + l2*cos(a2) = l3", "b": "l3 - l1*cos(a1) + l2*cos(a2) = 0",
     "solve_for": "l3", "id": 7,
     "vars": {"l1": [0.05, 0.1], "l2": [0.3, 0.6], "l3": [0, 1], "a1": ["0", "2*pi"], "a2": [-0.4, 0.4]}},
    {"kind": "quantity", "a": "12,5 MPa", "b": "12.6 N/mm²", "rtol": 0.01},
    {"kind": "inequality", "a": "0 < x <= a", "b": "0 < x < a", "vars": {"x": [-1, 1], "a": [0.1, 0.9]}},
    {"kind": "unordered_list", "a": ["a", "2*b"], "b": ["b + b", "a +"], "vars": {"a": [0, 1], "b": [0, 1]}},
)  # fmt: skip
HEAD = f"""# Comparing two answers

This page is written from the code by `uv run python -m tests.docs.compare_reference`; a test compares the two.
`grubler compare` reads one JSON object on standard input, or one a line, and writes one object a line in the same
order; `POST /api/v1/compare` does the same for lecturers ([api.md](api.md)).

`a` and `b` are typed in the [answer language](language.md). `vars` gives the least and the greatest value of each
symbol as constant expressions (at most {MOST_VARS} symbols; an item of a list is one of at most {MOST_ITEMS}). `id`, if
there is one, comes back. Equality is decided on the whole box, never by shape: `different` is proved at a witness,
`undecided` is said where neither is proved. The solutions of an equation know no sign, side, non-zero factor or
multiplicity. Points where a side has no value on a set of measure zero do not decide. Two runs give the same bytes;
`GRUBLER_SECRET` chooses the points.
"""


def page() -> str:
    """Give the whole page."""
    kinds = _table(("kind", "what is compared"), ((f"`{kind}`", KINDS[kind]) for kind in comparison.KINDS))
    codes = _table(("code", "verdict"), ((f"`{why}`", CODES[why]) for why in Why))
    refusals = _table(
        ("code", "an error line"), ((f"`{c.replace(', ', '`, `')}`", text) for c, text in REFUSALS.items())
    )
    unread = (
        "`unreadable` has the reason as its code ([the list](language.md#reading-errors)), the `position` in the text,",
        "counted from 0, the `side` and in a list the `item`. What is no request is `{\"error\": {\"code\": …,",
        "\"message\": …}}`, and the next line is read. The command ends with 0 whatever the answers are.",
    )  # fmt: skip
    return "\n".join([HEAD, *kinds, *codes, *unread, "", *refusals, *_examples()]).rstrip() + "\n"


def _table(head: tuple[str, str], rows: Iterator[tuple[str, str]]) -> list[str]:
    return [f"| {head[0]} | {head[1]} |", "|---|---|", *(f"| {one} | {two} |" for one, two in rows), ""]


def _examples() -> Iterator[str]:
    yield from ("```json", *(json.dumps(one, ensure_ascii=False) for one in EXAMPLES), "```", "", "are answered", "")
    answers = ({**({"id": one["id"]} if "id" in one else {}), **_answered(one)} for one in EXAMPLES)
    yield from ("```json", *(json.dumps(one) for one in answers), "```")


def _answered(request: dict[str, Any]) -> dict[str, Any]:
    found = comparison.answer({name: value for name, value in request.items() if name != "id"}, b"grubler")
    rounded = {name: float(f"{value:.3g}") for name, value in found.get("witness", {}).items()}
    return {**found, **({"witness": rounded} if "witness" in found else {})}


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
