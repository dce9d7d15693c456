"""What is written around submissions: drafts, marks by hand, reported problems; the audit log."""

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
