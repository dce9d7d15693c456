"""People, sessions, links, tokens and courses are kept alike on SQLite and on PostgreSQL."""

from __future__ import annotations

import asyncio
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest
from sqlalchemy import update
from sqlalchemy.exc import DBAPIError

from server.database import Database
from server.storage import Dealt, Draft, Handed, Marked, Owner, Problem
from server.storage.audit import Action, Entry
from server.storage.courses import Course, Group, Row
from server.storage.people import Link, Person, Session, Token
from server.tables import persons, submissions

NOW = datetime(2026, 11, 28, 9, 0, tzinfo=UTC)
LATER = NOW + timedelta(days=1)
ANNA = Person("AAAA-AAAA-AAAA", "anna@uni", "Anna", "student", NOW)
BORIS = Person("BBBB-BBBB-BBBB", "1002", "Boris", "lecturer", NOW, "hash", issuer="https://id", subject="b")
COURSE = Course("CCCC-CCCC-CCCC", "TMM", "pl", "Europe/Warsaw", NOW, "KX49-2MQT")


@pytest.fixture
def kept(database: Database) -> Database:
    async def fill() -> None:
        assert await database.people.add(ANNA) and await database.people.add(BORIS)
        await database.courses.add(COURSE, BORIS.id)

    asyncio.run(fill())
    return database


def test_a_login_and_a_subject_belong_to_one_person(kept: Database) -> None:
    async def tries() -> list[object]:
        people = kept.people
        return [
            await people.by_login("1002"),
            await people.by_subject("https://id", "b"),
            await people.add(replace(ANNA, id="X")),
            await people.add(replace(ANNA, id="X", login="x", issuer="https://id", subject="b")),
            await people.person("X"),
            await people.vouch(ANNA.id, "https://id", "b"),
            await people.vouch(ANNA.id, "https://id", "a"),
            (await people.person(ANNA.id) or ANNA).subject,
        ]

    assert asyncio.run(tries()) == [BORIS, BORIS, False, False, None, False, True, "a"]


def test_a_session_lasts_until_it_is_ended_by_its_person(kept: Database) -> None:
    session = Session("d" * 64, ANNA.id, NOW, NOW, LATER, "a browser")

    async def life() -> list[object]:
        people = kept.people
        await people.begin(session)
        await people.seen(session.digest, LATER)
        return [
            await people.session(session.digest),
            await people.end(BORIS.id, session.number),
            list(await people.sessions(ANNA.id)),
            await people.end(ANNA.id, session.number),
            await people.session(session.digest),
        ]

    seen = replace(session, last_used=LATER)
    assert asyncio.run(life()) == [(seen, ANNA), False, [seen], True, None]


def test_a_link_sets_one_password_and_ends_the_sessions(kept: Database) -> None:
    link = Link("l" * 64, "reset", ANNA.id, None, NOW, LATER)

    async def used() -> list[object]:
        people = kept.people
        await people.begin(Session("d" * 64, ANNA.id, NOW, NOW, LATER, ""))
        await people.keep_links([replace(link, digest="older")])
        await people.keep_links([link])
        racing = await asyncio.gather(*(people.redeem(link.digest, NOW, f"hash {i}") for i in range(5)))
        return [
            await people.link("older"),
            await people.redeem(link.digest, LATER, "late"),
            sum(person is not None for person in racing),
            list(await people.sessions(ANNA.id)),
        ]

    assert asyncio.run(used()) == [None, None, 1, []]


def test_a_link_that_has_expired_does_nothing(kept: Database) -> None:
    async def used() -> Person | None:
        await kept.people.keep_links([Link("l" * 64, "reset", ANNA.id, None, NOW, LATER)])
        return await kept.people.redeem("l" * 64, LATER, "hash")

    assert asyncio.run(used()) is None
    assert asyncio.run(kept.people.person(ANNA.id)) == ANNA


def test_there_is_one_first_administrator(database: Database) -> None:
    chief = Person("DDDD-DDDD-DDDD", "chief", "Chief", "administrator", NOW, "hash")

    async def race() -> list[bool]:
        await database.people.keep_links([Link("l" * 64, "first", None, None, NOW, LATER)])
        before = await database.people.has_administrator()
        others = (replace(chief, id=f"X{i}", login=f"x{i}") for i in range(4))
        won = await asyncio.gather(*(database.people.redeem_first("l" * 64, NOW, person) for person in others))
        return [before, won.count(True) == 1, await database.people.has_administrator()]

    assert asyncio.run(race()) == [False, True, True]


def test_a_token_is_revoked_by_its_person_alone(kept: Database) -> None:
    token = Token("TTTT-TTTT-TTTT", ANNA.id, "ci", "student", NOW, LATER)

    async def life() -> list[object]:
        people = kept.people
        await people.keep_token(token)
        return [
            await people.token(token.id),
            await people.revoke(BORIS.id, token.id, NOW),
            await people.revoke(ANNA.id, token.id, NOW),
            list(await people.tokens(ANNA.id)),
        ]

    assert asyncio.run(life()) == [(token, ANNA), False, True, [replace(token, revoked=NOW)]]


def test_a_roster_says_what_it_will_change_and_changes_just_that(kept: Database) -> None:
    rows = [Row("anna@uni", "A. N.", "A"), Row("1003", "Cezary", "B"), Row("1002", "Boris")]

    async def taken() -> list[list[str]]:
        courses = kept.courses
        said = await courses.roster(COURSE.id, rows, NOW, apply=False)
        assert len(await courses.members(COURSE.id)) == 1
        done = await courses.roster(COURSE.id, rows, NOW, apply=True)
        again = await courses.roster(COURSE.id, [replace(rows[0], group="B"), *rows[1:]], NOW, apply=True)
        return [[change.what for change in found] for found in (said, done, again)]

    first = ["joins", "new", "same"]
    assert asyncio.run(taken()) == [first, first, ["moves", "same", "same"]]
    members = asyncio.run(kept.courses.members(COURSE.id))
    assert [(m.person.name, m.role) for m in members] == [
        ("Boris", "lecturer"), ("Anna", "student"), ("Cezary", "student"),
    ]  # fmt: skip
    groups = {group.id: group.name for group in asyncio.run(kept.courses.groups(COURSE.id))}
    assert [groups.get(member.group or "") for member in members] == [None, "B", "B"]


def test_a_member_has_a_role_and_a_group_of_the_same_course(kept: Database) -> None:
    async def tries() -> list[object]:
        courses = kept.courses
        other = replace(COURSE, id="EEEE-EEEE-EEEE", join_code="OTHER")
        await courses.add(other, BORIS.id)
        assert await courses.add_group(Group("G", other.id, "A"))
        return [
            await courses.add_group(Group("H", other.id, "A")),
            await courses.join(COURSE.id, ANNA.id, "student", NOW),
            await courses.join(COURSE.id, ANNA.id, "lecturer", NOW),
            await courses.role(COURSE.id, ANNA.id),
            await courses.teaches(BORIS.id, ANNA.id),
            await courses.teaches(ANNA.id, BORIS.id),
            await courses.change(COURSE.id, ANNA.id, "assistant", "G"),
            await courses.change(COURSE.id, ANNA.id, "assistant", None),
            await courses.is_staff(ANNA.id),
            await courses.set_code(COURSE.id, "OTHER"),
            await courses.set_code(COURSE.id, None),
            await courses.by_code("KX49-2MQT"),
            [course.id for course, _ in await courses.of(ANNA.id)],
            await courses.leave(COURSE.id, ANNA.id),
        ]

    expected = [False, True, False, "student", True, False, False, True, True, False, True, None, [COURSE.id], True]
    assert asyncio.run(tries()) == expected


def test_practice_taken_over_is_the_person_s_and_is_not_forgotten(kept: Database) -> None:
    nobody = Owner("o" * 64, anonymous=True)
    variant = Dealt("VVVV-VVVV-VVVV", nobody, "slider_crank", 1, 7, {}, NOW, NOW)
    handed = Handed("RRRR-RRRR-RRRR", variant.id, nobody.id, {}, NOW, None, "b", "d", "pl")

    async def taken() -> list[object]:
        practice = kept.practice
        await practice.keep_variant(variant)
        await practice.keep_submission(Marked(handed, {}, True, "1"))
        return [
            await practice.practised(nobody.id),
            await practice.take_over(ANNA.id, BORIS.id),
            await practice.take_over(nobody.id, ANNA.id),
            await practice.purge(LATER),
            (await practice.variant(variant.id) or variant).owner,
        ]

    assert asyncio.run(taken()) == [1, 0, 1, 0, Owner(ANNA.id, anonymous=False)]


@pytest.mark.parametrize("settled", [False, True])
def test_what_is_written_around_practice_taken_over_outlives_its_first_owner(kept: Database, settled: bool) -> None:
    nobody = Owner("o" * 64, anonymous=True)
    mine, left = (Dealt(f"{sign * 4}-VVVV-VVVV", nobody, "slider_crank", 1, 7, {}, NOW, NOW) for sign in "AB")

    async def taken() -> list[object]:
        practice = kept.practice
        await practice.keep_variant(mine)
        await practice.keep_draft(Draft(mine.id, {"l3": "1"}, NOW, 1))
        await practice.keep_problem(Problem("P1", mine.id, nobody.id, "x", NOW), 9)
        await practice.take_over(nobody.id, ANNA.id)
        await practice.keep_variant(left)
        await practice.keep_draft(Draft(left.id, {"l3": "2"}, NOW, 1))
        if settled:
            await practice.settle_problem("P1", NOW, None)
        gone = await practice.purge(LATER)
        drafts = [await practice.draft(one.id) for one in (mine, left)]
        problems = [problem.id for problem in await practice.problems(LATER, 9, None)]
        return [gone, [draft is not None for draft in drafts], problems]

    assert asyncio.run(taken()) == [1, [True, False], [] if settled else ["P1"]]


@pytest.mark.parametrize("change", [{"answers": {"l3": ""}, "key": None}, {"time": LATER}, {"owner": BORIS.id}])
def test_only_the_answers_of_somebody_erased_may_go(kept: Database, change: dict[str, Any]) -> None:
    """A person is erased alike in both stores; before that, and in all else, a submission never changes."""
    variant = Dealt("VVVV-VVVV-VVVV", Owner(ANNA.id, anonymous=False), "slider_crank", 1, 7, {}, NOW, NOW)
    handed = Handed("RRRR-RRRR-RRRR", variant.id, ANNA.id, {"l3": "1"}, NOW, "k", "b", "d", "pl")
    alter = update(submissions).where(submissions.c.receipt == handed.receipt).values(**change)

    async def altered() -> bool:
        try:
            await kept._connections.write(lambda connection: connection.execute(alter).rowcount)
        except DBAPIError:
            return False
        return True

    async def tries() -> list[object]:
        await kept.practice.keep_variant(variant)
        await kept.practice.keep_submission(Marked(handed, {}, True, "1"))
        before = await altered()
        erased = update(persons).where(persons.c.id == ANNA.id).values(erased=NOW)
        await kept._connections.write(lambda connection: connection.execute(erased).rowcount)
        return [before, await altered()]

    assert asyncio.run(tries()) == [False, "key" in change]


def test_a_person_is_erased_with_all_practice(kept: Database) -> None:
    variant = Dealt("VVVV-VVVV-VVVV", Owner(ANNA.id, anonymous=False), "slider_crank", 1, 7, {}, NOW, NOW)
    handed = Handed("RRRR-RRRR-RRRR", variant.id, ANNA.id, {"l3": "1"}, NOW, "k", "b", "d", "pl")
    entry = Entry("server", Action.PERSON_ERASED, ANNA.id)

    async def erased() -> list[object]:
        await kept.practice.keep_variant(variant)
        await kept.practice.keep_submission(Marked(handed, {}, True, "1"))
        await kept.practice.keep_draft(Draft(variant.id, {"l3": "1"}, NOW, 1))
        await kept.practice.keep_problem(Problem("P1", variant.id, ANNA.id, "x", NOW), 9)
        await kept.people.keep_links([Link("l" * 64, "reset", ANNA.id, None, NOW, LATER)])
        done = [
            await kept.personal.erase(number, lambda answers, grade: (answers, grade), entry)
            for number in (ANNA.id, "NONE")
        ]
        left = await kept.personal.kept(ANNA.id)
        assert left is not None
        acts = [line.entry.action.value for line in left.acts]
        return [done, left.person["name"], left.variants, left.drafts, left.problems, acts]

    expected = [[True, False], ANNA.id, [], [], [], ["link_made", "person_erased"]]
    assert asyncio.run(erased()) == expected
