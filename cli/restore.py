"""`grubler restore`: takes a copy of a store back into an empty data folder or database."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from cli import store
from cli.backup import said
from server.upkeep import backup as copies


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    store.arguments(parser)
    parser.add_argument("file", metavar="FILE", help="file that `grubler backup` wrote")


def run(options: Namespace) -> int:
    """Take the copy back, then say what it holds."""
    with store.usable():
        said(copies.restore(store.settings(options), Path(options.file)))
    return 0
