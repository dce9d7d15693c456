"""Pages of everybody on the server, for administrators."""

from __future__ import annotations

from typing import Any

from fastapi import APIRouter, Depends, Request
from starlette.responses import HTMLResponse, RedirectResponse, Response

from server.answering import forms
from server.audit import acts
from server.people import everybody, personal
from server.people.everybody import Page, Sought
from server.reader import Asking, Reader, admit
from server.web.errors import Refused
from server.web.templating import page as made
from server.workbench import Bench, Tools

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@router.get("/people")
async def show_people(request: Request, bench: Tools, reader: Asking, q: Sought = "", page: Page = 1) -> HTMLResponse:
    """Find people."""
    people, more = await everybody.found(bench, q, page)
    context = {"people": people, "sought": q, "at": page, "more": more}
    return made(request, reader.language, "people.html", context)


@router.get("/people/{person}")
async def show_person(person: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Show a person."""
    return await _person(person, request, bench, reader, {})


@router.post("/people/{person}")
async def change_person(person: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Change role or access of a person."""
    values = (await forms.read(request)).values
    role, active = values.get("role"), values.get("active")
    if role not in (None, *everybody.ROLES) or active not in (None, "yes", "no"):
        raise Refused(422, "out_of_range", field="role", name="role")
    wanted = None if active is None else active == "yes"
    await everybody.change(bench, reader, await everybody.known(bench, person), role, wanted)
    return RedirectResponse(f"/people/{person}", 303)


@router.post("/people/{person}/link")
async def link_person(person: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Make a one-time link for a person and show it once."""
    link = await everybody.let_in_again(bench, reader, await everybody.known(bench, person))
    return await _person(person, request, bench, reader, {"made": link})


@router.post("/people/{person}/sessions")
async def end_sessions(person: str, bench: Tools, reader: Asking) -> Response:
    """End all sessions and tokens of a person."""
    await everybody.end_all(bench, reader, await everybody.known(bench, person))
    return RedirectResponse(f"/people/{person}", 303)


@router.post("/people/{person}/erase")
async def erase_person(person: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Erase a person, where the number was typed to confirm it."""
    typed = (await forms.read(request)).values.get("number", "").strip().upper()
    found = await everybody.known(bench, person)
    if typed != found.id:
        raise Refused(422, "erase_unconfirmed", field="number")
    await personal.erase(bench, found.id, acts.actor_of(reader))
    return RedirectResponse(f"/people/{person}", 303)


async def _person(number: str, request: Request, bench: Bench, reader: Reader, more: dict[str, Any]) -> HTMLResponse:
    person = await everybody.known(bench, number)
    context = {"one": await everybody.whole(bench, person), "roles": everybody.ROLES, "made": None} | more
    return made(request, reader.language, "person.html", context, path=f"/people/{number}")
