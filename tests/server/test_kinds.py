"""Every answer kind has a field on the page, and a sentence on how it is typed where that is not plain."""

from __future__ import annotations

import pytest

from graders import KINDS
from graders.words import LANGUAGES
from server.answering.forms import TABLES
from server.answering.workspace import HELPED, LONG
from server.web.language import say

PLAIN = {
    "choice",
    "expression",
    "integer",
    "matrix",
    "quantity",
    "rational",
    "symbolic_matrix",
    "text",
}


def test_every_kind_says_how_it_is_typed() -> None:
    assert set(KINDS) == PLAIN | set(HELPED)
    assert not PLAIN & set(HELPED)


def test_kinds_of_several_lines_have_a_field_of_several_lines() -> None:
    lines = {"polygon", "rates", "function", "samples", "text", "equation", "system", "inequality"}
    assert set(LONG) == lines
    assert set(LONG) | set(TABLES) <= set(KINDS)


@pytest.mark.parametrize("lang", LANGUAGES)
def test_the_sentences_are_there_in_every_language(lang: str) -> None:
    for kind in HELPED:
        assert len(say(lang, f"help.{kind}")) > 20
    for kind in KINDS:
        assert say(lang, f"kinds.{kind}_many")
