"""Figures and log lines name the pattern of a route, never what was asked about."""

from __future__ import annotations

import io
import json
import logging

import pytest
from starlette.testclient import TestClient

from server.people import tokens
from server.settings import SettingsError, from_environment
from server.web import logs
from server.web.logs import Lines


def scraped(client: TestClient) -> str:
    secret = client.app.state.bench.secret  # type: ignore[attr-defined]
    token = tokens.issue("administrator", secret)
    reply = client.get("/metrics", headers={"authorization": f"Bearer {token}"})
    assert reply.status_code == 200 and reply.headers["content-type"].startswith("text/plain")
    return reply.text


def test_requests_are_counted_by_the_pattern_of_their_route(client: TestClient) -> None:
    number = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 3}).json()["id"]
    client.get(f"/api/v1/variants/{number}")
    client.get("/no/such/page")
    client.head("/health")
    said = scraped(client)
    line = 'grubler_requests_total{method="GET",route="/api/v1/variants/{variant}",status="200"} 1.0'
    assert line in said and number not in said
    assert 'route="unknown",status="404"' in said and "such" not in said
    assert 'method="HEAD",route="/health"' in said
    assert 'grubler_request_seconds_count{route="/health"} 1.0' in said


def test_figures_are_for_administrators(client: TestClient) -> None:
    secret = client.app.state.bench.secret  # type: ignore[attr-defined]
    assert client.get("/metrics").status_code == 401
    lecturer = {"authorization": f"Bearer {tokens.issue('lecturer', secret)}"}
    assert client.get("/metrics", headers=lecturer).status_code == 403


def test_a_log_line_is_one_line_of_json_whatever_stands_in_it() -> None:
    held = io.StringIO()
    handler = logging.StreamHandler(held)
    handler.setFormatter(Lines())
    record = logging.LogRecord("grubler", logging.WARNING, "", 0, 'a\n{"level": "x"} "%s"', ("b\r\nc",), None)
    record.fields = {"request": "r-1"}
    handler.emit(record)
    (line,) = held.getvalue().splitlines()
    assert json.loads(line) | {"time": ""} == {
        "time": "", "level": "warning", "logger": "grubler", "message": 'a\n{"level": "x"} "b\r\nc"', "request": "r-1",
    }  # fmt: skip


def test_every_request_is_a_line_with_its_number(client: TestClient, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, "grubler.requests")
    reply = client.get("/health?secret=typed")
    (record,) = [r for r in caplog.records if r.name == "grubler.requests"]
    assert vars(record)["fields"]["request"] == reply.headers["x-request-id"]
    assert vars(record)["fields"]["status"] == 200 and "typed" not in record.getMessage()


def test_the_log_goes_where_it_is_told() -> None:
    root = logging.getLogger()
    handlers, level = root.handlers[:], root.level
    try:
        logs.install("json")
        assert root.level == logging.INFO and isinstance(root.handlers[0].formatter, Lines)
        logs.install("text")
        assert root.level == logging.WARNING
    finally:
        root.handlers[:], root.level = handlers, level


def test_an_unknown_kind_of_log_is_refused() -> None:
    assert from_environment({"GRUBLER_LOG": "json"}).log == "json"
    with pytest.raises(SettingsError, match="GRUBLER_LOG"):
        from_environment({"GRUBLER_LOG": "xml"})
