"""The reference solvers for lecturers, and the description of what they read, which is open to all."""

from __future__ import annotations

from typing import Any

from fastapi import APIRouter, Depends, Request
from pydantic import BaseModel
from starlette.concurrency import run_in_threadpool

from mechanics.wire import reading, solvers
from mechanics.wire.refusal import Refusal
from server.reader import admit
from server.web.errors import Failure, Refused
from server.web.typed import sendable

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["solvers"])
BODY = {"required": True, "content": {"application/json": {"schema": {"type": "object"}}}}
STATUS = {"unknown_solver": 404, "too_large": 413}  # 422 else


class Described(BaseModel):
    """A reference solver: a JSON Schema of its requests, the meaning of what it answers, a request to try."""

    summary: str
    request: dict[str, Any]
    answer: dict[str, str]
    example: dict[str, Any]


@router.get("/solvers")
def describe_solvers() -> dict[str, Described]:
    """Describe the reference solvers by name."""
    return {name: _described(name) for name in solvers.SOLVERS}


def _described(name: str) -> Described:
    solver, summary = solvers.load(name), solvers.SOLVERS[name]
    answer, example = dict(solver.ANSWER), dict(solver.EXAMPLE)
    return Described(summary=summary, request=solvers.schema(name), answer=answer, example=example)


@router.post(
    "/solve/{solver}",
    openapi_extra={"requestBody": BODY},
    responses={404: {"model": Failure}, 413: {"model": Failure}, 422: {"model": Failure}},
)
async def solve(solver: str, request: Request) -> dict[str, Any]:
    """Answer a request to a reference solver: SI units, angles in radians. Its `id` comes back with the answer.

    What cannot be solved is 422 with the code of the reason, such as `unstable` or `cannot_assemble`; the message is
    in English in every language. `GET /api/v1/solvers` describes requests and answers.
    """
    raw = await request.body()
    try:
        return await run_in_threadpool(_solved, solver, raw)
    except Refusal as refusal:
        status = STATUS.get(refusal.code, 422)
        raise Refused(status, refusal.code, field=refusal.field or None, said=refusal.message) from None


def _solved(solver: str, raw: bytes) -> dict[str, Any]:
    solvers.load(solver)
    request = reading.read(raw)
    identity = identified(request)
    return {**identity, **solvers.solve(solver, solvers.without_id(request))}


def identified(request: dict[str, Any]) -> dict[str, Any]:
    """Give the `id` of a request as it goes back.

    Raises:
        Refusal: `wrong_type`, `not_finite` or `out_of_range`; the last also for a text with half a character.
    """
    found = solvers.identified(request)
    if isinstance(text := found.get("id"), str) and sendable(text) != text:
        raise Refusal("out_of_range", "id holds half a character, which cannot be sent back", "id")
    return found
