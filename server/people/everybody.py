"""Everybody on the server, for administrators: finding, roles, closing accounts, links, ending sessions."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Annotated, Literal
from urllib.parse import quote

from fastapi import APIRouter, Depends, Query
from pydantic import BaseModel, StrictBool

from server.audit import acts
from server.courses.api import ShownCourse, shown
from server.people import identity
from server.people.access import MadeLink
from server.people.api import ShownPerson, Strict
from server.people.personal import GONE
from server.policy import CourseRole, Role
from server.reader import Asking, Reader, admit
from server.storage.audit import Action
from server.storage.people import Person
from server.web.errors import Refused
from server.workbench import Bench, Tools

AT_ONCE = 50  # people on one page
MOST_PAGES = 100_000

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["people"])
Sought = Annotated[str, Query(max_length=120)]
Page = Annotated[int, Query(ge=1, le=MOST_PAGES)]


class ListedPerson(ShownPerson):
    """A person as an administrator sees one."""

    active: bool
    erased: datetime | None
    signed_up: bool
    created: datetime


class Found(BaseModel):
    """People by name; `next` leads to more."""

    people: list[ListedPerson]
    next: str | None


class WholePerson(ListedPerson):
    """A person with courses, and how many sessions and tokens are open."""

    courses: list[ShownCourse]
    sessions: int
    tokens: int


class ChangedPerson(Strict):
    """Another role, or whether the person may sign in; what is left out stays."""

    role: Literal["student", "lecturer", "administrator"] | None = None
    active: StrictBool | None = None


@router.get("/people", responses=GONE)
async def find_people(bench: Tools, q: Sought = "", page: Page = 1) -> Found:
    """Find people by the beginning of the login or by a part of the name."""
    people, more = await found(bench, q, page)
    following = f"/api/v1/people?q={quote(q, safe='')}&page={page + 1}" if more else None
    return Found(people=[listed(person) for person in people], next=following)


@router.get("/people/{person}", responses=GONE)
async def show_person(person: str, bench: Tools) -> WholePerson:
    """Show a person."""
    return await whole(bench, await known(bench, person))


@router.patch("/people/{person}", responses=GONE)
async def change_person(person: str, body: ChangedPerson, bench: Tools, reader: Asking) -> WholePerson:
    """Change the role of a person on the server, close the account or open it again; not one's own."""
    await change(bench, reader, await known(bench, person), body.role, body.active)
    return await whole(bench, await known(bench, person))


@router.post("/people/{person}/link", status_code=201, responses=GONE)
async def link_person(person: str, bench: Tools, reader: Asking) -> MadeLink:
    """Make a one-time link with which a person sets a password."""
    return MadeLink(link=await let_in_again(bench, reader, await known(bench, person)))


@router.delete("/people/{person}/sessions", status_code=204, responses=GONE)
async def end_sessions(person: str, bench: Tools, reader: Asking) -> None:
    """End all sessions, tokens and unused links of a person."""
    await end_all(bench, reader, await known(bench, person))


async def found(bench: Bench, text: str, page: int) -> tuple[list[Person], bool]:
    """Find people; gives those of a page, and whether there are more."""
    people = list(await bench.people.find(text, (page - 1) * AT_ONCE, AT_ONCE + 1))
    return people[:AT_ONCE], len(people) > AT_ONCE


async def known(bench: Bench, number: str) -> Person:
    """Give a person; raises Refused where there is none."""
    person = await bench.people.person(number)
    if person is None:
        raise Refused(404, "unknown_person")
    return person


async def change(bench: Bench, reader: Reader, person: Person, role: str | None, active: bool | None) -> None:
    """Change role and access of a person; raises Refused for one's own, so that one administrator stays, and for
    somebody who was erased."""
    others = person.id != (reader.person.id if reader.person else None)
    if not others and (role not in (None, person.role) or active is False):
        raise Refused(403, "own_role")
    if person.erased and (active or role not in (None, person.role)):
        raise Refused(403, "erased_person")
    if role is not None and role != person.role:
        entry = acts.entry(reader, Action.ROLE_CHANGED, person.id, role=role, before=person.role)
        await bench.people.set_role(person.id, role, entry)
    if active is not None and active != person.active:
        act = Action.PERSON_ENABLED if active else Action.PERSON_DISABLED
        await bench.people.set_active(person.id, active, acts.entry(reader, act, person.id))


async def let_in_again(bench: Bench, reader: Reader, person: Person) -> str:
    """Make a one-time link for a person; raises Refused where the account is closed or erased."""
    if not person.active:
        raise Refused(403, "closed_account")
    purpose = "reset" if person.password else "join"
    return await identity.make_link(bench.people, bench.settings, purpose, acts.actor_of(reader), person)


async def end_all(bench: Bench, reader: Reader, person: Person) -> None:
    """End all sessions, tokens and unused links of a person."""
    await bench.people.end_all(person.id, datetime.now(UTC), acts.entry(reader, Action.SESSIONS_ENDED, person.id))


def listed(person: Person) -> ListedPerson:
    """Describe a person to an administrator."""
    return ListedPerson(
        id=person.id, login=person.login, name=person.name, role=person.role, active=person.active,
        erased=person.erased, signed_up=person.signed_up, created=person.created,
    )  # fmt: skip


async def whole(bench: Bench, person: Person) -> WholePerson:
    """Describe a person with courses, sessions and tokens."""
    now = datetime.now(UTC)
    courses = [shown(course, CourseRole[role.upper()]) for course, role in await bench.courses.of(person.id)]
    tokens = [one for one in await bench.people.tokens(person.id) if one.revoked is None and one.expires > now]
    sessions = [one for one in await bench.people.sessions(person.id) if one.expires > now]
    return WholePerson(
        **listed(person).model_dump(), courses=courses, sessions=len(sessions), tokens=len(tokens)
    )  # fmt: skip


ROLES = tuple(role.name.lower() for role in Role if role > Role.ANONYMOUS)
