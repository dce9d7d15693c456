"""`grubler grade`: marks files of answers and says it to people, programs and pipelines."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Callable, Mapping, Sequence

from cli import formats, pipelines
from cli.marking import Sheet, mark_file
from cli.problems import language
from cli.reading import read_tasks
from cli.secret import secret

PASS = 0.5
FORMATS: Mapping[str, Callable[[Sequence[Sheet], float, str], str]] = {
    "text": formats.text,
    "json": formats.as_json,
    "junit": pipelines.junit,
    "gradescope": pipelines.gradescope,
    "github": pipelines.github,
}


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("files", nargs="+", metavar="FILE", help="answers as JSON")
    parser.add_argument("--tasks", metavar="TASKS", help="file of the tasks that were dealt; other items score 0")
    parser.add_argument("--format", choices=tuple(FORMATS), default="text", help="form of the result")
    mark = "share of the score from which a file passes, 0 to 1 (default: 0.5)"
    parser.add_argument("--pass", dest="mark", type=_share, default=PASS, metavar="SHARE", help=mark)
    language(parser)


def run(options: Namespace) -> int:
    """Mark the files; one that cannot be used does not stop the others."""
    tasks = read_tasks(options.tasks) if options.tasks else None
    sheets = [mark_file(file, tasks, secret()) for file in options.files]
    for sheet in sheets:
        if sheet.problem:
            print(f"grubler: {sheet.problem.worded(options.lang)}", file=sys.stderr)
    print(FORMATS[options.format](sheets, options.mark, options.lang))
    return _code(sheets, options.mark)


def _code(sheets: Sequence[Sheet], mark: float) -> int:
    if any(sheet.failed for sheet in sheets):
        return 3
    if any(sheet.problem for sheet in sheets):
        return 2
    return int(any(sheet.score < mark for sheet in sheets))


def _share(text: str) -> float:
    try:
        share = float(text)
    except ValueError:
        share = -1.0
    if not 0 <= share <= 1:
        raise ArgumentTypeError(f"{text!r} is not a number from 0 to 1")
    return share
