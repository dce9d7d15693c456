"""Who asks: somebody signed in, a bearer token, an anonymous cookie, or nobody yet; and whether the route lets them."""

from __future__ import annotations

import re
import secrets
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from typing import Annotated
from urllib.parse import urlsplit

from fastapi import Depends, Request, Response

from server.people import sessions, tokens
from server.policy import POLICIES, CourseRole, InCourse, Role
from server.storage import Owner
from server.storage.courses import Course
from server.storage.people import Person, Session
from server.web import ids, language
from server.web.errors import Refused, printable
from server.web.limits import ADDRESS, DOCUMENTS, DOCUMENTS_OF_ADDRESS, NEWCOMERS, OWNER
from server.web.typed import repeated_name
from server.workbench import Bench, Tools

COOKIE = "grubler_practice"
COOKIE_FORM = re.compile(r"[A-Za-z0-9_-]{43}")
COOKIE_DAYS = 180
SAFE = ("GET", "HEAD", "OPTIONS")
PRINTED = ("/api/v1/reports/tmm2/{variant}.{form}", "/api/v1/task-sets/{task_set}/items/{number}/sheets.{form}")


@dataclass(frozen=True, slots=True)
class Reader:
    """The one who asks; without an owner until the first variant is dealt.

    Attributes:
        role: What the reader may do on the whole server.
        owner: Whose variants the reader answers.
        language: The reader's language.
        person: Who it is, if that is known.
        session: The session of a browser that is signed in.
        practice: The owner of what this browser practised without signing in.
        course: The course that the address belongs to, if the route's policy is one of a course.
        in_course: What the reader may do there.
    """

    role: Role
    owner: Owner | None
    language: str
    person: Person | None = None
    session: Session | None = None
    practice: Owner | None = None
    course: Course | None = None
    in_course: CourseRole | None = None

    @property
    def owner_id(self) -> str | None:
        """Number of the owner, if there is one."""
        return self.owner.id if self.owner else None


async def _itself(bench: Bench, number: str) -> str | None:
    return number


COURSES: dict[str, Callable[[Bench, str], Awaitable[str | None]]] = {"course": _itself}  # from a number to its course


async def admit(request: Request, bench: Tools) -> Reader:
    """Let a reader in, or refuse: the policy of the route, the token, the origin of the page that posts.

    Raises:
        Refused: 401 for a bad or missing token, 403 for a role that does not suffice or a foreign page, 404 for a
            course of others, 422 for a name that stands twice in a JSON body, 429 for too many posts.
    """
    needed = POLICIES.get((request.method, request.scope["route"].path))
    if needed is None:
        raise Refused(403, "forbidden")
    reader = await _known(request, bench)
    if reader.role < (Role.STUDENT if isinstance(needed, InCourse) else needed):
        raise Refused(*((401, "token_needed") if reader.role is Role.ANONYMOUS else (403, "forbidden")))
    if bench.settings.limited:
        _take_turn(request, bench, reader.owner)
    if isinstance(needed, InCourse):
        reader = await in_course(bench, reader, needed, request.path_params[needed.by])
    if getattr(request.scope["route"], "body_field", None) is not None:
        _no_name_twice(await request.body())
    request.state.reader = reader
    return reader


def _no_name_twice(body: bytes) -> None:
    twice = repeated_name(body)
    if twice is not None:
        raise Refused(422, "repeated_name", field=printable(twice), name=printable(twice))


async def in_course(bench: Bench, reader: Reader, needed: InCourse, number: str) -> Reader:
    """Find the course and the reader's role in it; those outside cannot tell a course from none.

    Raises:
        Refused: 404, no such course here; 403, the role there does not suffice.
    """
    found = await COURSES[needed.by](bench, number) if ids.known(number) else None
    course = await bench.courses.course(found) if found else None
    role = await role_in(bench, reader, course) if course else None
    if role is None:
        raise Refused(404, "unknown_course")
    if role < needed.role:
        raise Refused(403, "forbidden")
    return replace(reader, course=course, in_course=role)


async def role_in(bench: Bench, reader: Reader, course: Course) -> CourseRole | None:
    """Give the role in a course; a token that was made for less than its person may do less."""
    if reader.role is Role.ADMINISTRATOR:
        return CourseRole.LECTURER
    named = await bench.courses.role(course.id, reader.person.id) if reader.person else None
    if named is None:
        return None
    narrowed = reader.session is None and reader.role is Role.STUDENT
    return CourseRole.STUDENT if narrowed else CourseRole[named.upper()]


def _take_turn(request: Request, bench: Bench, owner: Owner | None) -> None:
    """Count a post, or a document, of its owner and of its address, which behind a proxy is not known."""
    printed = request.scope["route"].path in PRINTED
    if request.method in SAFE and not printed:
        return
    own, of_address = (DOCUMENTS, DOCUMENTS_OF_ADDRESS) if printed else (OWNER, ADDRESS)
    turns = [(own, owner.id)] if owner else []
    if request.client is not None and bench.settings.public_url is None and (owner is None or owner.anonymous):
        turns += [(of_address, request.client.host)] + ([] if owner else [(NEWCOMERS, request.client.host)])
    seconds = max((bench.limiter.wait(rate, name) for rate, name in turns), default=0)
    if seconds:
        raise Refused(429, "too_many", headers={"Retry-After": str(seconds)}, seconds=seconds)


Asking = Annotated[Reader, Depends(admit)]


async def _known(request: Request, bench: Bench) -> Reader:
    spoken = language.of(request)
    authorization = request.headers.get("authorization")
    if authorization is not None:
        return await _bearer(authorization, bench, spoken)
    if request.method not in SAFE:
        _check_origin(request, bench)
    kept = request.cookies.get(cookie_name(bench), "")
    owner = Owner(ids.digest(kept.encode()), anonymous=True) if COOKIE_FORM.fullmatch(kept) else None
    signed_in = await sessions.found(request, bench)
    if signed_in is None:
        return Reader(Role.ANONYMOUS, owner, spoken, practice=owner)
    session, person = signed_in
    return Reader(Role[person.role.upper()], _owned_by(person), spoken, person, session, owner)


def _owned_by(person: Person) -> Owner:
    return Owner(person.id, anonymous=False)


async def _bearer(authorization: str, bench: Bench, spoken: str) -> Reader:
    scheme, _, token = authorization.partition(" ")
    try:
        if scheme.lower() != "bearer":
            raise tokens.BadToken(scheme)
        role, subject = tokens.read(token.strip(), bench.secret)
        number = tokens.number_of(subject)
        if number is not None:
            return await _token_of_a_person(number, bench, role, spoken)
    except tokens.BadToken:
        raise Refused(401, "bad_token", headers={"WWW-Authenticate": "Bearer"}) from None
    return Reader(role, Owner(ids.digest(b"subject", subject.encode()), anonymous=False), spoken)


async def _token_of_a_person(number: str, bench: Bench, role: Role, spoken: str) -> Reader:
    """A person's token may do what it was made for, at most what the person may do now.

    Raises:
        BadToken: It is revoked or expired, or its person may no longer sign in.
    """
    found = await bench.people.token(number)
    if found is None or found[0].revoked or found[0].expires <= datetime.now(UTC) or not found[1].active:
        raise tokens.BadToken(number)
    person = found[1]
    return Reader(min(role, Role[person.role.upper()]), _owned_by(person), spoken, person)


def _check_origin(request: Request, bench: Bench) -> None:
    """A browser tells from which page it posts; a page of another site may not use our cookies."""
    origin, site = request.headers.get("origin"), request.headers.get("sec-fetch-site")
    ours = {request.headers.get("host"), urlsplit(bench.settings.public_url or "").netloc}
    foreign = origin is not None and (not urlsplit(origin).netloc or urlsplit(origin).netloc not in ours)
    if foreign or site in ("cross-site", "same-site"):
        raise Refused(403, "foreign_page")


def cookie_name(bench: Bench) -> str:
    """Give the name of the practice cookie; the prefix binds it to this host where https allows that."""
    return f"__Host-{COOKIE}" if bench.settings.https else COOKIE


def welcome(reader: Reader, bench: Bench) -> tuple[Owner, str | None]:
    """Give the owner of what is dealt now, and the cookie to set when the owner is new."""
    if reader.owner is not None:
        return reader.owner, None
    cookie = secrets.token_urlsafe(32)
    return Owner(ids.digest(cookie.encode()), anonymous=True), cookie


def remember(response: Response, bench: Bench, cookie: str | None) -> None:
    """Give a new owner the cookie that owns the variants."""
    if cookie is not None:
        age = COOKIE_DAYS * 24 * 3600
        response.set_cookie(
            cookie_name(bench), cookie, max_age=age, httponly=True, samesite="lax", secure=bench.settings.https
        )
