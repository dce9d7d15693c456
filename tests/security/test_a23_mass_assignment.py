"""A23: what the server decides cannot be set from outside: extra fields are refused by name, nothing is stored."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

EXTRA = ["score", "counted", "attempts", "owner", "student", "role", "time", "receipt", "grade", "deadline", "variant"]


@pytest.mark.parametrize("name", EXTRA)
def test_a_submission_takes_answers_only(client: TestClient, name: str) -> None:
    path = f"/api/v1/variants/{client.headers['x-variant']}/submissions"
    refused = client.post(path, json={"answers": {"l3": "1 m"}, name: 1})
    assert refused.status_code == 422 and name in refused.json()["error"]["field"]
    assert "receipt" not in client.get(f"/variants/{client.headers['x-variant']}").text.split("<main")[1][:200]


@pytest.mark.parametrize("name", ["givens", "version", "id", "owner", "exercise"])
def test_a_variant_takes_a_seed_only(client: TestClient, name: str) -> None:
    refused = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 1, name: {"l1": 1}})
    assert refused.status_code == 422 and name in refused.json()["error"]["field"]


def test_a_form_field_of_another_name_changes_nothing(client: TestClient) -> None:
    number = client.headers["x-variant"]
    form = {"answer.l3": "1 m", "score": "1", "owner": "me", "answer.alpha2.score": "1"}
    client.post(f"/variants/{number}", data=form, headers={"origin": "http://testserver"})
    page = client.get(f"/variants/{number}?lang=en").text
    assert "0 of 5 right" in page
