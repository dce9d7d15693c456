"""Parts of a text keep the place at which they were typed."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.parser import parse
from graders.language.piece import Piece
from graders.language.symbols import Symbols

TEXTS = st.text("ab 1;\t\n", max_size=12)


@given(TEXTS, st.integers(0, 12), st.integers(0, 12))
def test_a_part_stands_where_its_place_says(text: str, start: int, end: int) -> None:
    start, end = sorted((min(start, len(text)), min(end, len(text))))
    bare = Piece(text, 0).part(start, end).bare
    assert text[bare.place : bare.place + len(bare.text)] == bare.text == text[start:end].strip()


def test_an_error_is_placed_in_the_whole_text() -> None:
    piece = Piece("l1 = 2; a + q + 1", 0).part(8)
    with pytest.raises(AnswerSyntaxError) as caught:
        piece.read(lambda text: parse(text, Symbols({"a": "m"})))
    error = caught.value
    assert (error.reason, error.position, error.proposal.found) == (Reason.UNKNOWN_NAME, 12, "q")


def test_a_refused_part_names_its_place_and_beginning() -> None:
    error = Piece("word, and more than twenty letters", 7).error(Reason.NOT_A_LINE, "meant")
    assert (error.position, error.proposal.found, error.proposal.meant) == (7, "word, and more than ", "meant")
