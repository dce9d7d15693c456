"""A16: the worked solution opens with a submission that counts; a blank, broken or only kept one opens nothing."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient


@pytest.mark.parametrize("answers", [{}, {"l3": ""}, {"l3": "  \n"}, {"l3": "3 +* ("}, {"omega2_formula": "x"}])
def test_the_solution_stays_closed(client: TestClient, answers: dict[str, str]) -> None:
    number = client.headers["x-variant"]
    handed = client.post(f"/api/v1/variants/{number}/submissions", json={"answers": answers})
    assert handed.status_code == 201 and handed.json()["counted"] is False
    refused = client.get(f"/api/v1/variants/{number}/solution?lang=en")
    assert refused.status_code == 403 and refused.json()["error"]["opens"]


def test_a_submission_that_counts_opens_it(client: TestClient) -> None:
    number = client.headers["x-variant"]
    client.post(f"/api/v1/variants/{number}/submissions", json={"answers": {"l3": "1 m"}})
    assert client.get(f"/api/v1/variants/{number}/solution").status_code == 200
