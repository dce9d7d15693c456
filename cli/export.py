"""`grubler export`: writes all that is kept of a person as JSON."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace

from cli import store
from cli.problems import Unusable, language
from server import accounts
from server import run as server


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument(
        "--person", metavar="LOGIN", help="all that is kept of this person: index number, e-mail or number"
    )
    store.arguments(parser)
    language(parser)


def run(options: Namespace) -> int:
    """Print what is asked for and nothing else."""
    settings = store.settings(options)
    with store.usable():
        server.migrate(settings)
    try:
        print(json.dumps(accounts.data(settings, options.person), ensure_ascii=False, indent=2))
    except accounts.AccountError as problem:
        raise Unusable(str(problem), login=options.person) from None
    return 0
