"""Task sets: their slots, the deck that was dealt at publishing, counted attempts, extra time."""

from __future__ import annotations

from sqlalchemy import JSON, BigInteger, Column, Float, ForeignKey, Index, Integer, String, Table, UniqueConstraint

from server.tables.base import Moment, metadata

task_sets = Table(
    "task_sets", metadata,
    Column("id", String(32), primary_key=True),
    Column("course", ForeignKey("courses.id"), nullable=False),
    Column("title", String(200), nullable=False),
    Column("rules", JSON, nullable=False),  # mode, late policy, hints, solutions, follow-through, best or last
    Column("state", String(16), nullable=False),  # draft, published, closed
    Column("opens", Moment),
    Column("due", Moment),
    Column("closes", Moment),
    Column("published", Moment),
    Column("revision", Integer, nullable=False),  # so that two builders do not overwrite each other
    Column("created", Moment, nullable=False),
    Column("extended", JSON, nullable=False, server_default="[]"),  # [moment, minutes]: time limits that ran then
    Column("changed", Moment),  # the draft, and by whom
    Column("changed_by", String(32)),
    Index(None, "course"),
)  # fmt: skip

slots = Table(
    "slots", metadata,
    Column("id", String(32), primary_key=True),
    Column("task_set", ForeignKey("task_sets.id"), nullable=False),
    Column("number", Integer, nullable=False),
    Column("pool", JSON, nullable=False),  # ids of exercises, one of which is dealt
    Column("points", Float, nullable=False),
    Column("attempts", Integer),  # none: unlimited
    Column("limits", JSON, nullable=False),  # of givens: {name: [least, greatest]}
    UniqueConstraint("task_set", "number"),
)  # fmt: skip

deck = Table(
    "deck", metadata,
    Column("id", String(32), primary_key=True),
    Column("slot", ForeignKey("slots.id"), nullable=False),
    Column("number", Integer, nullable=False),
    Column("code", String(16), nullable=False, unique=True),  # what a student sees instead of the seed
    Column("exercise", String(64), nullable=False),
    Column("version", Integer, nullable=False),
    Column("seed", BigInteger, nullable=False),
    Column("givens", JSON, nullable=False),
    Column("shown", JSON, nullable=False),  # statement, figure and fields in three languages, as published
    Column("reference", JSON, nullable=False),  # never served
    Column("person", ForeignKey("persons.id")),
    Column("turn", Integer, nullable=False),  # 1, more where a faulty variant was replaced
    Column("variant", ForeignKey("variants.id"), unique=True),
    Column("dealt", Moment),
    Column("weights", JSON(none_as_null=True)),  # of the answers; none on a card of an older version: in what it shows
    UniqueConstraint("slot", "number"),
    UniqueConstraint("slot", "person", "turn"),
    # A gradebook is read from the index alone: what the cards show is hundreds of megabytes.
    Index("ix_deck_dealt", "slot", "person", "turn", "variant", "code", "exercise", "version", "seed", "dealt"),
)  # fmt: skip

attempts = Table(
    "attempts", metadata,
    Column("variant", ForeignKey("variants.id"), primary_key=True),
    Column("number", Integer, primary_key=True),  # from 1: two racing posts cannot take the same one
    Column("submission", ForeignKey("submissions.receipt"), nullable=False, unique=True),
)  # fmt: skip

hints = Table(
    "hints", metadata,
    Column("variant", ForeignKey("variants.id"), primary_key=True),
    Column("answer", String(64), primary_key=True),
    Column("rung", Integer, primary_key=True),  # from 1: posts that race cannot take the same one twice
    Column("time", Moment, nullable=False),
)  # fmt: skip

accommodations = Table(
    "accommodations", metadata,
    Column("task_set", ForeignKey("task_sets.id"), primary_key=True),
    Column("person", ForeignKey("persons.id"), primary_key=True),
    Column("minutes", Integer, nullable=False),
    Column("reason", String(200), nullable=False),
)  # fmt: skip
