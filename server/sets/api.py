"""Task sets for programs: building, opening, the student's own variants, more time, copies, sheets."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Annotated, Any, Literal

from fastapi import APIRouter, Depends, Path, Query, Response

from reports import formats
from server.answering.variants import ShownVariant, shown, visible
from server.audit import acts
from server.audit.acts import actor_of
from server.courses.api import HERE, ShownCourse, here, start
from server.jobs.api import ShownJob, shown_job
from server.policy import COURSE_LECTURER, CourseRole, Role
from server.reader import COURSES, Asking, Reader, admit, in_course
from server.sets import building, handing, printing, publishing, reopening
from server.sets.building import Draft
from server.sets.dealing import Trouble
from server.sets.publishing import Troubled
from server.sets.shapes import (
    ChangedTaskSet,
    ClassSheets,
    Copied,
    CopiedCourse,
    GivenTime,
    Later,
    ListedTaskSet,
    MoreTime,
    MovedTaskSet,
    MyTaskSet,
    NewCard,
    NewTaskSet,
    NewTime,
    ShownTaskSet,
    listed_set,
    my_set,
    shown_set,
)
from server.sets.standing import final, standing
from server.sets.wording import said, titles_of
from server.storage.audit import Action, Detail
from server.storage.courses import Course
from server.storage.jobs import FAILED, Busy, Job
from server.storage.sets import NotADraft, Slot, TaskSet
from server.web.errors import Failure, Refused
from server.workbench import Bench, Tools

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["task sets"])
FROZEN: dict[int | str, dict[str, Any]] = HERE | {409: {"model": Failure}}
FIELDS = {"limits": ("limits",), "unknown_given": ("limits",), "steps": ("pool",)}  # of an item, by what is wrong
WAIT = 20.0  # s that a request waits for a set to be published
Number = Annotated[int, Path(ge=1, le=building.MOST_SLOTS)]


async def _course_of(bench: Bench, number: str) -> str | None:
    found = await bench.sets.task_set(number)
    return found.course if found else None


COURSES["task_set"] = _course_of


@router.post("/task-sets", status_code=201, responses=HERE)
async def add_set(body: NewTaskSet, bench: Tools, reader: Asking) -> ShownTaskSet:
    """Start a set as a draft, in a course that one lectures."""
    place = await in_course(bench, reader, COURSE_LECTURER, body.course)
    draft = Draft.model_validate({name: getattr(body, name) for name in Draft.model_fields})
    return shown_set(await building.add(bench, here(place).course, draft))


@router.get("/courses/{course}/task-sets", responses=HERE)
async def list_sets(course: str, bench: Tools, reader: Asking) -> list[ListedTaskSet]:
    """List the sets of a course, the newest first; students see the published ones."""
    found = await listed(bench, reader)
    return [listed_set(one) for one in found]


@router.get("/task-sets/{task_set}", responses=HERE)
async def show_set(task_set: str, bench: Tools, reader: Asking) -> ShownTaskSet | MyTaskSet:
    """Show a set: to those who teach it as it was built, to a student as it stands for that student."""
    found = await set_of(bench, reader, task_set)
    if here(reader).role >= CourseRole.ASSISTANT:
        return shown_set(found)
    assert reader.person is not None
    now = datetime.now(UTC)
    own = await standing(bench, found, reader.person.id, now)
    return my_set(own, await final(bench, own, reader.person.id, now))


@router.patch("/task-sets/{task_set}", responses=FROZEN)
async def change_set(task_set: str, body: ChangedTaskSet, bench: Tools, reader: Asking) -> ShownTaskSet:
    """Change a draft. A published set is frozen."""
    old, course = await set_of(bench, reader, task_set), here(reader).course
    changes = {name: getattr(body, name) for name in body.model_fields_set - {"revision"}}
    for name in ("title", "items", "rules"):
        if changes.get(name, "") is None:
            raise Refused(422, "wrong_type", field=name, name=name)
    draft = building.merged(building.draft_of(old), changes)
    person = reader.person.id if reader.person else None
    return shown_set(await building.change(bench, old, course, draft, body.revision, person))


@router.delete("/task-sets/{task_set}", status_code=204, responses=FROZEN)
async def remove_set(task_set: str, bench: Tools, reader: Asking) -> None:
    """Remove a draft. A published set stays."""
    await building.remove(bench, await set_of(bench, reader, task_set), actor_of(reader))


@router.post("/task-sets/{task_set}/open", responses=FROZEN | {202: {"model": ShownTaskSet}})
async def open_set(
    task_set: str, response: Response, bench: Tools, reader: Asking,
    wait: Annotated[float, Query(ge=0, le=WAIT)] = WAIT,
) -> ShownTaskSet:  # fmt: skip
    """Publish a draft: a job draws and checks every card that will be dealt, then the set is frozen.

    Where that takes longer than `wait` seconds, the answer is 202, the set is `publishing`, and Location leads to the
    job. Students may work from the moment at which it opens.
    """
    job = await published(bench, reader, await set_of(bench, reader, task_set), wait)
    response.headers["Location"] = f"/api/v1/jobs/{job.id}"
    if job.live:
        response.status_code = 202
    return shown_set(await set_of(bench, reader, task_set))


@router.post(
    "/task-sets/{task_set}/items/{number}/variant", responses=HERE | {410: {"model": Failure}, 503: {"model": Failure}}
)
async def open_item(
    task_set: str, number: Number, bench: Tools, reader: Asking, body: NewCard | None = None
) -> ShownVariant:
    """Give one's own variant of a task; the first time it is dealt, later it is the same one."""
    found = await set_of(bench, reader, task_set)
    variant = await own_variant(bench, reader, found, slot_of(found, number), bool(body and body.another))
    return await shown(bench, await visible(bench, reader, variant), reader.language)


@router.get("/task-sets/{task_set}/accommodations", responses=HERE)
async def list_accommodations(task_set: str, bench: Tools, reader: Asking) -> list[GivenTime]:
    """List who has more time."""
    found = await bench.sets.accommodations(task_set)
    return [GivenTime(person=person, minutes=given[0], reason=given[1]) for person, given in sorted(found.items())]


@router.put("/task-sets/{task_set}/accommodations/{person}", responses=HERE)
async def give_time(task_set: str, person: str, body: MoreTime, bench: Tools, reader: Asking) -> NewTime:
    """Give a student more time; it moves the deadlines and the time limit, also of work under way.

    `reopened` warns that it opens a set again whose results or solutions the student may have seen.
    """
    again = await more_time(bench, reader, await set_of(bench, reader, task_set), person, body)
    return NewTime(person=person, minutes=body.minutes, reason=body.reason, reopened=again)


@router.post("/task-sets/{task_set}/extend", responses=HERE)
async def extend_set(task_set: str, body: Later, bench: Tools, reader: Asking) -> list[MovedTaskSet]:
    """Move the deadlines of a set, unless it has closed; gives what was moved."""
    return await _extended(bench, reader, [await set_of(bench, reader, task_set)], body.minutes)


@router.post("/courses/{course}/extend", responses=HERE)
async def extend_course(course: str, body: Later, bench: Tools, reader: Asking) -> list[MovedTaskSet]:
    """Move all open deadlines of a course; gives the sets that were moved."""
    return await _extended(bench, reader, list(await bench.sets.of(course)), body.minutes)


async def _extended(bench: Bench, reader: Reader, sets: list[TaskSet], minutes: int) -> list[MovedTaskSet]:
    moved = await building.extend(bench, sets, minutes, datetime.now(UTC), actor_of(reader))
    return [MovedTaskSet(**listed_set(one).model_dump(), solved_for=solved) for one, solved in moved]


@router.post("/task-sets/{task_set}/copy", status_code=201, responses=HERE)
async def copy_set(task_set: str, body: Copied, bench: Tools, reader: Asking) -> ShownTaskSet:
    """Copy a set as a draft, with its dates moved by whole days."""
    found = await set_of(bench, reader, task_set)
    return shown_set(await building.copy(bench, found, here(reader).course, body.days, actor_of(reader)))


@router.post("/courses/{course}/copy", status_code=201, responses=HERE)
async def copy_course(course: str, body: CopiedCourse, bench: Tools, reader: Asking) -> ShownCourse:
    """Start a course with copies of all sets of another, their dates moved by whole days; nobody comes along.

    Who may start a course may do so: a lecturer of the server.
    """
    new = await copied(bench, reader, body.title, body.days)
    return ShownCourse(
        id=new.id, title=new.title, language=new.language, time_zone=new.time_zone, role="lecturer",
        join_code=new.join_code, claims=new.claims,
    )  # fmt: skip


@router.get(
    "/task-sets/{task_set}/items/{number}/sheets.{form}",
    response_class=Response,
    responses=HERE | {429: {"model": Failure}, 200: {"content": {kind: {} for kind in formats.MEDIA.values()}}},
)
async def print_sheets(
    task_set: str, number: Number, form: Literal["pdf", "docx", "typ", "md"], bench: Tools, reader: Asking,
    key: Annotated[bool, Query()] = False, most: Annotated[int, Query(ge=1, le=1000)] = 1000,
) -> Response:  # fmt: skip
    """Print the cards of a task, one sheet a card; or their key, for lecturers only."""
    found = await set_of(bench, reader, task_set)
    slot = slot_of(found, number)
    cards = (await bench.sets.deck(found.id, slot.number))[:most]
    if not cards:
        raise Refused(409, "set_is_draft")
    shown = ((card.code, card.shown[reader.language], card.reference["texts"]) for card in cards)
    given = printing.Printed(reader.language, key, tuple(shown))
    (content,) = await bench.judging.apart(printing.document, [(given, form)])
    attached = {"Content-Disposition": f'attachment; filename="{"key" if key else "sheets"}-{number}.{form}"'}
    return Response(content, media_type=formats.MEDIA[form], headers=attached)


@router.post("/task-sets/{task_set}/sheets", status_code=202, responses=FROZEN)
async def print_class(
    task_set: str, response: Response, bench: Tools, reader: Asking, body: ClassSheets | None = None
) -> ShownJob:
    """Print all tasks of a published set for a class, as a job: sheets with codes, and the keys apart."""
    number = await printed(bench, reader, await set_of(bench, reader, task_set), body.most if body else None)
    response.headers["Location"] = f"/api/v1/jobs/{number}"
    return await shown_job(bench, number)


async def more_time(bench: Bench, reader: Reader, task_set: TaskSet, person: str, given: MoreTime) -> bool:
    """Give a student of the course more time in a set; tells whether that opens it again after its results were shown.

    Raises:
        Refused: 404, the person is no student of the course.
    """
    if await bench.courses.role(here(reader).course.id, person) != "student":
        raise Refused(404, "unknown_member")
    again = await reopening.reopens(bench, task_set, person, given.minutes, datetime.now(UTC))
    solved = await reopening.solved_for(bench, task_set, datetime.now(UTC)) if given.minutes else 0
    told: dict[str, Detail] = ({"reopened": True} if again else {}) | ({"solved_for": solved} if solved else {})
    entry = acts.entry(reader, Action.TIME_GIVEN, person, set=task_set.id, minutes=given.minutes, **told)
    await bench.sets.accommodate(task_set.id, person, given.minutes, given.reason, entry)
    return again


async def printed(bench: Bench, reader: Reader, task_set: TaskSet, most: int | None) -> str:
    """Order the sheets of a class: as many cards of each task as are asked for, else those of the students.

    Raises:
        Refused: 409, the set is not published, or its sheets are being printed.
    """
    if task_set.published is None:
        raise Refused(409, "set_is_draft")
    numbers = await bench.sets.numbers(task_set.id)
    kept = [number for number, person in numbers if person] or [number for number, _ in numbers]
    cards = kept if most is None else [number for number, _ in numbers][:most]
    person = reader.person.id if reader.person else None
    try:
        made = await printing.order(bench.jobs, task_set, cards, person, reader.language)
    except Busy as other:
        raise Refused(409, "job_under_way", number=str(other)) from None
    bench.engine.wake()
    return made


async def copied(bench: Bench, reader: Reader, title: str, days: int) -> Course:
    """Copy the course of an address with all its sets.

    Raises:
        Refused: 403, the reader may start no course; 422, the title cannot be used.
    """
    if reader.role < Role.LECTURER:
        raise Refused(403, "forbidden")
    old = here(reader).course
    new = await start(bench, reader, title, old.language, old.time_zone, copied=old.id)
    copies: dict[str, str] = {}
    for task_set in _firsts_first(await bench.sets.of(old.id)):
        first = copies.get(task_set.rules.get("second_chance_of") or "")
        copies[task_set.id] = (await building.copy(bench, task_set, new, days, actor_of(reader), first)).id
    return new


def _firsts_first(sets: Sequence[TaskSet]) -> list[TaskSet]:
    """Order sets from the oldest on, a second chance behind what it is a second chance to."""
    return sorted(reversed(sets), key=lambda one: one.rules.get("second_chance_of") is not None)


async def set_of(bench: Bench, reader: Reader, number: str) -> TaskSet:
    """Give a set; a draft is there for those alone who teach it.

    Raises:
        Refused: 404, there is none.
    """
    found = await bench.sets.task_set(number)
    if found is None or (found.published is None and here(reader).role < CourseRole.ASSISTANT):
        raise Refused(404, "unknown_set")
    return found


async def listed(bench: Bench, reader: Reader) -> list[TaskSet]:
    """List the sets of the course of an address that the reader may see."""
    staff = here(reader).role >= CourseRole.ASSISTANT
    return [one for one in await bench.sets.of(here(reader).course.id) if staff or one.published]


def slot_of(task_set: TaskSet, number: int) -> Slot:
    """Give a place in a set by its number.

    Raises:
        Refused: 404, there is none.
    """
    if not 1 <= number <= len(task_set.slots):
        raise Refused(404, "unknown_item")
    return task_set.slots[number - 1]


async def published(bench: Bench, reader: Reader, task_set: TaskSet, seconds: float) -> Job:
    """Publish a draft; gives the job, which may be under way still after the seconds that it was waited for.

    Raises:
        Refused: 409, it is published, is being published, or was changed meanwhile; 422, why it cannot be published;
            500, our fault.
    """
    if task_set.published:
        raise Refused(409, "set_frozen")
    try:
        person = reader.person.id if reader.person else None
        number = await publishing.order(bench, task_set, actor_of(reader), person)
    except (NotADraft, Busy):
        raise await _not_now(bench, task_set) from None
    except Troubled as error:
        raise await _troubled(bench, reader, error.troubles[0]) from None
    job = await publishing.waited(bench, number, seconds)
    if job.state == FAILED:
        troubles = publishing.troubles(job)
        raise await _troubled(bench, reader, troubles[0]) if troubles else Refused(500, "our_fault")
    return job


async def _not_now(bench: Bench, task_set: TaskSet) -> Refused:
    job = await bench.jobs.latest(publishing.NAME, task_set.id)
    return Refused(409, "job_under_way", number=job.id) if job is not None and job.live else Refused(409, "set_changed")


async def _troubled(bench: Bench, reader: Reader, trouble: Trouble) -> Refused:
    place = ("items", *((str(trouble.slot - 1), *FIELDS.get(trouble.code, ())) if trouble.slot else ()))
    field = ".".join(place)
    return Refused(
        422, "set_troubled", field=field, said=said(reader.language, trouble, await titles_of(bench, reader.language))
    )


async def own_variant(bench: Bench, reader: Reader, task_set: TaskSet, slot: Slot, another: bool) -> str:
    """Give the number of a student's own variant of a task.

    Raises:
        Refused: 403, the reader teaches here, or the set is not open.
    """
    if here(reader).role is not CourseRole.STUDENT or reader.person is None:
        raise Refused(403, "students_only")
    variant = await handing.open_task(bench, task_set, slot, reader.person.id)
    place = await bench.sets.place(variant) if another else None
    return variant if place is None else (await handing.another_card(bench, place)).variant or ""
