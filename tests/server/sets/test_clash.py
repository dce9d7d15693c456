"""A draft changed in two windows: nobody's work is lost, and it is said who did what."""

from __future__ import annotations

from html import unescape
from json import dumps
from typing import Any

import pytest
from starlette.testclient import TestClient

from server.people import personal
from server.sets.clash import Row, clash
from server.sets.form import flat, unflat
from tests.server.sets.builder import fields, saved, started
from tests.server.sets.conftest import EXERCISE, Course

BROWSER = {"accept": "text/html", "accept-language": "en"}


def form(**changes: str) -> dict[str, str]:
    plain = flat(unflat({"title": "Set", "slot.1.pool": "a", "slot.1.points": "1", "slot.2.pool": "b"}))
    return plain | {name.replace("__", "."): text for name, text in changes.items()}


def met(base: dict[str, str], mine: dict[str, str], theirs: dict[str, str]) -> Any:
    stored = unflat(theirs) | {"revision": 3, "base": "{}"}
    return clash("en", mine | {"base": dumps(base)}, stored, {"S1": "Set 1"})


def test_fields_that_one_side_changed_are_taken_from_it_and_both_sides_are_shown_where_they_differ() -> None:
    mine = form(title="Mine", slot__1__points="2,5", minutes="45")
    theirs = form(title="Theirs", slot__1__points="2.50", slot__2__attempts="3", mode="exam")
    found = met(form(slot__1__points="1.0"), mine, theirs)
    assert found.both == (Row("Title of the set", "Theirs", "Mine"),)
    assert found.theirs == ("Kind", "Task 2, Attempts")
    merged = flat(found.form)
    assert (merged["title"], merged["minutes"], merged["mode"], merged["slot.2.attempts"]) == (
        "Mine",
        "45",
        "exam",
        "3",
    )


@pytest.mark.parametrize(
    ("language", "points", "limits"), [("pl", "2,5", "l1 0,05 0,08"), ("en", "2.5", "l1 0.05 0.08")]
)
def test_numbers_are_told_with_the_decimal_mark_of_the_reader(language: str, points: str, limits: str) -> None:
    theirs = form(title="Set 1.5", slot__1__points="2.5", slot__1__limits="l1 0.05 0.08")
    mine = form(title="Set 2.5", slot__1__points="3", slot__1__limits="l1 0.05 0.09")
    found = clash(language, mine | {"base": dumps(form())}, unflat(theirs) | {"revision": 3, "base": "{}"}, {})
    assert [row.stored for row in found.both] == ["Set 1.5", points, limits]


def test_a_number_with_another_decimal_mark_is_no_change() -> None:
    base = form(slot__1__limits="l1 0.05 0.08", slot__1__points="2.5")
    theirs = base | {"title": "Theirs"}
    found = met(base, form(slot__1__limits="l1 0,05  0,08", slot__1__points="2,50"), theirs)
    assert found.theirs == ("Title of the set",) and found.mine == ()
    assert flat(found.form) == theirs


def test_tasks_that_were_moved_take_with_them_what_was_typed_in_them() -> None:
    moved = form(slot__1__pool="b", slot__1__points="", slot__2__pool="a", slot__2__points="1")
    assert flat(met(form(), form(title="Mine"), moved).form) == {**moved, "title": "Mine"}
    found = met(form(), form(slot__1__points="2", slot__2__attempts="3"), moved)
    assert flat(found.form) == {**moved, "slot.2.points": "2", "slot.1.attempts": "3"}
    assert (found.both, found.theirs) == ((), ("Tasks",))


def test_only_the_task_that_both_changed_is_asked_about_though_the_tasks_have_moved() -> None:
    theirs = form(slot__1__pool="c", slot__1__points="", slot__2__pool="a", slot__2__points="5", slot__3__pool="b")
    found = met(form(), form(slot__1__points="2", slot__2__limits="l1 1 2"), unflatted(theirs))
    assert found.both == (Row("Task 2, Points", "5", "2"),)
    assert flat(found.form) == {**unflatted(theirs), "slot.2.points": "2", "slot.3.limits": "l1 1 2"}


def test_a_task_that_the_other_one_removed_goes_unless_something_was_typed_in_it() -> None:
    removed = {name: text for name, text in form(title="Theirs").items() if not name.startswith("slot.2.")}
    assert flat(met(form(), form(minutes="45"), removed).form) == {**removed, "minutes": "45"}
    found = met(form(), form(slot__2__points="4"), removed)
    assert flat(found.form) == form(title="Theirs", slot__2__points="4")
    assert Row("Task 2, Points", "—", "4") in found.both


def test_exercises_that_one_side_chose_anew_stay_with_their_task() -> None:
    found = met(form(), form(slot__2__pool="b c"), form(slot__1__pool="d", slot__2__attempts="3"))
    assert flat(found.form) == form(slot__1__pool="d", slot__2__pool="b c", slot__2__attempts="3")
    assert found.both == ()


def unflatted(fields: dict[str, str]) -> dict[str, str]:
    """All fields of a form of which some were named."""
    return flat(unflat(fields))


def test_a_pool_is_told_by_the_titles_of_its_exercises() -> None:
    stored = unflat(form(slot__1__pool="a c")) | {"revision": 3, "base": "{}"}
    mine = form(slot__1__pool="b") | {"base": dumps(form())}
    found = clash("en", mine, stored, {"a": "Four-bar", "b": "Beam"})
    assert found.both == (Row("Task 1, Exercises of the catalogue", "Four-bar, c", "Beam"),)


def test_without_what_was_loaded_all_that_differs_is_shown_and_what_was_typed_stays() -> None:
    for base in ("", "[", "[1]", "[" * 100_000):
        found = clash("en", form(due="2030-01-31T12:00", second_chance_of="S1") | {"base": base},
                      unflat(form(title="Other")) | {"revision": 3, "base": "{}"}, {"S1": "Set 1"})  # fmt: skip
        assert found.theirs == () and flat(found.form)["title"] == "Set"
        assert {Row("Due", "—", "2030-01-31 12:00"), Row("Second chance to the set", "—", "Set 1")} <= set(found.both)


def posted(browser: TestClient, path: str, values: dict[str, str]) -> Any:
    return browser.post(path, data=values, headers=BROWSER)


@pytest.fixture
def draft(course: Course) -> str:
    path = started(course)
    saved(course.lecturer, path, add=EXERCISE)
    return path


def test_what_was_typed_into_a_draft_that_has_changed_comes_back_and_can_be_saved_or_let_go(
    course: Course, draft: str
) -> None:
    one = fields(course.lecturer.get(draft).text)
    saved(course.lecturer, draft, title="In the other window", minutes="45")
    reply = posted(course.lecturer, draft, one | {"title": "In this one", "slot.1.points": "3"})
    page = unescape(reply.text)
    assert reply.status_code == 409 and 'role="alert"' in page and "You changed it in another window (" in page
    assert "Taken over, since you changed nothing there: Time limit in minutes." in page
    assert f'<a class="btn" href="{draft}">Load what is stored</a>' in page
    again = fields(page)
    assert (again["title"], again["minutes"], again["slot.1.points"]) == ("In this one", "45", "3")
    assert "In the other window</td>" in page and "In this one</td>" in page
    assert posted(course.lecturer, draft, again).status_code == 303
    kept = fields(course.lecturer.get(draft).text)
    assert (kept["title"], kept["minutes"], kept["slot.1.points"]) == ("In this one", "45", "3")


def test_it_is_said_who_changed_the_draft(course: Course, draft: str) -> None:
    number, school = draft.rpartition("/")[2], course.school
    one = fields(course.lecturer.get(draft).text)
    members = course.lecturer.get(f"/api/v1/courses/{school.course}/members").json()
    other = next(member for member in members if member["login"] == "assistant")
    path = f"/api/v1/courses/{school.course}/members/{other['id']}"
    assert course.lecturer.patch(path, json={"role": "lecturer"}).status_code == 200
    body = {"revision": int(one["revision"]), "title": "By the other"}
    assert school.browser("assistant").patch(f"/api/v1/task-sets/{number}", json=body).status_code == 200
    page = unescape(posted(course.lecturer, draft, one | {"minutes": "30"}).text)
    assert f"{other['name']} changed it (" in page
    school.portal.call(personal.erase, school.bench, other["id"], "administrator")
    assert "Somebody else changed it." in posted(course.lecturer, draft, one | {"minutes": "30"}).text


def test_a_set_that_was_published_meanwhile_shows_what_was_not_saved(course: Course, draft: str) -> None:
    one = fields(course.lecturer.get(draft).text)
    saved(course.lecturer, draft, then="publish")
    reply = posted(course.lecturer, draft, one | {"title": "Too late"})
    page = unescape(reply.text)
    assert reply.status_code == 409 and "This set is published and does not change any more." in page
    assert "Too late</td>" in page and "Save what I typed" not in page and 'name="then"' not in page


@pytest.mark.parametrize("pressed", ["save", "publish"])
def test_a_button_may_be_pressed_twice(course: Course, draft: str, pressed: str) -> None:
    form = fields(course.lecturer.get(draft).text) | {"title": "Twice", "then": pressed}
    replies = [course.lecturer.post(draft, data=form, headers=BROWSER, follow_redirects=False) for _ in range(2)]
    assert [(reply.status_code, reply.headers["location"]) for reply in replies] == [(303, draft)] * 2
    kept = course.lecturer.get(f"/api/v1/task-sets/{draft.rpartition('/')[2]}").json()
    assert (kept["title"], kept["state"] == "published") == ("Twice", pressed == "publish")


@pytest.mark.parametrize(
    ("button", "pools"),
    [
        ({"add": "four_bar"}, [EXERCISE, "planetary", "four_bar"]),
        ({"add": EXERCISE, "title": "Twice", "slot.1.points": "2,5"}, [EXERCISE, "planetary", EXERCISE]),
        ({"move": "2"}, ["planetary", EXERCISE]),
        ({"remove": "1"}, ["planetary"]),
    ],
)
def test_a_task_is_added_moved_or_removed_once_however_often_the_button_is_pressed(
    course: Course, draft: str, button: dict[str, str], pools: list[str]
) -> None:
    saved(course.lecturer, draft, add="planetary")
    form = fields(course.lecturer.get(draft).text) | button
    replies = [course.lecturer.post(draft, data=form, headers=BROWSER, follow_redirects=False) for _ in range(3)]
    assert [(reply.status_code, reply.headers["location"]) for reply in replies] == [(303, draft)] * 3
    kept = course.lecturer.get(f"/api/v1/task-sets/{draft.rpartition('/')[2]}").json()
    assert [item["pool"] for item in kept["items"]] == [[pool] for pool in pools]


def test_a_task_that_is_added_to_a_draft_that_stands_otherwise_meets_a_clash(course: Course, draft: str) -> None:
    form = fields(course.lecturer.get(draft).text) | {"add": "four_bar"}
    saved(course.lecturer, draft, add="four_bar", title="In the other window")
    assert posted(course.lecturer, draft, form | {"title": "Here"}).status_code == 409


def test_what_is_asked_of_a_draft_that_was_saved_as_it_was_is_done(course: Course, draft: str) -> None:
    one = fields(course.lecturer.get(draft).text)
    saved(course.lecturer, draft)
    assert posted(course.lecturer, draft, one | {"add": "four_bar"}).status_code == 303
    assert fields(course.lecturer.get(draft).text)["slot.2.pool"] == "four_bar"
    saved(course.lecturer, draft)
    again = fields(course.lecturer.get(draft).text)
    saved(course.lecturer, draft)
    assert posted(course.lecturer, draft, again | {"then": "publish"}).status_code == 303
    assert course.lecturer.get(f"/api/v1/task-sets/{draft.rpartition('/')[2]}").json()["state"] == "published"


def test_a_form_that_is_refused_does_not_forget_which_draft_it_was_made_for(course: Course, draft: str) -> None:
    one = fields(course.lecturer.get(draft).text)
    saved(course.lecturer, draft, title="In the other window")
    refused = posted(course.lecturer, draft, one | {"slot.1.points": "many"})
    assert refused.status_code == 422
    repaired = fields(refused.text) | {"slot.1.points": "2"}
    assert posted(course.lecturer, draft, repaired).status_code == 409
