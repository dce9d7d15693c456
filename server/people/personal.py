"""What is kept of a person: handed out to the person and to administrators, and erased on request.

What an examination still holds back is left out. Erasing keeps the marks of sets and the answers that were judged,
under a number that is nobody's name; it removes names, logins, memberships, sessions, tokens, drafts, practice,
reports, comments, reasons, and every answer that no judge has read.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from datetime import UTC, datetime
from typing import Any

from fastapi import APIRouter, Depends
from fastapi.encoders import jsonable_encoder
from starlette.responses import JSONResponse, Response

from graders import Code
from graders.verdict import Outcome
from server.answering.receipts import GRADE
from server.audit import acts
from server.people.api import REFUSED, signed_in
from server.policy import Role
from server.reader import Asking, admit
from server.sets import handing
from server.storage.audit import Action, Entry
from server.storage.people import People
from server.storage.personal import Kept, Personal
from server.storage.practice import Answers, Marked
from server.storage.sets import Sets
from server.web.errors import Failure, Refused
from server.workbench import Bench, Tools

JUDGED = (Outcome.RIGHT, Outcome.PARTLY, Outcome.WRONG)
GONE: dict[int | str, dict[str, Any]] = REFUSED | {404: {"model": Failure}}

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["people"])
pages = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@router.get("/me/data", responses=REFUSED)
async def show_own(bench: Tools, reader: Asking) -> dict[str, Any]:
    """Give all that is kept of oneself."""
    return await given_out(bench, signed_in(reader).id, acts.actor_of(reader))


@router.get("/people/{person}/data", responses=GONE)
async def show_data(person: str, bench: Tools, reader: Asking) -> dict[str, Any]:
    """Give all that is kept of a person."""
    return await given_out(bench, person, acts.actor_of(reader))


@router.delete("/people/{person}", status_code=204, responses=GONE)
async def erase_person(person: str, bench: Tools, reader: Asking) -> None:
    """Erase a person. Marks stay under a number; nothing brings the person back but a backup."""
    await erase(bench, person, acts.actor_of(reader))


@pages.get("/account/data")
async def download_own(bench: Tools, reader: Asking) -> Response:
    """Download all that is kept of oneself."""
    return _file(await given_out(bench, signed_in(reader).id, acts.actor_of(reader)))


@pages.get("/people/{person}/data")
async def download_data(person: str, bench: Tools, reader: Asking) -> Response:
    """Download all that is kept of a person."""
    return _file(await given_out(bench, person, acts.actor_of(reader)))


def _file(data: dict[str, Any]) -> Response:
    attached = {
        "Content-Disposition": f'attachment; filename="{data["person"]["id"]}.json"',
        "Cache-Control": "no-store",
    }
    return JSONResponse(data, headers=attached)


async def given_out(bench: Bench, number: str, actor: str) -> dict[str, Any]:
    """Give all that is kept of a person, and note that it was given.

    Raises:
        Refused: 404, there is no such person.
    """
    data = await collected(bench.personal, bench.sets, number)
    await bench.audit.note(exported(number, actor))
    return data


def exported(number: str, actor: str) -> Entry:
    """Say in the audit log that the data of a person was given out."""
    return Entry(actor, Action.PERSON_EXPORTED, number)


async def collected(personal: Personal, sets: Sets, number: str) -> dict[str, Any]:
    """Give all that is kept of a person as JSON values, but what an examination still holds back.

    Raises:
        Refused: 404, there is no such person.
    """
    kept = await personal.kept(number)
    if kept is None:
        raise Refused(404, "unknown_person")
    held = {one.handed.receipt for one in kept.submissions if await _held(sets, one)}
    told = {
        "person": kept.person, "courses": kept.courses, "sessions": kept.sessions, "tokens": kept.tokens,
        "variants": [dict(row) | ({"seed": None} if row["code"] else {}) for row in kept.variants],
        "submissions": [_told(one, one.handed.receipt in held) for one in kept.submissions],
        "drafts": kept.drafts, "problems": kept.problems, "hints": kept.hints,
        "marks": [row for row in kept.marks if row["submission"] not in held],
        "extra_time": kept.extra, "acts": _acts(kept, held),
    }  # fmt: skip
    encoded: dict[str, Any] = jsonable_encoder(told)
    return encoded


async def _held(sets: Sets, marked: Marked) -> bool:
    place = await sets.place(marked.handed.variant) if marked.code else None
    return place is not None and handing.is_held(place, datetime.now(UTC))


def _told(marked: Marked, held: bool) -> dict[str, Any]:
    handed, grade = marked.handed, GRADE.validate_python(marked.grade)
    told = {
        "receipt": handed.receipt, "variant": handed.variant, "time": handed.time, "answers": handed.answers,
        "digest": handed.digest, "counted": marked.counted, "held": held,
    }  # fmt: skip
    if held:
        return told
    return told | {"score": grade.score, "verdicts": {name: one.code for name, one in grade.verdicts.items()}}


def _acts(kept: Kept, held: Collection[str]) -> list[dict[str, Any]]:
    return [
        {"time": line.time, "action": line.entry.action, "by_person": line.entry.actor == kept.person["id"],
         "details": line.entry.details}
        for line in kept.acts
        if line.entry.details.get("receipt") not in held
    ]  # fmt: skip


async def erase(bench: Bench, number: str, actor: str) -> None:
    """Erase a person.

    Raises:
        Refused: 404, there is no such person; 403, the person administers the server.
    """
    await erased(bench.people, bench.personal, number, actor)


async def erased(people: People, personal: Personal, number: str, actor: str) -> None:
    """Erase a person; raises Refused as `erase` does."""
    person = await people.person(number)
    if person is None:
        raise Refused(404, "unknown_person")
    if person.role == Role.ADMINISTRATOR.name.lower():
        raise Refused(403, "erase_administrator")
    await personal.erase(number, prune, Entry(actor, Action.PERSON_ERASED, number))


def prune(answers: Answers, grade: Mapping[str, Any]) -> tuple[Answers, Mapping[str, Any]]:
    """Leave of answers what a judge has read, and of the verdicts on the others no word that was typed."""
    read = {name for name, one in GRADE.validate_python(grade).verdicts.items() if one.outcome in JUDGED}
    bare = {
        name: one if name in read else one | {"details": None, "code": _bare(one["code"])}
        for name, one in grade["verdicts"].items()
    }
    left = {name: text if name in read else "" for name, text in answers.items()}
    return left, {**grade, "verdicts": bare}


def _bare(code: str) -> str:
    return Code.EMPTY.value if code == Code.UNREADABLE.value else code
