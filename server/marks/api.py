"""The gradebook for programs: marks of a set and of a course, progress, a student's work, marks by hand."""

from __future__ import annotations

import asyncio
import re
from typing import Any
from urllib.parse import quote

from fastapi import APIRouter, Depends, Response

from server.audit import acts
from server.courses.api import HERE, here
from server.marks import export, giving, gradebook
from server.marks.giving import NewMark, Settling
from server.marks.history import history
from server.marks.items import ItemStatistics, items, shown_item
from server.marks.shapes import (
    CourseGradebook,
    SetProgress,
    Settled,
    ShownGradebook,
    ShownHistory,
    ShownLeft,
    ShownMark,
    course_gradebook,
    set_progress,
    shown_gradebook,
    shown_history,
    shown_left,
    shown_mark,
)
from server.reader import Asking, Reader, admit
from server.sets.api import set_of
from server.storage.audit import Action
from server.workbench import Bench, Tools

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["marks"])
FILES: dict[int | str, dict[str, Any]] = HERE | {200: {"content": {kind: {} for kind in export.MEDIA.values()}}}
NOT_IN_NAMES = re.compile(r'[\\/:*?"<>|\x00-\x1f\x7f]+')  # of files, on one system or another
LONGEST_NAME = 80  # characters; 255 bytes is what a file's name may have


@router.get("/task-sets/{task_set}/gradebook", responses=HERE)
async def show_gradebook(task_set: str, bench: Tools, reader: Asking) -> ShownGradebook:
    """Give the points of all students in a set, as the rules of the set and the marks by hand have them."""
    return shown_gradebook(await gradebook.gradebook(bench, await set_of(bench, reader, task_set)))


@router.get("/courses/{course}/gradebook", responses=HERE)
async def show_course_gradebook(course: str, bench: Tools) -> CourseGradebook:
    """Give the points of all students in the published sets of a course, the oldest set first."""
    return course_gradebook(await gradebook.of_course(bench, course))


@router.get("/task-sets/{task_set}/marks.{form}", response_class=Response, responses=FILES)
async def export_set(
    task_set: str, form: export.Form, bench: Tools, reader: Asking, separator: export.Separator = "comma"
) -> Response:
    """Export the marks of a set as CSV or XLSX; with semicolons numbers have a decimal comma."""
    found = await gradebook.gradebook(bench, await set_of(bench, reader, task_set))
    table = export.of_set(found, here(reader).course.title, reader.language)
    return await _file(bench, reader, table, form, separator, found.task_set.title)


@router.get("/courses/{course}/marks.{form}", response_class=Response, responses=FILES)
async def export_course(
    course: str, form: export.Form, bench: Tools, reader: Asking, separator: export.Separator = "comma"
) -> Response:
    """Export the marks of all published sets of a course as CSV or XLSX."""
    found = await gradebook.of_course(bench, course)
    table = export.of_course(found, here(reader).course.title, reader.language)
    return await _file(bench, reader, table, form, separator, here(reader).course.title)


async def _file(
    bench: Bench, reader: Reader, table: export.Table, form: export.Form, separator: export.Separator, title: str
) -> Response:  # fmt: skip
    content = await asyncio.to_thread(export.written, table, form, separator)
    course = here(reader).course.id
    await bench.audit.note(acts.entry(reader, Action.MARKS_EXPORTED, course, students=len(table.rows)))
    attached = {"Content-Disposition": _attached(title, form), "Cache-Control": "no-store"}
    return Response(content, media_type=export.MEDIA[form], headers=attached)


def _attached(title: str, form: export.Form) -> str:
    """Name a file by what it is of (RFC 6266), without what some system does not take in the name of a file."""
    named = " ".join(NOT_IN_NAMES.sub(" ", title).split())[:LONGEST_NAME].strip(" .") or "marks"
    return f"attachment; filename=\"marks.{form}\"; filename*=UTF-8''{quote(f'{named}.{form}', safe='')}"


@router.get("/task-sets/{task_set}/progress", responses=HERE)
async def show_progress(task_set: str, bench: Tools, reader: Asking) -> SetProgress:
    """Tell how far the class is: two light queries, made to be asked again and again."""
    found = await set_of(bench, reader, task_set)
    here = set(await bench.sets.students(found.course))
    each = [one for one in await bench.marks.progress(found.id) if one.person in here]
    return set_progress(each, len(here), len(found.slots))


@router.get("/task-sets/{task_set}/students/{person}", responses=HERE)
async def show_history(task_set: str, person: str, bench: Tools, reader: Asking) -> ShownHistory:
    """Give all of a student's work in a set: what was shown, typed, judged and marked."""
    return shown_history(await history(bench, await set_of(bench, reader, task_set), person))


@router.get("/task-sets/{task_set}/statistics", responses=HERE)
async def show_statistics(task_set: str, bench: Tools, reader: Asking) -> list[ItemStatistics]:
    """Tell what the answers of the class say of the tasks; groups of fewer than five students are hidden."""
    found = await items(bench, await set_of(bench, reader, task_set))
    return [shown_item(one, reader.language) for one in found]


@router.post("/task-sets/{task_set}/marks", status_code=201, responses=HERE)
async def give_mark(task_set: str, body: NewMark, bench: Tools, reader: Asking) -> ShownMark:
    """Mark a submission by hand, or comment on it. The mark stays whatever is graded again later."""
    return shown_mark(await giving.give(bench, reader, await set_of(bench, reader, task_set), body))


@router.get("/task-sets/{task_set}/open-answers", responses=HERE)
async def list_open_answers(task_set: str, bench: Tools, reader: Asking) -> list[ShownLeft]:
    """List the answers that the judges have left to the lecturer, equal texts together."""
    return [shown_left(one) for one in await giving.waiting(bench, await set_of(bench, reader, task_set))]


@router.post("/task-sets/{task_set}/open-answers", responses=HERE)
async def settle_open_answer(task_set: str, body: Settling, bench: Tools, reader: Asking) -> Settled:
    """Settle an open answer for all who typed it like this."""
    return Settled(submissions=await giving.settle(bench, reader, await set_of(bench, reader, task_set), body))
