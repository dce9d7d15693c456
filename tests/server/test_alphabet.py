"""Names stand in the order of the alphabet, with letters beyond ASCII where a reader looks for them."""

from __future__ import annotations

import re

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
        ["Екимов", "Ёлкин Адам", "Елкин Борис", "Ерёмин", "Жук"],
        ["L1", "L2", "L10", "L10a", "M", "Sem 2 gr. 3", "Sem 2 gr. 11"],
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


def test_groups_are_listed_by_their_numbers(school: School) -> None:
    browser, place = school.browser("lecturer"), f"/api/v1/courses/{school.course}/groups"
    for name in ("L10", "L2", "Ł1"):
        assert browser.post(place, json={"name": name}).status_code == 201
    assert [one["name"] for one in browser.get(place).json()] == ["A", "L2", "L10", "Ł1"]


def test_a_long_course_leads_to_its_parts_and_a_long_roster_is_applied_from_the_top(school: School) -> None:
    browser, path = school.browser("lecturer"), f"/courses/{school.course}"
    page = browser.get(path).text
    for part in re.findall(r'<a href="#([\w-]+)">', page[page.index('<nav class="row') :]):
        assert f'id="{part}"' in page
    assert page.index('href="#h-copy"') < page.index('id="h-members"')
    preview = browser.post(f"{path}/roster", data={"roster": "4001;Nowak Jan;A"}).text
    assert preview.index('form="again" name="apply"') < preview.index("<tbody>")
