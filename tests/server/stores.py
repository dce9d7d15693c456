"""Stores with the tables of this version: the migrations run once, and the file that they made is copied."""

from __future__ import annotations

import atexit
from functools import cache
from pathlib import Path
from shutil import copyfile, rmtree
from tempfile import mkdtemp

from sqlalchemy import make_url

from server.migrate import migrate
from server.settings import Settings


def lay(settings: Settings) -> str:
    """Lay an empty store for a server that does not run yet; gives its address."""
    url = settings.store_url
    place = make_url(url)
    if place.get_backend_name() == "sqlite" and place.database:
        copyfile(_pattern(), place.database)
    else:
        migrate(url)
    return url


@cache
def _pattern() -> Path:
    folder = Path(mkdtemp(prefix="grubler-store-"))
    atexit.register(rmtree, folder)
    url = Settings(folder).store_url
    migrate(url)
    return Path(str(make_url(url).database))
