"""A copy of a store while it works, and its way back; a copy is a file, is never trusted, only compared."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.parse import quote

from sqlalchemy.exc import SQLAlchemyError

from server.migrate import current, migrate
from server.settings import Settings
from server.upkeep import rows

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
    """Copy a store to a file while the server may go on.

    Raises:
        BackupError: There is no store, the file is there already, or it cannot be written.
        MigrationError: A newer version of the program has written the store.
    """
    if file.exists():
        raise BackupError(f"{file} is there already")
    if settings.embedded:
        _copy_embedded(settings.data_dir / NAME, file)
    else:
        _write_out(settings.store_url, file)
    return content(file)


def _copy_embedded(source: Path, file: Path) -> None:
    if not source.is_file():
        raise BackupError(f"there is no store in {source.parent}")
    try:
        with closing(_opened(source)) as held, closing(sqlite3.connect(file)) as copy:
            held.backup(copy, pages=PAGES)
            copy.execute("PRAGMA journal_mode=DELETE")
    except sqlite3.Error as error:
        raise BackupError(f"{file} cannot be written: {error}") from error


def _write_out(url: str, file: Path) -> None:
    """Write the rows of a PostgreSQL store into a fresh file."""
    try:
        if not current(url):
            raise BackupError("the database lacks migrations: run `grubler migrate` first")
        migrate(f"sqlite:///{file}")
        rows.transfer(url, f"sqlite:///{file}")
        _close(file)
    except (sqlite3.Error, SQLAlchemyError, ConnectionError) as error:
        file.unlink(missing_ok=True)
        raise BackupError(f"{file} cannot be written: {error}") from error


def restore(settings: Settings, file: Path) -> Content:
    """Take a copy back into an empty data folder or database, and bring it to the tables of this version.

    Raises:
        BackupError: A store is there already, or the file is no sound copy of ours.
        MigrationError: A newer version of the program has written the copy.
    """
    target = settings.data_dir / NAME
    if settings.embedded and target.exists():
        raise BackupError(f"{target} is there already: name an empty data folder")
    before = content(file)
    if settings.embedded:
        settings.data_dir.mkdir(mode=0o700, parents=True, exist_ok=True)
    with TemporaryDirectory(dir=settings.data_dir if settings.embedded else None) as folder:
        fresh = _sound(file, Path(folder))
        if settings.embedded:
            fresh.rename(target)
        else:
            _write_in(settings.store_url, fresh, Path(folder) / "back.sqlite3")
    return before


def _sound(file: Path, folder: Path) -> Path:
    """Bring a copy of a file to the tables of this version, and refuse any other table."""
    fresh = folder / NAME
    with closing(_opened(file)) as held, closing(sqlite3.connect(fresh)) as copy:
        held.backup(copy)
    migrate(f"sqlite:///{fresh}")
    _same_shape(fresh, folder / "ours.sqlite3")
    _close(fresh)
    return fresh


def _write_in(url: str, fresh: Path, back: Path) -> None:
    """Write the rows of a file into a database; what can be read there again must have the same digest."""
    try:
        migrate(url)
        rows.transfer(f"sqlite:///{fresh}", url)
    except rows.NotEmpty:
        raise BackupError("the database holds something already: name an empty one") from None
    except (SQLAlchemyError, ConnectionError) as error:
        raise BackupError(f"the database does not take the copy: {error}") from error
    _write_out(url, back)
    if content(back) != content(fresh):
        raise BackupError("the database does not hold what the copy holds")


def _close(file: Path) -> None:
    """Leave one file, without a log of writing beside it."""
    with closing(sqlite3.connect(file)) as copy:
        copy.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        copy.execute("PRAGMA journal_mode=DELETE")


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
            found = [f"{name}\x1f{row!r}" for name in tables for row in held.execute(f'SELECT * FROM "{_plain(name)}"')]
    except sqlite3.Error as error:
        raise BackupError(f"{file} is no store: {error}") from error
    return Content(len(found), len(tables), sha256("\x1e".join(sorted(found)).encode()).hexdigest())


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
