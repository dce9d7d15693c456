"""`grubler migrate`: brings the store to the tables of this version."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from cli import store
from server import run as server


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    store.arguments(parser)


def run(options: Namespace) -> int:
    """Run the migrations that the store lacks; the embedded store is made where there is none."""
    with store.usable():
        server.migrate(store.settings(options))
    return 0
