"""The audit log for those it concerns: lecturers read the lines of their course, administrators all."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from functools import partial
from typing import Annotated, Any, Literal

from fastapi import APIRouter, Depends, Query, Request
from pydantic import BaseModel
from starlette.responses import HTMLResponse

from server.bench import Bench, Tools
from server.courses.api import HERE, here
from server.courses.zones import told
from server.people.api import REFUSED
from server.reader import Asking, admit
from server.sets import clock
from server.storage.audit import Checked, Detail, Line
from server.web.language import words
from server.web.templating import decimal, page

AT_ONCE = 100  # lines in one answer
TITLED = {"set", "from"}  # details that are numbers of sets and courses

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["audit"])
pages = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)
Before = Annotated[int | None, Query(ge=1, le=2**53)]


class Named(BaseModel):
    """A number, and the name it has now; none for what is nobody's or has gone."""

    id: str
    name: str | None


class ShownLine(BaseModel):
    """Who did what to whom, and the digest that binds the line to those before."""

    number: int
    time: datetime
    actor: Named
    action: str
    object: Named
    course: str | None
    details: dict[str, Detail]
    digest: str


class Lines(BaseModel):
    """Lines of the log, the newest first; `next` leads to older ones."""

    lines: list[ShownLine]
    next: str | None


@router.get("/audit", responses=REFUSED)
async def list_all(bench: Tools, before: Before = None) -> Lines:
    """Read the audit log of the server."""
    return await _listed(bench, None, before, "/api/v1/audit")


@router.get("/courses/{course}/audit", responses=HERE)
async def list_course(course: str, bench: Tools, before: Before = None) -> Lines:
    """Read the audit log of a course."""
    return await _listed(bench, course, before, f"/api/v1/courses/{course}/audit")


@pages.get("/audit")
async def show_all(
    request: Request, bench: Tools, reader: Asking, before: Before = None, check: Literal["yes"] | None = None
) -> HTMLResponse:
    """Show the audit log of the server, and whether its lines fit to one another, where that is asked."""
    checked = await bench.audit.check() if check else None
    return await _page(request, bench, reader.language, before, None, checked)


@pages.get("/courses/{course}/audit")
async def show_course(
    course: str, request: Request, bench: Tools, reader: Asking, before: Before = None
) -> HTMLResponse:
    """Show the audit log of a course."""
    return await _page(request, bench, reader.language, before, here(reader).course)


async def _listed(bench: Bench, course: str | None, before: int | None, path: str) -> Lines:
    lines = await bench.audit.lines(course, before, AT_ONCE)
    names = await _names(bench, lines)
    following = f"{path}?before={lines[-1].number}" if len(lines) == AT_ONCE else None
    return Lines(lines=[_shown(line, names) for line in lines], next=following)


async def _names(bench: Bench, lines: Any) -> Mapping[str, str]:
    return await bench.audit.names({number for line in lines for number in (line.entry.actor, line.entry.object)})


def _shown(line: Line, names: Mapping[str, str]) -> ShownLine:
    entry = line.entry
    return ShownLine(
        number=line.number, time=line.time, actor=Named(id=entry.actor, name=names.get(entry.actor)),
        action=entry.action.value, object=Named(id=entry.object, name=names.get(entry.object)), course=entry.course,
        details=dict(entry.details), digest=line.digest,
    )  # fmt: skip


async def _page(
    request: Request, bench: Bench, language: str, before: int | None, course: Any, checked: Checked | None = None
) -> HTMLResponse:
    listed = await _listed(bench, course.id if course else None, before, "")
    titles = await bench.audit.names(
        {str(d[name]) for line in listed.lines if (d := line.details) for name in TITLED & d.keys()}
    )
    place = clock.zone(course.time_zone if course else "UTC")
    context = {
        "course": course,
        "checked": checked,
        "lines": listed.lines,
        "older": listed.lines[-1].number if listed.next else None,
        "newest": before is None,
        **told(language, place),
        "worded": partial(_worded, language, titles),
        "actor": partial(_actor, language),
    }
    return page(request, language, "audit.html", context)


def _actor(language: str, actor: Named) -> str:
    """Name who acted; the command line and the server itself are no persons, but have words."""
    return actor.name or words(language).get(f"audit.actor_{actor.id}".replace(" ", "_"), actor.id)


def _plain(language: str, value: Detail) -> str:
    if isinstance(value, float):
        return decimal(language, value)
    return "—" if value is None else str(value)


def _worded(language: str, titles: Mapping[str, str], name: str, value: Detail) -> str:
    """Word a detail: its name, and its value where that is a word of ours or the number of a set or course."""
    known = words(language)
    said = known.get(f"audit.value_{value}".lower(), _plain(language, value))
    said = titles.get(said, said) if name in TITLED else said
    return f"{known.get(f'audit.detail_{name}', name)}: {said}"
