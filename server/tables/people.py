"""People, what they sign in with, and the one-time links that let them in."""

from __future__ import annotations

from sqlalchemy import Boolean, Column, ForeignKey, Index, String, Table, UniqueConstraint

from server.tables.base import Moment, metadata

persons = Table(
    "persons", metadata,
    Column("id", ForeignKey("owners.id"), primary_key=True),  # a person owns variants under the same number
    Column("login", String(80), unique=True),  # index number or e-mail, case folded
    Column("name", String(120), nullable=False),
    Column("password", String(200)),
    Column("role", String(16), nullable=False),  # student, lecturer, administrator
    Column("language", String(2)),
    Column("theme", String(8)),
    Column("active", Boolean, nullable=False),
    Column("issuer", String(200)),  # OpenID Connect
    Column("subject", String(200)),
    Column("created", Moment, nullable=False),
    Column("erased", Moment),  # from then only a number is left
    UniqueConstraint("issuer", "subject"),
)  # fmt: skip

sessions = Table(
    "sessions", metadata,
    Column("digest", String(64), primary_key=True),  # of the cookie, which is stored nowhere
    Column("person", ForeignKey("persons.id"), nullable=False),
    Column("created", Moment, nullable=False),
    Column("last_used", Moment, nullable=False),
    Column("expires", Moment, nullable=False),
    Column("agent", String(200), nullable=False),
    Index(None, "person"),
)  # fmt: skip

links = Table(
    "links", metadata,
    Column("digest", String(64), primary_key=True),
    Column("purpose", String(16), nullable=False),  # first, join, reset
    Column("person", ForeignKey("persons.id")),
    Column("course", ForeignKey("courses.id")),
    Column("created", Moment, nullable=False),
    Column("expires", Moment, nullable=False),
    Column("used", Moment),
)  # fmt: skip

api_tokens = Table(
    "api_tokens", metadata,
    Column("id", String(32), primary_key=True),
    Column("person", ForeignKey("persons.id"), nullable=False),
    Column("name", String(80), nullable=False),
    Column("role", String(16), nullable=False),
    Column("created", Moment, nullable=False),
    Column("expires", Moment, nullable=False),
    Column("revoked", Moment),
    Index(None, "person"),
)  # fmt: skip
