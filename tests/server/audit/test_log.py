"""Lecturers read what was done in their course, administrators everything; no line holds a secret or a name."""

from __future__ import annotations

import asyncio
import json

import pytest
from sqlalchemy import delete
from starlette.testclient import TestClient

from server.audit import api
from server.audit.acts import COMMAND_LINE
from server.database import Database
from server.database.audit import note
from server.database.engine import engine
from server.storage.audit import Action, Entry
from server.tables import audit
from server.web.language import LANGUAGES, words
from tests.server.school import CODE, PASSWORD, School

EN = {"accept-language": "en", "accept": "text/html"}


def lines(browser: TestClient, path: str = "/api/v1/audit") -> list[dict[str, object]]:
    found: list[dict[str, object]] = browser.get(path).json()["lines"]
    return found


def acts(school: School) -> tuple[list[str], list[str]]:
    """Do something of each kind; gives what the log must say, and what it must never hold."""
    lecturer, place, people = school.browser("lecturer"), f"/api/v1/courses/{school.course}", school.people
    link = lecturer.post(f"{place}/members/{people['leaver']}/link").json()["link"]
    path = link.removeprefix(school.bench.settings.address)
    school.browser().post(path, data={"password": "a very secret word"})
    token = lecturer.post("/api/v1/tokens", json={"name": "nightly", "role": "student"}).json()
    lecturer.delete(f"/api/v1/tokens/{token['id']}")
    lecturer.post(f"{place}/roster", json={"csv": "2001;Olga Nowa;B", "apply": True})
    lecturer.post(f"{place}/claims", json={"open": True})
    new = {"code": CODE, "login": "2001", "name": "Olga", "password": PASSWORD}
    claimed = school.browser().post("/api/v1/join", json=new).json()["id"]
    lecturer.post(f"{place}/members/{claimed}/unclaim")
    lecturer.patch(f"{place}/members/{people['other']}", json={"role": "assistant"})
    lecturer.patch(f"{place}/members/{people['other']}", json={"group": ""})
    lecturer.delete(f"{place}/members/{people['leaver']}")
    lecturer.post(f"{place}/code", json={"open": False})
    said = [
        "link_made", "link_used", "token_made", "token_revoked", "roster_imported", "joining_changed", "place_claimed",
        "claim_undone", "role_changed", "member_changed", "member_removed", "joining_changed",
    ]  # fmt: skip
    return said, [link.rsplit("/", 1)[1], token["token"], "a very secret word", PASSWORD, "Olga", "2001", "nightly"]


def test_acts_are_written_in_order_and_hold_no_secret(school: School) -> None:
    said, secrets = acts(school)
    everything = lines(school.browser("administrator"))
    assert [line["action"] for line in reversed(everything)] == said
    kept = [line.entry for line in school.portal.call(school.bench.audit.lines, None, None, 99)]
    whole = json.dumps([[entry.actor, entry.object, dict(entry.details)] for entry in kept], ensure_ascii=False)
    assert not [secret for secret in secrets if secret in whole]
    assert school.portal.call(school.bench.audit.check).broken is None


def test_a_lecturer_reads_the_lines_of_the_own_course(school: School) -> None:
    acts(school)
    mine = lines(school.browser("lecturer"), f"/api/v1/courses/{school.course}/audit")
    assert {line["course"] for line in mine} == {school.course}
    assert "token_made" not in {line["action"] for line in mine}  # a token belongs to no course
    changed = next(line for line in mine if line["action"] == "role_changed")
    assert changed["actor"] == {"id": school.people["lecturer"], "name": "Lecturer"}
    assert changed["object"] == {"id": school.people["other"], "name": "Other"}
    assert changed["details"] == {"role": "assistant", "before": "student"}
    page = school.browser("lecturer").get(f"/courses/{school.course}/audit", headers=EN).text
    assert "role: assistant; before: student" in page and "Europe/Warsaw" in page
    everything = school.browser("administrator").get("/audit", headers=EN).text
    assert "token made" in everything and "UTC" in everything


def test_a_link_for_a_shared_student_is_seen_in_both_courses(school: School) -> None:
    stranger, lecturer = school.browser("stranger"), school.browser("lecturer")
    own = stranger.get("/api/v1/courses").json()[0]["id"]
    for browser, course in ((lecturer, school.course), (stranger, own)):
        browser.post(f"/api/v1/courses/{course}/roster", json={"csv": "2001;Olga", "apply": True})
    (olga,) = [one for one in stranger.get(f"/api/v1/courses/{own}/members").json() if one["login"] == "2001"]
    stranger.post(f"/api/v1/courses/{own}/members/{olga['id']}/link")
    for browser, course in ((lecturer, school.course), (stranger, own)):
        newest = lines(browser, f"/api/v1/courses/{course}/audit")[0]
        assert (newest["action"], newest["actor"]) == (
            "link_made", {"id": school.people["stranger"], "name": "Stranger"},
        )  # fmt: skip


def test_a_long_log_is_read_in_parts(school: School, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(api, "AT_ONCE", 2)
    for at in range(5):
        school.portal.call(school.bench.audit.note, Entry("server", Action.REGRADED, f"job {at}", school.course))
    for path in ("/api/v1/audit", f"/api/v1/courses/{school.course}/audit"):
        browser, seen, following = school.browser("administrator"), [], path
        while following:
            part = browser.get(following).json()
            seen += [line["object"]["id"] for line in part["lines"]]
            following = part["next"]
        assert seen == [f"job {at}" for at in (4, 3, 2, 1, 0)]
    page = school.browser("administrator").get("/audit?before=4", headers=EN).text
    assert "job 2" in page and "job 3" not in page and 'href="?before=2"' in page and "Newest lines" in page
    assert school.browser("administrator").get("/api/v1/audit?before=0").status_code == 422


def test_markup_in_a_name_is_inert_in_the_log(school: School) -> None:
    lecturer = school.browser("lecturer")
    body = {"csv": "2001;<script>alert(1)</script>", "apply": True}
    lecturer.post(f"/api/v1/courses/{school.course}/roster", json=body)
    person = next(
        one["id"] for one in lecturer.get(f"/api/v1/courses/{school.course}/members").json() if one["login"] == "2001"
    )
    lecturer.post(f"/api/v1/courses/{school.course}/members/{person}/link")
    page = lecturer.get(f"/courses/{school.course}/audit").text
    assert "&lt;script&gt;alert(1)" in page and "<script>alert" not in page


def test_administrators_check_the_chain_and_are_told_where_it_breaks(school: School) -> None:
    for at in range(3):
        school.portal.call(school.bench.audit.note, Entry("server", Action.REGRADED, f"job {at}", school.course))
    boss, lecturer = school.browser("administrator"), school.browser("lecturer")
    assert 'href="?check=yes"' in boss.get("/audit", headers=EN).text
    assert "All lines fit to one another" in boss.get("/audit?check=yes", headers=EN).text
    assert "check=yes" not in lecturer.get(f"/courses/{school.course}/audit", headers=EN).text
    last = school.portal.call(school.bench.audit.lines, None, None, 1)[0].number
    cut = delete(audit).where(audit.c.id == last)
    store = engine(school.bench.settings.store_url, connections=1)
    with store.begin() as connection:
        connection.execute(cut)
    store.dispose()
    assert f"Line {last} does not fit" in boss.get("/audit?check=yes", headers=EN).text


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_act_is_worded(language: str) -> None:
    assert [action for action in Action if f"audit.{action.value}" not in words(language)] == []
    told = ("raised", "lowered", "withheld", "reworded", "recomputed", "minutes", "from", "days", "cards", "students")
    assert [name for name in told if f"audit.detail_{name}" not in words(language)] == []


def test_two_servers_write_one_chain(database: Database) -> None:
    """On PostgreSQL two servers write at once; a line must follow the one that was stored before it."""
    url = str(database._connections._writing.url.render_as_string(hide_password=False))
    other = Database(url)

    async def both() -> int | None:
        entry = Entry("server", Action.REGRADED, "x")
        work = [one._connections.write(lambda c: note(c, entry)) for one in (database, other) for _ in range(20)]
        await asyncio.gather(*work)
        return (await database.audit.check()).broken

    try:
        assert asyncio.run(both()) is None
        assert len(asyncio.run(database.audit.lines(None, None, 99))) == 40
    finally:
        other.close()


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_the_command_line_did_is_said_in_the_language_of_the_reader(school: School, language: str) -> None:
    entry = Entry(COMMAND_LINE, Action.LINK_MADE, school.people["student"], None, {"purpose": "reset"})
    school.portal.call(school.bench.audit.note, entry)
    page = school.browser("administrator").get(f"/audit?lang={language}").text
    assert f'<td class="half">{words(language)["audit.actor_command_line"]}</td>' in page
    assert (f'<td class="half">{COMMAND_LINE}</td>' in page) == (language == "en")
