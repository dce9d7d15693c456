"""All that is kept of a person is handed out, but what an examination holds back; erasing leaves marks and no name."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest
from sqlalchemy import select, update
from starlette.testclient import TestClient

from exercises import grading
from server.database.engine import engine
from server.migrate import migrate
from server.sets import handing
from server.settings import Settings
from server.tables import grades, metadata
from tests.server.conftest import SECRET
from tests.server.school import PASSWORD
from tests.server.sets.conftest import Course, made

PRACTISED = "simple_beam"  # not the exercise of the sets, which they reserve
SAID = "Ewa Kowalska was here"  # what a student may type anywhere
NUMBERED = {  # where the number of somebody erased stays, and why (decision 0021)
    "owners.id": "the number itself, which the rows of a person refer to",
    "persons.id": "says that the number is nobody's any more, and since when",
    "persons.name": "the number stands where the name was",
    "variants.owner": "whose work it was: the marks of a set and its statistics stay",
    "submissions.owner": "as above",
    "deck.person": "as above, and no card is dealt twice",
    "accommodations.person": "how long the work was in time",
    "batches.result": "which grades a regrade has changed",
    "jobs.payload": "for whom a deck was dealt",
    "audit.object": "what was done to the person; the chain of lines holds",
    "audit.actor": "what the person did; the chain of lines holds",
}


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Course]:
    settings = Settings(tmp_path_factory.mktemp("personal"), secret=SECRET, limited=False)
    migrate(settings.store_url)
    yield from made(settings)


def newcomer(course: Course, login: str) -> TestClient:
    """A student who has worked in every way: practice, drafts, reports, tokens, extra time, and in a set."""
    lecturer, place = course.lecturer, f"/api/v1/courses/{course.school.course}"
    lecturer.post(f"{place}/roster", json={"csv": f"{login};Ewa Kowalska;A", "apply": True})
    (link,) = lecturer.post(f"{place}/links").json()
    browser = course.school.browser()
    path = link["link"].removeprefix(course.school.bench.settings.address)
    assert browser.post(path, data={"password": PASSWORD}).status_code == 303
    browser.post("/api/v1/tokens", json={"name": f"{SAID} token"})
    dealt = browser.post(f"/api/v1/exercises/{PRACTISED}/variants", json={"seed": 7}).json()
    variant, (first, second, *_) = dealt["id"], dealt["answers"]
    assert course.hand_in(variant, {first: "1", second: SAID}, who=browser).status_code == 201
    browser.put(f"/api/v1/variants/{variant}/draft", json={"answers": {first: SAID}, "revision": 0})
    browser.post(f"/api/v1/variants/{variant}/problems", json={"text": SAID})
    return browser


def worked(course: Course, browser: TestClient, **changes: Any) -> tuple[str, str]:
    """Work in a set: one answer right, one that cannot be read; gives the set and the receipt."""
    number = course.published(item={"attempts": None}, **changes)
    person = browser.get("/api/v1/me").json()["id"]
    more = {"minutes": 30, "reason": SAID}
    path = f"/api/v1/task-sets/{number}/accommodations/{person}"
    assert course.lecturer.put(path, json=more).status_code == 200
    variant = course.variant(number, browser)
    (card,) = [
        card for card in course.school.portal.call(course.school.bench.sets.cards, number, person) if card.variant
    ]
    answers = {"l3": grading.reference(handing.variant_of(card))["l3"], "v3": f"{SAID}!"}
    receipt = course.hand_in(variant, answers, "a key", browser).json()["receipt"]["id"]
    browser.put(f"/api/v1/variants/{variant}/draft", json={"answers": {"l3": SAID}, "revision": 0})
    browser.post(f"/api/v1/variants/{variant}/problems", json={"text": SAID})
    return number, receipt


def data(browser: TestClient) -> dict[str, Any]:
    found: dict[str, Any] = browser.get("/api/v1/me/data").json()
    return found


def found(course: Course, *words: str) -> dict[str, str]:
    """Where any of some words stands in the store: a value by table and column. Documents are looked into as bytes."""
    held: dict[str, str] = {}
    store = engine(course.school.bench.settings.store_url, connections=1)
    with store.connect() as connection:
        for table in metadata.sorted_tables:
            for row in connection.execute(select(table)).mappings():
                for name, value in row.items():
                    text = value.decode("latin-1") if isinstance(value, bytes) else repr(value)
                    held |= {f"{table.name}.{name}": text for word in words if word.casefold() in text.casefold()}
    store.dispose()
    return held


def test_a_person_gets_all_that_is_kept_and_no_secret(course: Course) -> None:
    browser = newcomer(course, "7001")
    _, receipt = worked(course, browser)
    told = data(browser)
    assert told["person"]["login"] == "7001" and told["person"]["name"] == "Ewa Kowalska"
    assert [(one["title"], one["role"], one["group"]) for one in told["courses"]] == [("TMM", "student", "A")]
    assert [len(told[name]) for name in ("sessions", "tokens", "variants", "drafts", "problems", "extra_time")] == [
        1, 1, 2, 2, 2, 1,
    ]  # fmt: skip
    by_receipt = {one["receipt"]: one for one in told["submissions"]}
    assert by_receipt[receipt]["verdicts"]["l3"] == "right" and by_receipt[receipt]["answers"]["v3"] == f"{SAID}!"
    assert [(one["exercise"], one["seed"] is None, one["code"] is None) for one in told["variants"]] == [
        (PRACTISED, False, True), ("slider_crank", True, False),
    ]  # fmt: skip
    assert {act["action"] for act in told["acts"]} >= {"link_made", "link_used", "token_made", "time_given"}
    whole = json.dumps(told)
    person = course.school.portal.call(course.school.bench.people.by_login, "7001")
    cookie = next(iter(browser.cookies.jar)).value
    assert (
        person is not None
        and str(person.password) not in whole
        and str(cookie) not in whole
        and "reference" not in whole
    )


def test_an_examination_holds_its_results_back_here_too(course: Course) -> None:
    browser = newcomer(course, "7002")
    number, receipt = worked(course, browser, rules={"mode": "exam"})
    (mine,) = [one for one in data(browser)["submissions"] if one["receipt"] == receipt]
    assert mine["held"] and "score" not in mine and "verdicts" not in mine and mine["answers"]
    course.move(number, hours=2)
    (mine,) = [one for one in data(browser)["submissions"] if one["receipt"] == receipt]
    assert not mine["held"] and mine["verdicts"]["l3"] == "right"


def test_a_program_and_another_person_get_nothing(course: Course) -> None:
    token = course.student.post("/api/v1/tokens", json={"name": "ci"}).json()["token"]
    program = course.school.browser()
    bearer = {"authorization": f"Bearer {token}"}
    assert program.get("/api/v1/me/data", headers=bearer).json()["error"]["code"] == "person_needed"
    path = f"/api/v1/people/{course.school.people['student']}/data"
    assert course.other.get(path).status_code == 403 and course.lecturer.get(path).status_code == 403


def test_erasing_leaves_the_marks_and_no_word_of_the_person(course: Course) -> None:
    browser = newcomer(course, "7003071539026")
    number, receipt = worked(course, browser)
    me = browser.get("/api/v1/me").json()["id"]
    before = course.school.portal.call(course.school.bench.sets.ledger, number)
    administrator = course.school.browser("administrator")
    assert administrator.delete(f"/api/v1/people/{me}").status_code == 204
    assert browser.get("/api/v1/me").status_code == 401
    after = course.school.portal.call(course.school.bench.sets.ledger, number)
    assert [(one.receipt, one.grade["score"], one.counted) for one in after] == [
        (one.receipt, one.grade["score"], one.counted) for one in before
    ]
    kept = administrator.get(f"/api/v1/people/{me}/data").json()
    assert kept["person"]["name"] == me and kept["person"]["login"] is None and not kept["person"]["active"]
    (mine,) = kept["submissions"]
    assert mine["receipt"] == receipt and mine["answers"]["v3"] == "" and mine["answers"]["l3"]
    assert [kept[name] for name in ("sessions", "tokens", "drafts", "problems")] == [[], [], [], []]
    assert [len(kept["variants"]), kept["extra_time"][0]["reason"]] == [1, ""]
    assert kept["acts"][-1]["action"] == "person_erased"
    place = f"/api/v1/courses/{course.school.course}"
    assert course.lecturer.post(f"{place}/members/{me}/link").json()["error"]["code"] == "unknown_member"
    assert course.lecturer.post(f"{place}/links").json() == []
    assert course.lecturer.get(f"/api/v1/submissions/{receipt}").json()["verdicts"]["v3"]["code"] == "empty"
    assert found(course, "7003071539026") == {}


def test_no_table_holds_a_word_of_somebody_erased(course: Course) -> None:
    browser = newcomer(course, "7004071539026")
    number, receipt = worked(course, browser)
    me, lecturer, path = browser.get("/api/v1/me").json()["id"], course.lecturer, f"/api/v1/task-sets/{number}"
    note = {"receipt": receipt, "answer": "v3", "share": 1.0, "comment": f"{SAID} too"}
    assert lecturer.post(f"{path}/marks", json=note).status_code == 201
    older(course, receipt)
    job = lecturer.post(f"{path}/regrade", json={"reason": "l3 was misread"}).json()["id"]
    while not (changed := lecturer.get(f"/api/v1/jobs/{job}/changes").json()["changes"]):
        assert lecturer.get(f"/api/v1/jobs/{job}").json()["state"] in ("waiting", "running", "done")
    assert [one["person"] for one in changed] == [me]
    for login in ("7001", "7002", "7004071539026"):
        person = course.school.portal.call(course.school.bench.people.by_login, login)
        if person is not None:
            course.school.browser("administrator").delete(f"/api/v1/people/{person.id}")
    assert found(course, SAID, "Kowalska", "7004071539026", "a key") == {}
    assert set(found(course, me)) == NUMBERED.keys()
    assert course.school.portal.call(course.school.bench.audit.check).broken is None
    (row,) = [one for one in lecturer.get(f"{path}/gradebook").json()["students"] if one["student"]["id"] == me]
    assert row["student"]["left"] and row["points"] > 0


def older(course: Course, receipt: str) -> None:
    """Make the grade of a submission one that judges gave who saw less, so that a regrade changes it."""
    wrong = {"code": "wrong", "score": 0.0, "details": None, "remarks": None}
    store = engine(course.school.bench.settings.store_url, connections=1)
    with store.begin() as connection:
        mine = grades.c.submission == receipt
        grade = connection.execute(select(grades.c.grade).where(mine)).scalar_one()
        before = grade | {"score": 0.0, "verdicts": grade["verdicts"] | {"l3": grade["verdicts"]["l3"] | wrong}}
        connection.execute(update(grades).where(mine).values(grade=before))
    store.dispose()


def test_administrators_are_not_erased_and_a_typed_number_confirms(course: Course) -> None:
    administrator = course.school.browser("administrator")
    own = course.school.people["administrator"]
    assert administrator.delete(f"/api/v1/people/{own}").json()["error"]["code"] == "erase_administrator"
    assert administrator.delete("/api/v1/people/NONE-NONE-NONE").json()["error"]["code"] == "unknown_person"
    page = f"/people/{course.school.people['outsider']}"
    for typed in ("", course.school.people["other"]):
        assert (
            administrator.post(f"{page}/erase", data={"number": typed}).json()["error"]["code"] == "erase_unconfirmed"
        )
    number = course.school.people["outsider"].lower()
    assert administrator.post(f"{page}/erase", data={"number": number}).status_code == 303
    reopened = administrator.post(page, data={"active": "yes"})
    assert (reopened.status_code, reopened.json()["error"]["code"]) == (403, "erased_person")
    assert (
        course.school.people["outsider"] in administrator.get(page).text
        and "Outsider" not in administrator.get(page).text
    )


def test_what_is_downloaded_is_a_file_that_is_not_cached(course: Course) -> None:
    reply = course.student.get("/account/data")
    assert reply.headers["content-disposition"] == f'attachment; filename="{course.school.people["student"]}.json"'
    assert reply.headers["cache-control"] == "no-store" and reply.json()["person"]["login"] == "student"
    acts = course.school.portal.call(course.school.bench.audit.lines, None, None, 1)
    assert (acts[0].entry.action, acts[0].entry.actor) == ("person_exported", course.school.people["student"])
