"""Writes `docs/reference/api.md` from the server's OpenAPI: ``uv run python -m tests.docs.api_reference``."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from server.app import create_app
from server.policy import POLICIES
from server.settings import Settings

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reference" / "api.md"
HEAD = """# The interface for programs

This page is written from the interface's own description (`GET /api/v1/openapi.json`) by
`uv run python -m tests.docs.api_reference`; a test compares the two. Bodies are JSON,
and no name may stand twice in one object (`repeated_name`). Everything that can be read is
answered in the language of `?lang=pl|en|ru`, else of `Accept-Language`. A program shows its bearer token
(`grubler token --role lecturer`) in `Authorization: Bearer …`; practice needs none: the cookie of the first response
owns the variants dealt to it.

Every response that is no success has one shape, `Failure`. Positions are code points of the text as typed, from 0.
"""


def page() -> str:
    """Give the whole page."""
    with TemporaryDirectory() as folder:
        described = create_app(Settings(Path(folder))).openapi()
    routes = [line for path, methods in described["paths"].items() for line in _route(path, methods)]
    shapes = [
        line for name, shape in sorted(described["components"]["schemas"].items()) for line in _shape(name, shape)
    ]
    return "\n".join([HEAD, "## Routes", "", *routes, "## Shapes", "", *shapes]).rstrip() + "\n"


def _route(path: str, methods: Mapping[str, Any]) -> Iterator[str]:
    for method, route in methods.items():
        yield f"### `{method.upper()} {path}`"
        yield ""
        yield f"{route['description']} For: {POLICIES[method.upper(), path].name.lower()}."
        yield ""
        for given in route.get("parameters", []):
            yield f"- `{given['name']}` ({given['in']}): {_kind(given['schema'])}"
        body = route.get("requestBody", {}).get("content", {})
        for content in body.values():
            yield f"- body: {_kind(content['schema'])}"
        for status, response in route["responses"].items():
            kinds = [
                _kind(content["schema"]) for content in response.get("content", {}).values() if "schema" in content
            ]
            yield f"- {status}: {', '.join(kinds) or 'no body'}"
        yield ""


def _shape(name: str, shape: Mapping[str, Any]) -> Iterator[str]:
    yield f"### {name}"
    yield ""
    if "description" in shape:
        yield " ".join(shape["description"].split())
        yield ""
    needed = shape.get("required", [])
    for field, kind in shape.get("properties", {}).items():
        yield f"- `{field}`: {_kind(kind)}{'' if field in needed else ', may be left out'}"
    for example in shape.get("examples", []):
        yield f"- example: `{json.dumps(example, ensure_ascii=False)}`"
    yield ""


def _kind(schema: Mapping[str, Any]) -> str:
    """Word the type of a value."""
    if "$ref" in schema:
        return f"[{_name(schema)}](#{_name(schema).lower()})"
    if "anyOf" in schema:
        return " or ".join(_kind(one) for one in schema["anyOf"])
    if schema.get("type") == "array":
        return f"list of {_kind(schema['items'])}" if "items" in schema else "list"
    if schema.get("type") == "object":
        inner = schema.get("additionalProperties")
        return f"object of {_kind(inner)}" if isinstance(inner, Mapping) and inner else "object"
    limits = {"minimum": "≥", "maximum": "≤", "maxLength": "characters ≤", "minLength": "characters ≥"}
    said = [f"{sign} {schema[key]:g}" if schema[key] < 1e6 else f"{sign} {schema[key]}"
            for key, sign in limits.items() if key in schema]  # fmt: skip
    return ", ".join([str(schema.get("format") or schema.get("type", "any value")), *said])


def _name(schema: Mapping[str, Any]) -> str:
    return str(schema["$ref"]).rsplit("/", 1)[-1]


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
