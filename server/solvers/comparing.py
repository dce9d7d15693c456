"""Comparing two typed answers, for lecturers who write exercises or keys of their own."""

from __future__ import annotations

from typing import Any

from fastapi import APIRouter, Depends, Request
from pydantic import BaseModel

from graders import comparison
from graders.comparison.outcome import Verdict
from mechanics.wire import reading
from mechanics.wire.refusal import Refusal
from mechanics.wire.solvers import without_id
from server.reader import admit
from server.solvers.solving import identified
from server.web.errors import Failure, Refused
from server.workbench import Tools

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["solvers"])
TEXTS = {"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]}
BOUND = {"anyOf": [{"type": "string"}, {"type": "number"}]}
SCHEMA: dict[str, Any] = {
    "type": "object",
    "required": ["kind", "a", "b"],
    "additionalProperties": False,
    "properties": {
        "kind": {"enum": list(comparison.KINDS)},
        "a": {**TEXTS, "description": "the reference; a list of texts for a system and an unordered list"},
        "b": {**TEXTS, "description": "what is compared with it"},
        "vars": {
            "type": "object",
            "additionalProperties": {"type": "array", "items": BOUND, "minItems": 2, "maxItems": 2},
            "description": "least and greatest value of each symbol, as constant expressions",
        },
        "solve_for": {**TEXTS, "description": "the unknown of an equation, or the list of those of a system"},
        "rtol": {"type": "number", "minimum": 0, "exclusiveMaximum": 1, "description": "over the size of a quantity a"},
        "id": {"description": "comes back with the answer"},
    },
}
BODY = {"required": True, "content": {"application/json": {"schema": SCHEMA}}}


class Compared(BaseModel):
    """How two answers are to each other.

    `witness` is a point at which they are proved different; `position` is the 0-based code point of the text of `side`
    (in a list, of its `item`) that cannot be read.
    """

    verdict: Verdict
    code: str
    position: int | None
    witness: dict[str, float] | None = None
    side: str | None = None
    item: int | None = None
    id: str | int | float | None = None


@router.post(
    "/compare",
    openapi_extra={"requestBody": BODY},
    response_model_exclude_unset=True,
    responses={413: {"model": Failure}, 422: {"model": Failure}},
)
async def compare(request: Request, bench: Tools) -> Compared:
    """Compare two typed answers, as `grubler compare` does. What is no request is 422; the message is in English."""
    raw = await request.body()
    try:
        found = await bench.judging.run(_compared, raw, bench.secret)
    except (Refusal, comparison.BadRequest) as refused:
        status = 413 if refused.code == "too_large" else 422
        raise Refused(status, refused.code, field=refused.field or None, said=refused.message) from None
    return Compared(**found)


def _compared(raw: bytes, secret: bytes) -> dict[str, Any]:
    request = reading.read(raw)
    identity = identified(request)
    reading.distinct(request)
    return {**identity, **comparison.answer(without_id(request), secret)}
