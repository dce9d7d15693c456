"""What every resource works with: the store, the judge, the secret, the settings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from fastapi import Depends, Request

from server.jobs.engine import Engine
from server.jobs.streams import Streams
from server.judging.judging import Judging
from server.people.passwords import Passwords
from server.settings import Settings
from server.storage import Storage
from server.storage.audit import Audit
from server.storage.courses import Courses
from server.storage.jobs import Jobs
from server.storage.marks import Marks
from server.storage.people import People
from server.storage.personal import Personal
from server.storage.sets import Sets
from server.web.limits import Limiter
from server.web.static_files import Assets


@dataclass(frozen=True, slots=True)
class Bench:
    """The tools of one running server."""

    settings: Settings
    storage: Storage
    judging: Judging
    secret: bytes
    assets: Assets
    limiter: Limiter
    people: People
    courses: Courses
    passwords: Passwords
    sets: Sets
    audit: Audit
    jobs: Jobs
    engine: Engine
    personal: Personal
    marks: Marks
    streams: Streams


async def bench(request: Request) -> Bench:
    """Give the tools of the server that answers this request."""
    found: Bench = request.app.state.bench
    return found


Tools = Annotated[Bench, Depends(bench)]
