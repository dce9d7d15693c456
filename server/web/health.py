"""Whether the process lives, and whether it can serve."""

from __future__ import annotations

import asyncio

from fastapi import APIRouter, Depends
from pydantic import BaseModel

from server.reader import admit
from server.web.errors import Failure, unavailable
from server.workbench import Tools

SLOWEST = 3.0  # s
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
    """The store answers as well, without delay, has the tables of this version and takes what is written."""
    try:
        async with asyncio.timeout(SLOWEST):
            await bench.storage.check()
    except TimeoutError:  # while the store is migrated its tables are locked
        raise unavailable() from None
    return State(status="ready")
