"""Previews: what is understood of a line while it is typed."""

from __future__ import annotations

from html import escape
from typing import Any

from fastapi import APIRouter, Depends
from pydantic import BaseModel, ConfigDict, StrictBool

from exercises import grading
from exercises.exercise import Variant
from graders import Echo, Verdict
from graders.verdict import Reading
from graders.words import comma, message, noted, printed_unit
from server.answering.echoes import breakable
from server.answering.relations import relations
from server.answering.variants import GONE, restored, visible
from server.reader import Asking, admit
from server.sets import handing
from server.storage import Dealt
from server.web.errors import Failure, Refused, printable
from server.web.typed import Typed
from server.workbench import Bench, Tools

SPACE, DEGREE = '<mspace width=".2em"/>', "°"  # between a number and its unit, and the unit that stands close

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["variants"])


class Question(BaseModel):
    """One typed line; `relations` asks for its formulas as lists besides, of a diagram for its table."""

    model_config = ConfigDict(extra="forbid", json_schema_extra={"examples": [{"answer": "l3", "text": "1,25 m"}]})
    answer: Typed
    text: Typed
    relations: StrictBool = False


class Understood(BaseModel):
    """What was read, or why nothing could be; the same for every seed.

    `ok` tells which; positions are 0-based code points of the text as typed. `relations` holds the formulas of a
    polygon, of its derivatives or of an expression: a number, a name, or a list of an operation and its formulas; of a
    diagram it holds the `rows` of its table.
    `mathml` is one `math` element, or several between which a line may break; an empty one ends a line.
    """

    ok: bool
    mathml: str = ""
    text: str = ""
    latex: str = ""
    unit: str | None = None
    note: str | None = None
    code: str | None = None
    message: str | None = None
    position: int | None = None
    relations: dict[str, Any] | None = None


@router.post("/variants/{variant}/preview", responses=GONE | {422: {"model": Failure}})
async def preview(variant: str, question: Question, bench: Tools, reader: Asking) -> Understood:
    """Say what is understood of one typed line. Costs nothing and tells nothing about the answer."""
    dealt = await visible(bench, reader, variant)
    read = restored(dealt)
    try:
        said = await understood(bench, read, question.answer, question.text, reader.language)
    except Refused:
        if not await _asks(bench, dealt, question.answer):
            raise
        said = as_typed(question.text)
    if question.relations and said.ok:
        said.relations = await bench.judging.run(relations, read, question.answer, question.text)
    return said


async def understood(bench: Bench, variant: Variant, answer: str, text: str, language: str) -> Understood:
    """Say what is understood of one typed line.

    Raises:
        Refused: 422, no such answer is asked for.
    """
    try:
        read: Echo | Verdict = await bench.judging.run(grading.preview, variant, answer, text, comma(language))
    except grading.UnknownAnswer:
        raise Refused(422, "unknown_answer", field="answer", name=printable(answer)) from None
    if isinstance(read, Verdict):
        position = read.details.position if isinstance(read.details, Reading) else None
        return Understood(ok=False, code=read.code, message=message(read, language), position=position)
    return told(read, language)


def told(read: Echo, language: str) -> Understood:
    """Word what was read for a page in a language."""
    unit = printed_unit(read.unit or "", language)
    mathml = (
        read.mathml.replace("</math>", f"{'' if unit == DEGREE else SPACE}<mtext>{escape(unit)}</mtext></math>")
        if unit
        else breakable(read.mathml)
    )
    note = noted(read.notes, language) or None
    return Understood(
        ok=True, mathml=mathml, text=f"{read.text} {unit}".rstrip(), latex=read.latex, unit=read.unit, note=note
    )


def as_typed(text: str) -> Understood:
    """Say of an answer that the installed exercise no longer reads that it is taken as it stands."""
    return Understood(ok=True, text=text)


async def _asks(bench: Bench, dealt: Dealt, answer: str) -> bool:
    """Tell whether a card asks for an answer, whatever its exercise asks for now."""
    place = await bench.sets.place(dealt.id) if dealt.code else None
    return place is not None and answer in handing.weights_of(place.card)
