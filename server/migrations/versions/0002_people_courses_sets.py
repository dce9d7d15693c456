"""People, courses, task sets, drafts, marks, jobs, audit; grades say why they were given again."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Make the tables of courses."""
    _courses_and_people()
    _sessions()
    _memberships()
    _sets()
    _deck()
    _work()
    _jobs_and_audit()
    op.add_column("grades", sa.Column("reason", sa.String(200)))
    op.add_column("grades", sa.Column("job", sa.String(32)))


def _key(name: str, *columns: str) -> sa.PrimaryKeyConstraint:
    return sa.PrimaryKeyConstraint(*columns, name=f"pk_{name}")


def _points(name: str, column: str, to: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [to], name=f"fk_{name}_{column}")


def _moment(name: str, nullable: bool = False) -> sa.Column[object]:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=nullable)


def _text(name: str, length: int, nullable: bool = False) -> sa.Column[str]:
    return sa.Column(name, sa.String(length), nullable=nullable)


def _number(name: str, nullable: bool = False) -> sa.Column[int]:
    return sa.Column(name, sa.Integer(), nullable=nullable)


def _held(name: str, nullable: bool = False) -> sa.Column[object]:
    return sa.Column(name, sa.JSON(), nullable=nullable)


def _flag(name: str) -> sa.Column[bool]:
    return sa.Column(name, sa.Boolean(), nullable=False)


def _counted() -> sa.Column[int]:
    return sa.Column("id", sa.BigInteger().with_variant(sa.Integer(), "sqlite"), autoincrement=True, nullable=False)


def _once(name: str, *columns: str) -> sa.UniqueConstraint:
    return sa.UniqueConstraint(*columns, name=f"uq_{name}_{'_'.join(columns)}")


def _courses_and_people() -> None:
    op.create_table(
        "courses", _text("id", 32), _text("title", 200), _text("language", 2), _text("time_zone", 64),
        _text("join_code", 16, True), _flag("archived"), _moment("keep_until", True), _moment("created"),
        _key("courses", "id"), _once("courses", "join_code"),
    )  # fmt: skip
    op.create_table(
        "groups", _text("id", 32), _text("course", 32), _text("name", 80), _key("groups", "id"),
        _points("groups", "course", "courses.id"), _once("groups", "course", "name"),
    )  # fmt: skip
    op.create_table(
        "persons", _text("id", 64), _text("login", 80, True), _text("name", 120), _text("password", 200, True),
        _text("role", 16), _text("language", 2, True), _text("theme", 8, True), _flag("active"),
        _text("issuer", 200, True), _text("subject", 200, True), _moment("created"), _key("persons", "id"),
        _points("persons", "id", "owners.id"), _once("persons", "login"), _once("persons", "issuer", "subject"),
    )  # fmt: skip


def _sessions() -> None:
    op.create_table(
        "sessions", _text("digest", 64), _text("person", 64), _moment("created"), _moment("last_used"),
        _moment("expires"), _text("agent", 200), _key("sessions", "digest"),
        _points("sessions", "person", "persons.id"),
    )  # fmt: skip
    op.create_index("ix_sessions_person", "sessions", ["person"])
    op.create_table(
        "links", _text("digest", 64), _text("purpose", 16), _text("person", 64, True), _text("course", 32, True),
        _moment("created"), _moment("expires"), _moment("used", True), _key("links", "digest"),
        _points("links", "person", "persons.id"), _points("links", "course", "courses.id"),
    )  # fmt: skip
    op.create_table(
        "api_tokens", _text("id", 32), _text("person", 64), _text("name", 80), _text("role", 16), _moment("created"),
        _moment("expires"), _moment("revoked", True), _key("api_tokens", "id"),
        _points("api_tokens", "person", "persons.id"),
    )  # fmt: skip
    op.create_index("ix_api_tokens_person", "api_tokens", ["person"])


def _memberships() -> None:
    op.create_table(
        "memberships", _text("course", 32), _text("person", 64), _text("role", 16), _text("group", 32, True),
        _moment("joined"), _key("memberships", "course", "person"), _points("memberships", "course", "courses.id"),
        _points("memberships", "person", "persons.id"), _points("memberships", "group", "groups.id"),
    )  # fmt: skip
    op.create_index("ix_memberships_person", "memberships", ["person"])


def _sets() -> None:
    op.create_table(
        "task_sets", _text("id", 32), _text("course", 32), _text("title", 200), _held("rules"), _text("state", 16),
        _moment("opens", True), _moment("due", True), _moment("closes", True), _moment("published", True),
        _number("revision"), _moment("created"), _key("task_sets", "id"),
        _points("task_sets", "course", "courses.id"),
    )  # fmt: skip
    op.create_index("ix_task_sets_course", "task_sets", ["course"])
    op.create_table(
        "slots", _text("id", 32), _text("task_set", 32), _number("number"), _held("pool"),
        sa.Column("points", sa.Float(), nullable=False), _number("attempts", True), _held("limits"),
        _key("slots", "id"), _points("slots", "task_set", "task_sets.id"), _once("slots", "task_set", "number"),
    )  # fmt: skip
    op.create_table(
        "accommodations", _text("task_set", 32), _text("person", 64), _number("minutes"), _text("reason", 200),
        _key("accommodations", "task_set", "person"), _points("accommodations", "task_set", "task_sets.id"),
        _points("accommodations", "person", "persons.id"),
    )  # fmt: skip


def _deck() -> None:
    op.create_table(
        "deck", _text("id", 32), _text("slot", 32), _number("number"), _text("code", 16), _text("exercise", 64),
        _number("version"), sa.Column("seed", sa.BigInteger(), nullable=False), _held("givens"), _held("shown"),
        _held("reference"), _text("person", 64, True), _number("turn"), _text("variant", 32, True),
        _moment("dealt", True), _key("deck", "id"), _points("deck", "slot", "slots.id"),
        _points("deck", "person", "persons.id"), _points("deck", "variant", "variants.id"), _once("deck", "code"),
        _once("deck", "variant"), _once("deck", "slot", "number"), _once("deck", "slot", "person", "turn"),
    )  # fmt: skip
    op.create_table(
        "attempts", _text("variant", 32), _number("number"), _text("submission", 32),
        _key("attempts", "variant", "number"), _points("attempts", "variant", "variants.id"),
        _points("attempts", "submission", "submissions.receipt"), _once("attempts", "submission"),
    )  # fmt: skip


def _work() -> None:
    op.create_table(
        "drafts", _text("variant", 32), _held("answers"), _moment("time"), _number("revision"),
        _key("drafts", "variant"), _points("drafts", "variant", "variants.id"),
    )  # fmt: skip
    op.create_table(
        "marks", _counted(), _text("submission", 32), _text("answer", 64, True),
        sa.Column("share", sa.Float(), nullable=True), _text("comment", 4000), _text("author", 64), _moment("time"),
        _key("marks", "id"), _points("marks", "submission", "submissions.receipt"),
        _points("marks", "author", "persons.id"),
    )  # fmt: skip
    op.create_index("ix_marks_submission", "marks", ["submission"])
    op.create_table(
        "problems", _text("id", 32), _text("variant", 32), _text("owner", 64), _text("text", 2000), _moment("time"),
        _moment("settled", True), _key("problems", "id"), _points("problems", "variant", "variants.id"),
        _points("problems", "owner", "owners.id"),
    )  # fmt: skip
    op.create_index("ix_problems_variant", "problems", ["variant"])


def _jobs_and_audit() -> None:
    op.create_table(
        "jobs", _text("id", 32), _text("kind", 32), _held("payload"), _text("state", 16), _number("done"),
        _number("total"), _number("fence"), _moment("lease", True), _held("result", True), _text("error", 500, True),
        _text("person", 64, True), _moment("created"), _moment("finished", True), _key("jobs", "id"),
        _points("jobs", "person", "persons.id"),
    )  # fmt: skip
    op.create_index("ix_jobs_state_created", "jobs", ["state", "created"])
    op.create_table(
        "audit", _counted(), _moment("time"), _text("actor", 64), _text("action", 64), _text("object", 128),
        _held("details"), _text("previous", 64), _text("digest", 64), _key("audit", "id"), _once("audit", "digest"),
    )  # fmt: skip
