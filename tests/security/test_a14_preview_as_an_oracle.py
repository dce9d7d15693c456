"""A14: a preview says the same for every seed, to the byte, and costs nothing; it does not judge."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

from exercises.grading import reference
from exercises.variants import deal

TYPED = ["12,5 mm", "-0,37 m", "l1*omega1", "3 +", "ac(x+1)", "1e400", ""]


def previews(client: TestClient, seed: int, answer: str, texts: list[str]) -> list[bytes]:
    number = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": seed}).json()["id"]
    path = f"/api/v1/variants/{number}/preview?lang=pl"
    return [client.post(path, json={"answer": answer, "text": text}).content for text in texts]


@pytest.mark.parametrize("answer", ["l3", "omega2_formula"])
def test_two_seeds_are_told_the_same_bytes(client: TestClient, answer: str) -> None:
    right = reference(deal("slider_crank", 5))[answer]
    texts = [*TYPED, right]
    assert previews(client, 5, answer, texts) == previews(client, 6, answer, texts)


def test_a_preview_stores_nothing_and_opens_nothing(client: TestClient) -> None:
    number = client.headers["x-variant"]
    right = reference(deal("slider_crank", 7))["l3"]
    client.post(f"/api/v1/variants/{number}/preview", json={"answer": "l3", "text": right})
    assert client.get(f"/api/v1/variants/{number}/solution").status_code == 403
