"""Writes `docs/reference/commands.md` from the parser: ``uv run python -m tests.docs.command_reference``."""

from __future__ import annotations

from argparse import Action, ArgumentParser, _HelpAction, _SubParsersAction
from collections.abc import Iterator
from pathlib import Path

from cli.main import COMMANDS, parser

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reference" / "commands.md"
HEAD = """# The commands

This page is written from the parser of the command line by `uv run python -m tests.docs.command_reference`; a test
compares the two. The files that `grade` reads and writes are described in [files.md](files.md).

| exit code | meaning |
|---|---|
| 0 | passed, or simply done |
| 1 | graded below the pass mark; `verify`: an exercise has failures |
| 2 | unusable input: the message names file, item and field |
| 3 | our fault, not yours |

`grubler --version` prints the version. Two runs of a command on the same input print the same bytes, in every locale.
`GRUBLER_SECRET` chooses the points at which formulas are tested; without it the commands use a fixed public one.
"""


def page() -> str:
    """Give the whole page."""
    (below,) = (action for action in parser()._actions if isinstance(action, _SubParsersAction))
    sections = [line for name in COMMANDS for line in _section(name, below.choices[name])]
    return "\n".join([HEAD, *sections]).rstrip() + "\n"


def _section(name: str, made: ArgumentParser) -> Iterator[str]:
    arguments = [action for action in made._actions if not isinstance(action, _HelpAction)]
    yield from (f"## grubler {name}", "", f"{made.description}", "")
    yield from ("| argument | meaning |", "|---|---|")
    yield from (f"| {_shown(action)} | {_meaning(action)} |" for action in arguments)
    yield ""


def _shown(action: Action) -> str:
    if not action.option_strings:
        return f"`{action.metavar or action.dest}`" + (" …" if action.nargs in ("*", "+") else "")
    value = "" if action.nargs == 0 else f" {action.metavar or action.dest.upper()}"
    value = " " + "\\|".join(map(str, action.choices)) if action.choices else value
    return f"`{action.option_strings[0]}{value}`" + (", needed" if action.required else "")


def _meaning(action: Action) -> str:
    return action.help or ""


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
