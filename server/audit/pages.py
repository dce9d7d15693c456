"""The pages of the audit log: lecturers read the lines of their course, administrators all and whether they fit."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any, Literal

from fastapi import APIRouter, Depends, Request
from starlette.responses import HTMLResponse

from server.audit.api import Before, Named, listed
from server.courses.api import here
from server.courses.zones import told
from server.reader import Asking, admit
from server.sets import clock
from server.storage.audit import Checked, Detail
from server.web.language import words
from server.web.templating import decimal, page
from server.workbench import Bench, Tools

TITLED = {"set", "from"}  # details that are numbers of sets and courses

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@router.get("/audit")
async def show_all(
    request: Request, bench: Tools, reader: Asking, before: Before = None, check: Literal["yes"] | None = None
) -> HTMLResponse:
    """Show the audit log of the server, and whether its lines fit to one another, where that is asked."""
    checked = await bench.audit.check() if check else None
    return await _page(request, bench, reader.language, before, None, checked)


@router.get("/courses/{course}/audit")
async def show_course(
    course: str, request: Request, bench: Tools, reader: Asking, before: Before = None
) -> HTMLResponse:
    """Show the audit log of a course."""
    return await _page(request, bench, reader.language, before, here(reader).course)


async def _page(
    request: Request, bench: Bench, language: str, before: int | None, course: Any, checked: Checked | None = None
) -> HTMLResponse:
    found = await listed(bench, course.id if course else None, before, "")
    titles = await bench.audit.names(
        {str(d[name]) for line in found.lines if (d := line.details) for name in TITLED & d.keys()}
    )
    place = clock.zone(course.time_zone if course else "UTC")
    context = {
        "course": course,
        "checked": checked,
        "lines": found.lines,
        "older": found.lines[-1].number if found.next else None,
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
