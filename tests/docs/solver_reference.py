"""Writes `docs/reference/solvers.md` from the tables of fields: ``uv run python -m tests.docs.solver_reference``."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from mechanics.wire import solvers
from mechanics.wire.reading import LARGEST

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reference" / "solvers.md"
HEAD = f"""# The reference solvers

This page is written from the solvers' tables of fields by `uv run python -m tests.docs.solver_reference`; a test
compares the two. `grubler solve SOLVER` reads one JSON object on standard input, or one a line, and writes one object
a line in the same order; `grubler solve SOLVER --schema` prints the JSON Schema of the requests. The same solvers
answer `POST /api/v1/solve/{{solver}}` for lecturers ([api.md](api.md)); `GET /api/v1/solvers` describes them.

SI units, angles in radians. `id`, if there is one, comes back. A request has at most {LARGEST:,} bytes. What cannot be
answered is `{{"error": {{"code": …, "message": …}}}}`, and the next line is read:

| code | meaning |
|---|---|
| `bad_json`, `too_large` | the line is no JSON object, or too long |
| `unknown_field`, `missing_field`, `repeated_field` | a field that there is not, is not there, or stands twice |
| `wrong_type`, `not_finite`, `out_of_range` | a value of another type, NaN or infinite, or one that cannot be |
| `contradictory` | two fields that exclude each other |
| `unstable`, `unbalanced` | the supports do not hold the structure; the loads of a free body do not cancel |
| `cannot_assemble`, `singular` | no position exists; the equations have no unique solution here |
| `inconsistent`, `under_determined` | the conditions contradict one another, or there are too few |
| `unknown_solver` | there is no such solver |
"""


def page() -> str:
    """Give the whole page."""
    sections = [line for name in solvers.SOLVERS for line in _section(name)]
    return "\n".join([HEAD, *sections]).rstrip() + "\n"


def _section(name: str) -> Iterator[str]:
    solver = solvers.load(name)
    summary = solvers.SOLVERS[name]
    yield from (f"## {name}", "", f"{summary[0].upper()}{summary[1:]}.", "", solver.REQUEST.doc, "")
    yield from ("| field | value | meaning |", "|---|---|---|")
    yield from _rows("", solvers.schema(name))
    yield from ("", "| answer | meaning |", "|---|---|")
    yield from (f"| `{field}` | {_cell(meaning)} |" for field, meaning in solver.ANSWER.items())
    yield from ("", "```json", json.dumps(solver.EXAMPLE), "```", "")


def _rows(place: str, schema: Mapping[str, Any]) -> Iterator[str]:
    """One row for each field, those of inner objects below it."""
    for table in schema.get("oneOf", []):
        tag, word = next((name, one["const"]) for name, one in table["properties"].items() if "const" in one)
        where = f"{place}." if place else ""
        yield f"| `{where}{tag}` | `{word}` | {_cell(table.get('description', ''))} |"
        yield from _rows(place, table)
    for name, one in schema.get("properties", {}).items():
        if "const" in one:
            continue
        at = f"{place}.{name}" if place else name
        left_out = "" if name in schema["required"] else f"; else {_default(one['default'])}"
        yield f"| `{at}` | {_value(one)}{left_out} | {_cell(one.get('description', ''))} |"
        yield from _rows(f"{at}[]" if one.get("type") == "array" else at, one.get("items", one))


def _value(one: Mapping[str, Any]) -> str:
    if "enum" in one:
        return ", ".join(f"`{word}`" for word in one["enum"])
    if one.get("type") == "array":
        item = one["items"]
        unit = f" of {_value(item)}" if item.get("type") in ("number", "integer", "string", "array") else ""
        return f"list{unit}, {one['minItems']} to {one['maxItems']}"
    signs = {"exclusiveMinimum": ">", "minimum": "≥", "exclusiveMaximum": "<", "maximum": "≤"}
    limits = [f"{sign} {one[key]:g}" for key, sign in signs.items() if key in one]
    return ", ".join([one.get("x-unit") or str(one.get("type", "object")), *limits])


def _default(value: Any) -> str:
    return "none" if value in (None, []) else f"`{json.dumps(value)}`"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
