"""A copy of the embedded store while it works, and its way back; a copy is never trusted, only compared."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.parse import quote

from server.migrate import migrate
from server.settings import Settings

NAME = "grubler.sqlite3"
PAGES = 256  # copied at a time, so that a writer waits for no longer


class BackupError(ValueError):
    """The copy cannot be made or taken back; the message says why."""


@dataclass(frozen=True, slots=True)
class Content:
    """What a store holds: rows of each table and one digest over all of them."""

    rows: int
    tables: int
    digest: str


def backup(settings: Settings, file: Path) -> Content:
    """Copy the embedded store to a file while the server may go on.

    Raises:
        BackupError: There is no embedded store, the file is there already, or it cannot be written.
    """
    if not settings.embedded:
        raise BackupError("a PostgreSQL store is copied by pg_dump")
    source = settings.data_dir / NAME
    if not source.is_file():
        raise BackupError(f"there is no store in {settings.data_dir}")
    if file.exists():
        raise BackupError(f"{file} is there already")
    try:
        with closing(_opened(source)) as held, closing(sqlite3.connect(file)) as copy:
            held.backup(copy, pages=PAGES)
            copy.execute("PRAGMA journal_mode=DELETE")
    except sqlite3.Error as error:
        raise BackupError(f"{file} cannot be written: {error}") from error
    return content(file)


def restore(settings: Settings, file: Path) -> Content:
    """Take a copy back into an empty data folder, and bring it to the tables of this version.

    Raises:
        BackupError: A store is there already, or the file is no sound copy of ours.
        MigrationError: A newer version of the program has written the copy.
    """
    target = settings.data_dir / NAME
    if not settings.embedded:
        raise BackupError("a PostgreSQL store is restored by pg_restore")
    if target.exists():
        raise BackupError(f"{target} is there already: name an empty data folder")
    before = content(file)
    settings.data_dir.mkdir(mode=0o700, parents=True, exist_ok=True)
    with TemporaryDirectory(dir=settings.data_dir) as folder:
        fresh = Path(folder) / NAME
        with closing(_opened(file)) as held, closing(sqlite3.connect(fresh)) as copy:
            held.backup(copy)
        migrate(f"sqlite:///{fresh}")
        _same_shape(fresh, Path(folder) / "ours.sqlite3")
        with closing(sqlite3.connect(fresh)) as copy:
            copy.execute("PRAGMA wal_checkpoint(TRUNCATE)")
            copy.execute("PRAGMA journal_mode=DELETE")
        fresh.rename(target)
    return before


def content(file: Path) -> Content:
    """Count and digest all rows, whatever the order in which they were written.

    Raises:
        BackupError: The file is no sound store.
    """
    try:
        with closing(_opened(file)) as held:
            if held.execute("PRAGMA integrity_check").fetchone() != ("ok",):
                raise BackupError(f"{file} is damaged")
            names = [
                name for (name,) in held.execute("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")
            ]
            tables = [name for name in names if not name.startswith("sqlite_")]
            rows = [f"{name}\x1f{row!r}" for name in tables for row in held.execute(f'SELECT * FROM "{_plain(name)}"')]
    except sqlite3.Error as error:
        raise BackupError(f"{file} is no store: {error}") from error
    return Content(len(rows), len(tables), sha256("\x1e".join(sorted(rows)).encode()).hexdigest())


def _plain(name: str) -> str:
    if not name.replace("_", "").isalnum():
        raise BackupError(f"a table is called {name!r}")
    return name


def _opened(file: Path) -> sqlite3.Connection:
    """Open for reading only; nothing that stands in the file is run."""
    held = sqlite3.connect(f"file:{quote(str(file.resolve()))}?mode=ro", uri=True)
    held.execute("PRAGMA trusted_schema=OFF")
    return held


def _same_shape(file: Path, ours: Path) -> None:
    """Refuse what our migrations do not make: a foreign trigger or view would run later."""
    migrate(f"sqlite:///{ours}")
    if _shape(file) != _shape(ours):
        raise BackupError("the copy has tables, views or triggers that this program does not make")


def _shape(file: Path) -> set[tuple[str, ...]]:
    with closing(_opened(file)) as held:
        return set(held.execute("SELECT type, name, tbl_name, coalesce(sql, '') FROM sqlite_master"))
