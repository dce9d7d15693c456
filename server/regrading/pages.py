"""The page of a regrade: ordering one, and what the last one has found, student by student."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from fastapi import APIRouter, Depends, Query, Request
from starlette.responses import HTMLResponse, RedirectResponse, Response

from graders.words import titled
from server.answering import forms
from server.courses.api import here
from server.marks.asking import asked
from server.policy import CourseRole
from server.reader import Asking, admit
from server.regrading import job as regrade
from server.regrading.api import NOTHING, changes_of, ordered
from server.sets.api import set_of
from server.web.errors import printable
from server.web.templating import page
from server.workbench import Tools

LONGEST_REASON = 200

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@router.get("/sets/{task_set}/regrade")
async def show_regrade(
    task_set: str, request: Request, bench: Tools, reader: Asking,
    after: Annotated[int, Query(ge=0, le=2**31 - 1)] = 0,
) -> HTMLResponse:  # fmt: skip
    """Show what the last regrade of a set has found, and the form that orders one."""
    found = await set_of(bench, reader, task_set)
    last = await bench.jobs.latest(regrade.NAME, found.id)
    told, more = await changes_of(bench, last, after) if last and not last.live else (NOTHING, None)
    asks, solves = asked(found, reader.language), asked(found, reader.language, "steps")
    people = [*await bench.courses.members(found.course), *await bench.courses.left(found.course)]
    context = {
        "task_set": found,
        "course": here(reader).course,
        "lecturer": here(reader).role is CourseRole.LECTURER,
        "job": last,
        **told,
        "more": more,
        "asked": asks,
        "named": lambda one: [*((solves, step) for step in one["steps"]), *((asks, text) for text in one["texts"])],
        "titled": partial(titled, lang=reader.language),
        "names": {member.person.id: member.person.name for member in people},
    }
    return page(request, reader.language, "regrade.html", context)


@router.post("/sets/{task_set}/regrade")
async def start_regrade(task_set: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Order a regrade and go to its progress."""
    values = (await forms.read(request)).values
    reason = printable(values.get("reason", "").strip()[:LONGEST_REASON])
    dry_run = values.get("then") != "regrade"
    chosen = {name: values.get(name) == "yes" for name in ("allow_lower", "recompute_references")}
    wish = {"dry_run": dry_run, "reason": reason, **chosen}
    number = await ordered(bench, reader, await set_of(bench, reader, task_set), wish)
    return RedirectResponse(f"/jobs/{number}", 303)
