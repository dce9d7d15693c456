"""`grubler backup`: copies the store to a file while the server goes on."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from cli import store
from server.upkeep import backup as copies


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    store.arguments(parser)
    parser.add_argument("file", metavar="FILE", help="file to write; it must not be there yet")


def run(options: Namespace) -> int:
    """Copy, then say what the copy holds."""
    with store.usable():
        said(copies.backup(store.settings(options), Path(options.file)))
    return 0


def said(content: copies.Content) -> None:
    """Print what a copy holds, to be compared after it was taken back."""
    print(f"rows: {content.rows}, tables: {content.tables}, sha256: {content.digest}")
