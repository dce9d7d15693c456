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

from server.bench import Bench, Tools
from server.courses import HERE
from server.errors import Failure, Refused
from server.jobs.kinds import KINDS
from server.jobs.streams import AGAIN, Stream
from server.reader import COURSES, Asking, admit
from server.storage.jobs import Job

LOOK = 0.5  # s between two looks at a job that is watched
HEARTBEAT = 10.0  # s; proxies close what is silent for longer
LONGEST_WATCH = 20.0  # s; a browser comes again by itself, so a server that ends need not wait long

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["jobs"])


async def _course_of(bench: Bench, number: str) -> str | None:
    found = await bench.jobs.job(number)
    return found.course if found else None


COURSES["job"] = _course_of


class ShownJob(BaseModel):
    """A job: `state` is waiting, running, done, failed or cancelled; `done` of `total` batches are done.

    `result` holds what its kind tells of the work once it has ended.
    """

    id: str
    kind: str
    subject: str
    state: str
    done: int
    total: int
    result: dict[str, Any] | None
    created: datetime
    finished: datetime | None


@router.get("/jobs/{job}", responses=HERE)
async def show_job(job: str, bench: Tools) -> ShownJob:
    """Tell how far a job is."""
    return shown_job(await job_of(bench, job))


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
    return shown_job(await job_of(bench, job))


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


def shown_job(job: Job) -> ShownJob:
    """Show a job to those who teach the course."""
    return ShownJob(**{name: getattr(job, name) for name in ShownJob.model_fields})


async def _events(bench: Bench, job: Job) -> AsyncIterator[str]:
    """Send each change at once, and a sign of life where nothing changes."""
    clock = asyncio.get_running_loop().time
    end, silent, sent = clock() + LONGEST_WATCH, clock() + HEARTBEAT, None
    yield "retry: 1000\n\n"
    while True:
        if (job.state, job.done) != sent:
            sent, silent = (job.state, job.done), clock() + HEARTBEAT
            told = {"state": job.state, "done": job.done, "total": job.total}
            yield f"event: progress\ndata: {json.dumps(told)}\n\n"
        elif clock() > silent:
            silent = clock() + HEARTBEAT
            yield ": still here\n\n"
        if not job.live or clock() > end:
            return
        await asyncio.sleep(LOOK)
        job = await job_of(bench, job.id)
