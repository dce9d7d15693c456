"""The audit log for programs: lecturers read the lines of their course, administrators all."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query
from pydantic import BaseModel

from server.courses.api import HERE
from server.people.api import REFUSED
from server.reader import admit
from server.storage.audit import Detail, Line
from server.workbench import Bench, Tools

AT_ONCE = 100  # lines in one answer

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["audit"])
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
    return await listed(bench, None, before, "/api/v1/audit")


@router.get("/courses/{course}/audit", responses=HERE)
async def list_course(course: str, bench: Tools, before: Before = None) -> Lines:
    """Read the audit log of a course."""
    return await listed(bench, course, before, f"/api/v1/courses/{course}/audit")


async def listed(bench: Bench, course: str | None, before: int | None, path: str) -> Lines:
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
