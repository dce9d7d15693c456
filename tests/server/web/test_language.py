"""Everything is said in three languages, in the one that the reader asks for."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import server
from exercises.catalogue import CHAPTERS
from server.web.language import LANGUAGES, preferred, say, words
from server.web.templating import counted, plural

PLACES = re.compile(r"\{(\w*)(?::\w+)?\}")
SERVER = Path(server.__file__).parent
SAID = re.compile(r"""\bt\(\s*"([^"]*)"(\s*~)?""")  # in a template: a key, or what one begins with
COUNTED = re.compile(r"""\bn\([^"()]*"([^"]*)"\)""")


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_language_says_the_same_things_about_the_same_values(language: str) -> None:
    ours, theirs = words(language), words("en")
    assert ours.keys() == theirs.keys()
    for key in theirs:
        assert ours[key].strip(), key
        assert sorted(PLACES.findall(ours[key])) == sorted(PLACES.findall(theirs[key])), key


def test_every_sentence_that_a_template_or_the_server_asks_for_is_there() -> None:
    asked = [*templates(), *sources()]
    assert len(asked) > 500 and not [(place, key) for place, key in asked if not known(key)]


def templates() -> Iterator[tuple[str, str]]:
    """The keys in templates; one that is put together ends with a star."""
    for path in sorted((SERVER / "templates").rglob("*.html")):
        text = path.read_text("utf-8")
        yield from ((path.name, key + "*" * bool(more)) for key, more in SAID.findall(text))
        yield from ((path.name, f"{key}_{form}") for key in COUNTED.findall(text) for form in ("one", "few", "many"))


def sources() -> Iterator[tuple[str, str]]:
    """The keys of `say` and the codes of refusals in the server."""
    for path in sorted(SERVER.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            called = node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
            if called in ("say", "Refused") and isinstance(node, ast.Call) and len(node.args) > 1:
                before = "errors." * (called == "Refused")
                yield from ((path.name, before + key) for key in literal(node.args[1]))


def literal(node: ast.expr) -> Iterator[str]:
    """The text of an expression; of one that is put together, what it begins with and a star."""
    if isinstance(node, ast.IfExp):
        yield from literal(node.body)
        yield from literal(node.orelse)
    elif isinstance(node, ast.Constant):
        yield str(node.value)
    elif isinstance(node, ast.JoinedStr) and isinstance(node.values[0], ast.Constant):
        yield str(node.values[0].value) + "*"


def known(key: str) -> bool:
    """Whether there is such a sentence, or one that begins so."""
    return any(one.startswith(key[:-1]) for one in words("en")) if key.endswith("*") else key in words("en")


@pytest.mark.parametrize("language", ["pl", "ru"])
def test_nothing_is_left_in_english(language: str) -> None:
    same = {key for key, said in words(language).items() if said == words("en")[key]}
    assert same <= {
        "pages.minutes", "pages.symbol", "people.role_student", "people.role_administrator", "courses.role_student",
        "audit.value_student", "audit.value_administrator", "regrade.student",
        *(f"visual.{word}" for word in ("plus", "minus", "beta", "gamma", "delta", "epsilon", "sigma", "omega")),
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
