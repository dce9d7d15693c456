"""People for programs: signing in, sessions, tokens, taking practice over."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Request, Response
from pydantic import BaseModel, ConfigDict, Field

from server.audit import acts
from server.people import identity, sessions, tokens
from server.policy import Role
from server.reader import Asking, Reader, admit
from server.storage.audit import Action
from server.storage.people import Person, Session, Token
from server.web import ids
from server.web.errors import Failure, Refused
from server.web.typed import Typed
from server.workbench import Bench, Tools

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["people"])
REFUSED: dict[int | str, dict[str, Any]] = {status: {"model": Failure} for status in (401, 403, 422)}
MOST_DAYS = 366


class Strict(BaseModel):
    """A body with these fields and no others."""

    model_config = ConfigDict(extra="forbid")


class SignIn(Strict):
    """An index number or e-mail, and the password."""

    login: Typed
    password: Typed


class Join(Strict):
    """A join code; who is not signed in says who they are besides."""

    code: Typed
    login: Typed = ""
    name: Typed = ""
    password: Typed = ""


class NewToken(Strict):
    """What a token is for, what it may do at most, and for how many days."""

    name: Annotated[Typed, Field(min_length=1, max_length=80)]
    role: Typed = "student"
    days: Annotated[int, Field(ge=1, le=MOST_DAYS)] = 30


class ShownPerson(BaseModel):
    """A person."""

    id: str
    login: str | None
    name: str
    role: str


class ShownSession(BaseModel):
    """A session; `current` is the one that asks."""

    id: str
    created: datetime
    last_used: datetime
    expires: datetime
    agent: str
    current: bool


class ShownToken(BaseModel):
    """A token of a program, without the token itself."""

    id: str
    name: str
    role: str
    created: datetime
    expires: datetime
    revoked: datetime | None


class MadeToken(ShownToken):
    """A token that was just made; it is shown this once."""

    token: str


class TakenOver(BaseModel):
    """How many variants are this person's from now on."""

    variants: int


@router.post("/sessions", status_code=201, responses=REFUSED | {429: {"model": Failure}})
async def sign_in(body: SignIn, request: Request, response: Response, bench: Tools) -> ShownPerson:
    """Sign in: the session is in the cookie of the response."""
    person = await identity.sign_in(request, bench, body.login, body.password)
    await sessions.begin(request, response, bench, person)
    identity.remember_device(response, bench, person)
    return shown_person(person)


@router.get("/sessions", responses=REFUSED)
async def list_sessions(bench: Tools, reader: Asking) -> list[ShownSession]:
    """List one's own sessions."""
    found = await bench.people.sessions(signed_in(reader).id)
    return [_shown_session(session, reader) for session in found]


@router.delete("/sessions/{session}", status_code=204, responses=REFUSED | {404: {"model": Failure}})
async def end_session(session: str, request: Request, response: Response, bench: Tools, reader: Asking) -> None:
    """End one of one's own sessions; `current` is this one."""
    if session == "current" and reader.session:
        await sessions.end(request, response, bench)
        return
    await end(bench, reader, session)


@router.get("/me", responses=REFUSED)
async def show_me(reader: Asking) -> ShownPerson:
    """Tell who is signed in."""
    return shown_person(themselves(reader))


@router.get("/tokens", responses=REFUSED)
async def list_tokens(bench: Tools, reader: Asking) -> list[ShownToken]:
    """List one's own tokens."""
    return [_shown_token(token) for token in await bench.people.tokens(signed_in(reader).id)]


@router.post("/tokens", status_code=201, responses=REFUSED)
async def make_token(body: NewToken, bench: Tools, reader: Asking) -> MadeToken:
    """Make a token for a program. Only who is signed in can: a token makes no tokens."""
    token, text = await new_token(bench, reader, body.name, body.role, body.days)
    return MadeToken(token=text, **_shown_token(token).model_dump())


@router.delete("/tokens/{token}", status_code=204, responses=REFUSED | {404: {"model": Failure}})
async def revoke_token(token: str, bench: Tools, reader: Asking) -> None:
    """End one of one's own tokens."""
    await revoke(bench, reader, token)


@router.post("/practice", responses=REFUSED)
async def take_practice(bench: Tools, reader: Asking) -> TakenOver:
    """Take over what this browser practised before signing in."""
    return TakenOver(variants=await take_over(bench, reader))


@router.post("/join", status_code=201, responses=REFUSED | {status: {"model": Failure} for status in (404, 409, 429)})
async def join(body: Join, request: Request, response: Response, bench: Tools, reader: Asking) -> ShownPerson:
    """Join a course by its code, and sign up where nobody is signed in."""
    newcomer = identity.Newcomer(body.login, body.name, body.password) if body.login else None
    person = await identity.join(request, bench, reader, body.code, newcomer)
    if reader.person is None:
        await sessions.begin(request, response, bench, person)
    return shown_person(person)


def themselves(reader: Reader) -> Person:
    """Give the person who asks; a token of the command line is nobody's.

    Raises:
        Refused: 403, nobody is signed in.
    """
    if reader.person is None:
        raise Refused(403, "person_needed")
    return reader.person


def signed_in(reader: Reader) -> Person:
    """Give the person who is signed in: sessions, tokens and the password are not for programs.

    Raises:
        Refused: 403, nobody is, or a token asks.
    """
    if reader.session is None:
        raise Refused(403, "person_needed")
    return themselves(reader)


async def end(bench: Bench, reader: Reader, session: str) -> None:
    """End one of one's own sessions; raises Refused where there is none."""
    if len(session) != 16 or not await bench.people.end(signed_in(reader).id, session):
        raise Refused(404, "unknown_session")


async def new_token(bench: Bench, reader: Reader, name: str, role: str, days: int) -> tuple[Token, str]:
    """Make a token of the person who asks; raises Refused where it would do more than the person may."""
    person = signed_in(reader)
    wanted = Role.__members__.get(role.upper())
    if wanted is None or not Role.ANONYMOUS < wanted <= reader.role:
        raise Refused(403, "forbidden", field="role")
    now = datetime.now(UTC)
    token = Token(ids.new(), person.id, identity.name_of(name)[:80], role.lower(), now, now + timedelta(days=days))
    await bench.people.keep_token(token, acts.entry(reader, Action.TOKEN_MADE, token.id, role=token.role, days=days))
    return token, tokens.of_person(token.id, wanted, bench.secret, days * 24)


async def revoke(bench: Bench, reader: Reader, token: str) -> None:
    """End one of one's own tokens; raises Refused where there is none."""
    entry = acts.entry(reader, Action.TOKEN_REVOKED, token[:64])
    if not await bench.people.revoke(signed_in(reader).id, token, datetime.now(UTC), entry):
        raise Refused(404, "unknown_token")


async def take_over(bench: Bench, reader: Reader) -> int:
    """Take over what this browser practised before signing in; gives how many variants."""
    person = themselves(reader)
    return await bench.storage.take_over(reader.practice.id, person.id) if reader.practice else 0


def shown_person(person: Person) -> ShownPerson:
    """Describe a person."""
    return ShownPerson(id=person.id, login=person.login, name=person.name, role=person.role)


def _shown_session(session: Session, reader: Reader) -> ShownSession:
    return ShownSession(
        id=session.number, created=session.created, last_used=session.last_used, expires=session.expires,
        agent=session.agent, current=reader.session is not None and session.digest == reader.session.digest,
    )  # fmt: skip


def _shown_token(token: Token) -> ShownToken:
    return ShownToken(
        id=token.id, name=token.name, role=token.role, created=token.created, expires=token.expires,
        revoked=token.revoked,
    )  # fmt: skip
