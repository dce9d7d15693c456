"""The application: routes, their policies, and what surrounds them."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from datetime import UTC, datetime, timedelta
from importlib.metadata import version
from typing import Any, ClassVar

from fastapi import APIRouter, Depends, FastAPI, Request
from starlette.routing import Mount

from exercises import catalogue
from server import policy
from server.answering import drafts, hints, pages, previews, problems, reports, submissions, typing_page, variants
from server.audit import api as audit
from server.audit import pages as audit_pages
from server.catalogue import api as exercise_api
from server.catalogue import pages as catalogue_pages
from server.courses import api as courses
from server.courses import pages as course_pages
from server.database import Database, secret_of
from server.jobs import api as job_api
from server.jobs import pages as job_pages
from server.jobs.engine import Engine
from server.jobs.kinds import KINDS
from server.jobs.streams import Streams
from server.jobs.working import Bureau
from server.judging.judging import Judging
from server.judging.thread import JudgingThread
from server.marks import api as marks
from server.marks import pages as mark_pages
from server.people import access, account_pages, everybody, everybody_pages, oidc_pages, personal, signin_pages
from server.people import api as people
from server.people.passwords import Passwords
from server.reader import admit
from server.regrading import api as regrading
from server.regrading import pages as regrading_pages
from server.sets import api as task_sets
from server.sets import handing
from server.sets import pages as set_pages
from server.settings import Settings
from server.solvers import comparing, solving
from server.storage import Storage, StorageUnavailable
from server.storage.jobs import Jobs
from server.web import errors, health, metrics, static_files
from server.web.envelope import Envelope
from server.web.limits import Limiter
from server.workbench import Bench

IDLE = timedelta(days=30)  # anonymous practice is forgotten after
SERVER = "server"  # the worker of an embedded store: there is one
PRINTED = timedelta(days=7)  # documents that a job has made are forgotten after
COLLECT = 20.0  # s between two looks for examinations that are over
PURGE = 24 * 3600.0  # s between two purges
ROUTERS = (
    health.router,
    metrics.router,
    exercise_api.router,
    variants.router,
    previews.router,
    submissions.router,
    drafts.router,
    hints.router,
    problems.router,
    reports.router,
    solving.router,
    comparing.router,
    catalogue_pages.router,
    pages.router,
    typing_page.router,
    problems.pages,
    people.router,
    courses.router,
    access.router,
    access.pages,
    everybody.router,
    everybody_pages.router,
    personal.router,
    personal.pages,
    audit.router,
    audit_pages.router,
    signin_pages.router,
    oidc_pages.router,
    account_pages.router,
    course_pages.router,
    task_sets.router,
    set_pages.router,
    job_api.router,
    job_pages.router,
    marks.router,
    mark_pages.router,
    regrading.router,
    regrading_pages.router,
)
log = logging.getLogger("grubler")

description = APIRouter(dependencies=[Depends(admit)])


@description.get("/api/v1/openapi.json", include_in_schema=False)
async def openapi(request: Request) -> dict[str, Any]:
    """Give the description of the interface."""
    found: dict[str, Any] = request.app.openapi()
    return found


class Application(FastAPI):
    """FastAPI's, but the description of the interface is written once: it is the same for all of a process."""

    described: ClassVar[dict[str, Any]] = {}

    def openapi(self) -> dict[str, Any]:
        """Describe the interface."""
        if not self.described:
            self.described.update(super().openapi())
        return self.described


def create_app(settings: Settings, *, judging: Judging | None = None, passwords: Passwords | None = None) -> FastAPI:
    """Make the application.

    Args:
        settings: The server's settings; the store must have the tables of this version.
        judging: Where exercises are computed, if not on a thread of this process.
        passwords: How passwords are hashed, if not with the usual amount of work.

    Raises:
        UndeclaredRoute: A route has no policy.
        IncompleteExercise: An exercise folder is not complete.
    """
    catalogue.check()
    app = Application(
        title="Grübler", version=version("grubler"), lifespan=_lifespan, redirect_slashes=False,
        docs_url=None, redoc_url=None, openapi_url=None,
    )  # fmt: skip
    app.state.settings = settings
    app.state.judging = judging
    app.state.passwords = passwords
    app.state.assets = static_files.find()
    app.state.metrics = metrics.Metrics()
    for router in (description, *ROUTERS):
        app.router.routes.extend(router.routes)
    app.router.routes.append(Mount("/static", static_files.Static()))
    policy.check(app.routes)
    errors.install(app)
    app.add_middleware(Envelope, https=settings.https)
    return app


@asynccontextmanager
async def _lifespan(app: FastAPI) -> AsyncIterator[None]:
    settings: Settings = app.state.settings
    if app.state.assets.script is None:
        log.warning("The style sheet and the scripts are not built; pages are plain. Install the project again.")
    database = Database(settings.store_url)
    app.state.metrics.registry.register(metrics.FailedWrites(database.practice.failures))
    judging = app.state.judging or JudgingThread()
    passwords = app.state.passwords or Passwords()
    secret = settings.secret or secret_of(settings.store_url)
    bureau = Bureau(database.jobs, judging, secret, KINDS)
    engine = Engine(bureau, SERVER, settings.workers or 1)
    app.state.bench = Bench(
        settings, database.practice, judging, secret, app.state.assets, Limiter(), database.people, database.courses,
        passwords, database.sets, database.audit, database.jobs, engine, database.personal, database.marks, Streams(),
    )  # fmt: skip
    judging.begin()
    await _purge(database.practice, database.jobs)
    purging = asyncio.create_task(_purge_daily(database.practice, database.jobs))
    collecting = asyncio.create_task(_collect(app.state.bench))
    working = asyncio.create_task(_work(settings, bureau, engine))
    try:
        yield
    finally:
        for task in (purging, collecting, working):
            task.cancel()
            with suppress(asyncio.CancelledError):
                await task
        judging.close()
        passwords.close()
        database.close()


async def _purge_daily(storage: Storage, jobs: Jobs) -> None:
    while True:
        await asyncio.sleep(PURGE)
        await _purge(storage, jobs)


async def _work(settings: Settings, bureau: Bureau, engine: Engine) -> None:
    """Do the batches of jobs: those of an embedded store all, with PostgreSQL a share of them, or none."""
    if settings.embedded:
        await engine.run()
    elif settings.workers:
        from server.jobs import queue  # Procrastinate is imported where it is needed

        await queue.run_on(settings.store_url, bureau, settings.workers)


async def _collect(bench: Bench) -> None:
    """Take the last drafts of examinations whose time has run out."""
    while True:
        await asyncio.sleep(COLLECT)
        try:
            await handing.collect(bench, datetime.now(UTC))
        except StorageUnavailable as error:
            log.warning("drafts of examinations wait: %s", error)


async def _purge(storage: Storage, jobs: Jobs) -> None:
    try:
        await jobs.forget(datetime.now(UTC) - PRINTED)
        gone = await storage.purge(datetime.now(UTC) - IDLE)
        log.info("forgot %d idle practice variants", gone)
    except StorageUnavailable as error:
        log.warning("idle practice variants stay for now: %s", error)
