"""The builder: exercises, seeds and limits, and what is said of a draft that cannot be published."""

from __future__ import annotations

import re
from html import unescape
from typing import Any

import pytest
from markupsafe import escape

from exercises import catalogue
from exercises.givens import numbers
from exercises.variants import deal
from server.sets import foresight
from server.sets.foresight import Traits
from server.sets.form import draft_of_form, shelves
from tests.server.sets.builder import fields, saved, started, title
from tests.server.sets.conftest import EXERCISE, Course


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
def test_the_builder_shows_any_seed_in_any_language_and_twenty_in_a_table(course: Course, language: str) -> None:
    number = course.built()
    page = course.lecturer.get(f"/sets/{number}?slot=1&seed=1042&table=true&lang={language}").text
    alone = course.lecturer.get(f"/sets/{number}?slot=1&seed=1042&lang={language}").text
    assert len(re.findall(r'<th scope="row" class="num">\d+</th>', page)) == 20 and "<svg" in page
    assert "seed=1041" in page and "seed=1043" in page and "<caption>" not in alone


def test_a_set_that_cannot_be_published_says_why_on_a_page(course: Course) -> None:
    path = started(course)
    browser = {"accept": "text/html"}
    values = fields(course.lecturer.get(path).text)
    reply = course.lecturer.post(f"{path}?lang=en", data=values | {"then": "publish"}, headers=browser)
    assert reply.status_code == 422 and "There is no exercise in the set yet." in reply.text
    stale = course.lecturer.post(path, data=values | {"title": "Other"}, headers=browser)
    assert stale.status_code == 409
    wrong = values | {"revision": "2", "slot.1.pool": EXERCISE, "slot.1.attempts": "many"}
    assert course.lecturer.post(path, data=wrong).json()["error"]["field"] == "items.0.attempts"


@pytest.mark.parametrize(
    ("language", "changes", "said"),
    [
        ("en", {"slot.1.pool": f"{EXERCISE} nonsense"}, "Task 1, nonsense: There is no such exercise."),
        ("pl", {"slot.1.points": "dużo"}, "Wartość pola Zadanie 1, Punkty ma zły typ"),
        (
            "en",
            {"slot.1.limits": "l9 1 2"},
            "Task 1, Limits on givens: None of these exercises has a given l9. What can be limited: l1, l2,",
        ),
        (
            "pl",
            {"slot.1.pool": f"four_bar {EXERCISE}"},
            f"Liczba kroków: {title('four_bar', 'pl')} (14); {title(EXERCISE, 'pl')} (4).",
        ),
        ("ru", {"late_loss": "150"}, "Потеря за день"),
        ("en", {"due": "2026-03-29T02:30"}, "The value of Due is no moment"),
        ("pl", {"opens": "2030-02-01T12:00", "due": "2030-01-31T12:00"}, "Termin: Zestaw musi się otworzyć"),
        ("en", {"then": "publish", "slot.1.limits": "l1 0.041 0.042"}, "Task 1: the limits on givens accept 0 of 1000"),
        ("en", {"slot.1.limits": "l1 5 6"}, f"The given l1 of “{title(EXERCISE)}” never lies within these limits."),
        (
            "pl",
            {"slot.1.limits": "l1 5 6"},
            f"Dana l1 zadania „{title(EXERCISE, 'pl')}” nigdy nie mieści się w tych granicach.",
        ),
        (
            "ru",
            {"slot.1.limits": "l1 0 0,03"},
            f"Данная l1 задачи «{title(EXERCISE, 'ru')}» никогда не попадает в эти пределы.",
        ),
    ],
)
def test_what_the_builder_cannot_take_is_told_beside_all_that_was_typed(
    course: Course, language: str, changes: dict[str, str], said: str
) -> None:
    path, browser = started(course), {"accept": "text/html"}
    page = saved(course.lecturer, path, add=EXERCISE)
    values = fields(page.text) | {"title": "Zestaw z <błędem>", "hints": "ladder", "minutes": "45"} | changes
    reply = course.lecturer.post(f"{path}?lang={language}", data=values, headers=browser)
    assert reply.status_code == 422 and said in unescape(reply.text) and 'role="alert"' in reply.text
    kept = fields(reply.text)
    typed = {name: value for name, value in values.items() if name not in ("then", "revision", "base")}
    assert {name: kept[name] for name in typed} == typed
    repaired = kept | {"title": "Set 8", **fields(page.text), "revision": kept["revision"], "base": kept["base"]}
    assert course.lecturer.post(path, data=repaired).status_code == 303


def test_the_set_of_the_first_chance_is_chosen_by_its_title(course: Course) -> None:
    first, page = course.published(title="First chance <1>"), started(course)
    form = course.lecturer.get(page).text
    assert f'<option value="{first}">First chance &lt;1&gt;</option>' in form
    assert f'<option value="{page.rsplit("/", 1)[1]}"' not in form
    chosen = saved(course.lecturer, page, second_chance_of=first)
    assert f'<option value="{first}" selected>' in chosen.text
    other = started(course)
    assert f'<option value="{page.rsplit("/", 1)[1]}"' not in course.lecturer.get(other).text


def test_the_preview_says_of_a_seed_that_the_limits_let_nobody_get_it(course: Course) -> None:
    page = f"/sets/{course.built(item={'limits': {'l1': [0.05, 0.06]}})}?lang=en"
    told = ["keep this seed from being dealt" in course.lecturer.get(f"{page}&seed={seed}").text for seed in range(20)]
    kept = [0.05 <= numbers(deal(EXERCISE, seed).givens)["l1"] <= 0.06 for seed in range(20)]
    assert told == [not one for one in kept] and any(kept) and not all(kept)


def test_the_preview_tells_which_givens_can_be_limited_and_how(course: Course) -> None:
    page = f"/sets/{course.built()}"
    for language, said in (("en", "l1 0.04 0.12; l2 0.1 0.6;"), ("pl", "l1 0,04 0,12; l2 0,1 0,6;")):
        assert said in course.lecturer.get(f"{page}?lang={language}").text
    typed = fields(course.lecturer.get(f"{page}?lang=pl").text) | {"slot.1.limits": "l1 0,04 0,12; l2 0,1 0,6"}
    assert course.lecturer.post(page, data=typed).status_code == 303


def test_limits_that_hardly_a_draw_keeps_are_told_when_the_draft_is_saved(course: Course) -> None:
    told = "Task 2: the limits on givens accept 0 of"
    path = started(course)
    saved(course.lecturer, path, add=EXERCISE)
    page = saved(course.lecturer, path, add=EXERCISE)
    assert told not in saved(course.lecturer, path, **{"slot.2.limits": "l1 0.04 0.06"}).text
    page = saved(course.lecturer, path, **{"slot.2.limits": "l1 0.041 0.042"})
    assert told in page.text and "Task 1: the limits" not in page.text


def test_a_draft_that_can_no_longer_be_published_says_so_in_the_builder(
    course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = f"/sets/{course.built(item={'limits': {'l1': [0.05, 0.08]}})}?lang=pl"
    said = "Zadanie 1, Ograniczenia danych: Żadne z tych zadań nie ma danej l1."
    assert said not in course.lecturer.get(page).text
    monkeypatch.setattr(foresight, "traits", lambda exercise: Traits(("l2",), frozenset({4})))
    assert said in course.lecturer.get(page).text


def test_what_is_strange_in_the_form_is_left_for_the_schema() -> None:
    found = draft_of_form({"title": "x", "slot.1.pool": "a, b", "slot.1.limits": "l1 1;  ", "late_loss": "much"})
    assert found["items"] == [{"pool": ["a", "b"], "points": "1", "attempts": None, "limits": {"l1": ["1"]}}]
    assert found["rules"]["late_loss"] == "much" and found["due"] is None


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("pl", "Zadanie 1, Ograniczenia danych: Dana l1 stoi w ograniczeniach dwa razy."),
        ("en", "Task 1, Limits on givens: The given l1 stands in the limits twice."),
        ("ru", "Данная l1 стоит в ограничениях дважды."),
    ],
)
def test_a_given_that_is_limited_twice_is_refused_by_its_name(course: Course, language: str, said: str) -> None:
    page = f"/sets/{course.built()}?lang={language}"
    values = fields(course.lecturer.get(page).text) | {"slot.1.limits": "l1 0,05 0,06; l2 0,2 0,3; l1 0,05 0,08"}
    reply = course.lecturer.post(page, data=values, headers={"accept": "text/html"})
    assert reply.status_code == 422 and said in unescape(reply.text)
    assert fields(reply.text)["slot.1.limits"] == values["slot.1.limits"]


def test_the_builder_names_the_tasks_of_a_slot_and_has_nothing_to_judge_again_yet(course: Course) -> None:
    number = course.built(item={"exercise": "slider_crank"})
    page = course.lecturer.get(f"/sets/{number}?lang=en").text
    assert '<p class="prose flush">Slider-crank by the vector polygon</p>' in page
    page = course.lecturer.get(f"/sets/{number}/regrade?lang=en").text
    assert "Only a published set can be judged again." in page and "<form" not in page.partition("<main")[2]


@pytest.mark.parametrize(
    ("language", "chapter"), [("pl", "Manipulatory"), ("en", "Manipulators"), ("ru", "Манипуляторы")]
)
def test_exercises_are_chosen_by_their_titles_under_their_chapters(course: Course, language: str, chapter: str) -> None:
    number = course.built(item={"exercise": "tmm2_poo"})
    page = course.lecturer.get(f"/sets/{number}?lang={language}").text
    shelf = page[page.index('<details class="shelf"') : page.index("</details>")]
    for one in catalogue.ids():
        name = escape(title(one, language))
        assert f'value="{one}"{" checked" if one == "tmm2_poo" else ""}><span>{name} <small' in shelf
        assert f'<option value="{one}">{name}</option>' in page
    assert f"<legend>{chapter}</legend>" in shelf and f'<optgroup label="{chapter}">' in page


def test_a_pool_is_made_of_several_choices_and_emptied_by_none(course: Course) -> None:
    number = course.built(item={"exercise": "tmm2_poo"})
    values = fields(course.lecturer.get(f"/sets/{number}").text)
    several: dict[str, Any] = values | {"slot.1.pool": ["", "tmm2_opo", "tmm2_oop"]}
    assert course.lecturer.post(f"/sets/{number}", data=several).status_code == 303
    stored = course.lecturer.get(f"/api/v1/task-sets/{number}").json()
    assert [one["pool"] for one in stored["items"]] == [["tmm2_opo", "tmm2_oop"]]
    page = course.lecturer.get(f"/sets/{number}?lang=en").text
    none = fields(page) | {"slot.1.pool": ""}
    reply = course.lecturer.post(f"/sets/{number}?lang=en", data=none, headers={"accept": "text/html"})
    assert reply.status_code == 422 and "at least as many different exercises" in reply.text
    assert '<details class="shelf" open>' in reply.text


def test_what_is_not_in_the_catalogue_any_more_is_still_shown_and_can_be_left_out() -> None:
    found = shelves({"four_bar": "Four-bar linkage"}, ["four_bar", "withdrawn"])
    assert found == {"linkages": [("four_bar", "Four-bar linkage")], "": [("withdrawn", "withdrawn")]}


def test_a_pool_of_unequal_length_is_told_by_the_titles_of_its_exercises_with_their_steps(course: Course) -> None:
    path = started(course)
    saved(course.lecturer, path, add=EXERCISE)
    form = fields(course.lecturer.get(f"{path}?lang=en").text)
    reply = course.lecturer.post(
        f"{path}?lang=en", data=form | {"slot.1.pool": f"{EXERCISE} four_bar"}, headers={"accept": "text/html"}
    )
    assert reply.status_code == 422
    (said,) = re.findall(r'id="problem">([^<]*)', unescape(reply.text))
    assert "must have equally many steps" in said
    assert said.endswith(f"Number of steps here: {title(EXERCISE)} (4); {title('four_bar')} (14).")


def test_the_builder_tells_how_many_steps_each_exercise_has(course: Course) -> None:
    path = started(course)
    saved(course.lecturer, path, add=EXERCISE)
    page = course.lecturer.get(f"{path}?lang=en").text
    assert re.search(r'value="four_bar"><span>[^<]*<small class="quiet nowrap">steps: 14</small>', page)
    assert re.search(r'value="gear_train"><span>[^<]*<small class="quiet nowrap">steps: 4–5</small>', page)


@pytest.mark.parametrize(("language", "shown"), [("pl", "0,05 0,08"), ("ru", "0,05 0,08"), ("en", "0.05 0.08")])
def test_limits_are_written_with_the_decimal_mark_of_the_language_and_read_with_either(
    course: Course, language: str, shown: str
) -> None:
    path = started(course)
    saved(course.lecturer, path, add=EXERCISE)
    for typed in ("l1 0,05 0,08", "l1 0.05 0.08"):
        saved(course.lecturer, path, **{"slot.1.limits": typed})
        form = fields(course.lecturer.get(f"{path}?lang={language}").text)
        assert form["slot.1.limits"] == f"l1 {shown}"
        assert course.lecturer.post(f"{path}?lang={language}", data=form).status_code == 303
        kept = course.lecturer.get(f"/api/v1/task-sets/{path.rpartition('/')[2]}").json()
        assert kept["items"][0]["limits"] == {"l1": [0.05, 0.08]}


def test_the_builder_foresees_a_pool_that_most_likely_cannot_be_published(course: Course) -> None:
    path = started(course)
    saved(course.lecturer, path, add="gear_train")
    saved(course.lecturer, path, **{"slot.1.pool": "gear_train planetary"})
    page = unescape(course.lecturer.get(f"{path}?lang=en").text)
    assert f"on most of their cards: {title('gear_train')} (4); {title('planetary')} (5)." in page
    saved(course.lecturer, path, **{"slot.1.pool": "planetary"})
    assert "on most of their cards" not in course.lecturer.get(f"{path}?lang=en").text
