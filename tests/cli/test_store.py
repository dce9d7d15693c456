"""The commands that work on a server's store: serve, migrate, token."""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest

from server import run as server
from server.people.tokens import read
from server.policy import Role
from server.settings import Settings
from tests.cli.calling import ROOT, run


@pytest.fixture(autouse=True)
def _no_settings(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("GRUBLER_PORT", "GRUBLER_HOST", "GRUBLER_DATA_DIR", "GRUBLER_SECRET", "DATABASE_URL"):
        monkeypatch.delenv(name, raising=False)


def test_migrate_makes_the_store_and_may_be_repeated(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "deep" / "data"
    assert [run(capsys, "migrate", "--data-dir", str(folder)) for _ in range(2)] == [(0, "", "")] * 2
    assert (folder / "grubler.sqlite3").is_file()


def test_a_store_that_cannot_be_made_is_unusable(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    code, _, err = run(capsys, "migrate", "--data-dir", str(tmp_path / "file" / "data"))
    assert code == 2 and "the data folder" in err


def test_a_database_of_another_kind_is_unusable(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DATABASE_URL", "mysql://somewhere/x")
    code, _, err = run(capsys, "migrate")
    assert code == 2 and "must begin with postgresql://" in err


@pytest.mark.parametrize("command", ["worker", "migrate", "audit", "user reset", "erase --person 1 --yes"])
def test_a_database_that_does_not_answer_is_no_fault_of_the_program(
    command: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DATABASE_URL", "postgresql://somebody:hidden@127.0.0.1:1/x")
    code, out, err = run(capsys, *command.split())
    assert (code, out) == (2, "") and err.startswith("grubler: the store does not answer: ")
    assert err.count("\n") == 1 and "hidden" not in err


def test_a_token_holds_the_role_under_the_secret_of_the_environment(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GRUBLER_SECRET", "of the test")
    code, out, err = run(capsys, "token", "--role", "lecturer")
    assert (code, err) == (0, "")
    assert read(out.strip(), b"of the test")[0] is Role.LECTURER


def test_a_token_can_be_had_before_the_first_start(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    one, other = (run(capsys, "token", "--role", "student", "--data-dir", str(tmp_path)) for _ in range(2))
    assert one[0] == other[0] == 0 and one[1].count(".") == 2


@pytest.mark.parametrize("arguments", [["--role", "king"], [], ["--role", "lecturer", "--hours", "-1"]])
def test_a_token_for_nobody_is_unusable(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(capsys, "token", *arguments)[0] == 2


@pytest.mark.parametrize("hours", ["nan", "-1", "0", "long", "1e9"])
def test_the_hours_of_a_token_are_asked_for(hours: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, _, err = run(capsys, "token", "--role", "student", f"--hours={hours}")
    assert code == 2 and f"{hours!r} is not a number of hours" in err


@pytest.mark.parametrize("port", ["0", "65536", "http"])
def test_a_port_that_is_none_is_unusable(port: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, _, err = run(capsys, "serve", "--port", port)
    assert code == 2 and "the port must be a number" in err


def test_plain_http_for_others_must_be_asked_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, _, err = run(capsys, "serve", "--host", "0.0.0.0", "--data-dir", str(tmp_path / "data"))
    assert code == 2 and "--insecure-http" in err and not (tmp_path / "data").exists()


def test_options_reach_the_server(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    started: list[Settings] = []
    monkeypatch.setattr(server, "serve", started.append)
    options = ["--host", "127.0.0.2", "--port", "8001", "--data-dir", str(tmp_path), "--insecure-http"]
    assert run(capsys, "serve", *options, "--public-url", "https://lab.example")[0] == 0
    (found,) = started
    assert (found.host, found.port, found.data_dir) == ("127.0.0.2", 8001, tmp_path)
    assert found.insecure_http and found.public_url == "https://lab.example"


@pytest.mark.parametrize("host", ["127.0.0.1", "2001:db8::1", "no-such-host.invalid"])
def test_an_address_that_cannot_be_listened_at_is_unusable(
    host: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with socket.create_server(("127.0.0.1", 0)) as holder:
        port = str(holder.getsockname()[1])
        code, _, err = run(capsys, "serve", "--host", host, "--port", port, "--data-dir", str(tmp_path))
    assert code == 2 and "cannot be listened at" in err and len(err.splitlines()) == 1


def free_port() -> int:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        port: int = listener.getsockname()[1]
        return port


@pytest.fixture
def served(tmp_path: Path) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """A server and its address; it is ended as a service manager ends it."""
    port = free_port()
    command = [sys.executable, "-m", "cli.main", "serve", "--port", str(port), "--data-dir", str(tmp_path)]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        yield f"http://127.0.0.1:{port}", process
        process.terminate()
        process.wait(30)


def test_serve_answers_from_a_fresh_folder(served: tuple[str, subprocess.Popen[str]]) -> None:
    address, process = served
    deadline = time.monotonic() + 120
    while process.poll() is None and time.monotonic() < deadline:
        try:
            with urllib.request.urlopen(f"{address}/ready", timeout=10) as response:
                assert json.loads(response.read()) == {"status": "ready"}
            return
        except urllib.error.URLError:
            time.sleep(0.1)
    raise AssertionError(f"the server does not answer; exit code {process.poll()}")


def test_an_account_is_made_and_let_in_again_by_links(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    place = ["--data-dir", str(tmp_path)]
    for good in (("reset",), ("add", "anna@uni", "--name", "Anna"), ("reset", "Anna@Uni")):
        code, out, _ = run(capsys, "user", *good, *place)
        assert code == 0 and out.startswith("http://127.0.0.1:8000/links/")
    refusals = {("reset", "nobody"): "nobody signs in", ("add", "anna@uni", "--name", "Ann"): "is there already",
                ("add", "a b", "--name", "Ann"): "a login is", ("add", "x"): "a name has"}  # fmt: skip
    for words, said in refusals.items():
        code, _, err = run(capsys, "user", *words, *place)
        assert code == 2 and said in err
