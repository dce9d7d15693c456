"""The reference solvers over HTTP: for lecturers, as strict as on the command line."""

from __future__ import annotations

import json
from typing import Any

import pytest
from starlette.testclient import TestClient

from mechanics.wire import solvers
from server.people import tokens
from tests.server.conftest import SECRET

EXAMPLE = dict(solvers.load("beam").EXAMPLE)


def bearer(role: str) -> dict[str, str]:
    return {"authorization": f"Bearer {tokens.issue(role, SECRET)}"}


def posted(client: TestClient, body: Any, solver: str = "beam", **headers: str) -> tuple[int, Any]:
    given = body if isinstance(body, bytes) else json.dumps(body).encode()
    reply = client.post(f"/api/v1/solve/{solver}", headers={**bearer("lecturer"), **headers}, content=given)
    return reply.status_code, reply.json()


def test_a_lecturer_is_answered_as_on_the_command_line(client: TestClient) -> None:
    for name in solvers.SOLVERS:
        example = dict(solvers.load(name).EXAMPLE)
        status, found = posted(client, {**example, "id": "a"}, name)
        assert status == 200 and found.pop("id") == "a"
        assert set(found) <= set(solvers.load(name).ANSWER)


@pytest.mark.parametrize(("headers", "status"), [({}, 401), (bearer("student"), 403), (bearer("administrator"), 200)])
def test_only_lecturers_may_solve(client: TestClient, headers: dict[str, str], status: int) -> None:
    reply = client.post("/api/v1/solve/beam", json=EXAMPLE, headers=headers)
    assert reply.status_code == status and ("reactions" in reply.json()) == (status == 200)


@pytest.mark.parametrize(
    ("body", "status", "code", "field"),
    [
        ({**EXAMPLE, "I": 1e-6}, 422, "contradictory", "I"),
        ({**EXAMPLE, "supports": []}, 422, "unstable", None),
        ({**EXAMPLE, "bogus": 1}, 422, "unknown_field", "bogus"),
        ({**EXAMPLE, "id": "\ud800"}, 422, "out_of_range", "id"),
        (b'{"\\ud800": 1, "\\ud800": 1}', 422, "repeated_field", "\ufffd"),
        (b'{"L": NaN}', 422, "not_finite", "L"),
        (b'{"L": 1, "L": 2}', 422, "repeated_field", "L"),
        (b"{", 422, "bad_json", None),
        (b"", 422, "bad_json", None),
        (b"[" * 60000, 422, "bad_json", None),
        (b"a" * 70000, 413, "too_large", None),
    ],
)
def test_a_request_that_cannot_be_answered_says_why(
    client: TestClient, body: Any, status: int, code: str, field: str | None
) -> None:
    found = posted(client, body)
    assert found[0] == status
    assert (found[1]["error"]["code"], found[1]["error"]["field"]) == (code, field)
    assert found[1]["error"]["request_id"] and found[1]["error"]["message"]


def test_an_unknown_solver_is_not_found(client: TestClient) -> None:
    assert posted(client, EXAMPLE, "baem")[0] == 404


def test_what_the_solvers_read_is_open_to_all(client: TestClient) -> None:
    found = client.get("/api/v1/solvers").json()
    assert found.keys() == solvers.SOLVERS.keys()
    assert found["beam"]["request"] == solvers.schema("beam")
    assert found["beam"]["example"] == EXAMPLE
