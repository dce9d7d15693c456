"""A job is watched by those who teach the course, and ended by its lecturers; others cannot tell it from none."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest

from server.jobs import api, working
from server.jobs import streams as streams_of
from server.jobs.kinds import KINDS
from server.judging.thread import JudgingThread
from tests.conftest import Laid
from tests.server.conftest import SECRET
from tests.server.jobs.counting import COUNTING, TELLING, Here, order
from tests.server.school import School, opened

KIND = "sheets"
AGAIN = '<noscript><meta http-equiv="refresh" content="2"></noscript>'


@pytest.fixture(scope="module")
def school(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[School]:
    """A school whose server computes on its own thread."""
    settings = laid_for_all(tmp_path_factory.mktemp("jobs"), secret=SECRET, limited=False, workers=1)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(JudgingThread, "apart", Here.apart)
        patch.setitem(KINDS, KIND, replace(COUNTING, name=KIND))
        patch.setitem(KINDS, "publish", replace(TELLING, name="publish"))
        with opened(settings) as found:
            yield found


def started(school: School, *pieces: Any, kind: str = KIND, parts: int = 1) -> str:
    """Start a job of the course; gives its number."""
    made = order(pieces, kind=kind, parts=parts)
    made = replace(made, subject=made.id, course=school.course)
    school.portal.call(school.bench.jobs.start, made)
    school.portal.call(_wake, school)
    return made.id


async def _wake(school: School) -> None:
    school.bench.engine.wake()


def test_a_job_is_watched_to_its_end(school: School) -> None:
    lecturer = school.browser("lecturer")
    number = started(school, 1, [2, 0.2], 3)
    text = ""
    while '"state": "done"' not in text:
        reply = lecturer.get(f"/api/v1/jobs/{number}/events")
        assert reply.headers["content-type"].startswith("text/event-stream")
        text = reply.text
    told = [json.loads(line) for line in re.findall(r"^data: (.*)$", text, re.MULTILINE)]
    assert told[-1] == {"state": "done", "done": 3, "total": 3, "items": []}
    assert [one["done"] for one in told] == sorted(one["done"] for one in told)
    shown = lecturer.get(f"/api/v1/jobs/{number}").json()
    assert (shown["state"], shown["result"], shown["subject"]) == ("done", {"sum": 14}, number)
    document = lecturer.get(f"/api/v1/jobs/{number}/documents/2")
    assert (document.content, document.headers["content-type"]) == (b"document", "application/pdf")
    assert lecturer.get(f"/api/v1/jobs/{number}/documents/4").status_code == 404


def test_publishing_tells_how_far_each_task_is(school: School, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(working, "LOOK", 0.01)
    monkeypatch.setattr(api, "LOOK", 0.02)
    lecturer, number = school.browser("lecturer"), started(school, 20, 15, kind="publish", parts=20)
    text = lecturer.get(f"/api/v1/jobs/{number}/events").text
    told = [json.loads(line)["items"] for line in re.findall(r"^data: (.*)$", text, re.MULTILINE)]
    first = [items[0]["done"] for items in told]
    assert first == sorted(first) and len(set(first) - {0, 20}) > 1
    assert told[-1] == [{"number": n, "done": 20, "total": 20, "refused": False} for n in (20, 15)]
    assert lecturer.get(f"/api/v1/jobs/{number}").json()["items"] == told[-1]
    for language, words in (("en", "Task 20: 20 of 20"), ("pl", "Zadanie 20: 20 z 20"), ("ru", "Задача 20: 20 из 20")):
        page = lecturer.get(f"/jobs/{number}?lang={language}").text
        assert words in page and 'max="40" value="40"' in page


def test_a_silent_job_gives_a_sign_of_life(school: School, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(api, "LONGEST_WATCH", 0.3)
    monkeypatch.setattr(api, "HEARTBEAT", 0.0)
    monkeypatch.setattr(api, "LOOK", 0.05)
    number = started(school, [1, 0.6])
    text = school.browser("assistant").get(f"/api/v1/jobs/{number}/events").text
    assert ": still here\n\n" in text and text.startswith("retry:")


def test_one_person_has_so_many_streams_open_and_a_server_so_many(school: School) -> None:
    lecturer, streams, me = school.browser("lecturer"), school.bench.streams, school.people["lecturer"]
    number = started(school, 1)
    events = f"/api/v1/jobs/{number}/events"
    taken = [streams.enter(me) for _ in range(streams_of.MOST_OF_ONE + 1)]
    refused = lecturer.get(events)
    assert (taken.count(True), refused.status_code) == (streams_of.MOST_OF_ONE, 429)
    assert refused.headers["retry-after"] == str(streams_of.AGAIN)
    streams.leave(me)
    assert lecturer.get(events).status_code == 200
    assert streams.open[me] == streams_of.MOST_OF_ONE - 1  # the stream that ended has given its place back
    others = [streams.enter(f"person {n}") for n in range(streams_of.MOST)]
    assert others.count(True) == streams_of.MOST - streams.open[me]
    assert lecturer.get(events).status_code == 429
    streams.open.clear()


def test_without_a_script_the_page_looks_again_until_the_job_has_ended(school: School) -> None:
    lecturer = school.browser("lecturer")
    number = started(school, [1, 0.3], [2, 0.3])
    reply = lecturer.get(f"/jobs/{number}?lang=en")
    assert AGAIN in reply.text and "Documents printed: " in reply.text and f"/jobs/{number}/cancel" in reply.text
    assert f'data-job="/api/v1/jobs/{number}/events"' in reply.text and "refresh" not in reply.headers
    assert lecturer.post(f"/jobs/{number}/cancel").headers["location"] == f"/jobs/{number}"
    reply = lecturer.get(f"/jobs/{number}?lang=en")
    assert "refresh" not in reply.text and "/events" not in reply.text
    assert "cancelled" in reply.text and "/cancel" not in reply.text
    again = lecturer.post(f"/api/v1/jobs/{number}/cancel")
    assert (again.status_code, again.json()["state"]) == (200, "cancelled")


def test_a_fault_is_told_with_its_number_and_nothing_else(school: School) -> None:
    lecturer = school.browser("lecturer")
    number = started(school, "x")
    while lecturer.get(f"/api/v1/jobs/{number}").json()["state"] != "failed":
        school.portal.call(_wake, school)
    text = lecturer.get(f"/jobs/{number}?lang=en").text
    assert number in text and "literal" not in text


@pytest.mark.parametrize(("who", "status"), [("assistant", 200), ("student", 403), ("stranger", 404)])
def test_a_job_is_shown_to_those_who_teach_the_course(school: School, who: str, status: int) -> None:
    number, reader = started(school, 1), school.browser(who)
    for path in (f"/api/v1/jobs/{number}", f"/jobs/{number}", f"/api/v1/jobs/{number}/events"):
        assert reader.get(path).status_code == status, path
    assert reader.post(f"/api/v1/jobs/{number}/cancel").status_code in (403, 404)
    assert reader.get(f"/api/v1/jobs/{number}/documents/1").status_code in (403, 404)
    assert reader.get("/api/v1/jobs/AAAA-AAAA-AAAA").status_code == 404
