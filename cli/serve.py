"""`grubler serve`: starts the server."""

from __future__ import annotations

import socket
from argparse import ArgumentParser, Namespace

from cli import store
from cli.problems import Unusable
from server import run as server


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
    _check_address(settings.host, settings.port)
    with store.usable():
        server.serve(settings)
    return 0


def _check_address(host: str, port: int) -> None:
    """Try to listen: the server itself would leave with an exit code that says our fault."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        socket.create_server((host, port), family=family).close()
    except OSError as error:
        raise Unusable("busy", address=f"{host}:{port}", why=error.strerror or error) from None
