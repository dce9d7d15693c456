"""`grubler erase`: erases a person; marks stay under a number that is nobody's name."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from cli import store
from cli.problems import Unusable, language
from server import run as server
from server.people import accounts


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("--person", metavar="LOGIN", required=True, help="index number, e-mail or number of the person")
    parser.add_argument("--yes", action="store_true", help="do it: nothing but a backup brings the person back")
    store.arguments(parser)
    language(parser)


def run(options: Namespace) -> int:
    """Erase, then print the number under which the marks stay."""
    settings = store.settings(options)
    if not options.yes:
        raise Unusable("erase_unconfirmed", login=options.person)
    with store.usable():
        server.migrate(settings)
    try:
        print(accounts.erase(settings, options.person))
    except accounts.AccountError as problem:
        raise Unusable(str(problem), login=options.person) from None
    return 0
