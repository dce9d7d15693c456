"""The grubler command: finds the subcommand, imports only that one, turns errors into exit codes."""

from __future__ import annotations

import io
import os
import sys
from argparse import SUPPRESS, Action, ArgumentParser, Namespace
from collections.abc import Iterable, Sequence
from importlib import import_module
from typing import NoReturn

from cli.problems import Unusable

PASSED, BELOW, UNUSABLE, OUR_FAULT = range(4)
INTERRUPTED = 130
COMMANDS = {
    "serve": "start the server",
    "catalogue": "list the exercises",
    "draw": "show the variant of a seed",
    "grade": "grade files of answers",
    "solve": "answer requests to a reference solver",
    "compare": "compare pairs of typed answers",
    "report": "write the report of a laboratory",
    "sheet": "print tasks for a class, with the key apart",
    "verify": "check that exercises may be published",
    "new": "start a new exercise from a template",
    "worker": "do the jobs of servers that share a PostgreSQL store",
    "regrade": "judge again what was handed in to a task set",
    "migrate": "bring the store to the tables of this version",
    "token": "print a bearer token",
    "user": "let somebody in by a one-time link",
    "export": "write what is kept of a person, or marks",
    "erase": "erase a person; marks stay without a name",
    "audit": "check that no line of the audit log was changed or removed",
    "backup": "copy the store to a file",
    "restore": "take a copy of a store back",
}


def parser(commands: Iterable[str] = COMMANDS, *, named_only: bool = False) -> ArgumentParser:
    """Make the parser of the command line.

    Args:
        commands: The subcommands it knows.
        named_only: Name them without their arguments, so that none of their modules is imported.
    """
    made = ArgumentParser(prog="grubler", description="An autograded laboratory for theory of machines.")
    made.add_argument("--version", action=_Version, nargs=0, default=SUPPRESS, help="print the version and exit")
    subparsers = made.add_subparsers(title="commands", metavar="COMMAND", dest="command", required=True)
    for name in commands:
        summary = COMMANDS[name]
        below = subparsers.add_parser(name, help=summary, description=f"{summary[0].upper()}{summary[1:]}.")
        if not named_only:
            module = import_module(f"cli.{name}")
            module.arguments(below)
            below.set_defaults(run=module.run)
    return made


class _Version(Action):
    """Prints the version; looked up only when asked for, since the look costs more than parsing."""

    def __call__(self, parser: ArgumentParser, *_: object) -> NoReturn:
        from importlib.metadata import version

        print(f"grubler {version('grubler')}")
        parser.exit()


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command.

    Args:
        arguments: The command line without the program's name; that of the process by default.

    Returns:
        0 passed, 1 graded below the pass mark, 2 unusable input, 3 our fault.
    """
    _speak_utf8()
    given = list(sys.argv[1:] if arguments is None else arguments)
    known = given[:1] if given and given[0] in COMMANDS else list(COMMANDS)
    options = parser(known, named_only=known != given[:1]).parse_args(given)
    try:
        return _run(options)
    except BrokenPipeError:  # the reader of our output has gone, as in `grubler catalogue | head -1`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return PASSED
    except KeyboardInterrupt:
        return INTERRUPTED
    except Exception as error:
        sys.excepthook(type(error), error, error.__traceback__)
        print("grubler: this is a fault of the program, not of your input", file=sys.stderr)
        return OUR_FAULT


def _run(options: Namespace) -> int:
    try:
        code: int = options.run(options)
    except ValueError as error:
        problem = _unusable(error)
        if problem is None:
            raise
        print(f"grubler: {problem.worded(getattr(options, 'lang', 'en'))}", file=sys.stderr)
        return UNUSABLE
    sys.stdout.flush()
    return code


def _unusable(error: ValueError) -> Unusable | None:
    """Tell what the user can mend, an incomplete folder of an exercise too, from our own faults."""
    from exercises.catalogue import IncompleteExercise  # only for those who are told something

    if isinstance(error, IncompleteExercise):
        return Unusable("incomplete", why=error)
    return error if isinstance(error, Unusable) else None


def _speak_utf8() -> None:
    """Write the same bytes in every locale; what is no text (a file name) is escaped."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="backslashreplace", newline="\n")


if __name__ == "__main__":
    sys.exit(main())
