"""Leaving for the university's sign-in page, and coming back from it."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Query, Request
from starlette.responses import RedirectResponse, Response

from server.people import oidc
from server.people.signin_pages import HOME, inside, let_in
from server.reader import Asking, admit
from server.web.errors import Refused
from server.web.limits import ALL_TRIES
from server.workbench import Bench, Tools

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)
Short = Annotated[str, Query(max_length=2048)]


@router.get("/oidc")
async def leave(bench: Tools, reader: Asking, next: Short = HOME) -> Response:
    """Go to the issuer; who is signed in already comes back with both accounts joined."""
    oidc.provider_of(bench)
    _take_try(bench)
    person = reader.person.id if reader.session and reader.person else ""
    address, cookie = await oidc.leave(bench, inside(next), person)
    response = RedirectResponse(address, 303)
    response.set_cookie(
        _cookie(bench), cookie, max_age=oidc.LASTS, httponly=True, samesite="lax", secure=bench.settings.https
    )
    return response


@router.get("/oidc/callback")
async def arrive(
    request: Request, bench: Tools, reader: Asking, state: Short = "", code: Short = "", error: Short = ""
) -> Response:
    """Come back from the issuer; the cookie of the journey is used up."""
    oidc.provider_of(bench)
    _take_try(bench)
    person, onward = await oidc.arrive(bench, request.cookies.get(_cookie(bench), ""), state, "" if error else code)
    response = await let_in(request, bench, person, onward)
    response.delete_cookie(_cookie(bench), httponly=True, samesite="lax", secure=bench.settings.https)
    return response


def _take_try(bench: Bench) -> None:
    seconds = bench.limiter.wait(ALL_TRIES, "issuer") if bench.settings.limited else 0
    if seconds:
        raise Refused(429, "too_many_tries", headers={"Retry-After": str(seconds)}, seconds=seconds)


def _cookie(bench: Bench) -> str:
    return f"__Host-{oidc.COOKIE}" if bench.settings.https else oidc.COOKIE
