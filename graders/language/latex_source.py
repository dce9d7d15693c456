"""LaTeX as it is typed: whether a text is LaTeX, and a place in it from which it is read on."""

from __future__ import annotations

import re
from dataclasses import dataclass

from graders.language.commands import UPRIGHT
from graders.language.errors import AnswerSyntaxError, Reason

MAX_DEPTH = 60
COMMAND = re.compile(r"\\(?:[A-Za-z]+\*?|.)", re.DOTALL)
DOLLARS = re.compile(r"\s*\${1,2}[^$]+\${1,2}\s*")


def is_latex(text: str) -> bool:
    """Tell whether a text was written by a formula editor: a command, or braces behind `^`, `_` or around a comma."""
    return "\\" in text or ("{" in text and any(mark in text for mark in ("^{", "_{", "{,}")))


def undollared(text: str) -> str:
    """Blank out the dollar signs around a whole text, one or two, with which LaTeX is copied; places stay."""
    copied = DOLLARS.fullmatch(text)
    return text.replace("$", " ") if copied else text


def upright(latex: str, place: int) -> bool:
    """Tell whether letters stand upright: `\\mathrm{EI}` is one name, `EI` the product that an editor writes so."""
    before = latex[max(0, place - 24) : place].rstrip()
    commands = [f"\\{command}{{" for command in UPRIGHT]
    return before.endswith(tuple(commands)) or latex.startswith(tuple(commands), place)


@dataclass(slots=True)
class Source:
    """A place in LaTeX; `depth` counts what stands within one another there."""

    latex: str
    at: int = 0
    depth: int = 0

    def error(self, reason: Reason, found: str = "", place: int | None = None) -> AnswerSyntaxError:
        place = self.at if place is None else place
        return AnswerSyntaxError(reason, place, found or self.latex[place : place + 1])

    def next(self) -> str:
        return self.latex[self.at : self.at + 1]

    def skip_spaces(self) -> None:
        while self.next() and self.next() in " ~\n\t\r":
            self.at += 1

    def command(self) -> str:
        """Read a command and step over it: its name without the backslash."""
        found = COMMAND.match(self.latex, self.at)
        if found is None:
            raise self.error(Reason.BAD_CHARACTER)
        self.at = found.end()
        return found.group()[1:]

    def ahead(self) -> str:
        """Look at the command that comes next; empty if none does."""
        found = COMMAND.match(self.latex, self.at)
        return found.group()[1:] if found else ""

    def deeper(self) -> None:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise self.error(Reason.TOO_DEEP)
