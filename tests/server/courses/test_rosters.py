"""A roster in a file: whatever program wrote it, what it would change is shown first."""

from __future__ import annotations

import codecs

import pytest
from starlette.testclient import TestClient

from server.courses import rosters
from server.web.envelope import LARGEST_ROSTER
from server.web.errors import Refused
from tests.server.school import School

EN = {"accept-language": "en", "accept": "text/html"}
POLISH = "Nr indeksu;Imię i nazwisko;Grupa\r\n3001;Świętosława Żółć;Środa\r\n"
RUSSIAN = "номер;имя\n3001;Ёлкина Юлия\n"


@pytest.mark.parametrize(
    ("text", "encoding", "language"),
    [(POLISH, encoding, "pl") for encoding in ("utf-8", "utf-8-sig", "cp1250", "utf-16", "utf-16-le", "utf-16-be")]
    + [(RUSSIAN, encoding, "ru") for encoding in ("utf-8", "cp1251", "utf-16", "utf-16-le", "utf-16-be")]
    + [("3001;Ann\n", encoding, "en") for encoding in ("ascii", "utf-16-le")],
)  # fmt: skip
def test_a_file_is_read_as_spreadsheets_write_it(text: str, encoding: str, language: str) -> None:
    assert rosters.decoded(text.encode(encoding), language) == text


@pytest.mark.parametrize(
    ("raw", "code"),
    [(b"PK\x03\x04xlsx", "roster_spreadsheet"), (b"\xd0\xcf\x11\xe0\xa1\xb1", "roster_spreadsheet"),
     (b"3001;\x81\x83\x88 \xff", "roster_encoding"), (codecs.BOM_UTF16_LE + b"a", "roster_encoding")],
)  # fmt: skip
def test_what_is_no_text_is_refused_with_advice(raw: bytes, code: str) -> None:
    with pytest.raises(Refused) as refused:
        rosters.decoded(raw, "pl")
    assert refused.value.code == code


def send(browser: TestClient, school: School, content: bytes, name: str = "lista.csv") -> tuple[int, str]:
    reply = browser.post(f"/courses/{school.course}/roster", files={"file": (name, content, "text/csv")}, headers=EN)
    return reply.status_code, reply.text


@pytest.mark.parametrize("name", ['"Anna', 'Anna "', '"Anna" Nowak', '"' + "a" * 200_000, "a" * 200_000])
def test_a_quotation_mark_out_of_place_swallows_no_student(name: str) -> None:
    rows, unread = rosters.read(f'1001;{name}\n1002;"Nowak; Jan";B\n')
    assert (rows[-1].login, rows[-1].name, rows[-1].group) == ("1002", "Nowak; Jan", "B")
    assert [one.line for one in unread] == [1] * (2 - len(rows)) and len(rows) == 1 + (name == 'Anna "')


def test_a_name_in_two_columns_is_not_taken_for_a_group() -> None:
    rows, unread = rosters.read("1001;Nowak;Anna;B\n1002;Jan Nowak;B;\n1003;Ewa Lis;B;;")
    assert [row.login for row in rows] == ["1002", "1003"]
    assert [(one.line, one.code) for one in unread] == [(1, "many_columns")]


def test_a_file_shows_what_will_change_and_changes_nothing(school: School) -> None:
    lecturer = school.browser("lecturer")
    status, page = send(lecturer, school, (POLISH + "student;Ktoś Inny;\r\n").encode("cp1250"))
    assert status == 200 and "Świętosława Żółć" in page and "Apply changes: 1" in page
    assert "on this server: Student" not in page  # what does not change is only counted
    members = lecturer.get(f"/api/v1/courses/{school.course}/members").json()
    assert "3001" not in {member["login"] for member in members}
    _, page = send(lecturer, school, "outsider;Ktoś Inny;\r\n".encode())
    assert "on this server: Outsider" in page


def test_a_thousand_lines_are_shown_and_applied(school: School) -> None:
    lecturer = school.browser("lecturer")
    text = "".join(f"4{number:05};Żółcińska-Świętosławska Świętosława {number};Środa rano\n" for number in range(1000))
    status, page = send(lecturer, school, text.encode("utf-16"))
    assert status == 200 and "Apply changes: 1000" in page
    form = {"roster": text, "apply": "yes"}
    assert lecturer.post(f"/courses/{school.course}/roster", data=form).status_code == 303
    assert len(lecturer.get(f"/api/v1/courses/{school.course}/members").json()) == 1005
    status, page = send(lecturer, school, (text + "5;x\n").encode())
    assert status == 422 and "more than 1000 lines" in page


def test_a_file_that_is_too_large_or_missing_is_refused(school: School) -> None:
    lecturer = school.browser("lecturer")
    status, page = send(lecturer, school, b"1" * LARGEST_ROSTER)
    assert status == 413 and "512" in page
    path = f"/courses/{school.course}/roster"
    for files in ({"other": ("a.csv", b"1;A", "text/csv")}, {"file": (None, "1;A")}):
        assert lecturer.post(path, files=files).json()["error"]["code"] == "empty_roster"
    two = [("file", ("a.csv", b"1;A", "text/csv")), ("file", ("b.csv", b"2;B", "text/csv"))]
    assert lecturer.post(path, files=two).json()["error"]["code"] == "not_a_form"
    broken = {"content-type": "multipart/form-data; boundary=x"}
    assert lecturer.post(path, content=b"--y\r\n\r\n", headers=broken).status_code == 422
    assert school.browser("assistant").post(path, files=two).status_code == 403
