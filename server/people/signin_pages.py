"""The pages that let people in: signing in and out, joining a course, one-time links."""

from __future__ import annotations

from typing import Annotated, Any
from urllib.parse import quote

from fastapi import APIRouter, Depends, Query, Request
from starlette.responses import HTMLResponse, RedirectResponse, Response

from server.answering import forms
from server.people import identity, sessions
from server.people.identity import Newcomer
from server.people.passwords import SHORTEST
from server.reader import Asking, Reader, admit
from server.storage.people import Person
from server.web import language
from server.web.errors import Refused
from server.web.templating import keep_preferences, page
from server.workbench import Bench, Tools

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)
Next = Annotated[str, Query(max_length=200)]
HOME = "/home"


@router.get("/signin")
async def show_signin(request: Request, reader: Asking, next: Next = HOME) -> Response:
    """Show the ways to sign in."""
    if reader.person is not None:
        return RedirectResponse(inside(next), 303)
    return _page(request, reader, "signin.html", {"next": inside(next), "login": ""})


@router.post("/signin")
async def sign_in(request: Request, bench: Tools, reader: Asking) -> Response:
    """Sign in and go on."""
    values = (await forms.read(request)).values
    login, onward = values.get("login", ""), inside(values.get("next", HOME))
    try:
        person = await identity.sign_in(request, bench, login, values.get("password", ""))
    except Refused as refused:
        return _page(request, reader, "signin.html", {"next": onward, "login": login[:80]}, refused)
    return await let_in(request, bench, person, onward)


@router.post("/signout")
async def sign_out(request: Request, bench: Tools) -> Response:
    """Sign this browser out; drafts it kept are not there for the next person at the same computer."""
    response = RedirectResponse("/", 303, {"Clear-Site-Data": '"storage"'})
    await sessions.end(request, response, bench)
    return response


@router.get("/join")
async def show_code(request: Request, reader: Asking, code: Annotated[str, Query(max_length=40)] = "") -> Response:
    """Take the code of a course."""
    if code.strip():
        return RedirectResponse(f"/join/{quote(code.strip().upper(), safe='')}", 303)
    return RedirectResponse("/home" if reader.person else "/signin", 303)


@router.get("/join/{code}")
async def show_join(code: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Show which course is joined, and ask who joins."""
    return await _join_page(code, request, bench, reader, {})


@router.post("/join/{code}")
async def join(code: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Join a course and go there."""
    values = (await forms.read(request)).values
    try:
        person = await identity.join(request, bench, reader, code, None if reader.person else _newcomer(values))
    except Refused as refused:
        if refused.status_code == 404:
            raise
        return await _join_page(code, request, bench, reader, values, refused)
    if reader.person is not None:
        return RedirectResponse(HOME, 303)
    return await let_in(request, bench, person, HOME)


@router.get("/links/{link}")
async def show_link(link: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Show what a one-time link is for; only the form uses it up."""
    return await _link_page(link, request, bench, reader, {})


@router.post("/links/{link}")
async def use_link(link: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Set a password by a one-time link and sign in."""
    values = (await forms.read(request)).values
    try:
        person = await identity.redeem(bench, link, _newcomer(values))
    except Refused as refused:
        if refused.status_code == 404:
            raise
        return await _link_page(link, request, bench, reader, values, refused)
    return await let_in(request, bench, person, HOME)


async def let_in(request: Request, bench: Bench, person: Person, onward: str) -> Response:
    """Begin a session in this browser and go on, in the language that the person prefers."""
    response = RedirectResponse(onward, 303)
    await sessions.begin(request, response, bench, person)
    identity.remember_device(response, bench, person)
    keep_preferences(response, bench.settings.https, person.language, person.theme)
    return response


def inside(path: str) -> str:
    """Give an address of this server back; any other becomes the home page."""
    ours = path.startswith("/") and not path.startswith("//") and path.isprintable() and "\\" not in path
    return path if ours else HOME


def _newcomer(values: Any) -> Newcomer:
    return Newcomer(values.get("login", ""), values.get("name", ""), values.get("password", ""))


async def _join_page(
    code: str, request: Request, bench: Bench, reader: Reader, values: Any, refused: Refused | None = None
) -> HTMLResponse:
    course = await identity.coded(bench, code)
    context = {"course": course, "code": course.join_code, "person": reader.person, **_typed(values)}
    return _page(request, reader, "join.html", context, refused)


async def _link_page(
    link: str, request: Request, bench: Bench, reader: Reader, values: Any, refused: Refused | None = None
) -> HTMLResponse:
    found = await identity.linked(bench, link)
    person = await bench.people.person(found.person) if found.person else None
    context = {"link": link, "first": found.purpose == "first", "person": person, **_typed(values)}
    return _page(request, reader, "link.html", context, refused)


def _typed(values: Any) -> dict[str, str]:
    return {"login": values.get("login", "")[:80], "name": values.get("name", "")[:120]}


def _page(
    request: Request, reader: Reader, name: str, context: dict[str, Any], refused: Refused | None = None
) -> HTMLResponse:
    """Render a page; what was refused is said above the form, and what was typed stands in it again."""
    told: dict[str, Any] = {"problem": None, "wait": None, "least": SHORTEST}
    told["oidc"] = request.app.state.settings.provider is not None
    if refused is not None:
        told["problem"] = language.say(reader.language, f"errors.{refused.code}", **refused.values)
        told["wait"] = (refused.headers or {}).get("Retry-After")
    made = page(request, reader.language, name, context | told, status=refused.status_code if refused else 200)
    made.headers.update((refused.headers or {}) if refused else {})
    return made
