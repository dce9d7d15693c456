"""`grubler user`: makes accounts, and links for those who cannot get in."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from cli import store
from cli.problems import Unusable, language
from server import run as server
from server.people import accounts

ROLES = ("student", "lecturer", "administrator")


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("action", choices=("add", "reset"), help="a new account, or a new link for one that is there")
    missing = "index number or e-mail; reset without one is for the first administrator"
    parser.add_argument("login", nargs="?", metavar="LOGIN", help=missing)
    parser.add_argument("--name", default="", help="name of the new person")
    parser.add_argument(
        "--role", choices=ROLES, default="lecturer", help="what the new person may do (default: lecturer)"
    )
    store.arguments(parser)
    parser.add_argument("--port", help="port of the server, for the address in the link")
    parser.add_argument("--public-url", metavar="URL", help="address people type, for the address in the link")
    language(parser)


def run(options: Namespace) -> int:
    """Print a one-time link and nothing else."""
    settings = store.settings(options)
    with store.usable():
        server.migrate(settings)
    try:
        if options.action == "add":
            print(accounts.add(settings, options.login or "", options.name, options.role))
        else:
            print(accounts.reset(settings, options.login))
    except accounts.AccountError as problem:
        raise Unusable(str(problem), login=options.login) from None
    return 0
