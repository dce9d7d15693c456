"""A made-up language with brackets round every sentence: what stands outside of brackets was never translated."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from html.parser import HTMLParser
from typing import Any

import pytest
from starlette.testclient import TestClient

from exercises import catalogue
from exercises.catalogue import Spoken
from graders import words as graders_words
from server.answering import variants
from server.catalogue.api import sample
from server.web import language
from tests.server.test_policy import bearer

SILENT = ("math", "script", "style", "svg", "code", "textarea", "template")
SPOKEN = ("aria-label", "title", "placeholder", "alt")
SAME = {"Grübler", "polski", "English", "русский", "alpha", "omega", "epsilon"}  # names of languages and of symbols
NUMBERS = re.compile(
    r"\b[0-9A-Z]{4}(?:-[0-9A-Z]{4}){2}\b|\b[0-9a-f]{4}(?: [0-9a-f]{4}){3}\b|\b[0-9a-f-]{16,}\b|\br-[0-9a-f]{10}\b"
)
WORD = re.compile(r"[^\W\d_]{4,}")
VOID = ("input", "link", "meta", "br", "hr")


def bracketed(words: Any) -> Any:
    """Put brackets round every sentence, at any depth."""
    if isinstance(words, Mapping):
        return {key: bracketed(value) for key, value in words.items()}
    if isinstance(words, list):
        return list(map(bracketed, words))
    return f"⟦{words}⟧" if isinstance(words, str) else words


class Reader(HTMLParser):
    """Collects the words that stand outside of brackets."""

    def __init__(self, known: set[str]) -> None:
        super().__init__()
        self.depth, self.silent, self.known = 0, 0, known
        self.found: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.silent += tag in SILENT
        for name, value in attrs:
            if name in SPOKEN and not self.silent:
                self._read(value or "", 0)

    def handle_endtag(self, tag: str) -> None:
        self.silent -= tag in SILENT

    def handle_data(self, data: str) -> None:
        if not self.silent:
            self.depth = self._read(data, self.depth)

    def _read(self, text: str, depth: int) -> int:
        for part in re.split(r"([⟦⟧])", text):
            depth += {"⟦": 1, "⟧": -1}.get(part, 0)
            if depth == 0:
                self.found += [word for word in WORD.findall(part) if word not in self.known]
        return depth


@pytest.fixture
def pseudo(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Every catalogue of words in brackets; what was made of other words before is forgotten, and so is this."""
    _forget()
    said, judged, spoken = language.words, graders_words.locale, Spoken.__getitem__
    monkeypatch.setattr(language, "words", lambda lang: bracketed(said(lang)))
    monkeypatch.setattr(graders_words, "locale", lambda lang: bracketed(judged(lang)))
    monkeypatch.setattr(Spoken, "__getitem__", lambda self, lang: bracketed(spoken(self, lang)))
    yield
    _forget()


def _forget() -> None:
    sample.cache_clear()
    variants._presented.cache_clear()


def untranslated(page: str, known: set[str]) -> list[str]:
    reader = Reader(known | SAME)
    reader.feed(NUMBERS.sub("", page))
    return reader.found


@pytest.mark.usefixtures("pseudo")
@pytest.mark.parametrize("exercise", ["slider_crank", "beam_diagrams", "rrp_table", "gear_train", "slider_crank_cycle"])
def test_no_word_of_a_workspace_stands_outside_of_the_catalogues(
    client: TestClient, deal: Callable[..., str], exercise: str
) -> None:
    number = deal(exercise)
    names = list(client.get(f"/api/v1/variants/{number}").json()["answers"])
    client.post(f"/variants/{number}", data={f"answer.{name}": "1" for name in names})
    pages = [client.get(f"/variants/{number}").text, client.get(f"/exercises/{exercise}").text]
    pages += [client.post(f"/variants/{number}/preview", data={f"answer.{names[0]}": "1 m/"}).text]
    assert [untranslated(page, set(names)) for page in pages] == [[], [], []]


@pytest.mark.usefixtures("pseudo")
def test_no_word_of_any_other_page_stands_outside_of_the_catalogues(
    client: TestClient, deal: Callable[..., str]
) -> None:
    client.post(f"/variants/{deal()}/problem", data={"problem": "⟦what is typed⟧"})
    for path in ("/", "/?q=nothing", "/none", "/problems", "/typing"):
        page = client.get(path, headers=bearer("lecturer") | {"accept": "text/html"}).text
        assert untranslated(page, set(catalogue.ids()) | {"slider", "crank"}) == [], path


def test_the_search_would_find_a_word_in_a_template() -> None:
    assert untranslated("<p>⟦Saved⟧ again <b title='Later'>⟦and <i>on</i>⟧</b></p>", set()) == ["again", "Later"]
