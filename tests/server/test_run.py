"""The real server over a real socket: it starts, survives a power cut, and refuses to be exposed."""

from __future__ import annotations

import json
import socket
from http.client import HTTPConnection
from pathlib import Path
from typing import Any

import pytest
import uvicorn

from server import run
from server.database import secret_of
from server.people import tokens
from server.policy import Role
from server.settings import Settings, SettingsError
from tests.depth import amount
from tests.server.conftest import Live

CYCLES = amount(1, 2)
EACH = 5


def call(server: Live, method: str, path: str, body: Any = None, **headers: str) -> tuple[int, Any, dict[str, str]]:
    connection = HTTPConnection("127.0.0.1", server.port, timeout=20)
    content = json.dumps(body).encode() if body is not None else None
    sent = {"Content-Type": "application/json", **{name.replace("_", "-"): value for name, value in headers.items()}}
    connection.request(method, path, content, sent)
    reply = connection.getresponse()
    answered = reply.status, json.loads(reply.read() or b"null"), dict(reply.getheaders())
    connection.close()
    return answered


def test_a_task_is_dealt_answered_and_graded_over_a_socket(site: Live) -> None:
    status, variant, headers = call(site, "POST", "/api/v1/exercises/slider_crank/variants", {"seed": 7})
    assert status == 201
    cookie = headers["set-cookie"].split(";")[0]
    path = f"/api/v1/variants/{variant['id']}/submissions"
    status, graded, headers = call(site, "POST", path, {"answers": {"l3": "1 mm"}}, Cookie=cookie)
    assert status == 201 and graded["verdicts"]["l3"]["outcome"] == "wrong"
    assert "server" not in {name.lower() for name in headers}


def test_what_was_acknowledged_survives_kill_9(live: Live) -> None:
    _, variant, headers = call(live, "POST", "/api/v1/exercises/slider_crank/variants", {"seed": 7})
    cookie = headers["set-cookie"].split(";")[0]
    path = f"/api/v1/variants/{variant['id']}/submissions"
    kept: dict[str, Any] = {}
    for _ in range(CYCLES):
        for number in range(EACH):
            status, graded, _ = call(live, "POST", path, {"answers": {"l3": f"{number} mm"}}, Cookie=cookie)
            assert status == 201
            kept[graded["receipt"]["id"]] = graded
        live.kill()
        live.start()
        for receipt, graded in kept.items():
            assert call(live, "GET", f"/api/v1/submissions/{receipt}", Cookie=cookie)[:2] == (200, graded)


def test_a_token_made_beside_the_running_server_is_accepted(site: Live) -> None:
    bearer = f"Bearer {run.token(Settings(site.folder), 'lecturer')}"
    assert call(site, "GET", "/api/v1/exercises", Authorization=bearer)[0] == 200


def test_a_body_sent_in_pieces_without_end_is_bounded(site: Live) -> None:
    with socket.create_connection(("127.0.0.1", site.port), timeout=20) as wire:
        head = b"POST /api/v1/exercises/slider_crank/variants HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\n"
        wire.sendall(head + b"Transfer-Encoding: chunked\r\n\r\n")
        try:
            for _ in range(200):
                wire.sendall(b"400\r\n" + b" " * 1024 + b"\r\n")
        except OSError:
            pass
        assert b" 413 " in wire.recv(4096).split(b"\r\n")[0]


def test_an_address_that_others_can_reach_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="plain http"):
        run.serve(Settings(tmp_path, host="0.0.0.0"))
    assert not list(tmp_path.iterdir())


def test_a_token_needs_no_running_server(tmp_path: Path) -> None:
    settings = Settings(tmp_path / "new" / "folder")
    made = run.token(settings, "student")
    assert tokens.read(made, secret_of(settings.store_url))[0] is Role.STUDENT
    with_secret = Settings(tmp_path / "none", secret=b"s")
    assert tokens.read(run.token(with_secret, "lecturer"), b"s")[0] is Role.LECTURER
    assert not with_secret.data_dir.exists()


def test_a_data_folder_that_cannot_be_made_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(SettingsError, match="cannot be made"):
        run.migrate(Settings(tmp_path / "file" / "data"))


def test_postgresql_without_migrations_is_not_served(database_url: str, tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="grubler migrate"):
        run.serve(Settings(tmp_path, database_url=database_url))


@pytest.mark.parametrize("embedded", [True, False])
def test_the_store_is_brought_up_to_date_and_served(
    embedded: bool, request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    served: list[uvicorn.Config] = []

    def answer(server: run.Announced) -> None:
        served.append(server.config)
        server.started = True

    monkeypatch.setattr(run.Announced, "run", answer)
    url = None if embedded else request.getfixturevalue("database_url")
    settings = Settings(tmp_path / "data", host="::1", port=8123, database_url=url)
    if not embedded:
        run.migrate(settings)
    run.serve(settings)
    assert (served[0].host, served[0].port, served[0].proxy_headers) == ("::1", 8123, False)


def test_the_address_is_told_once_the_server_listens(site: Live) -> None:
    listens, first = site.said().splitlines()
    assert listens == f"Grübler listens at http://127.0.0.1:{site.port}"
    assert f"http://127.0.0.1:{site.port}/links/" in first


def test_a_port_that_is_taken_is_no_success(tmp_path: Path, capsys: Any) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        with pytest.raises(SystemExit):
            run.serve(Settings(tmp_path, port=taken.getsockname()[1]))
    assert "listens" not in capsys.readouterr().out
