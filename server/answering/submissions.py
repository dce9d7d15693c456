"""Submissions: graded, stored, and only then acknowledged by a receipt."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Annotated

from fastapi import APIRouter, Depends, Header, Request, Response
from pydantic import BaseModel, ConfigDict, Field

from exercises import grading, presenting
from exercises.exercise import Submission
from graders import Code, Verdict
from graders.verdict import Entries, Reading
from graders.words import message
from server.answering import receipts
from server.answering.receipts import GRADE, whole
from server.answering.variants import GONE, restored, sees, visible
from server.marks import counting
from server.policy import may_answer
from server.reader import Asking, Reader, admit
from server.sets import handing
from server.storage import Answers, Dealt, Marked
from server.storage.marks import Mark
from server.storage.sets import Line, Place
from server.web import ids
from server.web.errors import Failure, Refused, printable, unknown_variant
from server.web.typed import Typed
from server.workbench import Bench, Tools

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
    raw = await request.body()
    done = await submit(bench, reader, variant, new.answers, idempotency_key, ids.digest(raw))
    if done.around is None:
        response.status_code = 200
        return await graded(bench, done.marked, done.marked.handed.language)
    return worded(done.marked, done.around, done.marked.handed.language)


@router.get("/submissions/{receipt}", responses=GONE | {422: {"model": Failure}})
async def show_submission(receipt: str, bench: Tools, reader: Asking) -> Graded:
    """Look up a submission by the number on its receipt."""
    marked = await receipted(bench, reader, receipt)
    return await graded(bench, marked, reader.language, staff=reader.owner_id != marked.handed.owner)


@dataclass(frozen=True, slots=True)
class Around:
    """What a submission is seen with: its variant where a slip is named, its place in a set, the marks on it by hand,
    and whether the exercise still leads to what was kept of its card."""

    dealt: Dealt | None
    place: Place | None
    marks: Sequence[Mark] = ()
    sound: bool = True


@dataclass(frozen=True, slots=True)
class Done:
    """What stands under a key; what is around it unless it had been there before."""

    marked: Marked
    around: Around | None


async def submit(bench: Bench, reader: Reader, number: str, answers: Answers, key: str | None, body: str) -> Done:
    """Grade and store a submission.

    Args:
        bench: The server's tools.
        reader: Who hands in.
        number: The variant answered.
        answers: The answers as typed.
        key: Idempotency key.
        body: Digest of the request, compared when the key comes again.

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
            return Done(before, None)
    task, sound = Submission(restored(dealt), whole(answers)), True
    try:
        if place is not None:
            grade, sound = await handing.judge(bench, place, task)
        else:
            grade = await bench.judging.grade(task, bench.secret)
    except grading.UnknownAnswer as error:
        raise Refused(422, "unknown_answer", field=f"answers.{printable(error)}", name=printable(error)) from None
    handed = receipts.handed(dealt.id, dealt.owner.id, answers, key, body, reader.language, received)
    marked = receipts.marked(handed, grade, dealt.code)
    kept, replayed = await (handing.keep(bench, place, marked) if place else bench.storage.keep_submission(marked))
    return Done(kept, None if replayed else Around(dealt, place, sound=sound))


async def _before(
    bench: Bench, place: Place, dealt: Dealt, key: str | None, body: str, received: datetime
) -> Marked | None:
    """Give what a key stands for already; refuse a new submission outside the window.

    Raises:
        Refused: 403, the set is not open at the moment of receipt, or its student has left the course.
        KeyReused: The key was used with another body.
    """
    found = await bench.storage.keyed(dealt.owner.id, dealt.id, key, body) if key else None
    if found is None:
        handing.refuse_unless_working(place, received)
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
    handed, named = marked.handed, marked.grade["mistake"] or marked.grade.get("slip")
    dealt = await bench.storage.variant(handed.variant) if named else None
    place = await bench.sets.place(handed.variant) if marked.code else None
    if place is None:
        return worded(marked, Around(dealt, None), language, staff=staff)
    marks, sound = await bench.marks.on(handed.receipt), await bench.judging.run(handing.reproduced, place.card)
    return worded(marked, Around(dealt, place, marks, sound), language, staff=staff)


def worded(marked: Marked, around: Around, language: str, *, staff: bool = False) -> Graded:
    """Word a stored grade, seen with what is around it."""
    grade, handed, place = GRADE.validate_python(marked.grade), marked.handed, around.place
    held = place is not None and not staff and handing.is_held(place, datetime.now(UTC))
    hinted = not held and (place is None or staff or handing.rules_of(place.task_set).hints)
    told = hinted and (grade.mistake or grade.slip)
    hints = presenting.hints(restored(around.dealt), grade, language) if told and around.dealt else ()
    verdicts = {name: one for name, one in grade.verdicts.items() if not held or one.code is Code.UNREADABLE}
    marks = () if held else around.marks
    line = Line("", "", handed.variant, handed.receipt, handed.time, marked.grade, marked.counted)
    used = marked.counted and place is not None
    given = counting.by_submission(marks).get(handed.receipt, counting.NONE)
    return Graded(
        score=None if held else _score(place, line, given),
        counted=marked.counted,
        repeated=grade.counted and not marked.counted,
        provisional=not held and bool(counting.left_open(line, given)),
        held=held,
        needs_regrade=not around.sound,
        verdicts={name: judged(verdict, language, used=used) for name, verdict in verdicts.items()},
        hints=list(hints),
        by_hand=[ByHand(answer=one.answer, share=one.share, comment=one.comment, time=one.time) for one in marks],
        receipt=Receipt(id=handed.receipt, time=handed.time, digest=handed.digest),
        variant=handed.variant,
        answers=dict(handed.answers),
    )


def _score(place: Place | None, line: Line, given: counting.Given) -> float:
    if place is None:
        return float(line.grade["score"])
    return counting.earned(line, given, handing.weights_of(place.card), handing.rules_of(place.task_set))


def judged(verdict: Verdict, language: str, *, used: bool = False) -> Judged:
    """Word one verdict of a submission; `used` tells that it took an attempt at a set."""
    details = verdict.details
    return Judged(
        outcome=verdict.outcome,
        code=verdict.code,
        score=verdict.score,
        message=message(verdict, language, used=used),
        follow_through=verdict.code is Code.FOLLOWED,
        position=details.position if isinstance(details, Reading) else None,
        entries=list(details.wrong) if isinstance(details, Entries) else [],
    )
