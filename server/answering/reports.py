"""Reports of a variant as documents: the skeleton, or filled with the answers of a receipt."""

from __future__ import annotations

import asyncio
from datetime import tzinfo
from functools import lru_cache
from typing import Annotated, Literal

from fastapi import APIRouter, Depends, Query
from starlette.responses import Response

from reports import formats
from reports.document import Document
from reports.tmm2 import HandedIn, NoReport, Person, tmm2
from server.answering.submissions import Graded, graded, receipted
from server.answering.variants import GONE, restored, visible
from server.courses import zones
from server.reader import Asking, Reader, admit
from server.sets.clock import named
from server.storage import Dealt
from server.web.errors import Failure, Refused
from server.workbench import Bench, Tools

router = APIRouter(prefix="/api/v1/reports", dependencies=[Depends(admit)], tags=["reports"])
Written = Annotated[str, Query(max_length=80)]


@router.get(
    "/tmm2/{variant}.{form}",
    response_class=Response,
    responses=GONE
    | {code: {"model": Failure} for code in (422, 429)}
    | {200: {"content": {kind: {} for kind in formats.MEDIA.values()}}},
)
async def tmm2_report(
    variant: str, form: Literal["pdf", "docx", "typ", "md"], bench: Tools, reader: Asking,
    name: Written = "", group: Written = "", receipt: Annotated[str, Query(max_length=64)] = "",
) -> Response:  # fmt: skip
    """Write the TMM-2 report of a variant: without a receipt its skeleton, with one the student's own answers."""
    dealt = await visible(bench, reader, variant)
    handed = await _handed(bench, reader, dealt, receipt) if receipt else None
    person, number = Person(name, group), dealt.code or str(dealt.seed)
    try:
        made = await bench.judging.run(tmm2, restored(dealt), reader.language, person, number, handed)
    except NoReport:
        raise Refused(404, "no_report") from None
    content = await asyncio.to_thread(_written, made, form)
    attached = {"Content-Disposition": f'attachment; filename="tmm-2.{form}"'}
    return Response(content, media_type=formats.MEDIA[form], headers=attached)


@lru_cache(maxsize=64)
def _written(document: Document, form: str) -> bytes:
    """Write a document; one that was just written is at hand still."""
    return formats.written(document, form)


async def _handed(bench: Bench, reader: Reader, dealt: Dealt, receipt: str) -> HandedIn:
    """Give the submission of a receipt; refuses one of another variant."""
    marked = await receipted(bench, reader, receipt)
    if marked.handed.variant != dealt.id:
        raise Refused(404, "unknown_submission")
    found = await graded(bench, marked, reader.language, staff=reader.owner_id != dealt.owner.id)
    return handed_in(found, reader.language, await zones.of_variant(bench, reader, dealt))


def handed_in(found: Graded, language: str, place: tzinfo) -> HandedIn:
    """Give a graded submission as reports show it, its moment in a language and a zone."""
    return HandedIn(
        answers={name: text if isinstance(text, str) else "\n".join(text) for name, text in found.answers.items()},
        outcomes={name: verdict.outcome for name, verdict in found.verdicts.items()},
        receipt=found.receipt.id,
        received=named(language, found.receipt.time, place),
        digest=found.receipt.digest[:16],
        score=found.score,
    )
