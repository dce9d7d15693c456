"""Whether the process lives, and whether it can serve."""

from __future__ import annotations

from fastapi import APIRouter, Depends
from pydantic import BaseModel

from server.bench import Tools
from server.errors import Failure
from server.reader import admit

router = APIRouter(dependencies=[Depends(admit)], tags=["operations"])


class State(BaseModel):
    """The state of the server."""

    status: str


@router.get("/health")
async def health() -> State:
    """The process answers."""
    return State(status="ok")


@router.get("/ready", responses={503: {"model": Failure}})
async def ready(bench: Tools) -> State:
    """The store answers as well."""
    await bench.storage.check()
    return State(status="ready")
