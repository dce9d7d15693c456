"""What is written around submissions: drafts, marks by hand, reported problems; jobs; the audit log."""

from __future__ import annotations

from sqlalchemy import JSON, Column, Float, ForeignKey, Index, Integer, String, Table

from server.tables.base import Moment, counted, metadata

drafts = Table(
    "drafts", metadata,
    Column("variant", ForeignKey("variants.id"), primary_key=True),
    Column("answers", JSON, nullable=False),
    Column("time", Moment, nullable=False),
    Column("revision", Integer, nullable=False),
)  # fmt: skip

marks = Table(
    "marks", metadata,
    counted(),
    Column("submission", ForeignKey("submissions.receipt"), nullable=False),
    Column("answer", String(64)),  # none: the whole submission
    Column("share", Float),  # 0 to 1 of the answer's points; none: a comment only
    Column("comment", String(4000), nullable=False),
    Column("author", ForeignKey("persons.id"), nullable=False),
    Column("time", Moment, nullable=False),
    Index(None, "submission"),
)  # fmt: skip

problems = Table(
    "problems", metadata,
    Column("id", String(32), primary_key=True),
    Column("variant", ForeignKey("variants.id"), nullable=False),
    Column("owner", ForeignKey("owners.id"), nullable=False),
    Column("text", String(2000), nullable=False),
    Column("time", Moment, nullable=False),
    Column("settled", Moment),
    Index(None, "variant"),
)  # fmt: skip

jobs = Table(
    "jobs", metadata,
    Column("id", String(32), primary_key=True),
    Column("kind", String(32), nullable=False),
    Column("payload", JSON, nullable=False),
    Column("state", String(16), nullable=False),  # waiting, running, done, failed, cancelled
    Column("done", Integer, nullable=False),
    Column("total", Integer, nullable=False),
    Column("fence", Integer, nullable=False),  # grows with each taking: a late worker writes nothing
    Column("lease", Moment),
    Column("result", JSON),
    Column("error", String(500)),
    Column("person", ForeignKey("persons.id")),
    Column("created", Moment, nullable=False),
    Column("finished", Moment),
    Index(None, "state", "created"),
)  # fmt: skip

audit = Table(
    "audit", metadata,
    counted(),
    Column("time", Moment, nullable=False),
    Column("actor", String(64), nullable=False),
    Column("action", String(64), nullable=False),
    Column("object", String(128), nullable=False),
    Column("course", String(32)),  # whose lecturers may read the line
    Column("details", JSON, nullable=False),
    Column("previous", String(64), nullable=False),  # the digest of the line before
    Column("digest", String(64), nullable=False, unique=True),
    Index(None, "course", "id"),
)  # fmt: skip
