"""Right answers as people read them: formulas are set, numbers and units follow the language, choices are worded."""

from __future__ import annotations

import re

from exercises.presenting import Field
from exercises.words import with_unit
from graders.language import parse_line
from graders.language.errors import AnswerSyntaxError
from graders.language.mathml import mathml_of
from graders.language.tree import Number, Tree, mapped
from graders.words import comma, decimal
from reports.document import Formula, Line, line_from_html

FIGURES = 5
MOST_ROWS = 13  # of a table of samples
QUANTITY = re.compile(r"(-?[0-9.]+(?:e-?[0-9]+)?)(?: (\S+))?")
FRACTION = re.compile(r"-?[0-9]+\.[0-9]+(?:e-?[0-9]+)?")
NOTHING = 1e-12  # what rounding leaves of nought


def before_answer(prompt: Line) -> Line:
    """Part what is asked from the answer: by a colon, unless a question or a colon stands there."""
    last = prompt[-1] if prompt else ""
    return (*prompt, " " if isinstance(last, str) and last.rstrip().endswith(("?", ":")) else ": ")


def right(asked: Field, text: str, language: str) -> Line:
    """Write a right text of an answer in one line; nothing where a person has to judge."""
    if asked.kind == "text":
        return ()
    if asked.options:
        return _worded(asked, text)
    rows = text.split("\n")
    if asked.kind == "samples":
        thinned = rows[:1] + rows[1 :: max(1, len(rows) // (MOST_ROWS - 1))]
        return _joined([(_localised(row, language),) for row in thinned], " | ")
    return _joined([_row(row, language) for row in rows])


def _worded(asked: Field, text: str) -> Line:
    words = dict(asked.options)
    return _joined([line_from_html(words.get(part, part)) for part in text.split("; ")])


def _joined(lines: list[Line], sign: str = "; ") -> Line:
    return tuple(run for number, line in enumerate(lines) for run in ((sign, *line) if number else line))


def _row(text: str, language: str) -> Line:
    quantity = QUANTITY.fullmatch(text)
    if quantity is not None:
        return (with_unit(decimal(float(quantity[1]), language, FIGURES), quantity[2] or "", language),)
    head, colon, body = text.rpartition(": ")
    try:
        tree = mapped(parse_line(body), _rounded)
    except AnswerSyntaxError:
        return (_localised(text, language),)
    return (_localised(head + colon, language), Formula(mathml_of(tree, comma(language))))


def _rounded(node: Tree) -> Tree:
    """Round a long fraction to the figures of a key."""
    short = f"{float(node.digits):.{FIGURES}g}" if isinstance(node, Number) and "." in node.digits else "e"
    return node if "e" in short or not isinstance(node, Number) else Number(short, node.exponent)


def _localised(text: str, language: str) -> str:
    """Write the numbers of a text as the language does."""
    return FRACTION.sub(lambda found: _figures(float(found[0]), language), text).replace(" .. ", " … ")


def _figures(value: float, language: str) -> str:
    return decimal(value if abs(value) > NOTHING else 0.0, language, FIGURES)
