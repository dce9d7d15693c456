"""Jobs for programs: how far one is, its progress as it comes, ending it, what it has made."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from datetime import datetime
from typing import Any

from fastapi import APIRouter, Depends, Response
from pydantic import BaseModel
from starlette.responses import StreamingResponse

from server.courses.api import HERE
from server.jobs.kinds import KINDS
from server.jobs.streams import AGAIN, Stream
from server.reader import COURSES, Asking, admit
from server.storage.jobs import Job
from server.web.errors import Failure, Refused
from server.workbench import Bench, Tools

LOOK = 0.5  # s between two looks at a job that is watched
HEARTBEAT = 10.0  # s; proxies close what is silent for longer
LONGEST_WATCH = 20.0  # s; a browser comes again by itself, so a server that ends need not wait long

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["jobs"])


async def _course_of(bench: Bench, number: str) -> str | None:
    found = await bench.jobs.job(number)
    return found.course if found else None


COURSES["job"] = _course_of


class ItemProgress(BaseModel):
    """How far a task is that is being published: so many of its cards are drawn and checked.

    A refused one cannot be published; the job says why when it has ended.
    """

    number: int
    done: int
    total: int
    refused: bool


class ShownJob(BaseModel):
    """A job: `state` is waiting, running, done, failed or cancelled; `done` of `total` batches are done.

    `items` tells more of a set that is being published. `result` holds what the kind of job tells once it has ended.
    """

    id: str
    kind: str
    subject: str
    state: str
    done: int
    total: int
    items: list[ItemProgress]
    result: dict[str, Any] | None
    created: datetime
    finished: datetime | None


@router.get("/jobs/{job}", responses=HERE)
async def show_job(job: str, bench: Tools) -> ShownJob:
    """Tell how far a job is."""
    return await shown_job(bench, job)


@router.get(
    "/jobs/{job}/events",
    response_class=StreamingResponse,
    responses=HERE | {200: {"content": {"text/event-stream": {}}}, 429: {"model": Failure}},
)
async def watch_job(job: str, bench: Tools, reader: Asking) -> StreamingResponse:
    """Send the progress of a job as server-sent events, until it has ended.

    A stream ends after some time, too; a browser opens it again by itself. One person has only so many open at once.
    """
    found, name = await job_of(bench, job), reader.owner_id or ""
    if not bench.streams.enter(name):
        raise Refused(429, "too_many", headers={"Retry-After": str(AGAIN)}, seconds=AGAIN)
    return Stream(bench.streams, name, _events(bench, found))


@router.post("/jobs/{job}/cancel", responses=HERE)
async def cancel_job(job: str, bench: Tools) -> ShownJob:
    """End a job. What its batches have written stays where it may stand alone, else it is taken back."""
    await cancelled(bench, job)
    return await shown_job(bench, job)


@router.get(
    "/jobs/{job}/documents/{number}", response_class=Response,
    responses=HERE | {200: {"content": {"application/pdf": {}}}},
)  # fmt: skip
async def get_document(job: str, number: int, bench: Tools) -> Response:
    """Give a document that a job has made; it is kept for a week."""
    found, content = await job_of(bench, job), None
    if 1 <= number <= found.total:
        content = await bench.jobs.content(job, number)
    if content is None:
        raise Refused(404, "not_found")
    attached = {"Content-Disposition": f'attachment; filename="{found.kind}-{number}.pdf"'}
    return Response(content, media_type="application/pdf", headers=attached)


async def job_of(bench: Bench, number: str) -> Job:
    """Give a job.

    Raises:
        Refused: 404, there is none.
    """
    found = await bench.jobs.job(number)
    if found is None:
        raise Refused(404, "not_found")
    return found


async def cancelled(bench: Bench, number: str) -> None:
    """End a job that is under way; one that has ended stays as it is."""
    found = await job_of(bench, number)
    await bench.jobs.cancel(KINDS[found.kind], number)


async def shown_job(bench: Bench, number: str) -> ShownJob:
    """Show a job to those who teach the course.

    Raises:
        Refused: 404, there is none.
    """
    job = await job_of(bench, number)
    told = {name: getattr(job, name) for name in ShownJob.model_fields if name != "items"}
    return ShownJob(**told, items=await items_of(bench, job))


async def items_of(bench: Bench, job: Job) -> list[ItemProgress]:
    """Tell how far each task is, of a job whose batches are tasks and tell that."""
    found = await bench.jobs.progress(job.id) if KINDS[job.kind].tells else ()
    return [ItemProgress(number=p.piece, done=p.reached, total=p.parts, refused=p.refused) for p in found]


async def _events(bench: Bench, job: Job) -> AsyncIterator[str]:
    """Send each change at once, and a sign of life where nothing changes."""
    clock = asyncio.get_running_loop().time
    end, silent, sent = clock() + LONGEST_WATCH, clock() + HEARTBEAT, None
    yield "retry: 1000\n\n"
    while True:
        items = [item.model_dump() for item in await items_of(bench, job)]
        told = json.dumps({"state": job.state, "done": job.done, "total": job.total, "items": items})
        if told != sent:
            sent, silent = told, clock() + HEARTBEAT
            yield f"event: progress\ndata: {told}\n\n"
        elif clock() > silent:
            silent = clock() + HEARTBEAT
            yield ": still here\n\n"
        if not job.live or clock() > end:
            return
        await asyncio.sleep(LOOK)
        job = await job_of(bench, job.id)
