"""A student reports a problem; the lecturer sees the variant, its version and seed, and settles it."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from starlette.testclient import TestClient

from server.answering import problems
from tests.server.school import School
from tests.server.test_policy import bearer

ATTACK = '<script>alert(1)</script>{{ 7*7 }}"><img src=x onerror=alert(1)>'


def test_a_reported_problem_carries_what_is_needed_to_see_it(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal(seed=7)
    reply = client.post(f"/api/v1/variants/{number}/problems", json={"text": ATTACK})
    assert reply.status_code == 201
    (found,) = client.get("/api/v1/problems", headers=bearer("lecturer")).json()["problems"]
    assert found["id"] == reply.json()["id"] and found["text"] == ATTACK
    assert (found["variant"], found["exercise"], found["seed"]) == (number, "slider_crank", 7) and found["version"] > 0


def test_the_page_reports_and_lists_and_settles(client: TestClient, deal: Callable[..., str]) -> None:
    number, lecturer = deal(), bearer("lecturer") | {"accept-language": "en"}
    empty = client.post(f"/variants/{number}/problem", data={"problem": "  "}, headers={"accept-language": "en"})
    assert "nothing was sent" in empty.text
    sent = client.post(f"/variants/{number}/problem", data={"problem": ATTACK}, headers={"accept-language": "en"})
    assert "The report has arrived" in sent.text
    page = client.get("/problems", headers=lecturer).text
    assert number in page and "&lt;script&gt;" in page and "<script>alert" not in page and "<img" not in page
    problem = client.get("/api/v1/problems", headers=lecturer).json()["problems"][0]["id"]
    assert "No open reports" in client.post(f"/problems/{problem}", headers=lecturer).text
    again = client.post(f"/api/v1/problems/{problem}/settle", headers=lecturer)
    assert (again.status_code, again.json()["error"]["code"]) == (404, "unknown_problem")


def test_settling_by_a_program_takes_it_off_the_list(client: TestClient, deal: Callable[..., str]) -> None:
    problem = client.post(f"/api/v1/variants/{deal()}/problems", json={"text": "x"}).json()["id"]
    assert client.post(f"/api/v1/problems/{problem}/settle", headers=bearer("lecturer")).status_code == 204
    assert client.get("/api/v1/problems", headers=bearer("lecturer")).json() == {"problems": [], "next": None}


@pytest.mark.parametrize("text", ["", "x" * 2001, 5, None])
def test_what_is_no_report_is_refused(client: TestClient, deal: Callable[..., str], text: object) -> None:
    assert client.post(f"/api/v1/variants/{deal()}/problems", json={"text": text}).status_code == 422


def test_reports_of_one_variant_are_bounded_and_only_its_owner_reports(
    client: TestClient, deal: Callable[..., str]
) -> None:
    number = deal()
    path = f"/api/v1/variants/{number}/problems"
    codes = [client.post(path, json={"text": "x"}).status_code for _ in range(problems.MOST_OPEN + 1)]
    assert codes == [201] * problems.MOST_OPEN + [409]
    client.cookies.clear()
    assert client.post(path, json={"text": "x"}, headers=bearer("student", "bob")).status_code == 404


def test_students_do_not_see_what_others_report(client: TestClient) -> None:
    for path in ("/problems", "/api/v1/problems"):
        assert client.get(path).status_code == 401
        assert client.get(path, headers=bearer("student")).status_code == 403


def test_a_long_list_is_read_in_parts(
    client: TestClient, deal: Callable[..., str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(problems, "AT_ONCE", 2)
    for text in "abc":
        client.post(f"/api/v1/variants/{deal()}/problems", json={"text": text})
    first = client.get("/api/v1/problems", headers=bearer("lecturer")).json()
    rest = client.get(first["next"], headers=bearer("lecturer")).json()
    assert [one["text"] for part in (first, rest) for one in part["problems"]] == ["c", "b", "a"]
    assert rest["next"] is None


def test_a_lecturer_sees_and_settles_what_own_students_and_nobody_known_report(school: School) -> None:
    reporters = {"student": school.browser("student"), "outsider": school.browser("outsider"), "": school.browser()}
    for text, browser in reporters.items():
        number = browser.post("/api/v1/exercises/slider_crank/variants", json={"seed": 7}).json()["id"]
        sent = browser.post(f"/api/v1/variants/{number}/problems", json={"text": text or "nobody"})
        assert sent.status_code == 201
    seen = {}
    for who in ("lecturer", "stranger", "administrator"):
        listed = school.browser(who).get("/api/v1/problems").json()["problems"]
        seen[who] = {one["text"]: one["id"] for one in listed}
        page = school.browser(who).get("/problems").text
        assert all((text in page) == (text in seen[who]) for text in ("student", "outsider", "nobody"))
        assert '<a href="/problems" aria-current="page">' in page
    assert [sorted(seen[who]) for who in seen] == [["nobody", "student"], ["nobody"], ["nobody", "outsider", "student"]]
    foreign = school.browser("stranger").post(f"/api/v1/problems/{seen['lecturer']['student']}/settle")
    assert (foreign.status_code, foreign.json()["error"]["code"]) == (404, "unknown_problem")
    assert school.browser("lecturer").post(f"/problems/{seen['lecturer']['student']}").status_code == 303
    assert 'href="/problems"' not in school.browser("student").get("/home").text
