"""The pages of somebody who is signed in: home, and the account with its sessions and tokens."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Any

from fastapi import APIRouter, Depends, Request
from starlette.responses import HTMLResponse, RedirectResponse, Response

from server.answering import forms
from server.courses import api as courses
from server.courses import zones
from server.people import api as people
from server.people import identity, sessions
from server.people.agents import called
from server.people.passwords import SHORTEST
from server.policy import Role
from server.reader import Asking, Reader, admit
from server.sets import clock, home
from server.web import language
from server.web.errors import Refused
from server.web.templating import THEMES, keep_preferences, page
from server.workbench import Bench, Tools

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@router.get("/home")
async def show_home(request: Request, bench: Tools, reader: Asking) -> Response:
    """Show what waits for a student, one's own courses, and what was practised before signing in."""
    person, now = people.themselves(reader), datetime.now(UTC)
    mine = await bench.courses.of(person.id)
    sets = await home.sets_of(bench, person.id, mine, now)
    following = home.due_next(sets)
    context = {
        "courses": mine,
        "sets": sets,
        "following": following,
        "opened": await home.opened(bench, following, reader.language) if following else None,
        "remaining": clock.left(following.until, now) if following else None,
        "results": home.latest(sets),
        "local": lambda moment, course: clock.stamp(reader.language, moment, clock.zone(course.time_zone)),
        "practised": await bench.storage.practised(reader.practice.id) if reader.practice else 0,
        "lecturer": reader.role >= Role.LECTURER,
    }
    return page(request, reader.language, "home.html", context)


@router.post("/courses")
async def add_course(request: Request, bench: Tools, reader: Asking) -> Response:
    """Start a course and go there."""
    values = (await forms.read(request)).values
    zone = values.get("time_zone", "Europe/Warsaw")
    course = await courses.start(bench, reader, values.get("title", ""), values.get("language", ""), zone)
    return RedirectResponse(f"/courses/{course.id}", 303)


@router.get("/account")
async def show_account(request: Request, bench: Tools, reader: Asking) -> Response:
    """Show the account."""
    return await _account(request, bench, reader, {})


@router.post("/account")
async def change_account(request: Request, bench: Tools, reader: Asking) -> Response:
    """Keep language and appearance with the person."""
    values = (await forms.read(request)).values
    spoken, theme = values.get("language", ""), values.get("theme", "")
    if spoken not in language.LANGUAGES or theme not in THEMES:
        raise Refused(422, "out_of_range", field="language", name="language")
    await bench.people.prefer(people.signed_in(reader).id, spoken, theme)
    response = RedirectResponse("/account", 303)
    keep_preferences(response, bench.settings.https, spoken, theme)
    return response


@router.post("/account/password")
async def change_password(request: Request, bench: Tools, reader: Asking) -> Response:
    """Change the password; all other sessions end."""
    values = (await forms.read(request)).values
    person, session = people.signed_in(reader), reader.session.digest if reader.session else ""
    try:
        await identity.change_password(bench, person, session, values.get("old", ""), values.get("password", ""))
    except Refused as refused:
        said = language.say(reader.language, f"errors.{refused.code}", **refused.values)
        return await _account(request, bench, reader, {"problem": said}, refused.status_code)
    return RedirectResponse("/account", 303)


@router.post("/account/practice")
async def take_practice(bench: Tools, reader: Asking) -> Response:
    """Take over what this browser practised before signing in."""
    await people.take_over(bench, reader)
    return RedirectResponse("/home", 303)


@router.post("/account/sessions/{session}")
async def end_session(session: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """End a session."""
    if reader.session and session == reader.session.number:
        response = RedirectResponse("/", 303)
        await sessions.end(request, response, bench)
        return response
    await people.end(bench, reader, session)
    return RedirectResponse("/account", 303)


@router.post("/account/tokens")
async def make_token(request: Request, bench: Tools, reader: Asking) -> Response:
    """Make a token and show it once."""
    values = (await forms.read(request)).values
    days = values.get("days", "")
    if not (days.isascii() and days.isdecimal() and len(days) <= 3 and 1 <= int(days) <= people.MOST_DAYS):
        raise Refused(422, "out_of_range", field="days", name="days")
    _, text = await people.new_token(bench, reader, values.get("name", ""), values.get("role", ""), int(days))
    return await _account(request, bench, reader, {"fresh_token": text})


@router.post("/account/tokens/{token}")
async def revoke_token(token: str, bench: Tools, reader: Asking) -> Response:
    """End a token."""
    await people.revoke(bench, reader, token)
    return RedirectResponse("/account", 303)


async def _account(
    request: Request, bench: Bench, reader: Reader, more: dict[str, Any], status: int = 200
) -> HTMLResponse:
    person = people.signed_in(reader)
    context = {
        "person": person,
        "sessions": await bench.people.sessions(person.id),
        "called": called,
        "current": reader.session.digest if reader.session else "",
        "tokens": await bench.people.tokens(person.id),
        "roles": [role.name.lower() for role in Role if Role.ANONYMOUS < role <= reader.role],
        "least": SHORTEST,
        "oidc": bench.settings.provider is not None and person.issuer is None,
        "problem": None,
        "fresh_token": None,
        **zones.told(reader.language, await zones.of_reader(bench, reader)),
    }
    return page(request, reader.language, "account.html", context | more, status=status, path="/account")
