"""Task sheets for a class, and the key as a document of its own."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from exercises.exercise import Variant
from exercises.grading import reference
from exercises.presenting import Presented, presented
from reports.answers import before_answer, right
from reports.document import (
    Block,
    Break,
    Bullets,
    Document,
    Drawing,
    Facts,
    Heading,
    Line,
    Paragraph,
    Ruled,
    from_html,
    line_from_html,
)  # fmt: skip
from reports.words import words

WORKING = 10  # lines of squared paper under the answers
HAND = {"matrix": 4, "dh_table": 4, "polygon": 8, "rates": 3, "samples": 8, "diagram": 6, "text": 6, "function": 3}


@dataclass(frozen=True, slots=True)
class Sheet:
    """What is printed of a variant: its code, what it shows, and a right text for each answer."""

    code: str
    shown: Presented
    right: Mapping[str, str]


def sheet(code: str, variant: Variant, language: str) -> Sheet:
    """Make the sheet of a variant as the installed exercise shows it."""
    return Sheet(code, presented(variant, language), reference(variant))


def sheets(dealt: Sequence[Sheet], language: str) -> Document:
    """Print the tasks of a class, one sheet a variant, with its code.

    Args:
        dealt: The sheets, in the order printed.
        language: pl, en or ru.
    """
    blocks = [block for n, one in enumerate(dealt, 1) for block in _sheet(n, len(dealt), one, language)]
    said = words(language)["sheet"]
    return Document(said["title"], dealt[0].shown.title if dealt else "", language, tuple(blocks), "Grübler")


def _sheet(number: int, of: int, printed: Sheet, language: str) -> Iterator[Block]:
    said, shown = words(language)["sheet"], printed.shown
    if number > 1:
        yield Break()
    yield Heading(shown.title)
    place = said["of"].replace("{number}", str(number)).replace("{all}", str(of))
    yield Facts(
        (
            (said["name"], ""),
            (said["group"], ""),
            (said["mark"], ""),
            (f"{said['variant']}, {said['sheet']}", f"{printed.code}, {place}"),
        )
    )
    yield from from_html(shown.statement_html)
    if shown.picture:
        yield Drawing(shown.picture.svg, shown.title, 0.6)
    yield Heading(said["answers"], 2)
    yield from _answers(shown)
    yield Heading(said["work"], 2)
    yield Ruled(WORKING, squared=True)


def _answers(shown: Presented) -> Iterator[Block]:
    for number, asked in enumerate(shown.answers.values(), 1):
        named = asked.kind == "diagram" and asked.unit_text in asked.prompt_text  # with that of x beside it
        unit = f" [{asked.unit_text}]" if asked.unit_text and not named else ""
        yield Paragraph((f"{number}. ", *line_from_html(asked.prompt_html), unit), kept=True)
        if asked.options:
            yield Bullets(tuple(line_from_html(html) for _, html in asked.options))
        else:
            yield Ruled(HAND.get(asked.kind, 1))


def key(dealt: Sequence[Sheet], language: str) -> Document:
    """Print the answers of every variant, for the lecturer only."""
    said = words(language)["sheet"]
    blocks: list[Block] = []
    for one in dealt:
        blocks += [Heading(f"{said['variant']} {one.code}"), Bullets(tuple(_right(one, language)), numbered=True)]
    title = dealt[0].shown.title if dealt else ""
    return Document(said["key"], title, language, tuple(blocks), f"Grübler, {said['key']}")


def _right(printed: Sheet, language: str) -> Iterator[Line]:
    for name, asked in printed.shown.answers.items():
        answer, prompt = right(asked, printed.right[name], language), line_from_html(asked.prompt_html)
        yield (*before_answer(prompt), *answer) if answer else prompt
