"""Task sets as programs write and read them; what students are shown has shapes of its own."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated

from pydantic import BaseModel, Field, StrictBool, StrictInt

from server.people.api import Strict
from server.sets import building, handing
from server.sets.building import Days, Draft, Item, Local, Minutes, Title
from server.sets.rules import Rules
from server.sets.standing import Standing, Task
from server.storage.sets import TaskSet
from server.web.typed import Typed


class NewTaskSet(Draft):
    """A set and the course it is for."""

    course: Annotated[Typed, Field(max_length=32)]


class ChangedTaskSet(Strict):
    """What changes in a draft of a revision; what is left out stays."""

    revision: Annotated[StrictInt, Field(ge=1)]
    title: Title | None = None
    items: Annotated[tuple[Item, ...], Field(max_length=building.MOST_SLOTS)] | None = None
    opens: Local | None = None
    due: Local | None = None
    closes: Local | None = None
    rules: Rules | None = None


class NewCard(Strict):
    """Whether another card is wished for, in place of one that our fault has spoilt."""

    another: StrictBool = False


class MoreTime(Strict):
    """How many minutes more a student has (0 takes them back), and why."""

    minutes: Annotated[StrictInt, Field(ge=0, le=100_000)]
    reason: Annotated[Typed, Field(max_length=200)] = ""


class Later(Strict):
    """By how many minutes the open deadlines move."""

    minutes: Minutes


class Copied(Strict):
    """By how many days the dates of a copy move."""

    days: Days = 0


class ClassSheets(Strict):
    """How many cards of each task are printed; without a number, those of the students."""

    most: Annotated[StrictInt, Field(ge=1, le=1000)] | None = None


class CopiedCourse(Copied):
    """The title of a new course that gets copies of all sets, and by how many days their dates move."""

    title: Title


class ShownItem(BaseModel):
    """A place in a set as its lecturers see it."""

    number: int
    pool: list[str]
    points: float
    attempts: int | None
    limits: dict[str, tuple[float, float]]


class ShownTaskSet(BaseModel):
    """A set as its lecturers see it."""

    id: str
    course: str
    title: str
    state: str
    revision: int
    opens: datetime | None
    due: datetime | None
    closes: datetime | None
    rules: Rules
    items: list[ShownItem]


class LedgerLine(BaseModel):
    """A submission of one's own; what an examination holds back has no score. `hints` were opened at a price before."""

    receipt: str
    time: datetime
    counted: bool
    score: float | None
    hints: int


class MyItem(BaseModel):
    """One's own task in a set: the points it is worth and has earned, the attempts, the variant once it is open."""

    number: int
    points: float
    earned: float | None
    attempts: int | None
    left: int | None
    variant: str | None
    code: str | None
    ledger: list[LedgerLine]


class MyTaskSet(BaseModel):
    """A set as its student sees it: the own window, the points, the rules that decide over them."""

    id: str
    course: str
    title: str
    stage: str
    opens: datetime | None
    due: datetime | None
    closes: datetime | None
    held: bool
    points: float
    earned: float | None
    share: float | None
    rules: Rules
    items: list[MyItem]


class ListedTaskSet(BaseModel):
    """A set in the list of a course."""

    id: str
    title: str
    state: str
    opens: datetime | None
    due: datetime | None
    closes: datetime | None


class MovedTaskSet(ListedTaskSet):
    """A set whose deadlines were moved; `solved_for` tells to how many students its solutions stood open already."""

    solved_for: int


class GivenTime(BaseModel):
    """The minutes more that a student has."""

    person: str
    minutes: int
    reason: str


class NewTime(GivenTime):
    """The minutes more that were given; `reopened` where that opened a set again whose results or solutions the student
    may have seen."""

    reopened: bool


def listed_set(found: TaskSet) -> ListedTaskSet:
    """Show a set in a list."""
    return ListedTaskSet(**{name: getattr(found, name) for name in ListedTaskSet.model_fields})


def shown_set(found: TaskSet) -> ShownTaskSet:
    """Show a set to those who teach it."""
    items = [
        ShownItem(number=slot.number, pool=list(slot.pool), points=slot.points, attempts=slot.attempts,
                  limits=dict(slot.limits))
        for slot in found.slots
    ]  # fmt: skip
    return ShownTaskSet(
        id=found.id, course=found.course, title=found.title, state=found.state, revision=found.revision,
        opens=found.opens, due=found.due, closes=found.closes, rules=handing.rules_of(found), items=items,
    )  # fmt: skip


def my_set(own: Standing, share: float | None) -> MyTaskSet:
    """Show a set to its student."""
    found = own.task_set
    return MyTaskSet(
        id=found.id, course=found.course, title=found.title, stage=own.stage.value, opens=own.window.opens,
        due=own.window.due, closes=own.window.closes, held=own.held, points=own.worth,
        earned=None if own.held else own.points, share=None if share is None else round(share, 6), rules=own.rules,
        items=[_my_item(task, own.held) for task in own.tasks],
    )  # fmt: skip


def _my_item(task: Task, held: bool) -> MyItem:
    lines = [
        LedgerLine(
            receipt=one.receipt, time=one.time, counted=one.counted, score=None if held else one.share, hints=one.hints
        )
        for one in task.ledger
    ]
    return MyItem(
        number=task.slot.number, points=task.slot.points, earned=None if held else task.points,
        attempts=task.slot.attempts, left=task.left, variant=task.card.variant if task.card else None,
        code=task.card.code if task.card else None, ledger=lines,
    )  # fmt: skip
