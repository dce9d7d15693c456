"""What those who run a server rely on: readiness, requests under way when it ends, log lines that name the request."""

from __future__ import annotations

import asyncio
import io
import json
import logging
import signal
import socket
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from alembic.script import ScriptDirectory
from sqlalchemy import text
from starlette.testclient import TestClient

from exercises import grading
from server import run
from server.app import create_app
from server.database.engine import engine
from server.migrations import newest
from server.settings import Settings, SettingsError
from server.web.logs import REQUEST, Lines, Plain
from tests.server.conftest import Live
from tests.server.stores import free_port

TYPED = "12,5 MPa of mine"


def test_a_store_is_ready_with_the_tables_of_this_version_or_of_a_later_one(
    client: TestClient, settings: Settings
) -> None:
    store = engine(settings.store_url, connections=1, begin="BEGIN IMMEDIATE")
    found = []
    for version in ("0001", "9999", newest()):
        with store.begin() as connection:
            connection.execute(text("UPDATE alembic_version SET version_num = :version"), {"version": version})
        found.append(client.get("/ready").status_code)
    store.dispose()
    assert found == [503, 200, 200]


def test_the_newest_version_is_the_one_that_migrations_lead_to() -> None:
    folder = Path(run.__file__).parent / "migrations"
    assert ScriptDirectory(folder).get_current_head() == newest()


def test_a_store_that_takes_its_time_is_not_ready(client: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    async def slow() -> None:
        await asyncio.sleep(60)

    monkeypatch.setattr("server.web.health.SLOWEST", 0.01)
    monkeypatch.setattr(client.app.state.bench.storage, "check", slow)  # type: ignore[attr-defined]
    reply = client.get("/ready")
    assert (reply.status_code, reply.headers["retry-after"]) == (503, "2")


def test_a_database_that_does_not_answer_is_named_at_the_start(tmp_path: Path) -> None:
    away = f"postgresql://grubler:secret@127.0.0.1:{free_port()}/grubler"
    with pytest.raises(SettingsError, match="does not answer") as caught:
        run.serve(Settings(tmp_path, database_url=away))
    assert "secret" not in str(caught.value)


def test_a_server_that_is_told_to_end_answers_what_is_under_way(live: Live) -> None:
    assert live.process is not None
    body = b'{"seed": 7}'
    head = "POST /api/v1/exercises/slider_crank/variants HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\n"
    with socket.create_connection(("127.0.0.1", live.port), timeout=20) as wire:
        wire.sendall(f"{head}Expect: 100-continue\r\nContent-Length: {len(body)}\r\n\r\n".encode())
        assert b" 100 " in wire.recv(4096)  # the request is being read
        live.process.send_signal(signal.SIGTERM)
        with pytest.raises(OSError):
            while True:
                socket.create_connection(("127.0.0.1", live.port), timeout=20).close()
        wire.sendall(body)
        assert wire.recv(4096).startswith(b"HTTP/1.1 201")
    assert live.process.wait(20) in (0, -signal.SIGTERM)


@pytest.fixture(params=[Lines, Plain])
def lines(request: pytest.FixtureRequest) -> Iterator[io.StringIO]:
    held = io.StringIO()
    handler, log = logging.StreamHandler(held), logging.getLogger("grubler")
    handler.setFormatter(request.param())
    log.addHandler(handler)
    yield held
    log.removeHandler(handler)


def test_a_fault_is_logged_with_its_request_and_place_but_without_what_was_typed(
    client: TestClient, lines: io.StringIO, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(submission: Any, *rules: Any, **more: Any) -> None:
        try:
            float(submission.answers["l3"])
        except ValueError as error:
            raise RuntimeError(f"cannot use {submission.answers}") from error

    monkeypatch.setattr(grading, "grade", broken)
    variant = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 7}).json()["id"]
    reply = client.post(f"/api/v1/variants/{variant}/submissions", json={"answers": {"l3": TYPED}})
    said = lines.getvalue()
    assert reply.json()["verdicts"]["l3"]["outcome"] == "fault"
    assert reply.headers["x-request-id"] in said and "RuntimeError from ValueError" in said and "broken" in said
    assert TYPED not in said and "12,5" not in said
    assert REQUEST.get() is None


def test_no_log_line_of_a_lesson_holds_an_answer_or_a_cookie(settings: Settings) -> None:
    held = io.StringIO()
    handler, root = logging.StreamHandler(held), logging.getLogger()
    handler.setFormatter(Lines())
    level = root.level
    root.addHandler(handler)
    root.setLevel(logging.INFO)
    try:
        with TestClient(create_app(settings)) as client:
            variant = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 7}).json()["id"]
            client.post(f"/api/v1/variants/{variant}/submissions", json={"answers": {"l3": TYPED}})
            client.post(f"/api/v1/variants/{variant}/preview", json={"answer": "l3", "text": TYPED})
            client.post("/api/v1/sessions", json={"login": "anna", "password": TYPED})
            cookie = client.cookies["grubler_practice"]
    finally:
        root.removeHandler(handler)
        root.setLevel(level)
    said = [line for line in held.getvalue().splitlines() if json.loads(line)["logger"].startswith("grubler")]
    asked = [json.loads(line) for line in said if "grubler.requests" in line]
    assert len(asked) == 4 and all(line["request"].startswith("r-") for line in asked)
    for secret in (TYPED, cookie, variant, "anna"):
        assert secret not in "".join(said)
