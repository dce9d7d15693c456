"""Jobs and their batches. A batch is taken under a fence that grows each time: a late worker writes nothing."""

from __future__ import annotations

from sqlalchemy import JSON, Column, ForeignKey, Index, Integer, LargeBinary, String, Table

from server.tables.base import Moment, metadata

jobs = Table(
    "jobs", metadata,
    Column("id", String(32), primary_key=True),
    Column("kind", String(32), nullable=False),
    Column("subject", String(64), nullable=False),  # what it works on, such as a task set
    Column("course", ForeignKey("courses.id")),  # whose lecturers may see it
    Column("payload", JSON, nullable=False),
    Column("state", String(16), nullable=False),  # waiting, running, done, failed, cancelled
    Column("live", String(100)),  # kind and subject until it has ended: there is one at a time
    Column("done", Integer, nullable=False),  # batches
    Column("total", Integer, nullable=False),
    Column("result", JSON),
    Column("error", String(500)),
    Column("person", ForeignKey("persons.id")),
    Column("created", Moment, nullable=False),
    Column("finished", Moment),
    Index(None, "live", unique=True),
    Index(None, "subject", "created"),
    Index(None, "state", "created"),
)  # fmt: skip

batches = Table(
    "batches", metadata,
    Column("job", ForeignKey("jobs.id"), primary_key=True),
    Column("number", Integer, primary_key=True),
    Column("piece", JSON, nullable=False),  # which part of the work it is
    Column("state", String(16), nullable=False),  # waiting, running, done
    Column("fence", Integer, nullable=False),  # grows with each taking
    Column("lease", Moment),  # until when it is its worker's
    Column("worker", String(64)),
    Column("failures", Integer, nullable=False),
    Column("parts", Integer, nullable=False, server_default="1"),  # what is counted while the batch is worked on
    Column("reached", Integer, nullable=False, server_default="0"),  # of them
    Column("result", JSON),
    Column("content", LargeBinary),  # a document that was made
    Index(None, "state", "lease"),
)  # fmt: skip
