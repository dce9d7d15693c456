"""The page of a job: how far it is. Without a script it looks again by itself while the job is under way."""

from __future__ import annotations

from fastapi import APIRouter, Depends, Request
from starlette.responses import HTMLResponse, RedirectResponse, Response

from server.courses.api import here
from server.jobs.api import cancelled, items_of, job_of
from server.policy import CourseRole
from server.reader import Asking, admit
from server.sets.publishing import troubles
from server.sets.wording import said, titles_of
from server.web.templating import page
from server.workbench import Tools

AGAIN = 2  # s until the page looks again where no script does

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@router.get("/jobs/{job}")
async def show_job(job: str, request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """Show how far a job is, and where it has led."""
    found = await job_of(bench, job)
    items, against = await items_of(bench, found), troubles(found)
    titles = await titles_of(bench, reader.language) if against else {}
    context = {
        "job": found,
        "course": here(reader).course,
        "lecturer": here(reader).role is CourseRole.LECTURER,
        "items": items,
        "reached": (sum(one.done for one in items), sum(one.total for one in items))
        if items
        else (found.done, found.total),
        "troubles": [said(reader.language, one, titles) for one in against],
        "again": AGAIN,
    }
    return page(request, reader.language, "job.html", context)


@router.post("/jobs/{job}/cancel")
async def cancel_job(job: str, bench: Tools) -> Response:
    """End a job and show it."""
    await cancelled(bench, job)
    return RedirectResponse(f"/jobs/{job}", 303)
