"""Giving marks by hand, and settling what the judges have left open: for one, or for all who typed the same."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Annotated

from pydantic import Field, StrictInt

from server.answering.receipts import whole
from server.audit import acts
from server.marks.counting import Given, by_submission, left_open
from server.people.api import Strict, themselves
from server.reader import Reader
from server.storage import Handed, Marked
from server.storage.audit import Action
from server.storage.marks import Mark
from server.storage.sets import Line, TaskSet
from server.web import ids
from server.web.errors import Refused, printable
from server.web.typed import Typed
from server.workbench import Bench

Comment = Annotated[Typed, Field(max_length=4000)]
Share = Annotated[float, Field(ge=0, le=1, strict=True)]
Answer = Annotated[Typed, Field(min_length=1, max_length=64)]


class NewMark(Strict):
    """A mark on a submission: the share of the points of one answer or of all of it, and why; without a share it is a
    comment."""

    receipt: Annotated[Typed, Field(max_length=32)]
    answer: Answer | None = None
    share: Share | None = None
    comment: Comment = ""


class Settling(Strict):
    """What an open answer is worth, for all in a task who typed this text."""

    item: Annotated[StrictInt, Field(ge=1)]
    answer: Answer
    text: Typed
    share: Share
    comment: Comment = ""


@dataclass(frozen=True, slots=True)
class Left:
    """An answer that the judges have left open, with all submissions in which it was typed like this."""

    item: int
    answer: str
    code: str
    text: str
    lines: tuple[Line, ...]


async def give(bench: Bench, reader: Reader, task_set: TaskSet, new: NewMark) -> Mark:
    """Store a mark. What the judges have decided is changed with a reason alone.

    Raises:
        Refused: 404, no such submission in this set; 403, it is the reader's own, from before the reader taught here;
            422, no such answer, or no reason.
    """
    marked = await bench.storage.submission(new.receipt) if ids.known(new.receipt) else None
    place = await bench.sets.place(marked.handed.variant) if marked else None
    if marked is None or place is None or place.task_set.id != task_set.id or place.card.person is None:
        raise Refused(404, "unknown_submission")
    if place.card.person == themselves(reader).id:
        raise Refused(403, "own_work")
    if new.answer is not None and new.answer not in marked.grade["verdicts"]:
        raise Refused(422, "unknown_answer", field="answer", name=printable(new.answer))
    if not new.comment.strip() and (new.share is None or not await _is_open(bench, marked, new.answer)):
        raise Refused(422, "mark_without_reason", field="comment")
    mark = Mark(new.receipt, new.answer, new.share, new.comment.strip(), themselves(reader).id, datetime.now(UTC))
    entry = acts.entry(
        reader, Action.MARK_GIVEN, place.card.person, set=task_set.id, receipt=new.receipt, answer=new.answer,
        share=new.share,
    )  # fmt: skip
    await bench.marks.give([mark], entry)
    return mark


async def _is_open(bench: Bench, marked: Marked, answer: str | None) -> bool:
    handed = marked.handed
    line = Line("", "", handed.variant, handed.receipt, handed.time, marked.grade, marked.counted)
    given = by_submission(await bench.marks.on(handed.receipt))
    return answer in left_open(line, given.get(handed.receipt, {}))


async def waiting(bench: Bench, task_set: TaskSet) -> list[Left]:
    """List what the lecturer has still to settle in a set, equal texts together."""
    marks = by_submission(await bench.marks.of(task_set.id))
    return await waiting_in(bench, task_set, await bench.marks.lines(task_set.id), marks)


async def waiting_in(bench: Bench, task_set: TaskSet, lines: Sequence[Line], marks: Mapping[str, Given]) -> list[Left]:
    """List what is still to be settled in submissions that were read already, given the marks by hand."""
    doubtful = [line for line in lines if line.grade["verdicts"]]
    opened = [(line, name) for line in doubtful for name in left_open(line, marks.get(line.receipt, {}))]
    handed = await bench.marks.with_receipts(sorted({line.receipt for line, _ in opened}))
    numbers = {slot.id: slot.number for slot in task_set.slots}
    found: dict[tuple[int, str, str, str], list[Line]] = {}
    for line, name in opened:
        code = line.grade["verdicts"][name]["code"]
        found.setdefault((numbers[line.slot], name, code, _text(handed[line.receipt], name)), []).append(line)
    return [Left(*key, tuple(lines)) for key, lines in sorted(found.items(), key=lambda one: one[0])]


def _text(handed: Handed, answer: str) -> str:
    return whole(handed.answers).get(answer, "").strip()


async def settle(bench: Bench, reader: Reader, task_set: TaskSet, new: Settling) -> int:
    """Give all open answers with one text the same share; gives how many submissions that were.

    Raises:
        Refused: 404, there is none that is still open.
    """
    wanted = new.item, new.answer, new.text.strip()
    same = [one for one in await waiting(bench, task_set) if (one.item, one.answer, one.text) == wanted]
    lines = [line for one in same for line in one.lines if line.person != themselves(reader).id]
    if not lines:
        raise Refused(404, "settled_already")
    await bench.marks.give(_alike(lines, new, themselves(reader).id), acts.entry(
        reader, Action.MARK_GIVEN, task_set.id, item=new.item, answer=new.answer, share=new.share,
        submissions=len(lines),
    ))  # fmt: skip
    return len(lines)


def _alike(lines: Sequence[Line], new: Settling, author: str) -> list[Mark]:
    now, comment = datetime.now(UTC), new.comment.strip()
    return [Mark(line.receipt, new.answer, new.share, comment, author, now) for line in lines]
