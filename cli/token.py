"""`grubler token`: prints a bearer token for this server."""

from __future__ import annotations

from argparse import ArgumentParser, ArgumentTypeError, Namespace
from contextlib import suppress

from cli import store
from server import run as server
from server.people.tokens import HOURS
from server.policy import Role

ROLES = tuple(role.name.lower() for role in Role if role is not Role.ANONYMOUS)
MOST_HOURS = 24 * 366


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    store.arguments(parser)
    parser.add_argument("--role", choices=ROLES, required=True, help="what its bearer may do")
    parser.add_argument("--hours", type=_hours, default=HOURS, help=f"how long it is valid (default: {HOURS})")


def run(options: Namespace) -> int:
    """Print a token and nothing else."""
    with store.usable():
        print(server.token(store.settings(options), options.role, hours=options.hours))
    return 0


def _hours(text: str) -> float:
    with suppress(ValueError):
        hours = float(text)
        if 0 < hours <= MOST_HOURS:
            return hours
    raise ArgumentTypeError(f"{text!r} is not a number of hours from 0 to {MOST_HOURS}")
