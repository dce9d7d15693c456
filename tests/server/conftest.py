"""Servers and stores for the tests of the server room."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

import pytest
from starlette.testclient import TestClient

from server.app import create_app
from server.database import Database
from server.judging.thread import JudgingThread
from server.settings import Settings
from server.web import language as languages
from tests.conftest import REQUIRED, Laid
from tests.server.school import School, opened
from tests.server.stores import Postgres, free_port, lay

SECRET = b"a secret of the tests"
PROGRAM = """
import os
from server.run import serve
from server.settings import from_environment
serve(from_environment(os.environ))
"""
START = 90.0  # s to wait for a server


def leave_out(need: str, reason: str) -> None:
    """Leave a test out by name, unless the machine is required to have what it needs."""
    assert need not in REQUIRED, f"{need} is required: {reason}"
    pytest.skip(reason)


@pytest.fixture
def settings(tmp_path: Path, laid: Laid) -> Settings:
    """Settings of a server with a store of its own."""
    return laid(tmp_path, secret=SECRET)


@pytest.fixture
def client(settings: Settings) -> Iterator[TestClient]:
    """A client of a server that runs in this process; errors come back as responses."""
    with TestClient(create_app(settings), raise_server_exceptions=False) as found:
        yield found


@pytest.fixture(scope="session", autouse=True)
def told_as_to_a_judge() -> Iterator[None]:
    """What a thread of this process computes could as well be told to the judge of a server, and be told by it."""
    run = JudgingThread.run

    async def told(judging: JudgingThread, compute: Callable[..., object], *args: object, **kwargs: object) -> object:
        pickle.loads(pickle.dumps((compute, args, kwargs)))
        return pickle.loads(pickle.dumps(await run(judging, compute, *args, **kwargs)))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(JudgingThread, "run", told)
        yield


@pytest.fixture(autouse=True)
def no_language_chosen(request: pytest.FixtureRequest) -> Iterator[None]:
    """A test leaves no language chosen in the browsers of a course that it shares with others."""
    yield
    course = getattr(request.node, "funcargs", {}).get("course")
    for browser in [] if course is None else vars(course).values():
        if isinstance(browser, TestClient):
            browser.cookies.delete(languages.COOKIE)


@pytest.fixture(scope="module")
def shared_database_url(postgres: Postgres) -> str:
    """The address of an empty PostgreSQL database that the tests of a module share."""
    return postgres.empty()


@pytest.fixture
def database_url(postgres: Postgres) -> str:
    """The address of an empty PostgreSQL database."""
    return postgres.empty()


@pytest.fixture(params=["sqlite", "postgres"])
def store_url(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[str]:
    """The address of a store with the tables of this version, on each database."""
    if request.param == "sqlite":
        yield lay(Settings(tmp_path))
        return
    server: Postgres = request.getfixturevalue("postgres")
    address = server.lend()
    yield Settings(database_url=address).store_url
    server.take_back(address)


@pytest.fixture
def database(store_url: str) -> Iterator[Database]:
    """An empty store."""
    made = Database(store_url)
    yield made
    made.close()


@dataclass
class Live:
    """A server in a process of its own, reached through a socket; `changed` is a line that it runs first."""

    folder: Path
    port: int = field(default_factory=free_port)
    changed: str = ""
    process: subprocess.Popen[bytes] | None = None

    @property
    def url(self) -> str:
        """Its address."""
        return f"http://127.0.0.1:{self.port}"

    def start(self) -> None:
        """Start the process and wait until it serves."""
        environ = {**os.environ, "GRUBLER_DATA_DIR": str(self.folder), "GRUBLER_PORT": str(self.port)}
        with self.folder.with_suffix(".out").open("wb") as out:
            self.process = subprocess.Popen(
                [sys.executable, "-c", f"{self.changed}\n{PROGRAM}"], env=environ, stdout=out
            )
        try:
            self._wait(self.process, time.monotonic() + START)
        except BaseException:
            self.kill()
            raise

    def _wait(self, process: subprocess.Popen[bytes], deadline: float) -> None:
        while not self._serves():
            assert process.poll() is None, "the server has ended"
            assert time.monotonic() < deadline, "the server does not start"
            time.sleep(0.05)

    def _serves(self) -> bool:
        try:
            with urlopen(f"{self.url}/ready", timeout=1) as answer:
                return bool(answer.status == 200)
        except (URLError, OSError):
            return False

    def said(self) -> str:
        """What it has printed since it was last started."""
        return self.folder.with_suffix(".out").read_text("utf-8")

    def kill(self) -> None:
        """End it as a power cut would."""
        assert self.process is not None
        self.process.kill()
        self.process.wait()


@pytest.fixture
def live(tmp_path: Path) -> Iterator[Live]:
    """A running server."""
    server = Live(tmp_path / "data")
    server.start()
    yield server
    server.kill()


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Live]:
    """A running server that the tests of a session share."""
    server = Live(tmp_path_factory.mktemp("site"))
    server.start()
    yield server
    server.kill()


@pytest.fixture
def deal(client: TestClient) -> Callable[..., str]:
    """Deal a variant to the client's cookie; gives its number."""

    def dealt(exercise: str = "slider_crank", seed: int = 7) -> str:
        reply = client.post(f"/api/v1/exercises/{exercise}/variants", json={"seed": seed})
        assert reply.status_code == 201, reply.text
        number: str = reply.json()["id"]
        return number

    return dealt


@pytest.fixture
def school(settings: Settings) -> Iterator[School]:
    """A server with a course and somebody of every role."""
    with opened(settings) as found:
        yield found
