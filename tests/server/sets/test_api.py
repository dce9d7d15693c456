"""Task sets over HTTP: built, published, frozen, dealt, answered, closed."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest

from exercises import catalogue, grading, solving
from exercises.exercise import Submission
from graders import Expression
from server.sets import dealing, handing
from tests.server.conftest import SECRET
from tests.server.sets.conftest import EXERCISE, Course, moment


def texts(course: Course, number: str, who: str = "student") -> dict[str, str]:
    """The right answers of a student's card."""
    found: dict[str, str] = dict(course.card(number, who).reference["texts"])
    return found


def forget() -> None:
    """Let an exercise be solved anew."""
    handing._reproduced.cache_clear()
    solving.solved.cache_clear()


def code_of(reply: Any) -> tuple[int, str]:
    return reply.status_code, reply.json()["error"]["code"]


def test_a_draft_is_changed_by_revision_and_frozen_when_it_is_published(course: Course) -> None:
    number = course.built()
    path = f"/api/v1/task-sets/{number}"
    changed = course.lecturer.patch(path, json={"revision": 1, "title": "Set 5", "rules": {"keep": "last"}})
    assert (changed.json()["title"], changed.json()["revision"], changed.json()["rules"]["keep"]) == (
        "Set 5",
        2,
        "last",
    )
    assert changed.json()["items"][0]["pool"] == [EXERCISE] and changed.json()["due"]
    assert code_of(course.lecturer.patch(path, json={"revision": 1, "title": "x"})) == (409, "set_changed")
    assert course.student.get(path).status_code == 404
    assert course.lecturer.post(f"{path}/open").json()["state"] == "published"
    assert code_of(course.lecturer.patch(path, json={"revision": 2, "title": "x"})) == (409, "set_frozen")
    assert code_of(course.lecturer.post(f"{path}/open")) == (409, "set_frozen")
    listed = course.student.get(f"/api/v1/courses/{course.school.course}/task-sets").json()
    assert number in [one["id"] for one in listed]


@pytest.mark.parametrize(
    ("changes", "field", "code"),
    [
        ({"item": {"exercise": "no_such"}}, "items.0.no_such", "unknown_exercise"),
        ({"item": {"exercise": None}}, "items.0", "set_pick"),
        ({"item": {"pick": 2}}, "items.0", "set_pick"),
        ({"item": {"limits": {"l1": [2, 1]}}}, "items.0.limits", "out_of_range"),
        ({"item": {"limits": {"l9": [0, 1]}}}, "items.0.limits", "unknown_given"),
        ({"item": {"limits": {"l1": [5, 6]}}}, "items.0.limits", "limit_outside"),
        ({"item": {"pool": ["four_bar"]}}, "items.0.pool", "unequal_steps"),
        ({"item": {"points": -1}}, "items.0.points", "out_of_range"),
        ({"item": {"seed": 7}}, "items.0.seed", "extra_field"),
        ({"opens": "2026-12-08T08:00", "due": "2026-12-07T08:00"}, "due", "set_times"),
        ({"due": "2026-03-29T02:30"}, "due", "no_moment"),
        ({"rules": {"mode": "duel"}}, "rules.mode", "wrong_type"),
        ({"rules": {"second_chance_of": "AAAA-AAAA-AAAA"}}, "rules.second_chance_of", "unknown_set"),
        ({"state": "published"}, "state", "extra_field"),
    ],
)
def test_a_set_that_cannot_be_is_refused_by_name(
    course: Course, changes: dict[str, Any], field: str, code: str
) -> None:
    item = {"exercise": EXERCISE, **changes.pop("item", {})}
    body = {"course": course.school.course, "title": "Set", "items": [item], **changes}
    reply = course.lecturer.post("/api/v1/task-sets", json=body)
    assert (reply.status_code, reply.json()["error"]["code"]) == (422, code)
    assert field.startswith(reply.json()["error"]["field"])


def test_a_slot_that_cannot_be_published_is_told(course: Course) -> None:
    number = course.built(item={"limits": {"l1": [0.041, 0.042]}})
    reply = course.lecturer.post(f"/api/v1/task-sets/{number}/open?lang=en")
    assert code_of(reply) == (422, "set_troubled") and reply.json()["error"]["field"] == "items.0.limits"
    assert "accept 0 of 1000 draws" in reply.json()["error"]["message"]
    assert course.lecturer.get(f"/api/v1/task-sets/{number}").json()["state"] == "draft"


def test_only_lecturers_of_the_course_build(course: Course) -> None:
    body = {"course": course.school.course, "title": "Set", "items": []}
    statuses = [
        course.school.browser(who).post("/api/v1/task-sets", json=body).status_code
        for who in ("student", "assistant", "stranger", "outsider")
    ]
    assert statuses == [403, 403, 404, 404]


def test_a_student_is_dealt_one_card_and_sees_a_code_for_its_seed(course: Course) -> None:
    number = course.published(item={"limits": {"l1": [0.05, 0.08]}})
    first, again = course.open(number), course.open(number)
    card = course.card(number)
    assert first.status_code == 200 and first.json() == again.json()
    assert (first.json()["code"], first.json()["seed"]) == (card.code, None)
    tries = [dealing.seed(SECRET, course.school.people["student"], card.slot, 1, redraw) for redraw in range(200)]
    assert card.seed in tries
    assert 0.05 <= first.json()["givens"]["l1"] <= 0.08
    assert first.json()["id"] != course.variant(number, course.other)
    resolved = course.lecturer.get(f"/api/v1/variants/{first.json()['id']}").json()
    assert resolved["seed"] == card.seed
    assert code_of(course.open(number, course.lecturer)) == (403, "students_only")


def test_what_is_open_stays_as_it_was_published(course: Course, monkeypatch: pytest.MonkeyPatch) -> None:
    number = course.published()
    before = course.open(number).json()
    right = texts(course, number)
    exercise = catalogue.load(EXERCISE).exercise
    assert isinstance(exercise.steps, dict)
    monkeypatch.setitem(exercise.steps, "l3", f"({exercise.steps['l3']})*2")
    forget()
    after = course.open(number).json()
    graded = course.hand_in(before["id"], right).json()
    monkeypatch.undo()
    forget()
    assert after == before
    assert graded["needs_regrade"] is True and graded["verdicts"]["l3"]["outcome"] == "right"


def test_what_only_a_later_version_asks_for_takes_nothing_from_a_card(
    course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    number = course.published()
    variant, right = course.variant(number), texts(course, number)
    exercise = catalogue.load(EXERCISE).exercise
    assert isinstance(exercise.answers, dict)
    monkeypatch.setitem(exercise.answers, "l3_formula", Expression("l3"))
    forget()
    graded, page = course.hand_in(variant, right).json(), course.student.get(f"/variants/{variant}")
    monkeypatch.undo()
    forget()
    assert page.status_code == 200 and "l3_formula" not in page.text
    assert (graded["score"], set(graded["verdicts"]), graded["needs_regrade"]) == (1.0, set(right), True)


@contextmanager
def without(gone: str) -> Iterator[None]:
    """Let the installed exercise no longer ask for an answer."""
    answers = catalogue.load(EXERCISE).exercise.answers
    assert isinstance(answers, dict)
    before = dict(answers)
    del answers[gone]
    forget()
    try:
        yield
    finally:
        answers.clear()
        answers.update(before)  # in the order they had
        forget()


def test_what_an_exercise_no_longer_asks_for_is_kept_for_the_lecturer_and_the_rest_is_judged(course: Course) -> None:
    number = course.published(item={"attempts": 3})
    variant, right, gone = course.variant(number), texts(course, number), "omega2_formula"
    with without(gone):
        graded = course.hand_in(variant, right).json()
        empty = course.hand_in(variant, {"l3": "1 mm"}).json()
        unreadable = course.hand_in(variant, {**right, "l3": "1 m/"}).json()
        unknown = course.hand_in(variant, {**right, "v4": "1"})
    assert (graded["counted"], graded["provisional"], graded["score"]) == (True, True, pytest.approx(0.8))
    found = {name: one["code"] for name, one in graded["verdicts"].items()}
    assert found == {**dict.fromkeys(right, "right"), gone: "kept"}
    assert (empty["verdicts"][gone]["code"], empty["provisional"]) == ("empty", False)
    assert (unreadable["counted"], list(unreadable["verdicts"])) == (False, ["l3"])
    assert (code_of(unknown), unknown.json()["error"]["field"]) == ((422, "unknown_answer"), "answers.v4")


def test_pages_show_what_an_exercise_no_longer_asks_for_as_it_was_typed(course: Course) -> None:
    number, person, gone = course.published(), course.school.people["student"], "omega2_formula"
    variant, right = course.variant(number), texts(course, number)
    theirs = ("results", "analysis", "regrade", f"students/{person}")
    with without(gone):
        course.hand_in(variant, right)
        pages = [course.student.get(path) for path in (f"/variants/{variant}", f"/sets/{number}")]
        pages += [course.lecturer.get(f"/sets/{number}/{path}") for path in theirs]
        pages.append(course.student.post(f"/variants/{variant}/preview", data={f"answer.{gone}": right[gone]}))
        said = course.student.post(f"/api/v1/variants/{variant}/preview", json={"answer": gone, "text": "l1 - "})
        other = course.student.post(f"/api/v1/variants/{variant}/preview", json={"answer": "v4", "text": "l1"})
    assert [page.status_code for page in pages] == [200] * 7
    assert (said.json()["ok"], said.json()["text"]) == (True, "l1 - ")
    assert code_of(other) == (422, "unknown_answer")


def test_attempts_are_limited_and_counted_by_the_rule(course: Course) -> None:
    number = course.published()
    variant, right = course.variant(number), texts(course, number)
    unreadable = course.hand_in(variant, {"l3": "1 m/", "v3": right["v3"]}).json()
    assert (unreadable["counted"], list(unreadable["verdicts"])) == (False, ["l3"])
    wrong = course.hand_in(variant, {"l3": "1 m"}, "k").json()
    assert (wrong["counted"], wrong["repeated"]) == (True, False)
    again = course.hand_in(variant, {"l3": " 1 m "}).json()
    assert (again["counted"], again["repeated"]) == (False, True)
    assert course.hand_in(variant, right).json()["score"] == 1.0
    refused = course.hand_in(variant, {"l3": "2 m"})
    assert code_of(refused) == (403, "no_attempt_left")
    replayed = course.hand_in(variant, {"l3": "1 m"}, "k")
    assert (replayed.status_code, replayed.json()) == (200, wrong)
    mine = course.student.get(f"/api/v1/task-sets/{number}").json()
    item = mine["items"][0]
    assert (item["left"], item["earned"], mine["earned"], mine["share"]) == (0, 10.0, 10.0, 1.0)
    assert [line["counted"] for line in item["ledger"]] == [False, True, False, True]


def test_follow_through_is_worth_what_the_rules_say(course: Course) -> None:
    number = course.published(rules={"follow_through": 0.5})
    variant = course.variant(number)
    right, values = texts(course, number), course.card(number).reference["values"]
    slip = f"{-values['alpha2']!r} rad"
    found = course.hand_in(variant, {**right, "alpha2": slip}).json()["verdicts"]
    assert found["alpha2"]["outcome"] == "wrong" and found["l3"]["outcome"] == "right"


def test_outside_its_window_a_set_is_closed(course: Course) -> None:
    ahead = moment(hours=1)
    early = course.published(opens=ahead, due=moment(hours=2))
    reply = course.open(early)
    assert code_of(reply) == (403, "set_not_open")
    assert datetime.fromisoformat(reply.json()["error"]["opens"]) == datetime.fromisoformat(ahead)
    number = course.published()
    variant = course.variant(number)
    kept = course.hand_in(variant, {"l3": "1 m"}, "k")
    course.move(number, seconds=1)
    assert code_of(course.hand_in(variant, {"l3": "2 m"})) == (403, "set_closed")
    assert course.hand_in(variant, {"l3": "1 m"}, "k").json() == kept.json()
    assert code_of(course.open(number, course.other)) == (403, "set_closed")
    assert course.open(number).status_code == 200


def test_extra_time_reaches_work_under_way(course: Course) -> None:
    number = course.published()
    variant, person = course.variant(number), course.school.people["student"]
    course.move(number, minutes=5)
    path = f"/api/v1/task-sets/{number}/accommodations"
    given = course.lecturer.put(f"{path}/{person}", json={"minutes": 30, "reason": "dyslexia"})
    assert given.json() == course.lecturer.get(path).json()[0] | {"reopened": True}
    assert course.hand_in(variant, {"l3": "1 m"}).status_code == 201
    lecturer = course.school.people["lecturer"]
    assert code_of(course.lecturer.put(f"{path}/{lecturer}", json={"minutes": 30})) == (404, "unknown_member")


def test_open_deadlines_move_and_closed_ones_stay(course: Course) -> None:
    running, over = course.published(), course.published()
    course.move(over, minutes=1)
    before = course.lecturer.get(f"/api/v1/task-sets/{running}").json()["due"]
    moved = course.lecturer.post(f"/api/v1/courses/{course.school.course}/extend", json={"minutes": 15}).json()
    due = {one["id"]: one["due"] for one in moved}
    assert datetime.fromisoformat(due[running]) - datetime.fromisoformat(before) == timedelta(minutes=15)
    assert over not in due
    assert course.lecturer.post(f"/api/v1/task-sets/{over}/extend", json={"minutes": 15}).json() == []


def test_an_examination_holds_its_results_and_takes_the_last_draft(course: Course) -> None:
    number = course.published(rules={"mode": "exam"})
    variant, right = course.variant(number), texts(course, number)
    held = course.hand_in(variant, {"l3": "1 m"}).json()
    assert (held["held"], held["score"], held["verdicts"], held["hints"], held["counted"]) == (True, None, {}, [], True)
    mine = course.student.get(f"/api/v1/task-sets/{number}").json()
    assert (mine["held"], mine["earned"], mine["items"][0]["ledger"][0]["score"]) == (True, None, None)
    assert course.lecturer.get(f"/api/v1/submissions/{held['receipt']['id']}").json()["score"] is not None
    hostile = {**right, "alpha2": "(" * 500}
    path = f"/api/v1/variants/{variant}/draft"
    assert course.student.put(path, json={"answers": hostile, "revision": 1}).status_code == 200
    assert course.school.portal.call(handing.collect, course.school.bench, datetime.now(UTC)) == 0
    course.move(number, seconds=0)
    assert course.school.portal.call(handing.collect, course.school.bench, datetime.now(UTC)) == 1
    assert course.school.portal.call(handing.collect, course.school.bench, datetime.now(UTC)) == 0
    mine = course.student.get(f"/api/v1/task-sets/{number}").json()
    assert mine["held"] is False and mine["share"] >= 0.7 and len(mine["items"][0]["ledger"]) == 2


def test_a_reserved_exercise_is_practised_without_seed_and_solution(course: Course) -> None:
    course.published()
    practice = course.student.post(f"/api/v1/exercises/{EXERCISE}/variants", json={})
    assert practice.status_code == 201
    seeded = course.student.post(f"/api/v1/exercises/{EXERCISE}/variants", json={"seed": 7})
    assert code_of(seeded) == (403, "reserved")
    course.student.post(f"/api/v1/variants/{practice.json()['id']}/submissions", json={"answers": {"l3": "1"}})
    assert code_of(course.student.get(f"/api/v1/variants/{practice.json()['id']}/solution")) == (403, "reserved")
    free = course.student.post("/api/v1/exercises/planetary/variants", json={"seed": 7})
    assert free.status_code == 201


def test_the_solution_opens_by_the_rules(course: Course) -> None:
    number = course.published(rules={"solutions": "after_last_attempt"}, item={"attempts": 1})
    variant = course.variant(number)
    path = f"/api/v1/variants/{variant}/solution"
    assert code_of(course.student.get(path)) == (403, "set_solution_closed")
    course.hand_in(variant, {"l3": "1 m"})
    assert course.student.get(path).json()["lines"]


def test_our_fault_gives_the_attempt_back_and_another_card(course: Course, monkeypatch: pytest.MonkeyPatch) -> None:
    number = course.published(item={"attempts": 1})
    variant, right = course.variant(number), texts(course, number)
    assert code_of(course.open(number, another=True)) == (403, "card_is_sound")

    def fail(submission: Submission, secret: bytes, **rules: object) -> None:
        raise ZeroDivisionError("a bug")

    with monkeypatch.context() as patch:
        patch.setattr(grading, "grade", fail)
        spoilt = course.hand_in(variant, right).json()
    assert {one["outcome"] for one in spoilt["verdicts"].values()} == {"fault"} and spoilt["counted"] is False
    problems = course.lecturer.get("/api/v1/problems").json()["problems"]
    (mine,) = [problem for problem in problems if spoilt["receipt"]["id"] in problem["text"]]
    assert (mine["seed"], mine["code"]) == (None, course.open(number).json()["code"])
    page = course.lecturer.get("/problems", headers={"accept-language": "en"}).text
    assert f"Code {mine['code']}" in page
    fresh = course.open(number, another=True).json()
    assert fresh["id"] != variant and course.open(number).json() == fresh
    assert course.hand_in(fresh["id"], texts(course, number)).json()["score"] == 1.0


def test_more_students_than_cards_are_dealt_further_ones(course: Course, monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as patch:
        patch.setattr(dealing, "LEAST_CARDS", 2)
        patch.setattr(dealing, "SPARE", 1.0)
        number = course.published()
    client = course.school.browser("outsider")
    joined = client.post("/api/v1/join", json={"code": "KX49-2MQT"})
    assert joined.status_code < 300, joined.text
    assert course.open(number, client).status_code == 200
    assert (
        course.hand_in(course.variant(number, client), texts(course, number, "outsider"), who=client).json()["score"]
        == 1
    )


def test_a_second_chance_is_weighed_with_the_first(course: Course) -> None:
    first = course.published()
    course.hand_in(course.variant(first), {**texts(course, first), "l3": "9 m"})
    one = course.student.get(f"/api/v1/task-sets/{first}").json()["share"]
    second = course.published(rules={"second_chance_of": first})
    assert course.student.get(f"/api/v1/task-sets/{second}").json()["share"] == one
    course.hand_in(course.variant(second), texts(course, second))
    assert course.student.get(f"/api/v1/task-sets/{second}").json()["share"] == pytest.approx(0.9 + 0.1 * one)


def test_a_second_chance_comes_along_with_a_copied_course(course: Course) -> None:
    first = course.published(title="First of two")
    course.built(title="Second of two", rules={"second_chance_of": first})
    new = course.lecturer.post(f"/api/v1/courses/{course.school.course}/copy", json={"title": "Two", "days": 7}).json()
    listed = course.lecturer.get(f"/api/v1/courses/{new['id']}/task-sets").json()
    copies = {one["title"]: one["id"] for one in listed if "of two" in one["title"]}
    second = course.lecturer.get(f"/api/v1/task-sets/{copies['Second of two']}").json()
    assert second["rules"]["second_chance_of"] == copies["First of two"] != first


def test_sheets_and_key_of_a_deck_carry_codes(course: Course) -> None:
    number = course.published()
    path = f"/api/v1/task-sets/{number}/items/1/sheets.md?lang=en"
    card, sheets, key = course.open(number).json(), course.lecturer.get(path), course.lecturer.get(f"{path}&key=true")
    seed = str(course.card(number).seed)
    assert card["code"] in sheets.text.replace("\\", "") and seed not in sheets.text + key.text
    position = float(course.card(number).reference["texts"]["l3"].removesuffix(" mm"))
    assert f" {position:.5g}\u202fmm" in key.text.replace("\\", "")
    assert course.student.get(path).status_code == 403
    assert code_of(course.lecturer.get(f"/api/v1/task-sets/{course.built()}/items/1/sheets.md")) == (
        409,
        "set_is_draft",
    )


def test_a_course_is_copied_with_its_dates_shifted(course: Course) -> None:
    number = course.built(due="2026-12-07T23:59")
    copied = course.lecturer.post(f"/api/v1/task-sets/{number}/copy", json={"days": 365 - 133}).json()
    assert (copied["state"], copied["due"]) == ("draft", "2027-07-27T21:59:00Z")  # summer time: the hour on the wall
    path = f"/api/v1/courses/{course.school.course}/copy"
    new = course.lecturer.post(path, json={"title": "Next year", "days": 364}).json()
    sets = course.lecturer.get(f"/api/v1/courses/{new['id']}/task-sets").json()
    assert len(sets) == len(course.lecturer.get(f"/api/v1/courses/{course.school.course}/task-sets").json())
    assert {one["state"] for one in sets} == {"draft"}
    assert course.lecturer.get(f"/api/v1/courses/{new['id']}/members").json()[0]["role"] == "lecturer"
