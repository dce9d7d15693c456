"""The gradebook as programs read it."""

from __future__ import annotations

from datetime import datetime

from pydantic import BaseModel
from typing_extensions import TypedDict  # Pydantic asks for it below Python 3.12

from server.answering.receipts import GRADE
from server.answering.submissions import Judged, judged
from server.marks.giving import Left
from server.marks.gradebook import Cell, Gradebook, Row
from server.marks.history import History, Piece, Seen
from server.marks.totals import Total, totals
from server.sets.shapes import ListedTaskSet, listed_set
from server.storage.marks import Mark, Progress


class ShownStudent(BaseModel):
    """A student, with the name of the group; `left` is one who handed in and is no student of the course any more."""

    id: str
    login: str | None
    name: str
    group: str
    left: bool


class ShownCell(TypedDict):
    """A task of a student. `state` is right, partly, wrong, unreadable, undecided, fault, or open for no work yet;
    `provisional` says that the points can still change by what the lecturer settles; `hints` were opened at a price.
    `late_loss` and `hint_loss` are the points that lateness and these hints took off: `points` are what is left.
    """

    number: int
    state: str
    points: float
    late_loss: float
    hint_loss: float
    share: float | None
    provisional: bool
    late: bool
    by_hand: bool
    hints: int
    attempts: int
    submissions: int
    receipt: str | None
    variant: str | None
    code: str | None


class ShownRow(BaseModel):
    """A student in a set; `share` is weighed with the first chance where the set is a second one."""

    student: ShownStudent
    points: float
    share: float
    provisional: bool
    begun: datetime | None
    due: datetime | None
    extra_minutes: int
    items: list[ShownCell]


class ShownGradebook(BaseModel):
    """The gradebook of a set: students by group and name."""

    task_set: ListedTaskSet
    points: float
    items: list[float]
    students: list[ShownRow]


class SetColumn(BaseModel):
    """A set in the gradebook of a course."""

    id: str
    title: str
    points: float


class SetCell(BaseModel):
    """A set of a student; `taken` tells whether anything was judged."""

    points: float
    share: float
    taken: bool
    provisional: bool


class CourseRow(BaseModel):
    """A student in a course: the sets in the order of the columns. In `points` a set and its second chance count once,
    weighed: nine tenths of the better result and one tenth of the worse."""

    student: ShownStudent
    points: float
    provisional: bool
    sets: list[SetCell]


class CourseGradebook(BaseModel):
    """The gradebook of a course; `points` can be reached, a second chance adds none."""

    points: float
    sets: list[SetColumn]
    students: list[CourseRow]


class ShownMark(BaseModel):
    """A mark by hand: the share of one answer or of the whole, and why; without a share it is a comment."""

    number: int
    receipt: str
    answer: str | None
    share: float | None
    comment: str
    author: str
    time: datetime


class ShownPiece(BaseModel):
    """A submission as it was typed, judged and marked; `share` is what it earns with the marks by hand."""

    receipt: str
    time: datetime
    language: str
    late: bool
    counted: bool
    counts: bool
    score: float
    share: float
    verdicts: dict[str, Judged]
    open: list[str]
    answers: dict[str, str | list[str]]
    marks: list[ShownMark]


class ShownCard(BaseModel):
    """A card as the student saw it: from what was kept at publishing, in the student's language."""

    variant: str
    code: str
    exercise: str
    version: int
    seed: int
    language: str
    title: str
    statement: str
    statement_text: str
    figure: str | None
    draft: dict[str, str | list[str]] | None
    submissions: list[ShownPiece]


class ShownWork(BaseModel):
    """A task of a student with its cards, the present one first."""

    item: ShownCell
    cards: list[ShownCard]


class ShownHistory(BaseModel):
    """A student's work in a set."""

    student: ShownStudent
    points: float
    items: list[ShownWork]


class ShownLeft(BaseModel):
    """An answer that the judges have left open, and who typed it like this."""

    item: int
    answer: str
    code: str
    text: str
    students: list[str]
    receipts: list[str]


class Settled(BaseModel):
    """In how many submissions an open answer was settled."""

    submissions: int


class ShownProgress(BaseModel):
    """How far a student is: tasks opened and handed in, submissions, and when the last one came."""

    student: str
    opened: int
    answered: int
    submissions: int
    finished: bool
    last: datetime | None


class SetProgress(BaseModel):
    """How far a class is: how many have opened the set, handed something in, and handed in every task."""

    students: int
    opened: int
    handed_in: int
    finished: int
    each: list[ShownProgress]


def shown_gradebook(found: Gradebook) -> ShownGradebook:
    """Show the gradebook of a set."""
    return ShownGradebook(
        task_set=listed_set(found.task_set), points=found.worth, items=[slot.points for slot in found.task_set.slots],
        students=[_row(row) for row in found.rows],
    )  # fmt: skip


def course_gradebook(found: list[Gradebook]) -> CourseGradebook:
    """Show the gradebook of a course from those of its sets, which list the same students in the same order."""
    columns = [SetColumn(id=one.task_set.id, title=one.task_set.title, points=one.worth) for one in found]
    whole = totals(found)
    return CourseGradebook(points=whole.worth, sets=columns, students=[_course_row(one) for one in whole.students])


def shown_history(found: History) -> ShownHistory:
    """Show a student's work in a set."""
    works = [ShownWork(item=_cell(work.cell), cards=[_card(seen) for seen in work.cards]) for work in found.works]
    return ShownHistory(student=_student(found.row), points=found.row.points, items=works)


def shown_left(found: Left) -> ShownLeft:
    """Show an answer that was left open."""
    people = list(dict.fromkeys(line.person for line in found.lines))
    return ShownLeft(
        item=found.item, answer=found.answer, code=found.code, text=found.text, students=people,
        receipts=[line.receipt for line in found.lines],
    )  # fmt: skip


def shown_mark(mark: Mark) -> ShownMark:
    """Show a mark by hand."""
    return ShownMark(
        number=mark.number, receipt=mark.submission, answer=mark.answer, share=mark.share, comment=mark.comment,
        author=mark.author, time=mark.time,
    )  # fmt: skip


def set_progress(found: list[Progress], students: int, tasks: int) -> SetProgress:
    """Show how far a class is in a set of so many tasks."""
    each = [
        ShownProgress(
            student=one.person, opened=one.opened, answered=one.answered, submissions=one.submissions,
            finished=one.answered == tasks, last=one.last,
        )
        for one in found
    ]  # fmt: skip
    return SetProgress(
        students=students, opened=len(each), handed_in=sum(one.submissions > 0 for one in each),
        finished=sum(one.finished for one in each), each=each,
    )  # fmt: skip


def _student(row: Row) -> ShownStudent:
    person = row.member.person
    return ShownStudent(id=person.id, login=person.login, name=person.name, group=row.group, left=row.left)


def _row(row: Row) -> ShownRow:
    return ShownRow(
        student=_student(row), points=row.points, share=row.share, provisional=row.provisional, begun=row.begun,
        due=row.window.due, extra_minutes=row.extra, items=[_cell(cell) for cell in row.cells],
    )  # fmt: skip


def _cell(cell: Cell) -> ShownCell:
    return ShownCell(
        number=cell.slot.number, state=cell.state, points=cell.points, share=cell.share, provisional=cell.provisional,
        late_loss=cell.late_loss, hint_loss=cell.hint_loss,
        late=cell.late, by_hand=cell.by_hand, hints=cell.hints, attempts=cell.counted, submissions=cell.handed,
        receipt=cell.receipt,
        variant=cell.card.variant if cell.card else None, code=cell.card.code if cell.card else None,
    )  # fmt: skip


def _course_row(one: Total) -> CourseRow:
    cells = [SetCell(points=r.points, share=r.share, taken=r.taken, provisional=r.provisional) for r in one.rows]
    provisional = any(row.provisional for row in one.rows)
    return CourseRow(student=_student(one.rows[0]), points=one.points, provisional=provisional, sets=cells)


def _card(seen: Seen) -> ShownCard:
    card, shown = seen.card, seen.shown
    return ShownCard(
        variant=card.variant or "", code=card.code, exercise=card.exercise, version=card.version, seed=card.seed,
        language=seen.language, title=shown.title, statement=shown.statement_html, statement_text=shown.statement_text,
        figure=shown.picture.svg if shown.picture else None, draft=dict(seen.draft.answers) if seen.draft else None,
        submissions=[_piece(piece) for piece in seen.pieces],
    )  # fmt: skip


def _piece(piece: Piece) -> ShownPiece:
    handed, line = piece.handed, piece.line
    return ShownPiece(
        receipt=handed.receipt, time=handed.time, language=handed.language, late=piece.late, counted=line.counted,
        counts=piece.counts, score=line.grade["score"], share=piece.share, verdicts=verdicts_of(piece),
        open=list(piece.open), answers=dict(handed.answers), marks=[shown_mark(mark) for mark in piece.marks],
    )  # fmt: skip


def verdicts_of(piece: Piece) -> dict[str, Judged]:
    """Word the verdicts of a submission in the language in which its student read them."""
    grade = GRADE.validate_python(piece.line.grade)
    language, used = piece.handed.language, piece.line.counted
    return {name: judged(verdict, language, used=used) for name, verdict in grade.verdicts.items()}
