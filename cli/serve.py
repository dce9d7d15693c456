"""`grubler serve`: starts the server."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from cli import store
from cli.problems import Unusable
from server import run as server

CANNOT_BIND = 1  # how uvicorn leaves when it cannot listen at the address


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    store.arguments(parser)
    parser.add_argument("--host", help="address to listen at (default: GRUBLER_HOST, or 127.0.0.1)")
    parser.add_argument("--port", help="port to listen at (default: GRUBLER_PORT, or 8000)")
    parser.add_argument("--public-url", metavar="URL", help="address people type, where a proxy stands in front")
    plain = "let other machines in over plain http: answers and cookies can be read on their way"
    parser.add_argument("--insecure-http", action="store_true", help=plain)


def run(options: Namespace) -> int:
    """Serve until the process is told to end."""
    settings = store.settings(options)
    with store.usable():
        try:
            server.serve(settings)
        except SystemExit as stop:
            if stop.code == CANNOT_BIND:
                raise Unusable("busy", address=f"{settings.host}:{settings.port}") from None
            raise
    return 0
