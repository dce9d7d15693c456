"""Pages of marks: the results of a set and of a course, and a student's work with the forms to mark it."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial
from typing import Any

from fastapi import APIRouter, Depends, Request
from markupsafe import Markup, escape
from pydantic import ValidationError
from starlette.responses import HTMLResponse, RedirectResponse, Response

from graders import Code
from graders.words import marked
from server.answering import forms
from server.answering.receipts import whole
from server.courses.api import here
from server.courses.zones import told
from server.marks import giving, gradebook
from server.marks.asking import asked, chosen, in_words
from server.marks.giving import NewMark, Settling
from server.marks.gradebook import Cell, Gradebook, Row
from server.marks.history import history
from server.marks.items import items, shown_item
from server.marks.shapes import verdicts_of
from server.marks.totals import totals
from server.policy import CourseRole
from server.reader import Asking, Reader, admit
from server.sets import clock
from server.sets.api import set_of
from server.sets.handing import rules_of
from server.sets.reopening import solved_for, told_results
from server.sets.wording import title_of
from server.web.errors import Refused
from server.web.language import say
from server.web.templating import decimal, page
from server.workbench import Bench, Tools

MOST_OPEN = 50  # open answers on a page
OPEN = "\ue000", "\ue001"  # where the address and the name of a student will stand

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@dataclass(frozen=True, slots=True)
class Summary:
    """A class at a glance: who has handed in, the median of the points and the middle half; none below two people."""

    students: int
    opened: int
    handed_in: int
    median: float | None
    quarters: tuple[float, float] | None


@router.get("/sets/{task_set}/results")
async def show_results(task_set: str, request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """Show the points of a class in a set, and what is left to the lecturer."""
    found = await gradebook.gradebook(bench, await set_of(bench, reader, task_set))
    left = await giving.waiting_in(bench, found.task_set, found.material.lines, found.material.marks)
    context = {
        "book": found,
        "summary": summary(found),
        "priced": any([cell.hints for row in found.rows for cell in row.cells]),
        "asked": asked(found.task_set, reader.language),
        "left": left[:MOST_OPEN],
        "more_left": len(left) - len(left[:MOST_OPEN]),
        "undecided": sum(one.code != Code.FAULT for one in left),
        "faults": sum(one.code == Code.FAULT for one in left),
        "names": {row.member.person.id: row.member.person.name for row in found.rows},
    }
    return page(request, reader.language, "results.html", context | _common(reader))


@router.get("/sets/{task_set}/analysis")
async def show_analysis(task_set: str, request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """Show what the answers of a class tell of the tasks."""
    found = await set_of(bench, reader, task_set)
    shown = [shown_item(one, reader.language) for one in await items(bench, found)]
    context = {
        "task_set": found,
        "items": shown,
        "asked": asked(found, reader.language),
        "chosen": chosen(found, reader.language),
        "titles": {slot.number: await _titles(bench, slot.pool, reader.language) for slot in found.slots},
        "signed": partial(_signed, reader.language),
        "rounded": partial(_rounded, reader.language, places=1),
        "chance": partial(_rounded, reader.language, places=4),
    }
    return page(request, reader.language, "analysis.html", context | _common(reader))


@router.get("/courses/{course}/results")
async def show_course(course: str, request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """Show the points of a class in all published sets."""
    books = await gradebook.of_course(bench, course)
    context = {"books": books, "whole": totals(books)}
    return page(request, reader.language, "course_results.html", context | _common(reader))


@router.get("/sets/{task_set}/students/{person}")
async def show_student(
    task_set: str, person: str, request: Request, bench: Tools, reader: Asking, reopened: bool = False
) -> HTMLResponse:
    """Show a student's work in a set as the student saw it, with the forms to mark it; `reopened` when extra time has
    just opened again a set whose results or solutions were shown."""
    its_set, given = await set_of(bench, reader, task_set), await bench.sets.accommodations(task_set)
    found = await history(bench, its_set, person)
    most = max((minutes for minutes, _ in given.values()), default=0)
    context = {
        "task_set": its_set,
        "exam": rules_of(its_set).mode == "exam",
        "solved_for": await solved_for(bench, its_set, datetime.now(UTC)),
        "reopened": reopened,
        "results_told": told_results(its_set, found.row.window, most, datetime.now(UTC)),
        "found": found,
        "lecturer": here(reader).role is CourseRole.LECTURER,
        "reason": given.get(person, (0, ""))[1],
        "verdicts": verdicts_of,
        "whole": whole,
        "in_words": in_words,
    }
    return page(request, reader.language, "student.html", context | _common(reader))


@router.post("/sets/{task_set}/marks")
async def give_mark(task_set: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Mark a submission and go back to the student's work."""
    values = (await forms.read(request)).values
    written = {
        "receipt": values.get("receipt", ""),
        "answer": values.get("answer") or None,
        "share": _share(values.get("share", "")),
        "comment": values.get("comment", "").replace("\r\n", "\n"),
    }
    new = _checked(NewMark.model_validate, written)
    await giving.give(bench, reader, await set_of(bench, reader, task_set), new)
    marked = await bench.storage.submission(new.receipt)
    place = await bench.sets.place(marked.handed.variant) if marked else None
    assert place is not None  # it was marked just now
    return RedirectResponse(f"/sets/{task_set}/students/{place.card.person}#item-{place.slot.number}", 303)


@router.post("/sets/{task_set}/open-answers")
async def settle(task_set: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Settle an open answer for all who typed it like this, and go back to the results."""
    values = (await forms.read(request)).values
    item = values.get("item", "")
    written = {
        "item": int(item) if item.isascii() and item.isdecimal() and len(item) < 4 else item,
        "answer": values.get("answer", ""),
        "text": values.get("text", "").replace("\r\n", "\n"),
        "share": _share(values.get("share", "")),
        "comment": values.get("comment", "").replace("\r\n", "\n"),
    }
    new = _checked(Settling.model_validate, written)
    await giving.settle(bench, reader, await set_of(bench, reader, task_set), new)
    return RedirectResponse(f"/sets/{task_set}/results#h-left", 303)


def summary(found: Gradebook) -> Summary:
    """Sum a class up, without those who are in it no more."""
    rows = [row for row in found.rows if not row.left]
    begun = [row for row in rows if row.begun is not None]
    points = [row.points for row in rows if row.taken]
    enough = len(points) > 1
    low, middle, high = statistics.quantiles(points, n=4, method="inclusive") if enough else (0.0, 0.0, 0.0)
    handed_in = sum(row.handed for row in rows)
    return Summary(len(rows), len(begun), handed_in, middle if enough else None, (low, high) if enough else None)


def _share(text: str) -> float | str | None:
    """Read a percentage as a share; what is none stays as it is, for the schema to refuse by name."""
    written = text.strip().removesuffix("%").strip().replace(",", ".")
    if not written:
        return None
    try:
        return float(written) / 100
    except ValueError:
        return text


def _checked(model: Callable[[Any], Any], written: dict[str, Any]) -> Any:
    try:
        return model(written)
    except ValidationError as error:
        field = ".".join(map(str, error.errors()[0]["loc"]))
        raise Refused(422, "out_of_range", field=field, name=field) from None


async def _titles(bench: Bench, pool: Sequence[str], language: str) -> str:
    return "; ".join([await title_of(bench, one, language) for one in pool])


def _common(reader: Reader) -> dict[str, Any]:
    course = here(reader).course
    return {
        "course": course,
        **told(reader.language, clock.zone(course.time_zone)),
        "told": partial(_told, reader.language),
        "once": once,
    }


def _rounded(language: str, value: float, *, places: int) -> str:
    text = f"{value:.{places}f}"
    return marked(text, language)


def _signed(language: str, value: float) -> str:
    return _rounded(language, value, places=2).replace("-", "−")


def once(draw: Callable[[Cell, str, str], Markup]) -> Callable[[Row, str], Markup]:
    """Draw cells that look alike once: a class has thousands, and few different ones.

    What is drawn leaves the address and the name of the student open; the cells of a row are filled in together.
    """
    drawn: dict[object, str] = {}

    def found(row: Row, address: str) -> Markup:
        for cell in row.cells:
            if cell.look not in drawn:
                drawn[cell.look] = str(draw(cell, *OPEN))
        cells = "".join([drawn[cell.look] for cell in row.cells])
        return Markup(cells.replace(OPEN[0], escape(address)).replace(OPEN[1], escape(row.member.person.name)))

    return found


def _told(language: str, cell: Cell) -> str:
    """Tell a cell in words."""
    state = say(language, f"marks.state_{cell.state}")
    return say(
        language, "marks.cell", item=cell.slot.number, state=state, points=decimal(language, cell.points),
        all=decimal(language, cell.slot.points),
    )  # fmt: skip
