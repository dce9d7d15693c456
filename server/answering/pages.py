"""The pages of a variant: dealing one, workspace, worked solution. Complete HTML; scripts only add to it."""

from __future__ import annotations

import json
import secrets
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query, Request
from starlette.responses import HTMLResponse, RedirectResponse

from exercises import catalogue, presenting
from exercises.variants import MAX_SEED
from server.answering import forms
from server.answering.drafts import fresher, is_late, keep
from server.answering.forms import Form
from server.answering.hints import open_hint, price, with_ladders
from server.answering.laboratory import laboratory, without_empty
from server.answering.receipts import whole
from server.answering.submissions import Graded, graded, receipted, submit
from server.answering.variants import (
    dealt_to,
    presented,
    restored,
    results_are_held,
    solution_is_open,
    solved,
    visible,
)  # fmt: skip
from server.answering.workspace import lines, marked
from server.courses import zones
from server.policy import may_answer
from server.reader import Asking, Reader, admit, remember
from server.sets.standing import on_page
from server.storage import Dealt, Draft
from server.web import ids
from server.web.errors import Refused
from server.web.language import part
from server.web.templating import page
from server.workbench import Bench, Tools

SECTIONS = 13  # of the form of report TMM-2

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@dataclass(frozen=True, slots=True)
class Work:
    """What is on the desk: a variant, what was typed, the submission shown, the draft kept; `past`: only to look at."""

    dealt: Dealt
    typed: Mapping[str, str]
    result: Graded | None
    draft: Draft | None
    fresh: bool = False
    reported: bool | None = None
    section: int | None = None
    past: bool = False


@router.post("/exercises/{exercise}")
async def practise(exercise: str, request: Request, bench: Tools, reader: Asking) -> RedirectResponse:
    """Deal a variant and go there."""
    form = await forms.read(request)
    dealt, cookie = await dealt_to(bench, reader, exercise, _seed(form.values.get("seed", "").strip()))
    response = RedirectResponse(f"/variants/{dealt.id}", 303)
    remember(response, bench, cookie)
    return response


def _seed(text: str) -> int | None:
    if not text:
        return None
    if not (text.isascii() and text.isdecimal() and len(text) <= 16 and int(text) <= MAX_SEED):
        raise Refused(422, "out_of_range", field="seed", name="seed")
    return int(text)


@router.get("/variants/{variant}")
async def show_workspace(
    variant: str,
    request: Request,
    bench: Tools,
    reader: Asking,
    receipt: Annotated[str | None, Query(max_length=64)] = None,
    reported: Annotated[bool | None, Query()] = None,
    section: Annotated[int | None, Query(ge=1, le=SECTIONS)] = None,
) -> HTMLResponse:
    """Show the task with its figure and answers, as they were last typed or handed in."""
    dealt = await visible(bench, reader, variant)
    newest = await bench.storage.latest(dealt.id)
    last = await receipted(bench, reader, receipt) if receipt else newest
    if last is not None and last.handed.variant != dealt.id:
        raise Refused(404, "unknown_submission")
    past = last is not None and newest is not None and last.handed.receipt != newest.handed.receipt
    staff = reader.owner_id != dealt.owner.id
    result = await graded(bench, last, reader.language, staff=staff) if last else None
    draft = await bench.storage.draft(dealt.id) if may_answer(reader.owner_id, dealt) else None
    typed = draft.answers if draft and fresher(draft, last) and not past else result.answers if result else {}
    work = Work(dealt, whole(typed), result, draft, bool(receipt), reported, section, past)
    return await _workspace(request, bench, reader, work)


@router.post("/variants/{variant}")
async def check(variant: str, request: Request, bench: Tools, reader: Asking) -> RedirectResponse:
    """Hand in the answers and go to the verdicts."""
    form = await forms.read(request)
    dealt = await visible(bench, reader, variant)
    typed = await _typed(bench, reader, dealt, form)
    body = ids.digest(form.raw)
    key = form.values.get(forms.KEY, "")[:32]
    once = ids.digest(key.encode(), body.encode()) if key else None  # another answer on the same page is a new one
    done = await submit(bench, reader, variant, typed, once, body)
    section = form.values.get("section", "")
    place = f"&section={section}#section-{section}" if section in map(str, range(1, SECTIONS + 1)) else "#result"
    return RedirectResponse(f"/variants/{dealt.id}?receipt={done.marked.handed.receipt}{place}", 303)


@router.post("/variants/{variant}/hints")
async def buy_hint(variant: str, request: Request, bench: Tools, reader: Asking) -> RedirectResponse:
    """Open the next hint under an answer at its price, and go back to the answer."""
    values = (await forms.read(request)).values
    dealt = await visible(bench, reader, variant)
    answer = values.get("answer", "")
    await open_hint(bench, reader, dealt, answer, values.get("rung", ""))
    number = list((await _shown(bench, reader, dealt)).answers).index(answer) + 1
    return RedirectResponse(f"/variants/{dealt.id}#a{number}-hint", 303)


@router.post("/variants/{variant}/preview")
async def show_reading(variant: str, request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """Show how the answers are read, without judging them; they are kept as the draft."""
    form = await forms.read(request)
    dealt = await visible(bench, reader, variant)
    typed = await _typed(bench, reader, dealt, form)
    draft = await bench.storage.draft(dealt.id)
    if may_answer(reader.owner_id, dealt) and not await is_late(bench, dealt, datetime.now(UTC)):
        draft, _ = await keep(bench, dealt, typed, draft.revision if draft else 0)
    return await _workspace(request, bench, reader, Work(dealt, typed, None, draft))


@router.get("/variants/{variant}/solution")
async def show_solution(variant: str, request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """Show the worked solution once it is open."""
    dealt = await visible(bench, reader, variant)
    context = {"lines": await solved(bench, reader, dealt), "dealt": dealt, "shown": await _shown(bench, reader, dealt)}
    return page(request, reader.language, "solution.html", context)


async def _shown(bench: Bench, reader: Reader, dealt: Dealt) -> presenting.Presented:
    return await presented(bench, dealt, reader.language)


async def _hinted(bench: Bench, result: Graded) -> int:
    """Count the hints that were opened at a price before a submission."""
    return sum(hint.time <= result.receipt.time for hint in await bench.sets.hints(result.variant))


async def _typed(bench: Bench, reader: Reader, dealt: Dealt, form: Form) -> dict[str, str]:
    shown = await _shown(bench, reader, dealt)
    return {name: form.answer(field) for name, field in shown.answers.items()}


async def _told(bench: Bench, reader: Reader, dealt: Dealt) -> dict[str, Any]:
    """Give what the page shows of the set of a variant, and how it tells moments."""
    if not dealt.code:
        return {"task": None, **zones.told(reader.language, await zones.of_reader(bench, reader))}
    return await on_page(bench, dealt.id, reader.language, datetime.now(UTC))


async def _workspace(request: Request, bench: Bench, reader: Reader, work: Work) -> HTMLResponse:
    dealt, result = work.dealt, work.result
    shown, variant = await _shown(bench, reader, dealt), restored(dealt)
    laid = await lines(bench, variant, shown.answers, work.typed, result, reader.language)
    if catalogue.load(variant.exercise).exercise.report:
        laid = without_empty(laid)
    laid = marked(laid, result) if result else laid
    laid = await with_ladders(bench, reader, dealt, laid) if result else laid
    held = await results_are_held(bench, reader, dealt)
    lab = await bench.judging.run(laboratory, variant, laid, reader.language, work.section, held)
    judged = result.verdicts.values() if result else ()
    context: dict[str, Any] = {
        "dealt": dealt,
        "shown": shown,
        "lab": lab,
        "lines": laid,
        "result": result,
        "fresh": work.fresh,
        "past": work.past,
        "draft": work.draft,
        "reported": work.reported,
        "mine": may_answer(reader.owner_id, dealt),
        "right": sum(verdict.outcome == "right" for verdict in judged),
        "judged": any(verdict.outcome != "unreadable" for verdict in judged),
        "open": [line for line in laid if line.verdict and line.verdict.outcome not in ("right", "undecided")],
        "empty": result is not None and not any(text.strip() for text in whole(result.answers).values()),
        "marks": [one for one in result.by_hand if all(one not in line.marks for line in laid)] if result else [],
        "price": await price(bench, reader, dealt),
        "hinted": await _hinted(bench, result) if result and dealt.code else 0,
        "key": secrets.token_hex(8),
        "phrases": json.dumps(part(reader.language, "visual"), ensure_ascii=False),
        **(await _told(bench, reader, dealt)),
        "solution": await solution_is_open(bench, reader, dealt),
    }
    template = "laboratory.html" if lab else "workspace.html"
    return page(request, reader.language, template, context, path=f"/variants/{dealt.id}")
