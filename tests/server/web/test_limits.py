"""Posts are limited by person and by address, and nobody behind one address is locked out by a class."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from fastapi.testclient import TestClient

from server import reader
from server.app import create_app
from server.settings import Settings
from server.web import limits
from server.web.limits import ADDRESS, NEWCOMERS, OWNER, Limiter, Rate


class Clock:
    """A clock that is set by hand."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


def test_a_burst_passes_and_then_the_refill() -> None:
    clock = Clock()
    limiter = Limiter(clock)
    rate = Rate(3, 0.5)
    assert [limiter.wait(rate, "a") for _ in range(4)] == [0, 0, 0, 2]
    clock.now = 1.9
    assert limiter.wait(rate, "a") == 1
    clock.now = 2.0
    assert [limiter.wait(rate, "a") for _ in range(2)] == [0, 2]
    assert limiter.wait(rate, "b") == 0


def test_what_is_kept_of_strangers_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "KEPT", 5)
    limiter = Limiter(Clock())
    for number in range(50):
        limiter.wait(OWNER, str(number))
    assert len(limiter._left) == 5


def test_a_class_of_sixty_behind_one_address_is_not_locked_out() -> None:
    """Ten minutes: everybody opens four exercises, previews every third second and submits once a minute."""
    clock, refused = Clock(), 0
    limiter = Limiter(clock)
    for second in range(600):
        clock.now = float(second)
        for student in range(60):
            if second < 2 and student % 2 == second:
                refused += bool(limiter.wait(NEWCOMERS, "school"))
            if (second + student) % 3 == 0 or (second + student) % 60 == 7:
                refused += bool(limiter.wait(ADDRESS, "school")) + bool(limiter.wait(OWNER, str(student)))
    assert refused == 0


def test_a_flood_of_one_person_is_told_when_to_come_back(client: TestClient, deal: Callable[..., str]) -> None:
    path = f"/api/v1/variants/{deal()}/preview"
    body = {"answer": "l3", "text": "1"}
    for _ in range(2 * int(OWNER.burst)):
        refused = client.post(path, json=body)
        if refused.status_code != 200:
            break
    assert refused.status_code == 429 and refused.json()["error"]["code"] == "too_many"
    assert int(refused.headers["Retry-After"]) >= 1
    assert refused.headers["Retry-After"] in refused.json()["error"]["message"]
    pages = (client.post(f"/variants/{path.split('/')[4]}", data={}, headers={"Accept": "text/html"}) for _ in range(9))
    page = next(page for page in pages if page.status_code == 429)
    assert 'data-countdown="' in page.text
    assert client.get(f"/variants/{path.split('/')[4]}").status_code == 200


def test_a_flood_of_documents_is_stopped_with_a_countdown_while_other_posts_pass(
    client: TestClient, deal: Callable[..., str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reader, "DOCUMENTS", Rate(3, 1e-3))
    path = f"/api/v1/reports/tmm2/{deal('tmm2_oop')}.typ"
    assert len({client.get(path).content for _ in range(3)}) == 1
    refused = client.get(path)
    assert (refused.status_code, refused.json()["error"]["code"]) == (429, "too_many")
    page = client.get(path, headers={"accept": "text/html", "sec-fetch-mode": "navigate"})
    assert page.status_code == 429 and f'data-countdown="{page.headers["retry-after"]}"' in page.text
    assert client.get("/").status_code == 200 and deal()
    client.cookies.clear()
    monkeypatch.setattr(reader, "DOCUMENTS_OF_ADDRESS", Rate(2, 1e-3))
    assert [client.get(path).status_code for _ in range(3)] == [404, 404, 429]


def test_strangers_of_one_address_are_limited_together_unless_a_proxy_hides_them(
    settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reader, "NEWCOMERS", Rate(20, 1e-6))

    def first_refusal(chosen: Settings) -> int | None:
        with TestClient(create_app(chosen)) as client:
            for number in range(30):
                client.cookies.clear()
                if client.post("/api/v1/exercises/none/variants", json={}).status_code == 429:
                    return number
        return None

    refused = first_refusal(settings)
    assert refused == 20
    assert first_refusal(replace(settings, public_url="https://grubler.example")) is None
    assert first_refusal(replace(settings, limited=False)) is None
