"""A40: where a submission cannot be stored nothing is acknowledged, and a time to come back is given."""

from __future__ import annotations

from typing import Any

import pytest
from anyio.from_thread import BlockingPortal
from sqlalchemy import Connection, event
from starlette.testclient import TestClient

from server.people import tokens
from tests.server.stores import everything

LONG = "1" + "0" * 20_000


@pytest.fixture(scope="session")
def chosen() -> None:
    """Takes the embedded store, which can be told how large it may become."""


@pytest.fixture
def pages(client: TestClient) -> Any:
    """Bounds the pages that the store may have, as a full disk does; none lifts the bound."""
    connections = client.app.state.bench.storage._connections  # type: ignore[attr-defined]
    portal = client.portal
    assert isinstance(portal, BlockingPortal)

    def bounded(free: bool) -> None:
        def write(connection: Connection) -> None:
            used = connection.exec_driver_sql("PRAGMA page_count").scalar_one()
            connection.exec_driver_sql(f"PRAGMA max_page_count={2**30 if free else used}")

        portal.call(connections.write, write)

    return bounded


def test_a_full_disk_acknowledges_nothing_and_the_same_request_is_stored_once_later(
    client: TestClient, pages: Any
) -> None:
    path, stored = f"/api/v1/variants/{client.headers['x-variant']}/submissions", []
    pages(free=False)
    for number in range(50):
        reply = client.post(path, json={"answers": {"l3": LONG}}, headers={"idempotency-key": f"try {number}"})
        if reply.status_code != 201:
            break
        stored.append(reply.json()["receipt"]["id"])
    assert (reply.status_code, reply.json()["error"]["code"]) == (503, "unavailable")
    assert int(reply.headers["retry-after"]) > 0
    assert client.get("/health").status_code == 200
    for receipt in stored:  # what was acknowledged before is there
        assert client.get(f"/api/v1/submissions/{receipt}").status_code == 200
    pages(free=True)
    again = [
        client.post(path, json={"answers": {"l3": LONG}}, headers={"idempotency-key": f"try {number}"})
        for _ in range(2)
    ]
    assert [one.status_code for one in again] == [201, 200]
    assert again[0].json()["receipt"] == again[1].json()["receipt"]


def fill(client: TestClient) -> None:
    """Hand in long answers until one cannot be stored."""
    path = f"/api/v1/variants/{client.headers['x-variant']}/submissions"
    while client.post(path, json={"answers": {"l3": LONG}}).status_code == 201:
        pass


def test_a_full_disk_is_not_ready_until_there_is_room(client: TestClient, pages: Any) -> None:
    assert client.get("/ready").status_code == 200
    pages(free=False)
    fill(client)
    full = [client.get("/ready") for _ in range(2)]
    assert [(reply.status_code, reply.headers["retry-after"]) for reply in full] == [(503, "2")] * 2
    assert "grubler_failed_writes_total 3.0" in figures(client)  # the submission, and what each question tried
    pages(free=True)
    assert client.get("/ready").status_code == 200
    assert "room for writing" not in everything(client.app.state.settings.store_url)  # type: ignore[attr-defined]


def test_a_disk_that_was_full_before_the_start_is_not_ready(client: TestClient, pages: Any) -> None:
    pages(free=False)
    assert client.get("/ready").status_code == 503


def test_asking_writes_nothing_where_writes_succeed(client: TestClient) -> None:
    connections = client.app.state.bench.storage._connections  # type: ignore[attr-defined]
    begun: list[Any] = []
    event.listen(connections._writing, "begin", begun.append)
    for _ in range(5):
        assert client.get("/ready").status_code == 200
    assert len(begun) == 2  # the trial of a server that has just started


def figures(client: TestClient) -> str:
    secret = client.app.state.bench.secret  # type: ignore[attr-defined]
    return client.get("/metrics", headers={"authorization": f"Bearer {tokens.issue('administrator', secret)}"}).text
