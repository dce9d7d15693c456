"""Everything is said in three languages, in the one that the reader asks for."""

from __future__ import annotations

import re

import pytest

from exercises.catalogue import CHAPTERS
from server.language import LANGUAGES, preferred, say, words
from server.templating import counted, plural

PLACES = re.compile(r"\{(\w*)\}")


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_language_says_the_same_things_about_the_same_values(language: str) -> None:
    ours, theirs = words(language), words("en")
    assert ours.keys() == theirs.keys()
    for key in theirs:
        assert ours[key].strip(), key
        assert sorted(PLACES.findall(ours[key])) == sorted(PLACES.findall(theirs[key])), key


@pytest.mark.parametrize("language", ["pl", "ru"])
def test_nothing_is_left_in_english(language: str) -> None:
    same = {key for key, said in words(language).items() if said == words("en")[key]}
    assert same <= {
        "pages.minutes", "pages.symbol", "people.role_student", "people.role_administrator", "courses.role_student",
        "audit.value_student", "audit.value_administrator", "regrade.student",
    }  # fmt: skip


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_chapter_has_a_name(language: str) -> None:
    assert all(f"chapters.{chapter}" in words(language) for chapter in CHAPTERS)


def test_nothing_is_shouted() -> None:
    assert not [said for language in LANGUAGES for said in words(language).values() if "!" in said]


@pytest.mark.parametrize(
    ("header", "language"),
    [
        ("pl", "pl"), ("ru-RU,ru;q=0.9,en;q=0.8", "ru"), ("de,pl;q=0.5,en;q=0.7", "en"), ("", "en"), ("de", "en"),
        ("pl;q=0", "en"), ("pl;q=x,ru;q=0.1", "ru"), ("*", "en"), ("PL-pl", "pl"), ("," * 10000 + "pl", "en"),
    ],
)  # fmt: skip
def test_the_best_wish_that_can_be_met_is_met(header: str, language: str) -> None:
    assert preferred(header) == language


def test_values_stand_in_the_sentence_and_are_not_templates() -> None:
    assert "{limit}" in say("en", "errors.extra_field", name="{limit}")


@pytest.mark.parametrize(
    ("language", "forms"),
    [
        ("en", {1: "one", 2: "many", 5: "many", 21: "many"}),
        ("pl", {1: "one", 2: "few", 5: "many", 12: "many", 21: "many", 22: "few", 0: "many"}),
        ("ru", {1: "one", 2: "few", 5: "many", 11: "many", 12: "many", 21: "one", 22: "few"}),
    ],
)  # fmt: skip
def test_a_noun_agrees_with_its_number(language: str, forms: dict[int, str]) -> None:
    assert {number: plural(language, number) for number in forms} == forms


def test_a_number_of_things_is_worded() -> None:
    assert counted("pl", 4, "kinds.quantity") == "4 liczby"
    assert counted("ru", 5, "kinds.expression") == "5 формул"
