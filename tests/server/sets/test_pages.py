"""The pages of sets work as plain forms: build, look at seeds, publish, open, answer, see the points."""

from __future__ import annotations

import re
from datetime import UTC, datetime, timedelta
from html import unescape
from typing import Any

import pytest
from markupsafe import escape
from starlette.testclient import TestClient

from exercises import catalogue
from exercises.givens import numbers
from exercises.presenting import words_of
from exercises.variants import deal
from server.sets import foresight
from server.sets.foresight import Traits
from server.sets.form import draft_of_form, shelves
from tests.server.sets.conftest import EXERCISE, Course, moment


def fields(page: str) -> dict[str, str]:
    """The fields of the builder as the browser would send them."""
    form = page[page.index('name="revision"') - 40 : page.index('name="then"')]
    found = {match[1]: unescape(match[2]) for match in re.finditer(r'name="([\w.]+)"(?:[^>]*?) value="([^"]*)"', form)}
    for name in {name for name in found if name.endswith(".pool")}:
        ticked = re.findall(rf'type="checkbox" name="{re.escape(name)}" value="([^"]*)" checked', form)
        found[name] = " ".join(map(unescape, ticked))
    for match in re.finditer(r'<select id="\w+" name="(\w+)">(.*?)</select>', form, re.DOTALL):
        chosen = re.search(r'value="([^"]*)" selected', match[2])
        found[match[1]] = chosen[1] if chosen else ""
    for button in ("move", "remove"):
        found.pop(button, None)
    return found


def title(exercise: str, language: str = "en") -> str:
    """The title of an exercise."""
    return str(words_of(exercise, language)["title"])


def started(course: Course) -> str:
    path = f"/courses/{course.school.course}/sets"
    reply = course.lecturer.post(path, data={"title": "Set 7"})
    assert reply.status_code == 303, reply.text
    found: str = reply.headers["location"]
    return found


def saved(browser: TestClient, path: str, **changes: str) -> Any:
    reply = browser.post(path, data=fields(browser.get(path).text) | changes)
    assert reply.status_code == 303, reply.text
    return browser.get(path)


def test_a_set_is_built_published_and_answered_without_script(course: Course) -> None:
    path, lecturer, student = started(course), course.lecturer, course.student
    saved(lecturer, path, add="planetary")
    page = saved(lecturer, path, add=EXERCISE, **{"slot.1.points": "2,5"})
    assert fields(page.text)["slot.1.points"] == "2.5" and 'value="planetary"' in page.text
    home = f"/courses/{course.school.course}"
    assert 0 < page.text.index(f'href="{home}"') < page.text.index(f'href="{home}/sets"')  # the way back, widest first
    page = saved(lecturer, path, move="2", **{"slot.2.limits": "l1 0,05000001 0,08", "slot.2.attempts": "2"})
    assert fields(page.text)["slot.1.limits"] == "l1 0.05000001 0.08"
    page = saved(lecturer, path, remove="2", due="2030-01-31T12:00")
    assert "slot.2.pool" not in fields(page.text) and "31 Jan 2030, 12:00" in page.text
    assert student.get(path).status_code == 404
    page = saved(lecturer, path, then="publish")
    assert 'name="then"' not in page.text and "sheets.pdf" in page.text
    assert "Set 7" in student.get(f"/courses/{course.school.course}/sets").text
    opened = student.post(f"{path}/items/1", data={"another": "no"})
    workspace = student.get(opened.headers["location"] + "?lang=en")
    assert "Check answers (attempt 1 of 2)" in workspace.text and "31 Jan 2030, 12:00" in workspace.text
    code = course.card(path.rsplit("/", 1)[1]).code
    assert code in workspace.text and code in student.get(path).text
    graded = student.post(opened.headers["location"], data={"answer.l3": "1 m"})
    assert graded.status_code == 303, graded.text
    workspace = student.get(graded.headers["location"].split("#")[0] + "&lang=en")
    assert "Check answers (attempt 2 of 2)" in workspace.text and "1 of 2" in workspace.text
    assert re.search(r"<small data-left=[^>]*>\d+ d \d+ h left</small>", workspace.text)


def test_all_open_deadlines_of_a_course_move_together(course: Course) -> None:
    one, other, page = course.published(), course.published(), f"/courses/{course.school.course}"
    closed = course.published()
    course.move(closed, hours=3)
    before = {number: due(course, number) for number in (one, other, closed)}
    form = {"minutes": " 15 ", "seen": seen(course, page)}
    reply = course.lecturer.post(f"{page}/extend", data=form)
    onward, at = reply.headers["location"].split("#")
    moved = int(onward.removeprefix(f"{page}?moved="))
    told = course.lecturer.get(f"{onward}&lang=en").text
    assert f"Sets moved: {moved}." in told and moved >= 2 and f'id="{at}"' in told
    assert due(course, one) - before[one] == due(course, other) - before[other] == timedelta(minutes=15)
    assert due(course, closed) == before[closed]
    again = course.lecturer.post(f"{page}/extend", data=form)  # a second click
    assert (again.status_code, again.json()["error"]["code"]) == (409, "deadlines_moved")
    assert due(course, one) - before[one] == timedelta(minutes=15)
    for minutes in ("0", "-5", "x", "", "1e3", "1000000"):
        assert course.lecturer.post(f"{page}/extend", data={"minutes": minutes}).status_code == 422


def seen(course: Course, page: str) -> str:
    """What the form that moves deadlines says of those it was made for."""
    (found,) = re.findall(r'name="seen" value="(\w+)"', course.lecturer.get(page).text)
    return str(found)


def due(course: Course, number: str) -> datetime:
    return datetime.fromisoformat(course.lecturer.get(f"/api/v1/task-sets/{number}").json()["due"])


def test_a_course_is_copied_with_its_sets_and_later_dates_and_nobody(course: Course) -> None:
    number, page = course.published(title="Set to copy"), f"/courses/{course.school.course}"
    reply = course.lecturer.post(f"{page}/copy", data={"title": "TMM next year", "days": "364"})
    fresh = reply.headers["location"]
    sets = course.lecturer.get(f"/api/v1{fresh}/task-sets").json()
    copy = next(one for one in sets if one["title"] == "Set to copy")
    assert copy["state"] == "draft" and len(sets) == len(course.lecturer.get(f"/api/v1{page}/task-sets").json())
    assert timedelta(days=363) < due(course, copy["id"]) - due(course, number) < timedelta(days=365)
    members = course.lecturer.get(f"/api/v1{fresh}/members").json()
    assert [(one["login"], one["role"]) for one in members] == [("lecturer", "lecturer")]
    for form in ({"title": "", "days": "7"}, {"title": "x", "days": "4000"}, {"title": "x"}):
        assert course.lecturer.post(f"{page}/copy", data=form).status_code == 422


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
def test_the_builder_shows_any_seed_in_any_language_and_twenty_in_a_table(course: Course, language: str) -> None:
    number = course.built()
    page = course.lecturer.get(f"/sets/{number}?slot=1&seed=1042&table=true&lang={language}").text
    alone = course.lecturer.get(f"/sets/{number}?slot=1&seed=1042&lang={language}").text
    assert len(re.findall(r'<th scope="row" class="num">\d+</th>', page)) == 20 and "<svg" in page
    assert "seed=1041" in page and "seed=1043" in page and "<caption>" not in alone


def test_a_student_sees_the_rules_and_the_points_before_the_click(course: Course) -> None:
    number = course.published(rules={"mode": "exam", "minutes": 90}, opens=moment(hours=-1))
    page = course.student.get(f"/sets/{number}?lang=en").text
    for said in ("This is an examination", "90 min", "Worth: 10 pt", "Attempts used: 0 of 2", "Open task 1"):
        assert said in page
    path = course.student.post(f"/sets/{number}/items/1", data={"another": "no"}).headers["location"]
    graded = course.student.post(path, data={"answer.l3": "1 m"}).headers["location"].split("#")[0]
    assert "You see the result after the set has closed for everybody." in course.student.get(f"{graded}&lang=en").text


@pytest.mark.parametrize(("rules", "told"), [({}, False), ({"ladder": True}, True)])
def test_the_ladder_of_hints_is_the_sets_to_give_and_closed_in_practice_meanwhile(
    course: Course, rules: dict[str, bool], told: bool
) -> None:
    number = course.published(rules=rules)
    assert ("They cost nothing" in course.student.get(f"/sets/{number}?lang=en").text) is told
    practised = course.student.post(f"/exercises/{EXERCISE}", data={"seed": ""}).headers["location"]
    for path, open_ in ((f"/variants/{course.variant(number)}", told), (practised, False)):
        graded = course.student.post(path, data={"answer.l3": "9 m"}).headers["location"].split("#")[0]
        assert ("Hint: what it follows from" in course.student.get(f"{graded}&lang=en").text) is open_
    course.move(number, hours=1)


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


def test_a_draft_is_deleted_and_a_published_set_stays(course: Course) -> None:
    page, sets = started(course), f"/courses/{course.school.course}/sets"
    saved(course.lecturer, page, add=EXERCISE, title="Draft to go")
    number = page.rsplit("/", 1)[1]
    given = f"/api/v1/task-sets/{number}/accommodations/{course.school.people['student']}"
    assert course.lecturer.put(given, json={"minutes": 5}).status_code == 200
    assert f'action="{page}/remove"' in course.lecturer.get(page).text
    for who in (course.student, course.school.browser("assistant")):
        assert who.post(f"{page}/remove").status_code == who.delete(f"/api/v1/task-sets/{number}").status_code == 403
    assert course.lecturer.post(f"{page}/remove").headers["location"] == sets
    assert course.lecturer.get(page).status_code == 404 and "Draft to go" not in course.lecturer.get(sets).text
    assert "title: Draft to go" in course.lecturer.get(f"/courses/{course.school.course}/audit?lang=en").text
    published = course.published()
    assert f'action="/sets/{published}/remove"' not in course.lecturer.get(f"/sets/{published}").text
    refused = course.lecturer.delete(f"/api/v1/task-sets/{published}")
    assert (refused.status_code, refused.json()["error"]["code"]) == (409, "set_frozen")
    assert course.lecturer.delete(f"/api/v1/task-sets/{course.built()}").status_code == 204


def test_the_set_of_the_first_chance_is_chosen_by_its_title(course: Course) -> None:
    first, page = course.published(title="First chance <1>"), started(course)
    form = course.lecturer.get(page).text
    assert f'<option value="{first}">First chance &lt;1&gt;</option>' in form
    assert f'<option value="{page.rsplit("/", 1)[1]}"' not in form
    chosen = saved(course.lecturer, page, second_chance_of=first)
    assert f'<option value="{first}" selected>' in chosen.text
    other = started(course)
    assert f'<option value="{page.rsplit("/", 1)[1]}"' not in course.lecturer.get(other).text


def test_extra_time_is_given_on_the_page_of_a_student_and_taken_back(course: Course) -> None:
    number, person = course.published(), course.school.people["student"]
    page, given = f"/sets/{number}/students/{person}", f"/api/v1/task-sets/{number}/accommodations"
    for minutes in ("30", "0"):
        reply = course.lecturer.post(f"{page}/time", data={"minutes": minutes, "reason": "<dyslexia>"})
        assert (reply.status_code, reply.headers["location"]) == (303, page)
        assert (
            course.lecturer.get(given).json()
            == [{"person": person, "minutes": int(minutes), "reason": "<dyslexia>"}][: int(minutes)]
        )
        shown = course.lecturer.get(f"{page}?lang=en").text
        assert ("extra time: 30 min" in shown, 'value="&lt;dyslexia&gt;"' in shown) == (minutes == "30",) * 2
    for minutes in ("-1", "x", "", "100001"):
        assert course.lecturer.post(f"{page}/time", data={"minutes": minutes}).status_code == 422
    lecturer = course.school.people["lecturer"]
    assert course.lecturer.post(f"/sets/{number}/students/{lecturer}/time", data={"minutes": "5"}).status_code == 404
    log = course.lecturer.get(f"/courses/{course.school.course}/audit?lang=en").text
    assert "extra time given" in log and "set: Set 4; minutes: 30" in log and number not in log
    assistant = course.school.browser("assistant")
    assert assistant.post(f"{page}/time", data={"minutes": "5"}).status_code == 403
    form = f'action="{page}/time"'
    assert form in course.lecturer.get(page).text and form not in assistant.get(page).text


def test_a_task_of_a_student_is_named_in_the_language_of_who_reads(course: Course) -> None:
    number = course.published()
    course.variant(number)
    page, shown = f"/sets/{number}/students/{course.school.people['student']}", course.card(number).shown
    for language in ("pl", "en", "ru"):
        assert f"1. {shown[language]['title']}</h2>" in course.lecturer.get(f"{page}?lang={language}").text


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


def test_deadlines_move_and_sets_are_copied_from_the_page(course: Course) -> None:
    number = course.published()
    before = course.lecturer.get(f"/api/v1/task-sets/{number}").json()["due"]
    form = {"minutes": "15", "seen": seen(course, f"/sets/{number}")}
    assert [course.lecturer.post(f"/sets/{number}/extend", data=form).status_code for _ in range(2)] == [303, 409]
    assert course.lecturer.get(f"/api/v1/task-sets/{number}").json()["due"] > before
    assert course.lecturer.post(f"/sets/{number}/extend", data={"minutes": "x"}).status_code == 422
    copied = course.lecturer.post(f"/sets/{number}/copy").headers["location"]
    assert 'name="then"' in course.lecturer.get(copied).text


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


def test_the_page_says_why_nothing_more_can_be_handed_in(course: Course) -> None:
    number = course.published(title="Used up", item={"exercise": "slider_crank", "attempts": 1})
    variant = course.variant(number)
    path, button = f"/variants/{variant}?lang=en", 'data-sending="Checking…"'
    page = course.student.get(path).text
    assert "An unreadable answer costs nothing." in page and f"{button}>" in page
    page = course.lecturer.get(path).text
    assert "only the student can hand in" in page and button not in page
    course.hand_in(variant, {"l3": "1 mm"})
    page = course.student.get(path).text
    assert "The attempts of this task are used up." in page and f"{button} disabled" in page
    course.date(number, datetime.now(UTC) - timedelta(hours=2), datetime.now(UTC) - timedelta(hours=1))
    assert "This set is closed." in course.student.get(path).text


def test_an_examination_takes_nothing_that_it_could_not_read_and_says_so(course: Course) -> None:
    number = course.published(rules={"mode": "exam"})
    place = f"/variants/{course.variant(number)}"
    typed = {"answer.alpha2": "12 deg", "answer.l3": "10 mm /"}
    refused = course.student.post(place, data=typed, follow_redirects=True).text
    assert "Your answers are not taken yet: mend what could not be read" in refused and "Not read" in refused
    assert "Your answers are taken" not in refused and "No attempt was counted." in refused
    taken = course.student.post(place, data={**typed, "answer.l3": "10 mm"}, follow_redirects=True).text
    assert "Your answers are taken" in taken and "not taken yet" not in taken


@pytest.mark.parametrize(("rules", "shown"), [({}, True), ({"mode": "exam"}, False)], ids=["practice", "exam"])
def test_a_section_of_a_report_tells_the_attempt_it_costs_and_an_examination_is_handed_in_whole(
    course: Course, rules: dict[str, Any], shown: bool
) -> None:
    number = course.published(item={"exercise": "tmm2_oop", "attempts": 3}, rules=rules)
    path = f"/variants/{course.variant(number)}?lang=en"
    page = course.student.get(path).text
    assert ("Check section 7 (attempt 1 of 3)" in page) is ('name="section"' in page) is shown
    assert "(attempt 1 of 3)</button>" in page.rpartition('class="btn main"')[2]


def test_a_task_tells_the_seconds_until_it_is_due(course: Course) -> None:
    path = f"/variants/{course.variant(course.published(due=moment(days=1)))}?lang=en"
    found = re.search(r'data-left="(\d+)" data-days="{first} d {second} h left"', course.student.get(path).text)
    assert found and 23 * 3600 < int(found[1]) <= 24 * 3600


def test_a_lecturer_finds_no_button_to_hand_in_a_laboratory_of_a_student(course: Course) -> None:
    path = f"/variants/{course.variant(course.published(item={'exercise': 'tmm2_oop'}))}"
    assert 'name="section"' in course.student.get(path).text
    assert 'name="section"' not in course.lecturer.get(path).text


@pytest.mark.parametrize(
    ("rules", "bounds", "ahead"),
    [
        ({}, {}, {"late": 3600, "closed": 3600}),
        ({"late": "accepted"}, {}, {"late": 3600}),
        ({"late": "accepted"}, {"closes": 2}, {"late": 3600, "closed": 7200}),
        ({"late": "reduced"}, {"due": -1, "closes": 2}, {"closed": 7200}),
    ],
)
def test_a_page_knows_what_its_task_becomes_and_when(
    course: Course, rules: dict[str, str], bounds: dict[str, int], ahead: dict[str, int]
) -> None:
    words = {"late": "past due, still taken", "closed": "closed"}
    variant = course.variant(course.published(rules=rules, **{one: moment(hours=bounds[one]) for one in bounds}))
    page = course.student.get(f"/variants/{variant}?lang=en").text
    found = dict(re.findall(r'data-(late|closed)-in="(\d+)"', page))
    assert list(found) == list(ahead)
    for stage, seconds in ahead.items():
        assert seconds - 120 < int(found[stage]) <= seconds
        assert f'data-{stage}="{words[stage]}"' in page


@pytest.mark.parametrize("mode", ["practice", "exam"])
def test_empty_answers_are_said_to_be_nothing_to_judge_and_nothing_else(course: Course, mode: str) -> None:
    variant = course.variant(course.published(rules={"mode": mode}))
    sent = course.student.post(f"/variants/{variant}", data={"answer.l3": " ", "answer.v3": ""})
    page = course.student.get(f"{sent.headers['location'].split('#')[0]}&lang=en").text
    assert "All answers are empty: there is nothing to judge, and no attempt is counted</h2>" in page
    for other in ("Your answers are taken", "No attempt was counted", "mend what", "after it has closed for all"):
        assert other not in page


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
