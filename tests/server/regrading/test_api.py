"""A lecturer looks at what a regrade would change, then regrades; by programs and on pages."""

from __future__ import annotations

from typing import Any

import pytest
from sqlalchemy import select, update

from server.database.engine import engine
from server.tables import deck, grades, jobs
from tests.server.sets.conftest import Course
from tests.server.sets.test_api import without


@pytest.fixture(scope="module")
def handed_in(course: Course) -> str:
    """A set to which a student has handed in what is right, graded by judges who did not see it."""
    number = course.published()
    variant = course.variant(number)
    reply = course.hand_in(variant, dict(course.card(number).reference["texts"]))
    assert reply.json()["score"] == 1.0
    judged_otherwise(course, reply.json()["receipt"]["id"])
    return number


def judged_otherwise(course: Course, receipt: str) -> None:
    """Replace the stored grade of a submission by one of judges who took a right answer for wrong."""
    wrong = {"code": "wrong", "score": 0.0, "details": None, "remarks": None}
    store = engine(course.school.bench.settings.store_url, connections=1)
    with store.begin() as connection:
        grade = connection.execute(grades.select().where(grades.c.submission == receipt)).one().grade
        older = grade | {"score": 0.5, "verdicts": grade["verdicts"] | {"l3": grade["verdicts"]["l3"] | wrong}}
        connection.execute(update(grades).where(grades.c.submission == receipt).values(grade=older))
    store.dispose()


def ended(course: Course, job: str) -> Any:
    """Wait until a job has ended."""
    while True:
        found = course.lecturer.get(f"/api/v1/jobs/{job}").json()
        if found["state"] not in ("waiting", "running"):
            return found


def test_a_dry_run_tells_what_a_regrade_then_does(course: Course, handed_in: str) -> None:
    path = f"/api/v1/task-sets/{handed_in}/regrade"
    told = []
    for dry_run in (True, False, False):
        reply = course.lecturer.post(path, json={"dry_run": dry_run, "reason": "l3 was\x00 misread"})
        assert (reply.status_code, reply.json()["kind"]) == (202, "regrade"), reply.text
        job = ended(course, reply.json()["id"])
        assert reply.headers["location"] == f"/api/v1/jobs/{job['id']}"
        found = course.lecturer.get(f"/api/v1/jobs/{job['id']}/changes").json()
        told.append((job["result"]["raised"], [one["answers"][0]["name"] for one in found["changes"]], found["next"]))
    assert told == [(1, ["l3"], None), (1, ["l3"], None), (0, [], None)]
    mine = course.student.get(f"/api/v1/task-sets/{handed_in}").json()
    assert mine["items"][0]["earned"] == 10


def test_a_wrong_reference_is_shown_beside_the_new_one_before_it_is_replaced(course: Course) -> None:
    number = course.published()
    course.variant(number)
    card = course.card(number)
    right, path = card.reference["values"]["l3"], f"/sets/{number}/regrade"
    wrong = {**card.reference, "values": card.reference["values"] | {"l3": 2 * right}}
    store = engine(course.school.bench.settings.store_url, connections=1)
    with store.begin() as connection:
        connection.execute(update(deck).where(deck.c.id == card.id).values(reference=wrong))
    store.dispose()
    reply = course.lecturer.post(path, data={"recompute_references": "yes", "then": "look"})
    job = reply.headers["location"].rsplit("/", 1)[1]
    assert ended(course, job)["result"]["recomputed"] == 1 and course.card(number).reference == wrong
    (told,) = course.lecturer.get(f"/api/v1/jobs/{job}/changes").json()["references"]
    assert told == {
        "code": card.code, "slot": 1, "steps": [{"name": "l3", "old": 2 * right, "new": right}], "texts": [],
    }  # fmt: skip
    page = course.lecturer.get(f"{path}?lang=en").text
    assert (
        f'scope="row" class="code half">{card.code}</th><td class="half" data-label="Task">1</td>'
        "<td>Position of the slider from the projection"
        in page
        and str(2 * right) in page
    )
    assert '<input type="hidden" name="recompute_references" value="yes">' in page and "Nothing changes" not in page
    assert 'value="regrade">Compute references anew: 1<' in page
    wish = {"recompute_references": True}
    ended(course, course.lecturer.post(f"/api/v1/task-sets/{number}/regrade", json=wish).json()["id"])
    assert course.card(number).reference == card.reference


def test_what_an_exercise_no_longer_asks_for_takes_no_points_from_what_was_handed_in(course: Course) -> None:
    number, gone = course.published(), "omega2_formula"
    course.hand_in(course.variant(number), dict(course.card(number).reference["texts"]))
    with without(gone):
        job = ended(course, course.lecturer.post(f"/api/v1/task-sets/{number}/regrade", json={}).json()["id"])
    (change,) = course.lecturer.get(f"/api/v1/jobs/{job['id']}/changes").json()["changes"]
    assert (change["effect"], change["old"], change["new"]) == ("withheld", 1.0, 0.8)
    assert [(one["name"], one["new"]["code"]) for one in change["answers"]] == [(gone, "kept")]


def test_who_may_not_teach_may_not_regrade(course: Course, handed_in: str) -> None:
    path = f"/api/v1/task-sets/{handed_in}/regrade"
    assistant = course.school.browser("assistant")
    assert [who.post(path, json={}).status_code for who in (course.student, assistant)] == [403, 403]
    assert course.student.get(f"/sets/{handed_in}/regrade").status_code == 403
    assert assistant.get(f"/sets/{handed_in}/regrade").status_code == 200
    assert course.lecturer.post(path, json={"score": 1}).status_code == 422


def test_a_draft_has_nothing_to_regrade(course: Course) -> None:
    reply = course.lecturer.post(f"/api/v1/task-sets/{course.built()}/regrade", json={})
    assert (reply.status_code, reply.json()["error"]["code"]) == (409, "set_not_published")


def test_the_page_shows_every_change_and_both_grades(course: Course, handed_in: str) -> None:
    path = f"/sets/{handed_in}/regrade"
    store = engine(course.school.bench.settings.store_url, connections=1)
    with store.begin() as connection:  # the grade of the regrade is lost: it is found again
        connection.execute(grades.delete().where(grades.c.job.is_not(None)))
    store.dispose()
    reply = course.lecturer.post(path, data={"reason": "why", "then": "look"})
    assert reply.status_code == 303
    ended(course, reply.headers["location"].rsplit("/", 1)[1])
    page = course.lecturer.get(f"{reply.headers['location']}?lang=en").text
    assert f'href="{path}"' in page
    page = course.lecturer.get(f"{path}?lang=en").text
    assert "What would change" in page and "Student" in page and "<td>Position of the slider l3</td>" in page
    assert 'name="then" value="regrade">Change results: 1<' in page
    assert 'data-label="Before">wrong, 0</td><td class="half" data-label="Now">right, 1</td>' in page
    crumb = page.split('<p class="crumb">')[1].split("</p>")[0]
    assert crumb.index('href="/courses/') < crumb.index(f'href="/sets/{handed_in}"')
    assert f'href="{path}"' in course.lecturer.get(f"/sets/{handed_in}").text


def test_a_regrade_that_was_ordered_before_an_update_is_shown(course: Course, handed_in: str) -> None:
    path = f"/sets/{handed_in}/regrade"
    reply = course.lecturer.post(path, data={"then": "look"})
    ended(course, number := reply.headers["location"].rsplit("/", 1)[1])
    store = engine(course.school.bench.settings.store_url, connections=1)
    with store.connect() as connection:
        row = connection.execute(select(jobs.c.payload, jobs.c.result).where(jobs.c.id == number)).one()
    older = {
        "payload": {key: value for key, value in row.payload.items() if key != "recompute_references"},
        "result": {key: value for key, value in row.result.items() if key != "recomputed"},
    }
    assert older != row._asdict()
    with store.begin() as connection:  # it has read nothing, so it waits for the server's writer
        connection.execute(update(jobs).where(jobs.c.id == number).values(older))
    store.dispose()
    assert "What would change" in course.lecturer.get(f"{path}?lang=en").text
