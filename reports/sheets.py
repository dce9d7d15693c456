"""Task sheets for a class, and the key as a document of its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from exercises.exercise import Variant
from exercises.grading import reference
from exercises.presenting import Presented, presented
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


def sheets(dealt: Sequence[tuple[str, Variant]], language: str) -> Document:
    """Print the tasks of a class, one sheet a variant, with its code.

    Args:
        dealt: Codes and variants, in the order printed.
        language: pl, en or ru.
    """
    blocks = [
        block for n, (code, variant) in enumerate(dealt, 1) for block in _sheet(n, len(dealt), code, variant, language)
    ]
    shown = presented(dealt[0][1], language) if dealt else None
    said = words(language)["sheet"]
    return Document(said["title"], shown.title if shown else "", language, tuple(blocks), "Grübler")


def _sheet(number: int, of: int, code: str, variant: Variant, language: str) -> Iterator[Block]:
    said, shown = words(language)["sheet"], presented(variant, language)
    if number > 1:
        yield Break()
    yield Heading(shown.title)
    place = said["of"].replace("{number}", str(number)).replace("{all}", str(of))
    yield Facts(
        (
            (said["name"], ""),
            (said["group"], ""),
            (said["mark"], ""),
            (f"{said['variant']}, {said['sheet']}", f"{code}, {place}"),
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
        unit = f" [{asked.unit_text}]" if asked.unit_text else ""
        yield Paragraph((f"{number}. ", *line_from_html(asked.prompt_html), unit))
        if asked.options:
            yield Bullets(tuple(line_from_html(html) for _, html in asked.options))
        else:
            yield Ruled(HAND.get(asked.kind, 1))


def key(dealt: Sequence[tuple[str, Variant]], language: str) -> Document:
    """Print the answers of every variant, for the lecturer only."""
    said = words(language)["sheet"]
    blocks: list[Block] = []
    for code, variant in dealt:
        shown = presented(variant, language)
        blocks += [Heading(f"{said['variant']} {code}"), Bullets(tuple(_right(shown, variant)), numbered=True)]
    title = presented(dealt[0][1], language).title if dealt else ""
    return Document(said["key"], title, language, tuple(blocks), f"Grübler, {said['key']}")


def _right(shown: Presented, variant: Variant) -> Iterator[Line]:
    right = reference(variant)
    for name, asked in shown.answers.items():
        text = right[name] if asked.kind != "text" else ""
        yield (*line_from_html(asked.prompt_html), ": ", text.replace("\n", "; "))
