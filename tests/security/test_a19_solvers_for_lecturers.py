"""A19: reference solvers and comparison answer lecturers only; another student's variant is not there."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

from server.people import tokens
from tests.security.conftest import SECRET

BEAM = {"L": 1.0, "E": 2e11, "I": 1e-6, "supports": [{"x": 0, "type": "fixed"}], "loads": []}
PAIR = {"kind": "expression", "a": "x", "b": "x", "vars": {"x": ["0", "1"]}}
ASKED = pytest.mark.parametrize(("path", "body"), [("/api/v1/solve/beam", BEAM), ("/api/v1/compare", PAIR)])


def bearer(role: str) -> dict[str, str]:
    return {"authorization": f"Bearer {tokens.issue(role, SECRET)}"}


@ASKED
def test_a_student_gets_no_solver(client: TestClient, path: str, body: dict[str, object]) -> None:
    assert client.post(path, json=body).status_code == 401
    assert client.post(path, json=body, headers=bearer("student")).status_code == 403
    assert client.post(path, json=body, headers=bearer("lecturer")).status_code == 200


@pytest.mark.parametrize("path", ["", "/solution", "/preview", "/submissions"])
def test_a_variant_of_another_is_not_there(client: TestClient, path: str) -> None:
    number = client.headers["x-variant"]
    client.cookies.clear()
    address = f"/api/v1/variants/{number}{path}"
    body: dict[str, object] = {"answers": {}} if path == "/submissions" else {"answer": "l3", "text": "1"}
    reply = client.post(address, json=body) if path in ("/preview", "/submissions") else client.get(address)
    assert reply.status_code == 404
