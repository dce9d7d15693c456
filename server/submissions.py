"""Submissions: graded, stored, and only then acknowledged by a receipt."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Annotated

from fastapi import APIRouter, Depends, Header, Request, Response
from pydantic import BaseModel, ConfigDict, Field

from exercises import grading, presenting
from exercises.exercise import Submission
from graders import Code, Verdict
from graders.verdict import Entries, Reading
from graders.words import message
from server import ids, receipts
from server.bench import Bench, Tools
from server.errors import Failure, Refused, printable, unknown_variant
from server.marks import counting
from server.policy import may_answer
from server.reader import Asking, Reader, admit
from server.receipts import GRADE, whole
from server.sets import handing
from server.storage import Answers, Dealt, Marked
from server.storage.sets import Line, Place
from server.typed import Typed
from server.variants import GONE, restored, sees, visible

KEY_LONGEST = 64

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


class ByHand(BaseModel):
    """What a lecturer says of one answer or of the whole: its share of the points, and why."""

    answer: str | None
    share: float | None
    comment: str
    time: datetime


class Receipt(BaseModel):
    """The proof that the answers are stored."""

    id: str
    time: datetime
    digest: str


class Graded(BaseModel):
    """A graded submission.

    One that `counted` may use up an attempt; `repeated` says that it did not count because the same answers were
    handed in before. What is `held` has no score and no verdicts until the set has closed for everybody.
    `needs_regrade` says that the exercise has changed since its variant was dealt, and that the kept reference has
    judged.
    """

    score: float | None = Field(ge=0, le=1)
    counted: bool
    repeated: bool
    provisional: bool
    held: bool
    needs_regrade: bool
    verdicts: dict[str, Judged]
    hints: list[str]
    by_hand: list[ByHand]
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
    marked = await receipted(bench, reader, receipt)
    return await graded(bench, marked, reader.language, staff=reader.owner_id != marked.handed.owner)


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
    received = datetime.now(UTC)
    place = await bench.sets.place(dealt.id) if dealt.code else None
    if place is not None:
        before = await _before(bench, place, dealt, key, body, received)
        if before is not None:
            return before, True
    task = Submission(restored(dealt), whole(answers))
    try:
        grade = await (handing.judge(bench, place, task) if place else bench.judging.grade(task, bench.secret))
    except grading.UnknownAnswer as error:
        raise Refused(422, "unknown_answer", field=f"answers.{printable(error)}", name=printable(error)) from None
    handed = receipts.handed(dealt.id, dealt.owner.id, answers, key, body, reader.language, received)
    marked = receipts.marked(handed, grade, dealt.code)
    return await (handing.keep(bench, place, marked) if place else bench.storage.keep_submission(marked))


async def _before(
    bench: Bench, place: Place, dealt: Dealt, key: str | None, body: str, received: datetime
) -> Marked | None:
    """Give what a key stands for already; refuse a new submission outside the window.

    Raises:
        Refused: 403, the set is not open at the moment of receipt.
        KeyReused: The key was used with another body.
    """
    found = await bench.storage.keyed(dealt.owner.id, dealt.id, key, body) if key else None
    if found is None:
        handing.refuse_unless_open(handing.own_window(place), received)
    return found


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


async def graded(bench: Bench, marked: Marked, language: str, *, staff: bool = False) -> Graded:
    """Word a stored grade in a language; what an examination holds back, its student does not see."""
    grade, handed = GRADE.validate_python(marked.grade), marked.handed
    place = await bench.sets.place(handed.variant) if marked.code else None
    held = place is not None and not staff and handing.is_held(place, datetime.now(UTC))
    hinted = not held and (place is None or staff or handing.rules_of(place.task_set).hints)
    dealt = await bench.storage.variant(handed.variant) if hinted and (grade.mistake or grade.slip) else None
    verdicts = {name: one for name, one in grade.verdicts.items() if not held or one.code is Code.UNREADABLE}
    marks = await bench.marks.on(handed.receipt) if place is not None and not held else ()
    line = Line("", "", handed.variant, handed.receipt, handed.time, marked.grade, marked.counted, None)
    given = counting.by_submission(marks).get(handed.receipt, counting.NONE)
    return Graded(
        score=None if held else _score(place, line, given),
        counted=marked.counted,
        repeated=grade.counted and not marked.counted,
        provisional=not held and bool(counting.left_open(line, given)),
        held=held,
        needs_regrade=place is not None and not await bench.judging.run(handing.reproduced, place.card),
        verdicts={name: judged(verdict, language) for name, verdict in verdicts.items()},
        hints=list(presenting.hints(restored(dealt), grade, language)) if dealt else [],
        by_hand=[ByHand(answer=one.answer, share=one.share, comment=one.comment, time=one.time) for one in marks],
        receipt=Receipt(id=handed.receipt, time=handed.time, digest=handed.digest),
        variant=handed.variant,
        answers=dict(handed.answers),
    )


def _score(place: Place | None, line: Line, given: counting.Given) -> float:
    if place is None:
        return float(line.grade["score"])
    return counting.earned(line, given, handing.weights_of(place.card), handing.rules_of(place.task_set))


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
