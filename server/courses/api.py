"""Courses for programs, and what pages do alike: members, groups, join codes, rosters."""

from __future__ import annotations

import secrets
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Annotated, Any, Literal
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from fastapi import APIRouter, Depends
from pydantic import BaseModel, Field, StrictBool

from server.audit import acts
from server.courses import rosters
from server.courses.headings import Meaning
from server.people import identity
from server.people.api import REFUSED, Strict, themselves
from server.policy import CourseRole, may_change_role
from server.reader import Asking, Reader, admit
from server.storage.audit import Action, Entry
from server.storage.courses import Change, Course, Group, Member
from server.web import ids
from server.web.errors import Failure, Refused
from server.web.language import LANGUAGES
from server.web.typed import Typed
from server.workbench import Bench, Tools

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["courses"])
HERE: dict[int | str, dict[str, Any]] = REFUSED | {404: {"model": Failure}}
CODE_SIGNS = 8  # 40 random bits
CourseRoleName = Literal["student", "assistant", "lecturer"]
Title = Annotated[Typed, Field(min_length=1, max_length=200)]


class NewCourse(Strict):
    """A course: its language, and the time zone in which its dates are meant."""

    title: Title
    language: Literal["pl", "en", "ru"] = "en"
    time_zone: Annotated[Typed, Field(max_length=64)] = "Europe/Warsaw"


class NewGroup(Strict):
    """The name of a group."""

    name: Annotated[Typed, Field(min_length=1, max_length=80)]


class Place(Strict):
    """A member's role and group; what is left out stays."""

    role: CourseRoleName | None = None
    group: Typed | None = None


class Roster(Strict):
    """A roster as CSV, and whether it is to be applied or only looked at."""

    csv: Typed
    apply: StrictBool = False


class Joining(Strict):
    """Whether a course can be joined by a code."""

    open: StrictBool = True


class ShownCourse(BaseModel):
    """A course, and the reader's role in it. Only lecturers see the join code."""

    id: str
    title: str
    language: str
    time_zone: str
    role: str
    join_code: str | None
    claims: bool


class ShownGroup(BaseModel):
    """A group."""

    id: str
    name: str


class ShownMember(BaseModel):
    """A member of a course; `signed_up` tells whether there is a password yet, `claimed` when the code gave it."""

    id: str
    login: str | None
    name: str
    role: str
    group: str | None
    signed_up: bool
    claimed: datetime | None


class RosterLine(BaseModel):
    """What a line of a roster changes: new, joins, moves or same; `known` is another name the person has here."""

    login: str
    name: str
    group: str
    what: str
    known: str | None


class Unread(BaseModel):
    """A line that cannot be used; where it `repeats` the login of another line, which."""

    line: int
    code: str
    repeats: int | None = None


class Repeated(BaseModel):
    """A line that says the same as the line it `repeats`, and is passed over."""

    line: int
    repeats: int


class RosterColumn(BaseModel):
    """What a column holds, by its heading: `login`, `name`, `group`, or `unused`. A name may stand in several."""

    number: int
    heading: str
    meaning: Meaning


class Planned(BaseModel):
    """What a roster changes, line by line, and how its columns are understood; lines `above` the headings are left
    out."""

    columns: list[RosterColumn]
    above: list[int]
    changes: list[RosterLine]
    repeated: list[Repeated]
    unread: list[Unread]
    applied: bool


@router.get("/courses", responses=REFUSED)
async def list_courses(bench: Tools, reader: Asking) -> list[ShownCourse]:
    """List one's own courses."""
    found = await bench.courses.of(themselves(reader).id)
    return [shown(course, CourseRole[role.upper()]) for course, role in found]


@router.post("/courses", status_code=201, responses=REFUSED)
async def add_course(body: NewCourse, bench: Tools, reader: Asking) -> ShownCourse:
    """Start a course; who starts it is its lecturer."""
    return shown(await start(bench, reader, body.title, body.language, body.time_zone), CourseRole.LECTURER)


@router.get("/courses/{course}", responses=HERE)
async def show_course(course: str, reader: Asking) -> ShownCourse:
    """Show a course to its members."""
    seen = here(reader)
    return shown(seen.course, seen.role)


@router.post("/courses/{course}/code", responses=HERE)
async def change_code(course: str, body: Joining, bench: Tools, reader: Asking) -> ShownCourse:
    """Give a course another join code, or close joining; the old code ends."""
    await renew_code(bench, reader, body.open)
    changed = await bench.courses.course(course)
    assert changed is not None
    return shown(changed, here(reader).role)


@router.get("/courses/{course}/groups", responses=HERE)
async def list_groups(course: str, bench: Tools) -> list[ShownGroup]:
    """List the groups of a course."""
    return [ShownGroup(id=group.id, name=group.name) for group in await bench.courses.groups(course)]


@router.post("/courses/{course}/groups", status_code=201, responses=HERE | {409: {"model": Failure}})
async def add_group(course: str, body: NewGroup, bench: Tools) -> ShownGroup:
    """Add a group."""
    group = await new_group(bench, course, body.name)
    return ShownGroup(id=group.id, name=group.name)


@router.get("/courses/{course}/members", responses=HERE)
async def list_members(course: str, bench: Tools) -> list[ShownMember]:
    """List the members of a course."""
    return [_shown_member(member) for member in await bench.courses.members(course)]


@router.patch("/courses/{course}/members/{person}", responses=HERE)
async def change_member(course: str, person: str, body: Place, bench: Tools, reader: Asking) -> ShownMember:
    """Change the role or the group of a member; an empty group takes the member out of all."""
    member = await found(bench, course, person)
    group = member.group if body.group is None else body.group or None
    await place(bench, reader, member, body.role or member.role, group)
    return _shown_member(await found(bench, course, person))


@router.delete("/courses/{course}/members/{person}", status_code=204, responses=HERE)
async def take_out(course: str, person: str, bench: Tools, reader: Asking) -> None:
    """Take a member out of the course; what was handed in stays."""
    await remove(bench, reader, await found(bench, course, person))


@router.post("/courses/{course}/roster", responses=HERE)
async def import_roster(course: str, body: Roster, bench: Tools, reader: Asking) -> Planned:
    """Show what a roster would change, or change it. Everybody it names is a student; nobody is taken out."""
    changes, read = await take_roster(bench, reader, body.csv, body.apply)
    lines = [
        RosterLine(login=c.row.login, name=c.row.name, group=c.row.group, what=c.what, known=c.known) for c in changes
    ]
    columns = [RosterColumn(number=one.number, heading=one.heading, meaning=one.meaning) for one in read.columns]
    repeated = [Repeated(line=one.line, repeats=one.repeats) for one in read.repeated]
    unread = [Unread(line=line.line, code=line.code, repeats=line.repeats) for line in read.unread]
    return Planned(
        columns=columns, above=list(read.above), changes=lines, repeated=repeated, unread=unread, applied=body.apply
    )  # fmt: skip


@dataclass(frozen=True, slots=True)
class Here:
    """The course of an address and the reader's role in it."""

    course: Course
    role: CourseRole


def here(reader: Reader) -> Here:
    """Give the course that the policy of the route has found."""
    assert reader.course is not None and reader.in_course is not None
    return Here(reader.course, reader.in_course)


async def start(
    bench: Bench, reader: Reader, title: str, language: str, time_zone: str, copied: str | None = None
) -> Course:
    """Start a course; raises Refused where language or time zone is unknown."""
    if language not in LANGUAGES:
        raise Refused(422, "out_of_range", field="language", name="language")
    try:
        ZoneInfo(time_zone)
    except (ZoneInfoNotFoundError, ValueError, OSError):
        raise Refused(422, "out_of_range", field="time_zone", name="time_zone") from None
    course = Course(ids.new(), _title(title), language, time_zone, datetime.now(UTC), _new_code())
    lecturer = themselves(reader).id
    entry = Entry(lecturer, Action.COURSE_STARTED, course.id, course.id)
    if copied is not None:
        entry = Entry(lecturer, Action.COURSE_COPIED, course.id, course.id, {"from": copied})
    await bench.courses.add(course, lecturer, entry)
    return course


def _title(text: str) -> str:
    title = " ".join(text.split())
    if not 1 <= len(title) <= 200 or not title.isprintable():
        raise Refused(422, "out_of_range", field="title", name="title")
    return title


def _new_code() -> str:
    signs = "".join(secrets.choice(ids.ALPHABET) for _ in range(CODE_SIGNS))
    return f"{signs[:4]}-{signs[4:]}"


async def renew_code(bench: Bench, reader: Reader, wanted: bool) -> None:
    """Give a course another join code, or none."""
    course = here(reader).course.id
    entry = acts.entry(reader, Action.JOINING_CHANGED, course, open=wanted)
    while not await bench.courses.set_code(course, _new_code() if wanted else None, entry):
        continue


async def new_group(bench: Bench, course: str, name: str) -> Group:
    """Add a group; raises Refused where the name is taken or cannot be used."""
    group = Group(ids.new(), course, identity.name_of(name)[: rosters.MOST_GROUP])
    if not await bench.courses.add_group(group):
        raise Refused(409, "taken_group", field="name")
    return group


async def found(bench: Bench, course: str, person: str) -> Member:
    """Give a member of a course; raises Refused where there is none."""
    for member in await bench.courses.members(course):
        if member.person.id == person:
            return member
    raise Refused(404, "unknown_member")


async def place(bench: Bench, reader: Reader, member: Member, role: str, group: str | None) -> None:
    """Change role and group of a member; raises Refused for one's own role and for a group of another course."""
    if role.upper() not in CourseRole.__members__:
        raise Refused(422, "out_of_range", field="role", name="role")
    if role != member.role and not may_change_role(_actor(reader), member.person.id):
        raise Refused(403, "own_role")
    if role == member.role:
        entry = acts.entry(reader, Action.MEMBER_CHANGED, member.person.id, group=group)
    else:
        entry = acts.entry(reader, Action.ROLE_CHANGED, member.person.id, role=role, before=member.role)
    if not await bench.courses.change(here(reader).course.id, member.person.id, role, group, entry):
        raise Refused(404, "unknown_group", field="group")


async def remove(bench: Bench, reader: Reader, member: Member) -> None:
    """Take a member out; raises Refused for oneself."""
    if not may_change_role(_actor(reader), member.person.id):
        raise Refused(403, "own_role")
    entry = acts.entry(reader, Action.MEMBER_REMOVED, member.person.id, role=member.role)
    await bench.courses.leave(here(reader).course.id, member.person.id, entry)


async def take_roster(bench: Bench, reader: Reader, text: str, apply: bool) -> tuple[Sequence[Change], rosters.Reading]:
    """Show what a roster changes, or change it; a roster with lines that cannot be used changes nothing.

    Raises:
        Refused: 422, it is to be applied and some line cannot be used, or it is empty or too long.
    """
    read = rosters.read(text)
    if not read.rows and not read.unread:
        raise Refused(422, "empty_roster", field="csv")
    if apply and read.unread:
        raise Refused(422, "unread_roster", field="csv", line=read.unread[0].line)
    course, now = here(reader).course.id, datetime.now(UTC)
    return await bench.courses.roster(course, read.rows, now, apply, acts.actor_of(reader)), read


def _actor(reader: Reader) -> str | None:
    return reader.person.id if reader.person else None


def shown(course: Course, role: CourseRole) -> ShownCourse:
    """Describe a course to a member."""
    code = course.join_code if role is CourseRole.LECTURER else None
    return ShownCourse(
        id=course.id, title=course.title, language=course.language, time_zone=course.time_zone,
        role=role.name.lower(), join_code=code, claims=course.claims,
    )  # fmt: skip


def _shown_member(member: Member) -> ShownMember:
    person = member.person
    return ShownMember(
        id=person.id, login=person.login, name=person.name, role=member.role, group=member.group,
        signed_up=person.signed_up, claimed=member.claimed,
    )  # fmt: skip
