"""Comparing answers over HTTP: for lecturers, as on the command line."""

from __future__ import annotations

import json
from typing import Any

import pytest
from starlette.testclient import TestClient

from graders import comparison
from tests.server.conftest import SECRET
from tests.server.solvers.test_solving import bearer

REQUEST = {"kind": "equation", "a": "x = a", "b": "x = 2*a", "solve_for": "x", "vars": {"x": [0, 2], "a": ["0", "1"]}}


def posted(client: TestClient, body: Any) -> tuple[int, Any]:
    given = body if isinstance(body, bytes) else json.dumps(body).encode()
    reply = client.post("/api/v1/compare", headers=bearer("lecturer"), content=given)
    return reply.status_code, reply.json()


def test_a_lecturer_is_answered_as_on_the_command_line(client: TestClient) -> None:
    assert posted(client, {**REQUEST, "id": 7}) == (200, {"id": 7, **comparison.answer(REQUEST, SECRET)})
    assert posted(client, {**REQUEST, "b": "x ="})[1] == {
        "verdict": "unreadable", "code": "needs_operand", "position": 3, "side": "b",
    }  # fmt: skip
    assert posted(client, {**REQUEST, "b": "a = x"})[1] == {"verdict": "equal", "code": "equal", "position": None}


@pytest.mark.parametrize(("headers", "status"), [({}, 401), (bearer("student"), 403), (bearer("administrator"), 200)])
def test_only_lecturers_may_compare(client: TestClient, headers: dict[str, str], status: int) -> None:
    reply = client.post("/api/v1/compare", json=REQUEST, headers=headers)
    assert reply.status_code == status and ("verdict" in reply.json()) == (status == 200)


@pytest.mark.parametrize(
    ("body", "status", "code", "field"),
    [
        ({**REQUEST, "bogus": 1}, 422, "unknown_field", "bogus"),
        ({**REQUEST, "\ud800": 1}, 422, "unknown_field", "?"),
        ({**REQUEST, "id": "\ud800"}, 422, "out_of_range", "id"),
        ({**REQUEST, "kind": "formula"}, 422, "unknown_kind", "kind"),
        ({**REQUEST, "vars": {"x": [2, 0]}}, 422, "out_of_range", "vars.x"),
        (b'{"kind": "expression", "a": "1", "a": "2"}', 422, "repeated_field", "a"),
        (b"{", 422, "bad_json", None),
        (b"a" * 70000, 413, "too_large", None),
    ],
)
def test_what_is_no_request_says_why(client: TestClient, body: Any, status: int, code: str, field: str | None) -> None:
    found = posted(client, body)
    assert found[0] == status
    assert (found[1]["error"]["code"], found[1]["error"]["field"]) == (code, field)


def test_the_interface_describes_the_request(client: TestClient) -> None:
    described = client.get("/api/v1/openapi.json").json()["paths"]["/api/v1/compare"]["post"]
    schema = described["requestBody"]["content"]["application/json"]["schema"]
    assert schema["properties"]["kind"]["enum"] == list(comparison.KINDS)
