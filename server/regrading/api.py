"""Regrading for programs: ordering a run, dry or not, and reading what it changes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query, Response
from pydantic import BaseModel, Field, StrictBool

from server.audit.acts import actor_of
from server.courses.api import HERE
from server.jobs.api import ShownJob, job_of, shown_job
from server.people.api import Strict
from server.reader import Asking, Reader, admit
from server.regrading import job as regrade
from server.sets.api import set_of
from server.storage.jobs import Busy, Job
from server.storage.sets import TaskSet
from server.web.errors import Failure, Refused, printable
from server.web.typed import Typed
from server.workbench import Bench, Tools

NOTHING: Mapping[str, Any] = {"changes": [], "references": []}

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["regrading"])


class NewRegrade(Strict):
    """A dry run tells what would change and changes nothing. A lower score replaces a higher one only if allowed.

    With `recompute_references` the givens that were dealt are solved anew where the installed exercise does not lead to
    what was kept of a card: that is how a set is repaired whose references were wrong when it was published.
    """

    dry_run: StrictBool = False
    allow_lower: StrictBool = False
    recompute_references: StrictBool = False
    reason: Annotated[Typed, Field(max_length=200)] = ""


class SaidOfAnswer(BaseModel):
    """What a grade says of one answer."""

    outcome: str
    code: str
    score: float


class ChangedAnswer(BaseModel):
    """An answer of which two grades do not say the same."""

    name: str
    old: SaidOfAnswer | None
    new: SaidOfAnswer | None


class Versions(BaseModel):
    """Of the judges, old and new; of the exercise, when it was dealt and as it is installed."""

    old: str
    new: str
    exercise: int
    installed: int | None


class Change(BaseModel):
    """A submission that is judged in another way now.

    `effect` is raised, lowered, reworded (the same score), or withheld: the new score is lower and that was not
    allowed, so the old one stays. `stale` says that the installed exercise no longer leads to what was kept of the
    card, which has judged.
    """

    receipt: str
    person: str
    slot: int
    effect: str
    old: float
    new: float
    answers: list[ChangedAnswer]
    versions: Versions
    stale: bool


class ChangedValue(BaseModel):
    """A value of a step, or a right text of an answer; nothing where that reference knows none of this name."""

    name: str
    old: float | str | list[list[float]] | None
    new: float | str | list[list[float]] | None


class ChangedReference(BaseModel):
    """What a card was judged against, and what it is judged against now, where the two differ."""

    code: str
    slot: int
    steps: list[ChangedValue]
    texts: list[ChangedValue]


class Changes(BaseModel):
    """Some of the changes; `next` leads to more."""

    changes: list[Change]
    references: list[ChangedReference]
    next: str | None


@router.post("/task-sets/{task_set}/regrade", status_code=202, responses=HERE | {409: {"model": Failure}})
async def start_regrade(task_set: str, body: NewRegrade, response: Response, bench: Tools, reader: Asking) -> ShownJob:
    """Judge all that was handed in to a set again, as a job; both grades of a submission are kept."""
    wish = {**body.model_dump(), "reason": printable(body.reason)}
    number = await ordered(bench, reader, await set_of(bench, reader, task_set), wish)
    response.headers["Location"] = f"/api/v1/jobs/{number}"
    return await shown_job(bench, number)


@router.get("/jobs/{job}/changes", responses=HERE)
async def list_changes(job: str, bench: Tools, after: Annotated[int, Query(ge=0, le=2**31 - 1)] = 0) -> Changes:
    """List what a regrade has changed, or would change, batch by batch."""
    found = await job_of(bench, job)
    if found.kind != regrade.NAME:
        raise Refused(404, "not_found")
    told, last = await changes_of(bench, found, after)
    more = f"/api/v1/jobs/{job}/changes?after={last}" if last else None
    return Changes.model_validate({**told, "next": more})


async def ordered(bench: Bench, reader: Reader, task_set: TaskSet, wish: Mapping[str, Any]) -> str:
    """Order a regrade; gives the number of the job.

    Raises:
        Refused: 409, the set is a draft, or a regrade of it is under way.
    """
    if task_set.published is None:
        raise Refused(409, "set_not_published")
    person = reader.person.id if reader.person else None
    try:
        number = await regrade.order(bench.jobs, task_set, actor_of(reader), person, **wish)
    except Busy as other:
        raise Refused(409, "job_under_way", number=str(other)) from None
    bench.engine.wake()
    return number


async def changes_of(bench: Bench, job: Job, after: int) -> tuple[Mapping[str, Any], int | None]:
    """Give changes and references of the next batch that has any behind a number, and the number to go on from."""
    while True:
        batch = next(iter(await bench.jobs.results(job.id, after, 1)), None)
        if batch is None:
            return NOTHING, None
        after, result = batch
        told = {name: result.get(name, []) for name in NOTHING}
        if any(told.values()):
            return told, after if after < job.total else None
