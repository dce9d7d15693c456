"""Pages of task sets: the list of a course, a student's set, the builder with its preview."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from functools import partial
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Path, Query, Request
from pydantic import ValidationError
from starlette.responses import HTMLResponse, RedirectResponse, Response

from exercises.variants import MAX_SEED
from server.answering import forms
from server.audit.acts import actor_of
from server.courses.api import here
from server.courses.zones import told
from server.policy import CourseRole
from server.reader import Asking, Reader, admit
from server.sets import building, clock, publishing
from server.sets.api import copied, listed, more_time, own_variant, printed, published, set_of, slot_of
from server.sets.building import Draft
from server.sets.clash import clash
from server.sets.duration import needed
from server.sets.foresight import length
from server.sets.form import draft_of_form, joined, problem, shelves, typed, written
from server.sets.previewing import preview
from server.sets.reopening import solved_for
from server.sets.shapes import MoreTime
from server.sets.standing import final, standing
from server.sets.wording import by_titles, titles_of
from server.storage.sets import DRAFT, PUBLISHING, TaskSet
from server.web.errors import Refused, printable, wants_page
from server.web.templating import page
from server.workbench import Bench, Tools

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)
NO_CLASH: Mapping[str, Any] = {"clash": None, "who": None, "mine": False}
PATIENCE = 2.0  # s that a person waits for a set to be published without seeing how far it is
Seed = Annotated[int, Query(ge=0, le=MAX_SEED)]
Number = Annotated[int, Path(ge=1, le=building.MOST_SLOTS)]


@router.get("/courses/{course}/sets")
async def show_sets(course: str, request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """List the sets of a course; a student sees how each stands."""
    found, person = await listed(bench, reader), reader.person
    staff = here(reader).role >= CourseRole.ASSISTANT
    now = datetime.now(UTC)
    own = {one.id: await standing(bench, one, person.id, now) for one in found if person and not staff}
    context = {"sets": found, "own": own, "lecturer": here(reader).role is CourseRole.LECTURER}
    return page(request, reader.language, "sets.html", context | _common(reader))


@router.post("/courses/{course}/sets")
async def start_set(course: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Start a set and go to the builder."""
    title = (await forms.read(request)).values.get("title", "").strip()
    made = await building.add(bench, here(reader).course, _checked({"title": title}))
    return RedirectResponse(f"/sets/{made.id}", 303)


@router.get("/sets/{task_set}")
async def show_set(
    task_set: str, request: Request, bench: Tools, reader: Asking,
    slot: Annotated[int, Query(ge=1, le=building.MOST_SLOTS)] = 1, seed: Seed = 1, table: bool = False,
) -> HTMLResponse:  # fmt: skip
    """Show a set: to a student the tasks, to those who teach it the builder."""
    found = await set_of(bench, reader, task_set)
    if here(reader).role >= CourseRole.ASSISTANT:
        return await _builder(request, bench, reader, found, slot, seed, table)
    assert reader.person is not None
    now = datetime.now(UTC)
    own = await standing(bench, found, reader.person.id, now)
    titles = await bench.sets.titles(found.id, reader.person.id, reader.language)
    share, takes = await final(bench, own, reader.person.id, now), needed(slot.pool for slot in found.slots)
    context = {"own": own, "share": share, "titles": titles, "takes": takes}
    return page(request, reader.language, "set.html", context | _common(reader))


@router.post("/sets/{task_set}")
async def save_set(task_set: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Save the draft as the form has it, and publish it if that was asked."""
    old, values = await set_of(bench, reader, task_set), joined(await forms.read(request))
    return await _save(request, bench, reader, old, values)


async def _save(request: Request, bench: Bench, reader: Reader, old: TaskSet, values: Mapping[str, str]) -> Response:
    kept = typed(values)
    try:
        new = await _changed(bench, reader, old, values)
        old, kept = new, kept | _loaded(written(new, clock.zone(here(reader).course.time_zone), reader.language))
        job = await published(bench, reader, new, PATIENCE) if values.get("then") == "publish" else None
    except Refused as refused:
        if not wants_page(request):
            raise
        if (refused.status_code, refused.field) == (409, "revision"):
            return await _clashed(request, bench, reader, old.id, values)
        if refused.status_code != 422:
            raise
        return await _builder(request, bench, reader, old, typed=kept, refused=refused)
    return RedirectResponse(f"/jobs/{job.id}" if job and job.live else f"/sets/{new.id}", 303)


async def _changed(bench: Bench, reader: Reader, old: TaskSet, values: Mapping[str, str]) -> TaskSet:
    revision = values.get("revision", "")
    if not (revision.isascii() and revision.isdecimal() and len(revision) < 10):
        raise Refused(422, "out_of_range", field="revision", name="revision")
    draft, person = _checked(draft_of_form(values)), reader.person.id if reader.person else None
    return await building.change(bench, old, here(reader).course, draft, int(revision), person)


def _loaded(form: Mapping[str, Any]) -> dict[str, Any]:
    """Give what a form tells of the draft that it was loaded from."""
    return {name: form[name] for name in ("revision", "base")}


async def _clashed(request: Request, bench: Bench, reader: Reader, number: str, values: Mapping[str, str]) -> Response:
    """Give back what was typed into a draft that has changed meanwhile, with who changed what, to save or to let go."""
    found = await set_of(bench, reader, number)
    if _done(reader, found, values):
        return RedirectResponse(f"/sets/{number}", 303)
    titles = {one.id: one.title for one in await bench.sets.of(found.course)} | await titles_of(bench, reader.language)
    stored = written(found, clock.zone(here(reader).course.time_zone), reader.language)
    both = clash(reader.language, values, stored, titles)
    if not both.mine and not both.theirs:  # one button pressed twice, or a draft that was saved as it was
        return await _unhindered(request, bench, reader, found, values)
    who = await bench.people.person(found.changed_by) if found.changed_by else None
    mine = reader.person is not None and found.changed_by == reader.person.id
    told = {"clash": both, "who": who.name if who else None, "mine": mine}
    form = both.form if found.state == DRAFT else stored
    return await _builder(request, bench, reader, found, typed=form, told=told, status=409)


def _done(reader: Reader, found: TaskSet, values: Mapping[str, str]) -> bool:
    """Tell whether a task was added, moved or removed as is asked: the button was pressed twice."""
    asked = any(values.get(name) for name in ("add", "move", "remove"))
    return asked and building.says(found, here(reader).course, _checked(draft_of_form(values)))


async def _unhindered(
    request: Request, bench: Bench, reader: Reader, found: TaskSet, values: Mapping[str, str]
) -> Response:
    """Do what was asked of a draft in which nothing stands otherwise, or show what has become of it."""
    if found.state == DRAFT:
        return await _save(request, bench, reader, found, {**values, "revision": str(found.revision)})
    job = await bench.jobs.latest(publishing.NAME, found.id)
    return RedirectResponse(f"/jobs/{job.id}" if job and job.live else f"/sets/{found.id}", 303)


@router.post("/sets/{task_set}/remove")
async def remove_set(task_set: str, bench: Tools, reader: Asking) -> Response:
    """Remove a draft and go to the sets of the course."""
    found = await set_of(bench, reader, task_set)
    await building.remove(bench, found, actor_of(reader))
    return RedirectResponse(f"/courses/{found.course}/sets", 303)


@router.post("/sets/{task_set}/students/{person}/time")
async def give_time(task_set: str, person: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Give a student more time and go back to that student's work."""
    values = (await forms.read(request)).values
    minutes = _whole(values.get("minutes", ""), "minutes", 0, 100_000)
    reason = printable(values.get("reason", "").strip())
    given = MoreTime(minutes=minutes, reason=reason)
    again = await more_time(bench, reader, await set_of(bench, reader, task_set), person, given)
    return RedirectResponse(f"/sets/{task_set}/students/{person}" + ("?reopened=true" if again else ""), 303)


@router.post("/sets/{task_set}/items/{number}")
async def open_item(task_set: str, number: Number, request: Request, bench: Tools, reader: Asking) -> Response:
    """Deal a student's card, or give the one dealt before, and go there."""
    another = (await forms.read(request)).values.get("another") == "yes"
    found = await set_of(bench, reader, task_set)
    variant = await own_variant(bench, reader, found, slot_of(found, number), another)
    return RedirectResponse(f"/variants/{variant}", 303)


@router.post("/sets/{task_set}/extend")
async def extend_set(task_set: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Move the open deadlines of a set."""
    await _extended(request, bench, reader, [await set_of(bench, reader, task_set)])
    return RedirectResponse(f"/sets/{task_set}", 303)


@router.post("/courses/{course}/extend")
async def extend_course(course: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Move all open deadlines of a course and tell how many were moved."""
    moved = await _extended(request, bench, reader, await bench.sets.of(course))
    return RedirectResponse(f"/courses/{course}?moved={moved}#h-later", 303)


async def _extended(request: Request, bench: Bench, reader: Reader, sets: Sequence[TaskSet]) -> int:
    """Move deadlines as a form wishes, from those that it was made for: a second click moves nothing. Tells how many
    sets were moved."""
    values = (await forms.read(request)).values
    minutes = _whole(values.get("minutes", ""), "minutes", 1, 100_000)
    seen = values.get("seen", "")
    return len(await building.extend(bench, sets, minutes, datetime.now(UTC), actor_of(reader), seen))


@router.post("/courses/{course}/copy")
async def copy_course(course: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Start a course with copies of all sets of this one and go there."""
    values = (await forms.read(request)).values
    days = _whole(values.get("days", ""), "days", -3660, 3660)
    made = await copied(bench, reader, values.get("title", ""), days)
    return RedirectResponse(f"/courses/{made.id}", 303)


@router.post("/sets/{task_set}/sheets")
async def print_class(task_set: str, bench: Tools, reader: Asking) -> Response:
    """Print all tasks for the class and go to the progress."""
    number = await printed(bench, reader, await set_of(bench, reader, task_set), None)
    return RedirectResponse(f"/jobs/{number}", 303)


@router.post("/sets/{task_set}/copy")
async def copy_set(task_set: str, bench: Tools, reader: Asking) -> Response:
    """Copy a set as a draft and go there."""
    made = await building.copy(bench, await set_of(bench, reader, task_set), here(reader).course, 0, actor_of(reader))
    return RedirectResponse(f"/sets/{made.id}", 303)


def _whole(text: str, name: str, least: int, most: int) -> int:
    digits = text.strip().removeprefix("-")
    if not (digits.isascii() and digits.isdecimal() and len(digits) <= 6 and least <= int(text) <= most):
        raise Refused(422, "out_of_range", field=name, name=name)
    return int(text)


def _checked(written: Mapping[str, Any]) -> Draft:
    try:
        return Draft.model_validate(written)
    except ValidationError as error:
        field = ".".join(map(str, error.errors()[0]["loc"]))
        raise Refused(422, "wrong_type", field=field, name=field) from None


def _common(reader: Reader) -> dict[str, Any]:
    course = here(reader).course
    return {"course": course, **told(reader.language, clock.zone(course.time_zone))}


async def _builder(
    request: Request, bench: Bench, reader: Reader, found: TaskSet, number: int = 1, seed: int = 1, table: bool = False,
    typed: Mapping[str, Any] | None = None, refused: Refused | None = None,
    told: Mapping[str, Any] = NO_CLASH, status: int = 200,
) -> HTMLResponse:  # fmt: skip
    """Show the builder; after a refusal with what was typed, and why it cannot be taken."""
    slot = found.slots[min(number, len(found.slots)) - 1] if found.slots else None
    place = clock.zone(here(reader).course.time_zone)
    job = await bench.jobs.latest(publishing.NAME, found.id) if found.state == PUBLISHING else None
    dealt = await bench.jobs.progress(job.id) if job else ()
    titles = await titles_of(bench, reader.language)
    unfit = refused or (await building.unfit(bench, found) if found.state == DRAFT else None)
    context = {
        "task_set": found,
        "written": typed or written(found, place, reader.language),
        "problem": problem(reader.language, unfit, titles) if unfit else None,
        "wait": None,
        "scarce": await building.scarcely(bench, found) if found.state == DRAFT and not unfit else (),
        "uneven": await building.unequal(bench, found) if found.state == DRAFT and not unfit else (),
        "firsts": [one for one in await bench.sets.of(found.course) if _may_be_first(one, found)],
        "lecturer": here(reader).role is CourseRole.LECTURER,
        "seen_deadlines": building.deadlines([found]),
        "movable": bool(building.movable([found], datetime.now(UTC))),
        "solved_for": await solved_for(bench, found, datetime.now(UTC)),
        "job": job,
        "cards": (sum(one.reached for one in dealt), sum(one.parts for one in dealt)),
        "students": len(await bench.sets.students(found.course)),
        "takes": needed(slot.pool for slot in found.slots),
        "slot": slot,
        "seed": seed,
        "last_seed": MAX_SEED,
        "seen": await bench.judging.run(preview, slot.pool[0], seed, reader.language, table, slot.limits)
        if slot
        else None,
        "titles": titles,
        "lengths": {one: await bench.judging.run(length, one) for one in titles} if found.state == DRAFT else {},
        "shelves": partial(shelves, titles),
        "by_titles": by_titles,
    }
    status = refused.status_code if refused else status
    return page(request, reader.language, "builder.html", {**context, **told, **_common(reader)}, status=status)


def _may_be_first(one: TaskSet, second: TaskSet) -> bool:
    """Whether a set may be the one to which another is a second chance."""
    return one.id != second.id and one.published is not None and not one.rules.get("second_chance_of")
