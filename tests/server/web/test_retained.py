"""A form that is refused gives back what was typed, and says how it can be sent again."""

from __future__ import annotations

from html import unescape

import pytest
from starlette.testclient import TestClient

from tests.server.school import School
from tests.server.web.test_errors import Broken, break_store

DESK = "/variants/AAAA-AAAA-AAAA"
PAGE = {"accept": "text/html", "accept-language": "en", "referer": f"http://testserver{DESK}?receipt=X"}
TYPED = {"answer.alpha2": "−17,5\xa0°", "answer.l3": "<b>2</b>", "answer.v3": " ", "password": "chalk", "key": "0"}


def test_what_is_typed_after_the_session_has_ended_is_given_back(school: School) -> None:
    reply = school.browser().post(DESK, data=TYPED, headers=PAGE)
    assert reply.status_code == 404
    assert f'href="/signin?next={DESK}"' in reply.text
    assert "−17,5\xa0°</textarea>" in reply.text and "&lt;b&gt;2&lt;/b&gt;" in reply.text
    assert reply.text.count("<textarea") == 2
    assert "chalk" not in reply.text and "<b>2" not in reply.text


def test_the_remark_of_a_lecturer_is_given_back(school: School) -> None:
    page = {**PAGE, "referer": "http://testserver/sets/AAAA-AAAA-AAAA/students/BBBB-BBBB-BBBB"}
    values = {"receipt": "x", "share": "50", "comment": "The sign of M is lost.\nThe rest holds."}
    reply = school.browser().post("/sets/AAAA-AAAA-AAAA/marks", data=values, headers=page)
    assert reply.status_code == 401
    assert "The sign of M is lost.\nThe rest holds.</textarea>" in unescape(reply.text)
    assert 'href="/signin?next=/sets/AAAA-AAAA-AAAA/students/BBBB-BBBB-BBBB"' in reply.text


def test_what_a_store_that_is_away_cannot_take_is_given_back(client: TestClient) -> None:
    break_store(client, Broken())
    reply = client.post(DESK, data=TYPED, headers=PAGE)
    assert reply.status_code == 503
    assert "−17,5\xa0°</textarea>" in reply.text
    assert "/signin?next" not in reply.text


@pytest.mark.parametrize(
    "referer", ["https://elsewhere.example/variants/X", "", "//", "http://testserver//elsewhere.example"]
)
def test_signing_in_again_never_leads_elsewhere(school: School, referer: str) -> None:
    reply = school.browser().post(DESK, data=TYPED, headers={**PAGE, "referer": referer})
    assert 'href="/signin?next=/home"' in reply.text


def test_a_body_that_is_no_form_is_not_shown(school: School) -> None:
    headers = {**PAGE, "content-type": "application/x-www-form-urlencoded"}
    reply = school.browser().post(DESK, content=b"answer.l3=\xff\xfe", headers=headers)
    assert reply.status_code == 422
    assert "<textarea" not in reply.text


@pytest.mark.parametrize(
    ("language", "said", "back"),
    [
        ("pl", "Wartość pola „liczba minut” (liczba całkowita)", "Wróć na poprzednią stronę"),
        ("en", "The value of “minutes” (a whole number)", "Back to the page before"),
        ("ru", "«число минут» (целое число)", "На предыдущую страницу"),
    ],
)
def test_a_field_that_is_refused_is_named_for_people(school: School, language: str, said: str, back: str) -> None:
    path = f"/courses/{school.course}"
    page = {"accept": "text/html", "accept-language": language, "referer": f"http://testserver{path}"}
    reply = school.browser("lecturer").post(f"{path}/extend", data={"minutes": "soon", "seen": ""}, headers=page)
    assert reply.status_code == 422
    assert said in reply.text and f'<a href="{path}">{back}</a>' in reply.text
