"""`grubler solve`: answers requests to a reference solver, one JSON object or one a line."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from functools import partial

from cli.lines import answered
from mechanics.wire import solvers


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("solver", metavar="SOLVER", choices=solvers.SOLVERS, help="which one, such as beam")
    parser.add_argument("--schema", action="store_true", help="print the JSON Schema of its requests instead")


def run(options: Namespace) -> int:
    """Answer each request on standard input in its turn."""
    if options.schema:
        print(json.dumps(solvers.schema(options.solver), indent=2))
        return 0
    return answered(partial(solvers.answer, options.solver))
