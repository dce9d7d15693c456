"""A13 in sets: every address that a student may open is crawled, with a card of every exercise, before any reveal.

The set is an examination that is open, so all feedback is held back; a draft lies there, something was handed in, and
the languages take turns. Printed sheets are read as the documents that are printed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime

import pytest
from starlette.testclient import TestClient

from graders.words import LANGUAGES
from reports import sheets
from reports.typst import source
from server.policy import POLICIES, CourseRole, InCourse, Role
from server.sets import dealing, handing, planning, printing
from server.sets.dealing import Plan
from server.storage.sets import Card
from tests.conftest import Laid
from tests.security.test_a13_reference_values import HIDING, SMALL, numbers, secrets_in
from tests.server.sets.classroom import publish
from tests.server.sets.conftest import Course, made, moment

PUBLIC = ("id", "givens", "statement", "statement_text", "data", "answers", "receipt", "sessions", "acts", "variants")
ELSEWHERE = (
    "/",
    "/api/v1/openapi.json",
    "/static",
    "/oidc",
    "/oidc/callback",
    "/exercises/{exercise}",
    "/api/v1/exercises/{exercise}",
)  # samples and descriptions, which hold no card
PUBLIC_PARTS = re.compile(r'(?s)<div class="statement">.*?</div>|<tbody>.*?</tbody>|<dl class="block">.*?</dl>')
NO_NUMBERS = re.compile(  # moments and ids
    r"\d{4}-\d\d-\d\d[T ][\d:.]+(?:[+-][\d:]+|Z)?|\d\d?:\d\d(?::\d\d)?|[0-9A-Z]{4}(?:-[0-9A-Z]{4})+"
    r"|\d{1,2} [A-Z][a-z]{2} \d{4}|\d\d\.\d\d\.\d{4}"
)
SEAT = "seat 3"
WISHED = {"solver": "beam", "link": "x" * 43, "code": "KX49-2MQT", "form": "md"}
SEEN_BY_STUDENTS = (Role.ANONYMOUS, Role.STUDENT)


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[tuple[Course, str]]:
    for course in made(laid_for_all(tmp_path_factory.mktemp("exam"), secret=b"exam", limited=False)):
        items = [{"exercise": exercise, "attempts": 2} for exercise in HIDING]
        body = {"course": course.school.course, "title": "All", "items": items, "due": moment(days=20)}
        number = course.lecturer.post("/api/v1/task-sets", json=body | {"rules": {"mode": "exam"}}).json()["id"]
        course.school.portal.call(publish_one_card_each, course, number)
        yield course, number


def always(plan: Plan) -> Plan:
    """The same numbers in every run: those that happen to stand elsewhere on a page would fail now and then."""
    return replace(plan, slot=plan.pool[0], shuffle="exam")


async def publish_one_card_each(course: Course, number: str) -> None:
    """Deal the student's cards alone: what is checked of them at publishing is tried elsewhere."""
    bench, person = course.school.bench, course.school.people["student"]
    task_set = await bench.sets.task_set(number)
    assert task_set is not None
    cards = [
        planning.stored(plan.slot, 1, dealing.card(person, dealing.draw(bench.secret, always(plan), SEAT)), person)
        for plan in planning.planned(task_set, (person,))
    ]
    publish(bench.settings.store_url, task_set, cards, datetime.now(UTC))


def open_to_students() -> Iterator[str]:
    """The addresses to look at that a student's role opens, as the table of policies has them."""
    for (method, route), policy in POLICIES.items():
        least = isinstance(policy, InCourse) and policy.role is CourseRole.STUDENT
        if method == "GET" and (policy in SEEN_BY_STUDENTS or least):
            yield route


OF_A_CARD = {"variant", "receipt", "number"}


def crawled(student: TestClient, routes: Sequence[str], values: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Open addresses, and preview an answer; what is public on purpose (statement, givens, own answers) is cut out."""
    wish = {"accept-language": values["language"]}
    asked = {"answer": values["answer"], "text": "1"}
    replies = {"preview": student.post(f"/api/v1/variants/{values['variant']}/preview", json=asked, headers=wish)}
    for route in routes:
        path = re.sub(r"\{(\w+)\}", lambda found: values[found[1]], route)
        kind = "application/json" if path.startswith("/api/") else "text/html"
        replies[path] = student.get(path, headers=wish | {"accept": kind})
    for path, reply in replies.items():
        assert reply.status_code < 500, path
        text = reply.text
        if reply.headers.get("content-type", "").startswith("application/json"):
            own = reply.json()
            told = {key: one for key, one in own.items() if key not in PUBLIC} if isinstance(own, dict) else own
            text = str(told)
        text = NO_NUMBERS.sub("", PUBLIC_PARTS.sub("", text))
        yield path, "\n".join(line for line in text.splitlines() if not line.startswith(("|", "- ")))


def refuse_leaks(student: TestClient, routes: Sequence[str], known: Mapping[str, str], card: Card) -> None:
    values, formulas = secrets_in(handing.variant_of(card))
    assert values or formulas
    for path, text in crawled(student, routes, known):
        assert not [formula for formula in formulas if formula in text], path
        for one in numbers(text):
            near = [value for value in values if abs(one - value) <= 1e-3 * value]
            assert not near or (one.is_integer() and one < SMALL), (path, one, near)


def worked(exam: tuple[Course, str], exercise: str) -> tuple[dict[str, str], Card]:
    """Open a task, type a draft and hand something in; gives what stands in the addresses, and the card."""
    course, number = exam
    place, student = HIDING.index(exercise) + 1, course.student
    wish = {"accept-language": LANGUAGES[place % 3]}
    reply = student.post(f"/api/v1/task-sets/{number}/items/{place}/variant", json={}, headers=wish)
    assert reply.status_code == 200, reply.text
    variant, first = reply.json()["id"], next(iter(reply.json()["answers"]))
    student.put(f"/api/v1/variants/{variant}/draft", json={"answers": {first: "1"}, "revision": 0})
    receipt = course.hand_in(variant, {first: "1"}).json()["receipt"]["id"]
    cards = course.school.portal.call(course.school.bench.sets.cards, number, course.school.people["student"])
    (card,) = [card for card in cards if card.variant == variant]
    return WISHED | {
        "exercise": exercise, "variant": variant, "receipt": receipt, "course": course.school.course,
        "task_set": number, "number": str(place), "language": LANGUAGES[place % 3], "answer": first,
    }, card  # fmt: skip


@pytest.mark.parametrize("exercise", HIDING)
def test_no_address_of_a_card_gives_its_reference_away(exam: tuple[Course, str], exercise: str) -> None:
    known, card = worked(exam, exercise)
    routes = [route for route in open_to_students() if OF_A_CARD & set(re.findall(r"\{(\w+)\}", route))]
    assert len(routes) >= 7
    refuse_leaks(exam[0].student, routes, known, card)
    formulas = secrets_in(handing.variant_of(card))[1]
    for language in LANGUAGES:
        sheet = printing.sheet(card.code, card.shown[language], card.reference["texts"])
        printed = source(sheets.sheets([sheet], language))
        assert card.code in printed and not [formula for formula in formulas if formula in printed]


def test_no_other_address_gives_a_reference_away(exam: tuple[Course, str]) -> None:
    known, card = worked(exam, "slider_crank")
    routes = [route for route in open_to_students() if not OF_A_CARD & set(re.findall(r"\{(\w+)\}", route))]
    assert {"/courses/{course}/sets", "/sets/{task_set}", "/api/v1/me/data", "/account/data"} <= set(routes)
    refuse_leaks(exam[0].student, [route for route in routes if route not in ELSEWHERE], known, card)


def test_what_is_kept_of_a_card_is_served_to_nobody(exam: tuple[Course, str]) -> None:
    """The reference of a card leaves the server by no address, for nobody; a lecturer has the printed key alone."""
    course, number = exam
    for browser in (course.student, course.lecturer, course.school.browser("administrator")):
        for path in (f"/api/v1/task-sets/{number}", f"/sets/{number}", "/api/v1/me/data"):
            assert '"reference"' not in browser.get(path).text, path
