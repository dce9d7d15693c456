"""Publishing is a job: the set is frozen while it is dealt, usable when it is done, and a draft again if it fails."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import pytest

from exercises import catalogue
from server.judging.thread import JudgingThread
from server.sets import printing
from tests.server.sets.conftest import Course, in_this_process
from tests.server.sets.test_api import code_of


@pytest.fixture
def hold(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[bool]]:
    """While it holds True, nothing is computed apart."""
    held = [True]

    async def apart(judging: JudgingThread, compute: Callable[..., Any], tasks: Sequence[Any]) -> list[Any]:
        while held[0]:
            await asyncio.sleep(0.01)
        return await in_this_process(judging, compute, tasks)

    monkeypatch.setattr(JudgingThread, "apart", apart)
    yield held
    held[0] = False


def ended(course: Course, job: str) -> Any:
    while (found := course.lecturer.get(job).json())["state"] in ("waiting", "running"):
        pass
    return found


def begun(course: Course, number: str) -> str:
    """Start publishing without waiting; gives the address of the job."""
    reply = course.lecturer.post(f"/api/v1/task-sets/{number}/open?wait=0")
    assert (reply.status_code, reply.json()["state"]) == (202, "publishing"), reply.text
    return str(reply.headers["location"])


def test_a_set_is_frozen_while_it_is_dealt_and_usable_when_it_is_done(course: Course, hold: list[bool]) -> None:
    number = course.built()
    path = f"/api/v1/task-sets/{number}"
    job = begun(course, number)
    assert code_of(course.lecturer.patch(path, json={"revision": 1, "title": "x"})) == (409, "set_frozen")
    assert code_of(course.lecturer.post(f"{path}/open")) == (409, "job_under_way")
    assert course.open(number).status_code == 404 and course.student.get(path).status_code == 404
    page = course.lecturer.get(f"/sets/{number}?lang=en").text
    assert "Variants drawn and checked: 0 of 4" in page and 'name="then"' not in page
    hold[0] = False
    assert ended(course, job)["result"] == {"cards": 4}
    assert course.lecturer.get(path).json()["state"] == "published"
    assert course.open(number).status_code == 200


def test_a_set_whose_publishing_is_cancelled_is_a_draft_again(course: Course, hold: list[bool]) -> None:
    number = course.built()
    job = begun(course, number)
    assert course.lecturer.post(f"{job}/cancel").json()["state"] == "cancelled"
    hold[0] = False
    assert course.lecturer.get(f"/api/v1/task-sets/{number}").json()["state"] == "draft"
    reply = course.lecturer.post(f"/api/v1/task-sets/{number}/open")
    assert (reply.status_code, reply.json()["state"]) == (200, "published")


def test_what_stands_against_publishing_is_told_by_the_job_and_no_card_stays(course: Course, hold: list[bool]) -> None:
    number = course.built(item={"limits": {"l1": [0.041, 0.042]}})
    job = begun(course, number)
    hold[0] = False
    found = ended(course, job)
    assert (found["state"], found["result"]["troubles"][0]["code"]) == ("failed", "limits")
    page = course.lecturer.get(f"/jobs/{found['id']}?lang=en").text
    assert "Task 1" in page and f'href="/sets/{number}"' in page
    assert "<progress" not in page and "drawn and checked" not in page
    assert course.lecturer.get(f"/api/v1/task-sets/{number}").json()["state"] == "draft"
    assert course.school.portal.call(course.school.bench.sets.deck, number) == []


def test_a_task_that_cannot_be_published_is_told_while_the_others_go_on(
    course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    free = asyncio.Event()

    async def apart(judging: JudgingThread, compute: Callable[..., Any], tasks: Sequence[Any]) -> list[Any]:
        if tasks[0][1].number == 2:
            await free.wait()
        return await in_this_process(judging, compute, tasks)

    monkeypatch.setattr(JudgingThread, "apart", apart)
    one: dict[str, Any] = {"exercise": "slider_crank", "points": 10}
    number = course.built(items=[one | {"limits": {"l1": [0.041, 0.042]}}, one])
    job = begun(course, number)
    while not (items := course.lecturer.get(job).json()["items"])[0]["refused"]:
        pass
    assert [(one["done"], one["total"], one["refused"]) for one in items] == [(0, 4, True), (0, 4, False)]
    page = course.lecturer.get(f"/jobs/{job.rsplit('/', 1)[1]}?lang=en").text
    assert "Task 1: cannot be published; the others are still being checked." in page
    assert "drawn and checked: 0 of 8" in page and "Task 2: 0 of 4</li>" in page
    course.school.portal.call(free.set)
    assert ended(course, job)["state"] == "failed"


def test_a_class_is_printed_from_the_deck_however_the_exercise_has_changed(
    course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    number = course.published()
    monkeypatch.setattr(printing, "AT_ONCE", 2)
    monkeypatch.setattr(catalogue, "load", None)  # an upgrade has taken the exercise away
    for body, sizes in (({"most": 3}, [2, 1, 2, 1]), ({}, [2, 1, 2, 1])):
        reply = course.lecturer.post(f"/api/v1/task-sets/{number}/sheets", json=body)
        assert reply.status_code == 202, reply.text
        found = ended(course, reply.headers["location"])
        told = [(one["slot"], one["key"], one["sheets"]) for one in found["result"]["documents"]]
        assert told == list(zip([1] * 4, [False, False, True, True], sizes, strict=True))
    for batch in (1, 4):
        document = course.lecturer.get(f"{reply.headers['location']}/documents/{batch}")
        assert document.content.startswith(b"%PDF-")
    assert f"/jobs/{found['id']}/documents/4" in course.lecturer.get(f"/jobs/{found['id']}").text
    assert course.student.post(f"/api/v1/task-sets/{number}/sheets", json={}).status_code == 403
    draft = course.lecturer.post(f"/api/v1/task-sets/{course_draft(course)}/sheets", json={})
    assert code_of(draft) == (409, "set_is_draft")


def course_draft(course: Course) -> str:
    """A draft without tasks: nothing of the catalogue is needed."""
    body = {"course": course.school.course, "title": "Draft"}
    return str(course.lecturer.post("/api/v1/task-sets", json=body).json()["id"])
