"""The stores that the benchmarks of the server run on: a file, or a PostgreSQL server that writes through to disk."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.error import URLError
from urllib.request import urlopen

from server.run import migrate
from server.settings import Settings, from_environment
from tests.server.stores import Postgres, running

KINDS = ("sqlite", "postgres")
START = 120.0  # s to wait for a server
Environment = Mapping[str, str]


@contextmanager
def stores(kind: str, number: int = 1) -> Iterator[list[Environment]]:
    """Lay empty stores of a kind; gives the environment in which a server finds each.

    PostgreSQL is the server in GRUBLER_TEST_DATABASE_URL, else one of our own that forces every commit to disk.
    """
    with TemporaryDirectory() as folder:
        folders = [{"GRUBLER_DATA_DIR": f"{folder}/{one}"} for one in range(number)]
        if kind == "sqlite":
            yield [laid(one) for one in folders]
        elif "GRUBLER_TEST_DATABASE_URL" in os.environ:
            server = Postgres(os.environ["GRUBLER_TEST_DATABASE_URL"])
            yield [laid({**one, "DATABASE_URL": server.empty()}) for one in folders]
            server.drop()
        else:
            with running(durable=True) as own:
                server = Postgres(own.address)
                yield [laid({**one, "DATABASE_URL": server.empty()}) for one in folders]


def laid(environment: Environment) -> Environment:
    """Bring a store to the tables of this version."""
    migrate(settings(environment))
    return environment


def settings(environment: Environment) -> Settings:
    """Read the settings of a server."""
    return from_environment(environment)


@contextmanager
def serving(environment: Environment, port: int) -> Iterator[int]:
    """Run a server as people run it, until it is told to end; gives the number of its process."""
    Path(environment["GRUBLER_DATA_DIR"]).mkdir(exist_ok=True)
    command = [sys.executable, "-m", "cli.main", "serve", "--port", str(port)]
    server = subprocess.Popen(
        command, env={**os.environ, **environment}, cwd=Path(__file__).resolve().parents[1], stdout=subprocess.DEVNULL
    )
    try:
        wait_for(server, port)
        yield server.pid
    finally:
        server.terminate()
        server.wait()


def wait_for(server: subprocess.Popen[bytes], port: int) -> None:
    """Wait until a server is ready."""
    deadline = time.monotonic() + START
    while True:
        try:
            with urlopen(f"http://127.0.0.1:{port}/ready", timeout=5):
                return
        except (URLError, OSError):
            if server.poll() is not None or time.monotonic() > deadline:
                raise SystemExit("the server does not start") from None
            time.sleep(0.05)


def cpu(process: int) -> float:
    """Tell how many seconds of a processor a process has used with all that it has started."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    own = sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")
    lists = (task.read_text() for task in Path(f"/proc/{process}/task").glob("*/children"))
    return own + sum(cpu(int(child)) for listed in lists for child in listed.split())
