"""Signing in leaves a cookie; the store knows its digest, so the cookie can be ended but not read."""

from __future__ import annotations

import re
import secrets
from datetime import UTC, datetime, timedelta

from fastapi import Request, Response

from server.storage.people import Person, Session
from server.web import ids
from server.workbench import Bench

COOKIE = "grubler_session"
FORM = re.compile(r"[A-Za-z0-9_-]{43}")
LASTS = timedelta(days=14)
IDLE = timedelta(days=5)  # a session that is not used ends earlier
NOTED = timedelta(minutes=10)  # how exactly the last use is noted


def cookie_name(bench: Bench) -> str:
    """Give the name of the cookie; the prefix binds it to this host where https allows that."""
    return f"__Host-{COOKIE}" if bench.settings.https else COOKIE


async def begin(request: Request, response: Response, bench: Bench, person: Person) -> Session:
    """Sign a person in under a fresh cookie; the session that this browser had before ends."""
    await _end(request, bench)
    cookie, now = secrets.token_urlsafe(32), datetime.now(UTC)
    agent = request.headers.get("user-agent", "")[:200]
    session = Session(ids.digest(b"session", cookie.encode()), person.id, now, now, now + LASTS, agent)
    await bench.people.begin(session)
    age, secure = int(LASTS.total_seconds()), bench.settings.https
    response.set_cookie(cookie_name(bench), cookie, max_age=age, httponly=True, samesite="lax", secure=secure)
    return session


async def end(request: Request, response: Response, bench: Bench) -> None:
    """Sign this browser out."""
    await _end(request, bench)
    response.delete_cookie(cookie_name(bench), httponly=True, samesite="lax", secure=bench.settings.https)


async def found(request: Request, bench: Bench) -> tuple[Session, Person] | None:
    """Give the session of this browser and its person, if the session still lasts."""
    cookie = request.cookies.get(cookie_name(bench), "")
    if not FORM.fullmatch(cookie):
        return None
    kept = await bench.people.session(ids.digest(b"session", cookie.encode()))
    now = datetime.now(UTC)
    if kept is None or not kept[1].active or kept[0].expires <= now or kept[0].last_used + IDLE <= now:
        return None
    if now - kept[0].last_used > NOTED:
        await bench.people.seen(kept[0].digest, now)
    return kept


async def _end(request: Request, bench: Bench) -> None:
    signed_in = await found(request, bench)
    if signed_in is not None:
        session, person = signed_in
        await bench.people.end(person.id, session.number)
