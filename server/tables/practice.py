"""Owners, variants, submissions that never change, their grades, settings of the server."""

from __future__ import annotations

from sqlalchemy import JSON, BigInteger, Boolean, Column, ForeignKey, Index, Integer, String, Table, UniqueConstraint

from server.tables.base import Moment, counted, metadata

settings = Table(
    "settings", metadata,
    Column("name", String(64), primary_key=True),
    Column("value", String(256), nullable=False),
)  # fmt: skip

owners = Table(
    "owners", metadata,
    Column("id", String(64), primary_key=True),
    Column("anonymous", Boolean, nullable=False),
    Column("created", Moment, nullable=False),
)  # fmt: skip

variants = Table(
    "variants", metadata,
    Column("id", String(32), primary_key=True),
    Column("owner", ForeignKey("owners.id"), nullable=False),
    Column("exercise", String(64), nullable=False),
    Column("version", Integer, nullable=False),
    Column("seed", BigInteger, nullable=False),
    Column("givens", JSON, nullable=False),
    Column("created", Moment, nullable=False),
    Column("last_used", Moment, nullable=False),
    Index(None, "owner"),
    Index(None, "last_used"),
)  # fmt: skip

submissions = Table(
    "submissions", metadata,
    Column("receipt", String(32), primary_key=True),
    Column("variant", ForeignKey("variants.id"), nullable=False),
    Column("owner", ForeignKey("owners.id"), nullable=False),
    Column("answers", JSON, nullable=False),
    Column("time", Moment, nullable=False),
    Column("key", String(128)),
    Column("body", String(64), nullable=False),
    Column("digest", String(64), nullable=False),
    Column("language", String(2), nullable=False),
    UniqueConstraint("owner", "variant", "key"),
    Index(None, "variant", "time"),
)  # fmt: skip

grades = Table(
    "grades", metadata,
    counted(),
    Column("submission", ForeignKey("submissions.receipt"), nullable=False),
    Column("grader_version", String(32), nullable=False),
    Column("grade", JSON, nullable=False),
    Column("counted", Boolean, nullable=False),
    Column("time", Moment, nullable=False),
    Column("reason", String(200)),
    Column("job", String(32)),
    Index(None, "submission"),
)  # fmt: skip
