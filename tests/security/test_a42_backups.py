"""A42: a copy made while the server works comes back with the same digest; a damaged or foreign one is refused."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from server.app import create_app
from server.run import migrate
from server.settings import Settings
from server.upkeep import backup as copies
from server.upkeep.backup import BackupError, backup, content, restore
from tests.server.stores import Postgres, free_port


@pytest.fixture
def filled(tmp_path: Path) -> Settings:
    """A store with a variant and a submission."""
    settings = Settings(tmp_path / "held", limited=False)
    migrate(settings)
    with TestClient(create_app(settings), base_url="http://localhost") as client:
        number = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 3}).json()["id"]
        client.post(f"/api/v1/variants/{number}/submissions", json={"answers": {"l3": "0,3 m"}})
    return settings


def test_the_restored_copy_has_the_same_digest_and_is_served(filled: Settings, tmp_path: Path) -> None:
    made = backup(filled, tmp_path / "copy")
    assert made == content(filled.data_dir / copies.NAME) and made.rows > 3
    back = Settings(tmp_path / "back", limited=False)
    assert restore(back, tmp_path / "copy") == made == content(back.data_dir / copies.NAME)
    with TestClient(create_app(back), base_url="http://localhost") as client:
        assert client.get("/ready").status_code == 200
    assert [entry.name for entry in back.data_dir.iterdir() if entry.is_dir()] == []


def test_a_copy_is_made_while_the_server_writes(filled: Settings, tmp_path: Path) -> None:
    with TestClient(create_app(filled), base_url="http://localhost") as client:
        numbers = []
        for seed in range(5):
            wish = {"seed": seed}
            numbers.append(client.post("/api/v1/exercises/gear_train/variants", json=wish).json()["id"])
            backup(filled, tmp_path / f"copy{seed}")
    with closing(sqlite3.connect(tmp_path / "copy4")) as copy:
        assert {number for (number,) in copy.execute("SELECT id FROM variants")} >= set(numbers)


def test_nothing_is_written_over(filled: Settings, tmp_path: Path) -> None:
    backup(filled, tmp_path / "copy")
    with pytest.raises(BackupError, match="there already"):
        backup(filled, tmp_path / "copy")
    with pytest.raises(BackupError, match="empty data folder"):
        restore(filled, tmp_path / "copy")


def test_a_store_that_is_not_there_is_named(filled: Settings, tmp_path: Path) -> None:
    elsewhere = Settings(tmp_path, database_url=f"postgresql://127.0.0.1:{free_port()}/grubler")
    with pytest.raises(BackupError, match="cannot be written"):
        backup(elsewhere, tmp_path / "copy")
    assert not (tmp_path / "copy").exists()
    with pytest.raises(BackupError, match="no store"):
        backup(Settings(tmp_path / "none"), tmp_path / "copy")
    backup(filled, tmp_path / "copy")
    with pytest.raises(BackupError, match="does not take the copy"):
        restore(elsewhere, tmp_path / "copy")


def test_a_drill_on_postgresql_gives_the_same_digest_and_a_server_that_goes_on(
    filled: Settings, tmp_path: Path, postgres: Postgres
) -> None:
    first, second = (Settings(tmp_path, database_url=postgres.empty(), limited=False) for _ in range(2))
    copied = backup(filled, tmp_path / "copy")
    assert restore(first, tmp_path / "copy") == copied
    with TestClient(create_app(first), base_url="http://localhost") as client:
        number = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 3}).json()["id"]
        graded = client.post(f"/api/v1/variants/{number}/submissions", json={"answers": {"l3": "1 m"}}).json()
        made = backup(first, tmp_path / "more")
        cookie = client.cookies["grubler_practice"]
    assert restore(second, tmp_path / "more") == made and made.rows > copied.rows
    assert backup(second, tmp_path / "again") == made
    with TestClient(create_app(second), base_url="http://localhost", cookies={"grubler_practice": cookie}) as client:
        assert client.get(f"/api/v1/submissions/{graded['receipt']['id']}").json() == graded
        answers = {"answers": {"l3": "2 m"}}
        assert client.post(f"/api/v1/variants/{number}/submissions", json=answers).status_code == 201
    with pytest.raises(BackupError, match="holds something already"):
        restore(second, tmp_path / "copy")


def test_a_database_without_tables_is_not_copied(tmp_path: Path, postgres: Postgres) -> None:
    with pytest.raises(BackupError, match="grubler migrate"):
        backup(Settings(tmp_path, database_url=postgres.empty()), tmp_path / "copy")


@pytest.mark.parametrize(
    "change",
    [
        "CREATE TRIGGER t AFTER INSERT ON variants BEGIN DELETE FROM grades; END",
        "CREATE VIEW v AS SELECT * FROM submissions",
        "CREATE TABLE more (a INTEGER)",
        "DROP TRIGGER submissions_never_change",
    ],
)
def test_a_copy_with_a_foreign_shape_is_refused(filled: Settings, tmp_path: Path, change: str) -> None:
    backup(filled, tmp_path / "copy")
    with closing(sqlite3.connect(tmp_path / "copy")) as copy:
        copy.execute(change)
        copy.commit()
    back = Settings(tmp_path / "back")
    with pytest.raises(BackupError, match="does not make"):
        restore(back, tmp_path / "copy")
    assert not (back.data_dir / copies.NAME).exists()


@pytest.mark.parametrize("cut", [0, 100, 5000])
def test_a_damaged_copy_is_refused(filled: Settings, tmp_path: Path, cut: int) -> None:
    backup(filled, tmp_path / "copy")
    whole = (tmp_path / "copy").read_bytes()
    (tmp_path / "copy").write_bytes(whole[:cut] + bytes(9000) + whole[cut + 9000 :] if cut else b"no store at all")
    back = Settings(tmp_path / "back")
    with pytest.raises(BackupError):
        restore(back, tmp_path / "copy")
    assert not (back.data_dir / copies.NAME).exists()
