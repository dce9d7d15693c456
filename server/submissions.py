"""Submissions: graded, stored, and only then acknowledged by a receipt."""

from __future__ import annotations

import json
from datetime import UTC, datetime
from typing import Annotated

from fastapi import APIRouter, Depends, Header, Request, Response
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter

from exercises import grading, presenting
from exercises.exercise import Grade, Submission
from graders import Code, Verdict
from graders.verdict import Entries, Reading
from graders.words import message
from server import ids
from server.bench import Bench, Tools
from server.errors import Failure, Refused, printable, unknown_variant
from server.policy import may_answer
from server.reader import Asking, Reader, admit
from server.storage import Answers, Handed, Marked
from server.typed import Typed
from server.variants import GONE, restored, sees, visible

KEY_LONGEST = 64
GRADE: TypeAdapter[Grade] = TypeAdapter(Grade)

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["submissions"])


class NewSubmission(BaseModel):
    """Answers exactly as typed; a missing one counts as empty."""

    model_config = ConfigDict(
        extra="forbid", json_schema_extra={"examples": [{"answers": {"l3": "1,25 m", "omega2_formula": "v/l2"}}]}
    )
    answers: dict[Typed, Typed | list[Typed]]


class Judged(BaseModel):
    """The verdict on one answer. `position` is a 0-based code point; `entries` are rows and columns from 1."""

    outcome: str
    code: str
    score: float
    message: str
    follow_through: bool
    position: int | None
    entries: list[tuple[int, int]]


class Receipt(BaseModel):
    """The proof that the answers are stored."""

    id: str
    time: datetime
    digest: str


class Graded(BaseModel):
    """A graded submission."""

    score: float = Field(ge=0, le=1)
    counted: bool
    provisional: bool
    verdicts: dict[str, Judged]
    hints: list[str]
    receipt: Receipt
    variant: str
    answers: dict[str, str | list[str]]


@router.post(
    "/variants/{variant}/submissions",
    status_code=201,
    responses=GONE | {code: {"model": Failure} for code in (409, 413, 422, 503)} | {200: {"model": Graded}},
)
async def hand_in(
    variant: str, new: NewSubmission, request: Request, response: Response, bench: Tools, reader: Asking,
    idempotency_key: Annotated[str | None, Header(min_length=1, max_length=KEY_LONGEST, pattern="^[!-~ ]+$")] = None,
) -> Graded:  # fmt: skip
    """Hand in answers. With a key, the same request again gives the first response and stores nothing."""
    body = ids.digest(await request.body())
    marked, replayed = await submit(bench, reader, variant, new.answers, idempotency_key, body)
    if replayed:
        response.status_code = 200
    return await graded(bench, marked, marked.handed.language)


@router.get("/submissions/{receipt}", responses=GONE | {422: {"model": Failure}})
async def show_submission(receipt: str, bench: Tools, reader: Asking) -> Graded:
    """Look up a submission by the number on its receipt."""
    return await graded(bench, await receipted(bench, reader, receipt), reader.language)


async def submit(
    bench: Bench, reader: Reader, number: str, answers: Answers, key: str | None, body: str
) -> tuple[Marked, bool]:
    """Grade and store a submission.

    Args:
        bench: The server's tools.
        reader: Who hands in.
        number: The variant answered.
        answers: The answers as typed.
        key: Idempotency key.
        body: Digest of the request, compared when the key comes again.

    Returns:
        What is stored under the key, and whether it had been there before.

    Raises:
        Refused: The variant is not this reader's, or an answer is not asked for.
        KeyReused: The key was used with another body.
        StorageUnavailable: Nothing was stored.
    """
    dealt = await visible(bench, reader, number)
    if not may_answer(reader.owner_id, dealt):
        raise unknown_variant()
    try:
        grade = await bench.judging.grade(Submission(restored(dealt), whole(answers)), bench.secret)
    except grading.UnknownAnswer as error:
        raise Refused(422, "unknown_answer", field=f"answers.{printable(error)}", name=printable(error)) from None
    handed = _handed(dealt.id, dealt.owner.id, answers, key, body, reader.language)
    marked = Marked(handed, GRADE.dump_python(grade, mode="json"), grade.counted, grade.grader_version)
    return await bench.storage.keep_submission(marked)


def _handed(variant: str, owner: str, answers: Answers, key: str | None, body: str, language: str) -> Handed:
    receipt, now = ids.new(), datetime.now(UTC)
    typed = json.dumps(answers, sort_keys=True).encode()
    digest = ids.digest(receipt.encode(), variant.encode(), now.isoformat().encode(), typed)
    return Handed(receipt, variant, owner, dict(answers), now, key, body, digest, language)


def whole(answers: Answers) -> dict[str, str]:
    """Give answers as texts; a list of lines is a text of lines."""
    return {name: text if isinstance(text, str) else "\n".join(text) for name, text in answers.items()}


async def receipted(bench: Bench, reader: Reader, receipt: str) -> Marked:
    """Give a submission that this reader may see.

    Raises:
        Refused: 404, there is none, or it is somebody else's.
    """
    marked = await bench.storage.submission(receipt) if ids.known(receipt) else None
    dealt = await bench.storage.variant(marked.handed.variant) if marked else None
    if marked is None or dealt is None or not await sees(bench, reader, dealt):
        raise Refused(404, "unknown_submission")
    return marked


async def graded(bench: Bench, marked: Marked, language: str) -> Graded:
    """Word a stored grade in a language."""
    grade, handed = GRADE.validate_python(marked.grade), marked.handed
    dealt = await bench.storage.variant(handed.variant) if grade.mistake or grade.slip else None
    hints = list(presenting.hints(restored(dealt), grade, language)) if dealt else []
    return Graded(
        score=grade.score,
        counted=grade.counted,
        provisional=grade.provisional,
        verdicts={name: judged(verdict, language) for name, verdict in grade.verdicts.items()},
        hints=hints,
        receipt=Receipt(id=handed.receipt, time=handed.time, digest=handed.digest),
        variant=handed.variant,
        answers=dict(handed.answers),
    )


def judged(verdict: Verdict, language: str) -> Judged:
    """Word one verdict."""
    details = verdict.details
    return Judged(
        outcome=verdict.outcome,
        code=verdict.code,
        score=verdict.score,
        message=message(verdict, language),
        follow_through=verdict.code is Code.FOLLOWED,
        position=details.position if isinstance(details, Reading) else None,
        entries=list(details.wrong) if isinstance(details, Entries) else [],
    )
