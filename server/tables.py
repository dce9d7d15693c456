"""The tables of the store. `migrations/` builds them; a test compares the two."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Any

from sqlalchemy import (
    JSON,
    BigInteger,
    Boolean,
    Column,
    DateTime,
    Dialect,
    ForeignKey,
    Index,
    Integer,
    MetaData,
    String,
    Table,
    TypeDecorator,
    UniqueConstraint,
)  # fmt: skip


class Moment(TypeDecorator[datetime]):
    """A moment in UTC, also where the database knows no time zones."""

    impl = DateTime(timezone=True)
    cache_ok = True

    def process_result_value(self, value: Any, dialect: Dialect) -> Any:
        """Give a moment that knows its zone."""
        return value if value is None or value.tzinfo else value.replace(tzinfo=UTC)


metadata = MetaData(
    naming_convention={
        "pk": "pk_%(table_name)s",
        "fk": "fk_%(table_name)s_%(column_0_name)s",
        "uq": "uq_%(table_name)s_%(column_0_N_name)s",
        "ix": "ix_%(table_name)s_%(column_0_N_name)s",
    }
)

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
    Column("id", BigInteger().with_variant(Integer, "sqlite"), primary_key=True, autoincrement=True),
    Column("submission", ForeignKey("submissions.receipt"), nullable=False),
    Column("grader_version", String(32), nullable=False),
    Column("grade", JSON, nullable=False),
    Column("counted", Boolean, nullable=False),
    Column("time", Moment, nullable=False),
    Index(None, "submission"),
)  # fmt: skip
