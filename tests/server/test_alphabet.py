"""Names stand in the order of the alphabet, with letters beyond ASCII where a reader looks for them."""

from __future__ import annotations

import pytest

from server.alphabet import alphabetical
from server.people import everybody
from server.storage.courses import Row
from server.storage.people import Person
from tests.server.school import NOW, School


@pytest.mark.parametrize(
    "names",
    [
        ["Adam", "Ąbera", "Czyż", "Ćma", "Lis", "Luty", "ładny", "Łoś", "Zwykły", "Źrebak", "Żak"],
        ["Елка", "Ёлка", "Иванова", "Йод", "Ким"],
        ["", "Öhm", "Ørsted", "Zeuner"],
    ],
)
def test_a_letter_with_a_mark_follows_the_letter_without(names: list[str]) -> None:
    assert sorted(reversed(names), key=alphabetical) == names


def test_members_are_listed_by_the_alphabet_after_those_who_teach(school: School) -> None:
    rows = [Row(str(number), name, "A") for number, name in enumerate(("Zwykły Adam", "Ćma Róża", "Łoś Ewa"))]
    lines = "\n".join(f"{row.login};{row.name};{row.group}" for row in rows)
    browser, place = school.browser("lecturer"), f"/api/v1/courses/{school.course}"
    assert browser.post(f"{place}/roster", json={"csv": lines, "apply": True}).status_code == 200
    names = [one["name"] for one in browser.get(f"{place}/members").json()]
    assert names == ["Lecturer", "Assistant", "Ćma Róża", "Leaver", "Łoś Ewa", "Other", "Student", "Zwykły Adam"]


def test_accounts_are_listed_by_the_alphabet_over_all_pages(school: School, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(everybody, "AT_ONCE", 2)
    for number, name in enumerate(("Zwykły Adam", "Ćma Róża", "Łoś Ewa", "Ёлкина Юлия", "Жук Олег", "adamska Ola")):
        school.portal.call(
            school.bench.people.add, Person(f"NAME-NAME-000{number}", f"7{number}", name, "student", NOW)
        )
    browser, names, following = school.browser("administrator"), [], "/api/v1/people?q=7"
    while following:
        part = browser.get(following).json()
        names += [one["name"] for one in part["people"]]
        following = part["next"]
    assert names == ["adamska Ola", "Ćma Róża", "Łoś Ewa", "Zwykły Adam", "Ёлкина Юлия", "Жук Олег"]
