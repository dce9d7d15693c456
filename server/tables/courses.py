"""Courses, their groups and members."""

from __future__ import annotations

from sqlalchemy import Boolean, Column, ForeignKey, Index, String, Table, UniqueConstraint, false, true

from server.tables.base import Moment, metadata

courses = Table(
    "courses", metadata,
    Column("id", String(32), primary_key=True),
    Column("title", String(200), nullable=False),
    Column("language", String(2), nullable=False),
    Column("time_zone", String(64), nullable=False),
    Column("join_code", String(16), unique=True),
    Column("archived", Boolean, nullable=False),
    Column("claims", Boolean, nullable=False, server_default=false()),  # the code gives places of the roster away
    Column("keep_until", Moment),
    Column("created", Moment, nullable=False),
)  # fmt: skip

groups = Table(
    "groups", metadata,
    Column("id", String(32), primary_key=True),
    Column("course", ForeignKey("courses.id"), nullable=False),
    Column("name", String(80), nullable=False),
    UniqueConstraint("course", "name"),
)  # fmt: skip

memberships = Table(
    "memberships", metadata,
    Column("course", ForeignKey("courses.id"), primary_key=True),
    Column("person", ForeignKey("persons.id"), primary_key=True),
    Column("role", String(16), nullable=False),  # student, assistant, lecturer
    Column("group", ForeignKey("groups.id")),
    Column("joined", Moment, nullable=False),
    Column("claimed", Moment),  # when the course code gave this place of the roster away
    Column("vouched", Boolean, nullable=False, server_default=true()),  # came here first, or joined while signed in
    Index(None, "person"),
)  # fmt: skip
