"""`grubler worker`: does the jobs of servers that share a PostgreSQL store."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from cli import store
from server import run as server
from server.settings import MOST_WORKERS


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    store.arguments(parser)
    at_a_time = "batches at a time (default: GRUBLER_WORKERS, or as many as there are processors)"
    parser.add_argument("--processes", type=_processes, metavar="N", help=at_a_time)


def run(options: Namespace) -> int:
    """Work until the process is told to end."""
    with store.usable():
        server.work(store.settings(options), options.processes)
    return 0


def _processes(text: str) -> int:
    processes = int(text)
    if not 1 <= processes <= MOST_WORKERS:
        raise ValueError(text)
    return processes
