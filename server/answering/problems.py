"""Problems that students report of an exercise: they carry the variant, its version, and seed or code of the card.

Administrators see all of them, lecturers those of their own students and of people nobody knows; they settle them.
"""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Annotated

from fastapi import APIRouter, Depends, Query, Request
from pydantic import BaseModel, ConfigDict, Field
from starlette.responses import HTMLResponse, RedirectResponse

from server.answering import forms
from server.answering.variants import GONE, visible
from server.courses import zones
from server.policy import Role, may_answer
from server.reader import Asking, Reader, admit
from server.sets.wording import title_of
from server.storage import Problem
from server.web import ids
from server.web.errors import Failure, Refused, unknown_variant
from server.web.templating import page
from server.web.typed import Typed
from server.workbench import Bench, Tools

LONGEST = 2000  # characters
MOST_OPEN = 10  # problems of one variant
AT_ONCE = 100  # problems in one answer

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["problems"])
pages = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


class NewProblem(BaseModel):
    """What is wrong, in a student's words."""

    model_config = ConfigDict(
        extra="forbid",
        json_schema_extra={"examples": [{"text": "The figure shows l3 to the left, the text to the right."}]},
    )
    text: Annotated[Typed, Field(min_length=1, max_length=LONGEST)]


class ShownProblem(BaseModel):
    """A reported problem with all that is needed to see the same; a card of a set has a code instead of a seed."""

    id: str
    variant: str
    exercise: str
    version: int
    seed: int | None
    code: str | None
    text: str
    time: datetime


class Reported(BaseModel):
    """The number of a reported problem."""

    id: str
    time: datetime


class Problems(BaseModel):
    """Open problems, the newest first; `next` leads to older ones."""

    problems: list[ShownProblem]
    next: str | None


@router.post(
    "/variants/{variant}/problems",
    status_code=201,
    responses=GONE | {code: {"model": Failure} for code in (409, 422, 503)},
)
async def report_problem(variant: str, new: NewProblem, bench: Tools, reader: Asking) -> Reported:
    """Report a problem of the exercise; number, version and seed of the variant go along."""
    found = await report(bench, reader, variant, new.text)
    return Reported(id=found.id, time=found.time)


@router.get("/problems", responses={code: {"model": Failure} for code in (401, 403, 422)})
async def show_problems(bench: Tools, reader: Asking, before: Annotated[datetime | None, Query()] = None) -> Problems:
    """List the open problems of one's students, and of people nobody knows."""
    found = await bench.storage.problems(_moment(before), AT_ONCE, _teacher(reader))
    shown = [_shown(one) for one in found]
    full = len(found) == AT_ONCE
    return Problems(
        problems=shown, next=f"/api/v1/problems?before={found[-1].time:%Y-%m-%dT%H:%M:%S.%fZ}" if full else None
    )


@router.post(
    "/problems/{problem}/settle", status_code=204, responses={404: {"model": Failure}, 422: {"model": Failure}}
)
async def settle_problem(problem: str, bench: Tools, reader: Asking) -> None:
    """Note that a problem is settled."""
    await settle(bench, reader, problem)


@pages.post("/variants/{variant}/problem")
async def send_problem(variant: str, request: Request, bench: Tools, reader: Asking) -> RedirectResponse:
    """Report a problem from the page of the variant."""
    form = await forms.read(request)
    text = form.values.get("problem", "").strip()[:LONGEST]
    if text:
        await report(bench, reader, variant, text)
    return RedirectResponse(f"/variants/{variant}?reported={int(bool(text))}#problem", 303)


@pages.get("/problems")
async def list_problems(request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """Show the open problems to a lecturer."""
    found = await bench.storage.problems(datetime.now(UTC), AT_ONCE, _teacher(reader))
    context = {
        "problems": found,
        "titles": {one.exercise: await title_of(bench, one.exercise, reader.language) for one in found},
        **zones.told(reader.language, await zones.of_reader(bench, reader)),
    }
    return page(request, reader.language, "problems.html", context)


@pages.post("/problems/{problem}")
async def settle_from_page(problem: str, bench: Tools, reader: Asking) -> RedirectResponse:
    """Settle a problem and go back to the list."""
    await settle(bench, reader, problem)
    return RedirectResponse("/problems", 303)


async def report(bench: Bench, reader: Reader, number: str, text: str) -> Problem:
    """Store a problem of one's own variant.

    Raises:
        Refused: 404, not this reader's variant; 409, enough is reported of it.
    """
    dealt = await visible(bench, reader, number)
    if not may_answer(reader.owner_id, dealt):
        raise unknown_variant()
    problem = Problem(ids.new(), dealt.id, dealt.owner.id, text, datetime.now(UTC))
    if not await bench.storage.keep_problem(problem, MOST_OPEN):
        raise Refused(409, "problems_enough")
    return problem


async def settle(bench: Bench, reader: Reader, number: str) -> None:
    """Settle an open problem.

    Raises:
        Refused: 404, there is none that concerns the reader.
    """
    known = ids.known(number)
    if not (known and await bench.storage.settle_problem(number, datetime.now(UTC), _teacher(reader))):
        raise Refused(404, "unknown_problem")


def _teacher(reader: Reader) -> str | None:
    """Whose problems a reader sees: all for administrators; who is nobody known teaches nobody."""
    if reader.role is Role.ADMINISTRATOR:
        return None
    return reader.person.id if reader.person else ""


def _shown(problem: Problem) -> ShownProblem:
    return ShownProblem(
        id=problem.id, variant=problem.variant, exercise=problem.exercise, version=problem.version,
        seed=None if problem.code else problem.seed, code=problem.code, text=problem.text, time=problem.time,
    )  # fmt: skip


def _moment(before: datetime | None) -> datetime:
    if before is None:
        return datetime.now(UTC)
    return before if before.tzinfo else before.replace(tzinfo=UTC)
