"""Verdicts in words where their code alone is known."""

from __future__ import annotations

import pytest

from graders.verdict import Code
from graders.words import LANGUAGES, titled


@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_code_alone_is_worded_with_its_gaps_left_open(lang: str) -> None:
    assert titled("wrong_angle", lang).count("…") == 1
    assert not any("{" in titled(code, lang) or "…." in titled(code, lang) for code in Code)


def test_a_code_that_has_no_sentence_has_no_title() -> None:
    assert titled("of_another_version", "en") == ""
