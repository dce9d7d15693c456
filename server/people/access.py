"""How the students of a course come in: personal links, and places of the roster that the course code gives away."""

from __future__ import annotations

import csv
import io
from typing import Any

from fastapi import APIRouter, Depends, Request
from pydantic import BaseModel, StrictBool
from starlette.responses import RedirectResponse, Response

from graders.words import comma
from server.answering import forms
from server.audit import acts
from server.courses import api as courses
from server.courses.api import HERE, ShownCourse, here
from server.marks.export import inert
from server.people import identity
from server.people.api import Strict
from server.policy import may_replace, may_reset
from server.reader import Asking, Reader, admit
from server.storage.audit import Action
from server.storage.courses import Member
from server.web.errors import Refused
from server.web.language import say
from server.workbench import Bench, Tools

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["courses"])
pages = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


class Claims(Strict):
    """Whether the course code gives places of the roster away."""

    open: StrictBool


class MadeLink(BaseModel):
    """A one-time link; it is shown this once."""

    link: str


class LinkFor(MadeLink):
    """A one-time link and the student it is for."""

    person: str
    login: str | None
    name: str
    group: str | None


@router.post("/courses/{course}/members/{person}/link", status_code=201, responses=HERE)
async def link_member(course: str, person: str, bench: Tools, reader: Asking) -> MadeLink:
    """Make a one-time link with which a student sets a password, the first one or a new one."""
    return MadeLink(link=await personal_link(bench, reader, await courses.found(bench, course, person)))


@router.post("/courses/{course}/members/{person}/unclaim", status_code=204, responses=HERE)
async def undo_claim(course: str, person: str, bench: Tools, reader: Asking) -> None:
    """Take a place that the course code gave away back: password, sessions and tokens end, the work stays."""
    await unclaim(bench, reader, await courses.found(bench, course, person))


@router.post("/courses/{course}/links", status_code=201, responses=HERE)
async def link_all(course: str, bench: Tools, reader: Asking) -> list[LinkFor]:
    """Make personal links for all students who have never signed in; earlier links of theirs end."""
    return await links_for_all(bench, reader)


@router.post("/courses/{course}/claims", responses=HERE)
async def change_claims(course: str, body: Claims, bench: Tools, reader: Asking) -> ShownCourse:
    """Let the course code give away places of the roster to whom names an index number first, or not."""
    await let_claim(bench, reader, body.open)
    changed = await bench.courses.course(course)
    assert changed is not None
    return courses.shown(changed, here(reader).role)


@pages.post("/courses/{course}/members/{person}/unclaim")
async def undo_claim_from_page(course: str, person: str, bench: Tools, reader: Asking) -> Response:
    """Take a place back and go back to the course."""
    await unclaim(bench, reader, await courses.found(bench, course, person))
    return RedirectResponse(f"/courses/{course}#m-{person}", 303)


@pages.post("/courses/{course}/links")
async def link_all_from_page(course: str, bench: Tools, reader: Asking) -> Response:
    """Give the personal links of all who have never signed in as a table for a mail merge."""
    content = table(reader.language, await links_for_all(bench, reader))
    attached = {"Content-Disposition": 'attachment; filename="links.csv"', "Cache-Control": "no-store"}
    return Response(content, media_type="text/csv; charset=utf-8", headers=attached)


@pages.post("/courses/{course}/claims")
async def change_claims_from_page(course: str, request: Request, bench: Tools, reader: Asking) -> Response:
    """Let the course code give away places of the roster, or not, and go back to the course."""
    await let_claim(bench, reader, (await forms.read(request)).values.get("open") == "yes")
    return RedirectResponse(f"/courses/{course}#h-code", 303)


async def personal_link(bench: Bench, reader: Reader, member: Member) -> str:
    """Make a one-time link for a student.

    Raises:
        Refused: 403 for somebody who may do more anywhere, and for the password of a student of other courses.
    """
    person = member.person
    await _refuse_others(bench, reader, member)
    purpose, actor = "reset" if person.password else "join", acts.actor_of(reader)
    return await identity.make_link(bench.people, bench.settings, purpose, actor, person, here(reader).course.id)


async def unclaim(bench: Bench, reader: Reader, member: Member) -> None:
    """Take a place back that the course code gave away.

    Raises:
        Refused: 404, the code did not give it; 403, the person may do more anywhere, or is in other courses too.
    """
    if member.claimed is None:
        raise Refused(404, "unclaimed")
    await _refuse_others(bench, reader, member)
    await bench.people.unclaim(member.person.id, acts.entry(reader, Action.CLAIM_UNDONE, member.person.id))


async def _refuse_others(bench: Bench, reader: Reader, member: Member) -> None:
    person, actor = member.person, reader.person.id if reader.person else None
    if not may_reset(actor, person.id, person.role, await bench.courses.is_staff(person.id)):
        raise Refused(403, "no_reset")
    if not person.active:
        raise Refused(403, "closed_account")
    if person.signed_up and not may_replace(reader.role, await bench.courses.elsewhere(actor or "", person.id)):
        raise Refused(403, "no_reset_elsewhere")


async def _waits(bench: Bench, reader: Reader, member: Member) -> bool:
    person, actor = member.person, reader.person.id if reader.person else None
    if member.role != "student" or person.signed_up or not person.active:
        return False
    return may_reset(actor, person.id, person.role, await bench.courses.is_staff(person.id))


async def links_for_all(bench: Bench, reader: Reader) -> list[LinkFor]:
    """Make links for all students of the course who have never signed in, by group and name."""
    course = here(reader).course.id
    groups = {group.id: group.name for group in await bench.courses.groups(course)}
    bare = [one for one in await bench.courses.members(course) if await _waits(bench, reader, one)]
    bare.sort(key=lambda one: (groups.get(one.group or "", ""), one.person.name))
    made = [identity.new_link(bench.settings, "join", one.person, course) for one in bare]
    await bench.people.keep_links([link for link, _ in made], acts.actor_of(reader))
    return [
        LinkFor(
            link=address, person=one.person.id, login=one.person.login, name=one.person.name,
            group=groups.get(one.group or ""),
        )
        for one, (_, address) in zip(bare, made, strict=True)
    ]  # fmt: skip


def table(language: str, links: list[LinkFor]) -> bytes:
    """Write links as CSV for a spreadsheet of the language; no cell can become a formula."""
    written = io.StringIO()
    writer: Any = csv.writer(written, delimiter=";" if comma(language) else ",")
    heads = ("people.login", "people.name", "courses.group", "courses.invite")
    writer.writerow([say(language, head) for head in heads])
    cells = ((one.login or "", one.name, one.group or "", one.link) for one in links)
    writer.writerows(map(inert, row) for row in cells)
    return written.getvalue().encode("utf-8-sig")


async def let_claim(bench: Bench, reader: Reader, wanted: bool) -> None:
    """Let the course code give away places of the roster, or not."""
    course = here(reader).course.id
    await bench.courses.let_claim(course, wanted, acts.entry(reader, Action.JOINING_CHANGED, course, claims=wanted))
