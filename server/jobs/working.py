"""Doing one batch: read, compute in a process of its own, write once; whatever goes wrong, nothing is doubled."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager, nullcontext, suppress
from dataclasses import dataclass

from server.jobs.tally import Tally, tallied
from server.judging.judging import Judging
from server.storage import StorageUnavailable
from server.storage.jobs import Batch, Fenced, Jobs, Kind

RENEWALS = 3  # in the time of one lease
LEFT_TO_OTHERS = 1.0  # s until a batch is given back that this worker cannot do
LOOK = 0.5  # s between two looks at how far a batch is
log = logging.getLogger("grubler")


@dataclass(frozen=True, slots=True)
class Bureau:
    """What a worker needs: the store, processes that compute, the secret, the kinds of jobs it knows."""

    jobs: Jobs
    judging: Judging
    secret: bytes
    kinds: Mapping[str, Kind]


async def work(bureau: Bureau, batch: Batch) -> None:
    """Do a batch that was taken.

    One that fails is tried again; one whose worker is stopped is given back; one that another worker has taken
    meanwhile, because this one was silent for too long, is dropped. One of a kind that only workers of another version
    know is left to them.
    """
    if batch.kind not in bureau.kinds:
        return await _leave_to_others(bureau, batch)
    kind = bureau.kinds[batch.kind]
    try:
        with tallied() if kind.tells else nullcontext() as tally:
            async with _renewed(bureau.jobs, batch, tally):
                given = await bureau.jobs.read(kind, batch)
                told = (tally,) if tally else ()
                (outcome,) = await bureau.judging.apart(kind.compute, [(bureau.secret, given, *told)])
        await bureau.jobs.keep(kind, batch, outcome)
    except Fenced as refused:
        log.warning("came too late and wrote nothing: %s", refused)
    except StorageUnavailable as error:
        log.warning("batch %d of job %s waits for the store: %s", batch.number, batch.job, error)
    except asyncio.CancelledError:
        await asyncio.shield(_give_back(bureau, batch))
        raise
    except Exception as error:
        log.exception("batch %d of job %s failed", batch.number, batch.job)
        with suppress(StorageUnavailable):
            await bureau.jobs.fail(kind, batch, repr(error))


async def _leave_to_others(bureau: Bureau, batch: Batch) -> None:
    log.warning("batch %d of job %s is of the kind %s, which others may know", batch.number, batch.job, batch.kind)
    try:
        await asyncio.sleep(LEFT_TO_OTHERS)
    finally:
        await asyncio.shield(_give_back(bureau, batch))


async def _give_back(bureau: Bureau, batch: Batch) -> None:
    """Give a batch back; where the store does not answer, its lease ends by itself."""
    with suppress(StorageUnavailable):
        await bureau.jobs.give_back(batch)


@asynccontextmanager
async def _renewed(jobs: Jobs, batch: Batch, tally: Tally | None) -> AsyncIterator[None]:
    renewing = asyncio.create_task(_renew(jobs, batch, tally))
    try:
        yield
    finally:
        renewing.cancel()
        with suppress(asyncio.CancelledError):
            await renewing


async def _renew(jobs: Jobs, batch: Batch, tally: Tally | None) -> None:
    """Keep a batch and tell how far it is; one that is not ours any more is given up."""
    clock, period, told = asyncio.get_running_loop().time, jobs.lease / RENEWALS, 0
    due = clock() + period
    while True:
        await asyncio.sleep(min(LOOK, period))
        reached = tally.read() if tally else 0
        if reached == told and clock() < due:
            continue
        with suppress(StorageUnavailable):  # tried again; without luck others take the batch
            if not await jobs.renew(batch, reached):
                return tally.drop() if tally else None
            told, due = reached, clock() + period
