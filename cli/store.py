"""The options of the commands that work on a server's store, and what they cannot use."""

from __future__ import annotations

import os
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from contextlib import contextmanager

from cli.problems import Unusable
from server.database.engine import UNANSWERED
from server.migrate import MigrationError
from server.settings import Settings, SettingsError, from_environment
from server.upkeep.backup import BackupError


def arguments(parser: ArgumentParser) -> None:
    """Add the option that names the store."""
    parser.add_argument("--data-dir", metavar="DIR", help="folder of the store (default: GRUBLER_DATA_DIR, or data)")


def settings(options: Namespace) -> Settings:
    """Make the settings from the options and the environment; raises Unusable."""
    with usable():
        given = {name: getattr(options, name, None) for name in ("data_dir", "host", "port", "public_url")}
        return from_environment(os.environ, insecure_http=getattr(options, "insecure_http", False), **given)


@contextmanager
def usable() -> Iterator[None]:
    """Turn settings that the server refuses, and a store that does not answer, into unusable input."""
    try:
        yield
    except UNANSWERED as error:
        raise Unusable("unanswered", why=error) from error
    except (SettingsError, MigrationError, BackupError) as error:
        raise Unusable("settings", why=error) from error
