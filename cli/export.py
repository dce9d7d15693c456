"""`grubler export`: writes all that is kept of a person as JSON, or the marks of a set or course as a table."""

from __future__ import annotations

import json
import sys
from argparse import ArgumentParser, Namespace

from cli import store
from cli.problems import Unusable, language
from cli.report import write
from server import run as server
from server.marks import exporting
from server.people import accounts
from server.settings import Settings


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument(
        "--person", metavar="LOGIN", help="all that is kept of this person: index number, e-mail or number"
    )
    what.add_argument("--task-set", metavar="NUMBER", help="the marks of a task set")
    what.add_argument("--course", metavar="NUMBER", help="the marks of all published sets of a course")
    parser.add_argument("--format", choices=("csv", "xlsx"), default="csv", help="form of the marks (default: csv)")
    parts = "what parts the cells of CSV; after semicolons numbers have a decimal comma (default: comma)"
    parser.add_argument("--separator", choices=("comma", "semicolon"), default="comma", help=parts)
    parser.add_argument("--pseudonyms", action="store_true", help="name nobody in the marks, for research")
    parser.add_argument("--output", metavar="FILE", help="where the marks go (default: standard output)")
    store.arguments(parser)
    language(parser)


def run(options: Namespace) -> int:
    """Print what is asked for and nothing else."""
    if options.person is not None and options.pseudonyms:
        raise Unusable("pseudonym_of_one", login=options.person)
    settings = store.settings(options)
    with store.usable():
        server.migrate(settings)
    if options.person is None:
        return _marks(settings, options)
    try:
        print(json.dumps(accounts.data(settings, options.person), ensure_ascii=False, indent=2))
    except accounts.AccountError as problem:
        raise Unusable(str(problem), login=options.person) from None
    return 0


def _marks(settings: Settings, options: Namespace) -> int:
    content = exporting.marks(
        settings, options.task_set, options.course, options.format, options.separator, options.lang,
        named=not options.pseudonyms,
    )  # fmt: skip
    if content is None:
        raise Unusable("unknown_marks", number=options.task_set or options.course)
    if options.output is None:
        sys.stdout.buffer.write(content)
    else:
        write(options.output, content)
    return 0
