"""Hints at a price: named before the click, taken once, from what is handed in afterwards, and told to both sides."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

from server.web.language import LANGUAGES, say
from tests.server.sets.conftest import Course, moment
from tests.server.sets.test_api import texts

PRICED = {"ladder": True, "hint_price": 0.2}


def astray(course: Course, **changes: object) -> tuple[str, str]:
    """Hand in a wrong answer to a set whose hints have a price; gives the set and the variant."""
    number = course.published(**({"rules": PRICED, "item": {"attempts": None}} | changes))
    variant = course.variant(number)
    assert course.hand_in(variant, {"l3": "9 m"}).status_code == 201
    return number, variant


def bought(course: Course, variant: str, rung: str, answer: str = "l3", who: TestClient | None = None) -> int:
    """Ask for a step of the ladder; gives the status."""
    form = {"answer": answer, "rung": rung}
    reply = (who or course.student).post(f"/variants/{variant}/hints", data=form, headers={"accept": "text/html"})
    return reply.status_code


def seen(course: Course, variant: str, language: str = "en") -> str:
    return course.student.get(f"/variants/{variant}?lang={language}").text


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_price_stands_on_the_button_and_in_the_rules(course: Course, language: str) -> None:
    number, variant = astray(course)
    page = seen(course, variant, language)
    assert 'form="buy-a2"' in page and "(−20 %" in page and '<details class="hint"' not in page
    assert "20 %" in course.student.get(f"/sets/{number}?lang={language}").text


def test_a_hint_is_taken_once_and_stays_open(course: Course) -> None:
    number, variant = astray(course)
    assert [bought(course, variant, rung) for rung in ("2", "1", "1", "0", "-1", "", "3", "4")] == [
        409, 303, 303, 409, 409, 409, 409, 409,
    ]  # fmt: skip
    page = seen(course, variant)
    assert page.count('<details class="hint"') == 1 and 'name="rung" value="2"' in page
    right = texts(course, number)
    assert course.hand_in(variant, right).json()["score"] == 1
    assert bought(course, variant, "2") == 409  # nothing is wrong now
    page = seen(course, variant)
    assert page.count('<details class="hint"') == 1 and "Hints before it" in page and "1 (−20 % of the points)" in page
    assert course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]["earned"] == 8


def test_the_lecturer_sees_what_was_opened_and_no_price(course: Course) -> None:
    number, variant = astray(course)
    assert bought(course, variant, "1") == 303
    course.hand_in(variant, texts(course, number))
    row = course.lecturer.get(f"/api/v1/task-sets/{number}/gradebook").json()["students"]
    (cell,) = [one["items"][0] for one in row if one["items"][0]["receipt"]]
    assert (cell["points"], cell["hints"]) == (8, 1)
    assert (cell["late_loss"], cell["hint_loss"]) == (0, 2)
    results = course.lecturer.get(f"/sets/{number}/results?lang=en").text
    assert "hints opened: 1" in results and "after hints at a price" in results
    person = course.school.people["student"]
    own = course.lecturer.get(f"/sets/{number}/students/{person}?lang=en").text
    assert "hints opened: 1" in own and "10 before deductions, hints: −2" in own and "late: " not in own
    assert course.lecturer.get(f"/variants/{variant}?lang=en").text.count("(−20 %") == 0
    (told,) = [one for one in course.student.get("/api/v1/me/data").json()["hints"] if one["variant"] == variant]
    assert (told["answer"], told["rung"]) == ("l3", 1)


def test_the_last_step_is_the_equation_with_the_data_and_has_its_price_too(course: Course) -> None:
    number, variant = astray(course)
    assert [bought(course, variant, rung) for rung in ("1", "2", "3", "4")] == [303, 303, 303, 409]
    page = seen(course, variant)
    line = page[page.index('name="answer.l3"') :].split("</li>")[0]
    assert line.count('<details class="hint"') == line.count("</details>") == 3 and 'form="buy-' not in line
    assert "Next hint: the equation with your data" in line and "<mo>°</mo>" in line
    course.hand_in(variant, texts(course, number))
    assert "3 (−60 % of the points)" in seen(course, variant)
    assert course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]["earned"] == 4


def test_what_was_earned_before_a_hint_stays(course: Course) -> None:
    number, variant = astray(course)
    right = texts(course, number)
    half = {name: text for name, text in right.items() if name != "l3"} | {"l3": "9 m"}
    course.hand_in(variant, half)
    before = course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]["earned"]
    assert bought(course, variant, "1") == 303
    course.hand_in(variant, half | {"l3": "8 m"})
    assert course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]["earned"] == before > 0


def test_a_hint_is_sold_only_where_it_is_offered(course: Course) -> None:
    number, variant = astray(course)
    asked = [bought(course, variant, "1", answer) for answer in ("v3", "omega2_formula", "nothing", "")]
    assert asked == [409] * 4 and bought(course, variant, "1", who=course.other) == 404
    assert bought(course, variant, "1", who=course.lecturer) == 409
    assert "% of the points" in course.student.get(f"/variants/{variant}?lang=en").text
    course.move(number, hours=1)
    assert bought(course, variant, "1") == 403
    assert "% of the points" not in course.student.get(f"/variants/{variant}?lang=en").text
    for rules in ({"ladder": True}, {"hint_price": 0.2}, PRICED | {"mode": "exam"}):
        _, other = astray(course, rules=rules, opens=moment(hours=-1))
        assert bought(course, other, "1") == 409


def test_a_program_sees_the_hints_and_opens_the_next_one(course: Course) -> None:
    number, variant = astray(course)
    path = f"/api/v1/variants/{variant}/hints"
    wanted = {"answer": "l3", "price": 0.2}
    assert course.student.get(path).json() == [wanted | {"steps": [], "left": 3}]
    for _ in range(2):  # the second time it is open
        reply = course.student.post(path, json={"answer": "l3", "step": 1})
        assert reply.status_code == 200 and "<mi>" in reply.json()["steps"][0]
        assert reply.json() == wanted | {"steps": reply.json()["steps"], "left": 2}
    assert course.student.get(path).json() == [reply.json()]
    for step, status in ((3, 409), (0, 422), ("1", 422)):
        assert course.student.post(path, json={"answer": "l3", "step": step}).status_code == status
    assert course.student.post(path, json={"answer": "x", "step": 1}).status_code == 409
    assert course.other.post(path, json={"answer": "l3", "step": 2}).status_code == 404
    course.hand_in(variant, texts(course, number))
    assert course.student.get(path).json() == [reply.json() | {"left": 0}]
    assert course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]["earned"] == 8


def test_in_practice_hints_are_whole_and_free(client: TestClient) -> None:
    variant = client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 7}).json()["id"]
    path = f"/api/v1/variants/{variant}/hints"
    assert client.get(path).json() == []
    client.post(f"/api/v1/variants/{variant}/submissions", json={"answers": {"l3": "9 m"}})
    (found,) = client.get(path).json()
    assert (found["answer"], len(found["steps"]), found["left"], found["price"]) == ("l3", 3, 0, 0)
    assert client.post(path, json={"answer": "l3", "step": 1}).status_code == 409


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_laboratory_leads_towards_its_formula_and_never_shows_it(client: TestClient, language: str) -> None:
    variant = client.post("/api/v1/exercises/slider_crank_polygon/variants", json={"seed": 7}).json()["id"]
    client.post(f"/api/v1/variants/{variant}/submissions", json={"answers": {"v3": "99 m/s"}})
    page = client.get(f"/variants/{variant}?lang={language}").text
    line = page[page.index('name="answer.v3"') :].split("</li>")[0]
    told = ("hint_shape", "hint_shape_help", "hint_signs", "hint_signs_help")
    assert all(say(language, f"pages.{key}") in line for key in told)
    assert line.count('<details class="hint"') == 3 and line.count(">±</mo>") == 4


def test_an_examination_tells_a_program_nothing_by_its_hints(course: Course) -> None:
    _, variant = astray(course, rules=PRICED | {"mode": "exam"})
    path = f"/api/v1/variants/{variant}/hints"
    assert course.student.get(path).json() == []
    assert course.student.post(path, json={"answer": "l3", "step": 1}).status_code == 409
