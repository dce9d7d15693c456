"""The page of a course: for its students a few words, for those who teach it members, groups and the roster."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query, Request
from starlette.exceptions import HTTPException
from starlette.responses import HTMLResponse, RedirectResponse, Response

from server.answering import forms
from server.courses import api as courses
from server.courses import rosters
from server.courses.headings import Meaning
from server.courses.zones import told
from server.people import access
from server.policy import CourseRole
from server.reader import Asking, Reader, admit
from server.sets import building, clock
from server.sets.reopening import solved_for
from server.web.envelope import LARGEST_ROSTER
from server.web.errors import Refused
from server.web.language import say
from server.web.templating import page
from server.workbench import Bench, Tools

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)
ROLES = tuple(role.name.lower() for role in CourseRole)


@router.get("/courses/{course}")
async def show_course(
    course: str,
    request: Request,
    bench: Tools,
    reader: Asking,
    moved: Annotated[int | None, Query(ge=0, le=9999)] = None,
) -> Response:
    """Show a course, and how many deadlines were just moved."""
    return await _course(request, bench, reader, {"moved": moved})


@router.post("/courses/{course}/code")
async def change_code(course: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Give the course another join code, or close joining."""
    values = (await forms.read(request)).values
    await courses.renew_code(bench, reader, values.get("open") == "yes")
    return back(course, "h-code")


@router.post("/courses/{course}/groups")
async def add_group(course: str, request: Request, bench: Tools) -> Response:
    """Add a group."""
    await courses.new_group(bench, course, (await forms.read(request)).values.get("name", ""))
    return back(course, "h-groups")


@router.post("/courses/{course}/members/{person}")
async def change_member(course: str, person: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Change the role and the group of a member, or take the member out."""
    values = (await forms.read(request)).values
    member = await courses.found(bench, course, person)
    if values.get("leave") == "yes":
        await courses.remove(bench, reader, member)
        return back(course, "h-members")
    role, group = values.get("role", member.role), values.get("group", member.group or "")
    await courses.place(bench, reader, member, role, group or None)
    return back(course, f"m-{person}")


@router.post("/courses/{course}/members/{person}/link")
async def link_member(course: str, person: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Make a one-time link for a student and show it once."""
    member = await courses.found(bench, course, person)
    made = await access.personal_link(bench, reader, member)
    return await _course(request, bench, reader, {"made": made, "made_for": member.person})


@router.post("/courses/{course}/roster")
async def import_roster(course: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Show what a roster would change, pasted or in a file; with the second button, change it."""
    values = await _posted(request, reader)
    text = values.get("roster", "")
    if values.get("apply") == "yes":
        await courses.take_roster(bench, reader, text, apply=True)
        return back(course, "h-members")
    changes, read = await courses.take_roster(bench, reader, text, apply=False)
    context = {
        "course": courses.here(reader).course,
        "text": text,
        "changes": [change for change in changes if change.what != "same"],
        "same": sum(change.what == "same" for change in changes),
        "unread": [(line.line, _reason(reader, line)) for line in read.unread],
        "columns": [(one.value, [c for c in read.columns if c.meaning is one]) for one in Meaning],
        "above": read.above,
        "repeated": read.repeated,
    }
    return page(request, reader.language, "roster.html", context, path=f"/courses/{course}")


async def _posted(request: Request, reader: Reader) -> Mapping[str, str]:
    """Read the form with a pasted roster, or the one with a file of it."""
    if not request.headers.get("content-type", "").startswith("multipart/form-data"):
        return (await forms.read(request)).values
    try:
        async with request.form(max_files=1, max_fields=4, max_part_size=LARGEST_ROSTER) as form:
            file = form.get("file")
            raw = b"" if file is None or isinstance(file, str) else await file.read()
    except HTTPException as error:
        raise error if isinstance(error, Refused) else Refused(422, "not_a_form") from None
    return {"roster": rosters.decoded(raw, courses.here(reader).course.language)}


def _reason(reader: Reader, line: rosters.Unread) -> str:
    return say(reader.language, f"errors.{line.code}", line=line.repeats)


def back(course: str, place: str) -> Response:
    """Go back to the place on the page of a course whose button was pressed."""
    return RedirectResponse(f"/courses/{course}#{place}", 303)


async def _course(request: Request, bench: Bench, reader: Reader, more: dict[str, Any]) -> HTMLResponse:
    here = courses.here(reader)
    staff, lecturer = here.role >= CourseRole.ASSISTANT, here.role is CourseRole.LECTURER
    sets, now = await bench.sets.of(here.course.id) if lecturer else [], datetime.now(UTC)
    context = {
        "course": here.course,
        "staff": staff,
        "lecturer": lecturer,
        "seen_deadlines": building.deadlines(sets),
        "solved": [(one.title, await solved_for(bench, one, now)) for one in building.movable(sets, now)],
        "members": await bench.courses.members(here.course.id) if staff else [],
        "groups": await bench.courses.groups(here.course.id) if staff else [],
        "roles": ROLES,
        "address": bench.settings.address,
        **told(reader.language, clock.zone(here.course.time_zone)),
        "moved": None,
        "made": None,
        "made_for": None,
    }
    return page(request, reader.language, "course.html", context | more, path=f"/courses/{here.course.id}")
