"""The page on how answers are typed: every example is read, and as it says."""

from __future__ import annotations

import pytest
from markupsafe import escape
from starlette.testclient import TestClient

from graders.words import LANGUAGES
from server.answering.typing_page import FORMULA, SAMPLES, SYMBOLS, as_written, examples
from server.answering.workspace import HELPED
from server.web.language import say

IN_SENTENCES = ("dh_table", "inequality", "function", "diagram")  # kinds whose sentence gives the same example


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_example_is_read(language: str) -> None:
    read = [example.read for part in examples(language).values() for example in part]
    assert len(read) > 25
    assert all(one.ok and one.text for one in read)


def test_an_example_that_cannot_be_read_would_be_found() -> None:
    with pytest.raises(ValueError, match="ambiguous_fraction"):
        FORMULA.parse("a/2b", SYMBOLS)


def test_all_ways_to_write_a_number_are_the_same_amount() -> None:
    amounts = [judge.parse(text, SYMBOLS).value for judge, text in SAMPLES["numbers"]]
    assert amounts == pytest.approx([12500.0] * len(amounts), rel=1e-15)


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_sentences_at_the_fields_give_examples_that_are_read(language: str) -> None:
    shown = {judge.kind: as_written(text, language) for part in SAMPLES.values() for judge, text in part}
    for kind in (*IN_SENTENCES, "set"):
        assert shown[kind] in say(language, f"help.{kind}"), kind


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_shows_what_is_typed_and_how_it_is_read(client: TestClient, language: str) -> None:
    page = client.get(f"/typing?lang={language}").text
    assert say(language, "typing.title") in page
    for example in (one for part in examples(language).values() for one in part):
        assert f"<code>{escape(example.typed)}</code>" in page
        assert example.read.mathml in page
    assert page.count("<dt>") == len(HELPED) + 4 + 7


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_says_how_it_is_used_without_a_mouse_and_whom_to_tell_what_does_not_work(
    client: TestClient, language: str
) -> None:
    page = client.get(f"/typing?lang={language}").text
    told = page[page.index('id="access"') :]
    assert all(say(language, name) in told for name in ("island.play", "pages.report"))
    for key in ("Tab", "Enter", "Ctrl+Enter", "MathML", "PDF/UA"):
        assert key in told


def test_the_page_is_linked_from_every_foot_and_beside_the_answers(client: TestClient) -> None:
    foot = '<a href="/typing">How to type answers</a>'
    dealt = client.post("/exercises/slider_crank", data={"seed": "7"}, headers={"accept-language": "en"})
    for page in (client.get("/?lang=en").text, dealt.text):
        assert page.index('class="foot"') < page.index(foot) < page.index('<a href="/typing#access">Accessibility</a>')
    assert dealt.text.index('id="h-ans"') < dealt.text.index('href="/typing" target') < dealt.text.index('id="a1"')
