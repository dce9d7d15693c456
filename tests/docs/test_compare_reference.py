"""The page on comparing answers is that of the code."""

from __future__ import annotations

from graders import comparison
from graders.comparison.outcome import Why
from tests.docs import compare_reference


def test_the_written_page_is_up_to_date() -> None:
    written = compare_reference.page()
    assert compare_reference.PAGE.read_text("utf-8") == written, "write compare.md again: see its first lines"


def test_every_kind_and_code_is_explained() -> None:
    assert set(compare_reference.KINDS) == set(comparison.KINDS)
    assert set(compare_reference.CODES) == set(Why)
