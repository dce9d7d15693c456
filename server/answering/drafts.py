"""Drafts: what is typed so far, kept on the server so that another device or a crash finds it again."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Annotated

from fastapi import APIRouter, Depends
from pydantic import BaseModel, ConfigDict, Field, StrictInt

from exercises import catalogue
from server.answering.variants import GONE, restored, visible
from server.policy import may_answer
from server.reader import Asking, Reader, admit
from server.sets import handing
from server.sets.rules import Stage
from server.storage import Answers, Dealt, Draft, Marked
from server.web.errors import Failure, Refused, printable, unknown_variant
from server.web.typed import Typed
from server.workbench import Bench, Tools

MOST_REVISIONS = 2**31 - 2

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["drafts"])


class NewDraft(BaseModel):
    """Answers as typed so far, and the revision they were typed over (0 where there was none)."""

    model_config = ConfigDict(
        extra="forbid", json_schema_extra={"examples": [{"answers": {"l3": "1,2"}, "revision": 0}]}
    )
    answers: dict[Typed, Typed | list[Typed]]
    revision: Annotated[StrictInt, Field(ge=0, le=MOST_REVISIONS)]


class ShownDraft(BaseModel):
    """A draft as it is kept; without one the revision is 0."""

    answers: dict[str, str | list[str]]
    revision: int
    time: datetime | None


@router.get("/variants/{variant}/draft", responses=GONE | {422: {"model": Failure}})
async def show_draft(variant: str, bench: Tools, reader: Asking) -> ShownDraft:
    """Give the draft of one's own variant."""
    dealt = await _own(bench, reader, variant)
    return _shown(await bench.storage.draft(dealt.id))


@router.put(
    "/variants/{variant}/draft", responses=GONE | {code: {"model": Failure} for code in (403, 409, 413, 422, 503)}
)
async def put_draft(variant: str, new: NewDraft, bench: Tools, reader: Asking) -> ShownDraft:
    """Keep a draft. Where another tab or device has kept one meanwhile, nothing is kept: 409, read it first."""
    dealt = await _own(bench, reader, variant)
    task = restored(dealt)
    asked = catalogue.load(task.exercise).exercise.answers_of(task.givens)
    unknown = sorted(set(new.answers) - set(asked))
    if unknown:
        name = printable(unknown[0])
        raise Refused(422, "unknown_answer", field=f"answers.{name}", name=name)
    kept, is_this = await keep(bench, dealt, new.answers, new.revision)
    if not is_this:
        raise Refused(409, "draft_changed", field="revision")
    return _shown(kept)


async def keep(bench: Bench, dealt: Dealt, answers: Answers, revision: int) -> tuple[Draft, bool]:
    """Keep answers as the draft that follows a revision; gives what is kept, and whether it is this.

    Raises:
        Refused: 403, it came after the end of an examination: what was kept in time is taken, not this.
    """
    now = datetime.now(UTC)
    if await is_late(bench, dealt, now):
        raise Refused(403, "set_closed")
    return await bench.storage.keep_draft(Draft(dealt.id, answers, now, revision + 1))


async def is_late(bench: Bench, dealt: Dealt, now: datetime) -> bool:
    """Tell whether a variant belongs to an examination that is over for its student."""
    place = await bench.sets.place(dealt.id) if dealt.code else None
    return place is not None and handing.is_exam(place) and handing.own_window(place).stage(now) is Stage.CLOSED


def fresher(draft: Draft | None, last: Marked | None) -> bool:
    """Whether a draft was typed after the last submission."""
    return draft is not None and (last is None or draft.time > last.handed.time)


async def _own(bench: Bench, reader: Reader, number: str) -> Dealt:
    dealt = await visible(bench, reader, number)
    if not may_answer(reader.owner_id, dealt):
        raise unknown_variant()
    return dealt


def _shown(draft: Draft | None) -> ShownDraft:
    if draft is None:
        return ShownDraft(answers={}, revision=0, time=None)
    return ShownDraft(answers=dict(draft.answers), revision=draft.revision, time=draft.time)
