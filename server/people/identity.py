"""Signing in, joining a course, using a one-time link: what pages and programs do alike."""

from __future__ import annotations

import secrets
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from hmac import compare_digest
from hmac import digest as hmac

from fastapi import Request, Response

from server.people import passwords
from server.reader import Reader
from server.settings import Settings
from server.storage.courses import Course
from server.storage.people import Link, People, Person
from server.web import ids
from server.web.errors import Refused
from server.web.limits import ALL_TRIES, TRIES, TRIES_FROM_ANYWHERE
from server.workbench import Bench

KNOWN = "grubler_known"  # a browser in which this person has signed in before
KNOWN_DAYS = 180
LINK_LASTS = timedelta(days=7)
MOST_LOGIN, MOST_NAME = 80, 120


@dataclass(frozen=True, slots=True)
class Newcomer:
    """What somebody new tells about themselves."""

    login: str
    name: str
    password: str


async def sign_in(request: Request, bench: Bench, login: str, password: str) -> Person:
    """Find the person of a login and a password.

    Raises:
        Refused: 401, and whether there is such an account cannot be told; 429 for too many tries.
    """
    wanted = login.strip().casefold()[:MOST_LOGIN]
    _take_try(request, bench, wanted)
    person = await bench.people.by_login(wanted)
    fits = await bench.passwords.fits(password, person.password if person else None)
    if person is None or not fits or not person.active:
        raise Refused(401, "wrong_sign_in")
    return person


def _take_try(request: Request, bench: Bench, login: str) -> None:
    """Count a try. Strangers who try many passwords of a person do not lock out a browser the person has used."""
    known = _known_device(request, bench, login)
    address = request.client.host if request.client and bench.settings.public_url is None else "proxy"
    turns = [(TRIES, f"{login} {known or address}"), (ALL_TRIES, "all tries")]
    turns += [] if known else [(TRIES_FROM_ANYWHERE, f"{login} anywhere")]
    seconds = max(bench.limiter.wait(rate, name) for rate, name in turns) if bench.settings.limited else 0
    if seconds:
        raise Refused(429, "too_many_tries", headers={"Retry-After": str(seconds)}, seconds=seconds)


def _known_device(request: Request, bench: Bench, login: str) -> str | None:
    nonce, _, seal = request.cookies.get(KNOWN, "")[:200].partition(".")
    return nonce if compare_digest(seal.encode(), _seal(bench, nonce, login).encode()) else None


def _seal(bench: Bench, nonce: str, login: str) -> str:
    return hmac(bench.secret, ids.digest(b"known browser", nonce.encode(), login.encode()).encode(), "sha256").hex()


def remember_device(response: Response, bench: Bench, person: Person) -> None:
    """Note in this browser that the person has signed in with it."""
    nonce = secrets.token_hex(12)
    value, age = f"{nonce}.{_seal(bench, nonce, person.login or '')}", KNOWN_DAYS * 24 * 3600
    response.set_cookie(KNOWN, value, max_age=age, httponly=True, samesite="lax", secure=bench.settings.https)


async def join(request: Request, bench: Bench, reader: Reader, code: str, newcomer: Newcomer | None) -> Person:
    """Make somebody a student of the course with a join code, and sign up who is not signed in.

    Raises:
        Refused: 404 for a code of no course, 401 where somebody new is not told about, 409 for an index number that
            somebody has already, 422 for what cannot be used, 429 for too many tries.
    """
    course = await coded(bench, code)
    person = reader.person
    if person is None:
        if newcomer is None:
            raise Refused(401, "token_needed")
        person = await _signed_up(request, bench, course, newcomer)
    await bench.courses.join(course.id, person.id, "student", datetime.now(UTC))
    return person


async def coded(bench: Bench, code: str) -> Course:
    """Give the course of a join code; raises Refused where there is none."""
    course = await bench.courses.by_code(code.strip().upper()[:16])
    if course is None:
        raise Refused(404, "unknown_code")
    return course


async def _signed_up(request: Request, bench: Bench, course: Course, newcomer: Newcomer) -> Person:
    """Sign somebody up, or give a first password to a person whom the roster of this very course names.

    The name of the roster stays: whoever types the number does not change whose marks these are.
    """
    login, name = login_of(newcomer.login), name_of(newcomer.name)
    check_password(newcomer.password, login)
    _take_try(request, bench, login)
    hashed = await bench.passwords.hashed(newcomer.password)
    person = Person(ids.new(), login, name, "student", datetime.now(UTC), hashed)
    if await bench.people.add(person):
        return person
    there = await bench.people.by_login(login)
    if there is None or not await _claimed(bench, course, there, hashed):
        raise Refused(409, "taken_login", field="login")
    return there


async def _claimed(bench: Bench, course: Course, person: Person, password: str) -> bool:
    """Give a place of the roster away by the code of the course, if its lecturer lets the code do so."""
    if not course.claims or await bench.courses.role(course.id, person.id) != "student":
        return False
    return await bench.people.claim(person.id, course.id, password, datetime.now(UTC))


async def make_link(
    people: People, settings: Settings, purpose: str, actor: str, person: Person | None = None,
    course: str | None = None,
) -> str:  # fmt: skip
    """Make a one-time link; gives its address."""
    link, address = new_link(settings, purpose, person, course)
    await people.keep_links([link], actor)
    return address


def new_link(settings: Settings, purpose: str, person: Person | None, course: str | None) -> tuple[Link, str]:
    """Draw a one-time link; gives it as it is stored, and its address, which is stored nowhere."""
    secret, now = secrets.token_urlsafe(32), datetime.now(UTC)
    link = Link(_digest(secret), purpose, person.id if person else None, course, now, now + LINK_LASTS)
    return link, f"{settings.address}/links/{secret}"


async def linked(bench: Bench, secret: str) -> Link:
    """Give the link of an address; raises Refused where there is none or it was used."""
    link = await bench.people.link(_digest(secret))
    if link is None or link.used or link.expires <= datetime.now(UTC):
        raise Refused(404, "unknown_link")
    return link


async def redeem(bench: Bench, secret: str, newcomer: Newcomer) -> Person:
    """Use a link up; raises Refused where it cannot be used or the password will not do."""
    link, now = await linked(bench, secret), datetime.now(UTC)
    if link.purpose == "first":
        return await _first(bench, secret, newcomer)
    known = await bench.people.person(link.person or "")
    check_password(newcomer.password, (known.login if known else None) or "")
    person = await bench.people.redeem(_digest(secret), now, await bench.passwords.hashed(newcomer.password))
    if person is None or not person.active:
        raise Refused(404, "unknown_link")
    return person


async def _first(bench: Bench, secret: str, newcomer: Newcomer) -> Person:
    login, name = login_of(newcomer.login), name_of(newcomer.name)
    check_password(newcomer.password, login)
    hashed, now = await bench.passwords.hashed(newcomer.password), datetime.now(UTC)
    person = Person(ids.new(), login, name, "administrator", now, hashed)
    if not await bench.people.redeem_first(_digest(secret), now, person):
        raise Refused(404, "unknown_link")
    return person


async def change_password(bench: Bench, person: Person, session: str, old: str, new: str) -> None:
    """Change a password; all sessions but one end.

    Raises:
        Refused: 401 for a wrong old password, 422 for a new one that will not do.
    """
    check_password(new, person.login or "")
    if person.password is not None and not await bench.passwords.fits(old, person.password):
        raise Refused(401, "wrong_sign_in", field="old")
    await bench.people.set_password(person.id, await bench.passwords.hashed(new), session)


def login_of(text: str) -> str:
    """Give an index number or e-mail as it is stored.

    Raises:
        Refused: 422, it is empty, too long, or holds spaces or control characters.
    """
    login = text.strip().casefold()
    if not 1 <= len(login) <= MOST_LOGIN or not login.isprintable() or " " in login or login[0] in "=+-@":
        raise Refused(422, "bad_login", field="login")
    return login


def name_of(text: str) -> str:
    """Give a name as it is stored.

    Raises:
        Refused: 422, it is empty, too long, or holds control characters.
    """
    name = " ".join(text.split())
    if not 1 <= len(name) <= MOST_NAME or not name.isprintable() or name[0] in "=+-@":
        raise Refused(422, "bad_name", field="name")
    return name


def check_password(password: str, login: str) -> None:
    """Refuse a new password that will not do."""
    if not passwords.usable(password, login):
        raise Refused(422, "weak_password", field="password", least=passwords.SHORTEST)


def _digest(secret: str) -> str:
    return ids.digest(b"link", secret.encode())
