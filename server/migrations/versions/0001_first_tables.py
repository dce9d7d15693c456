"""Owners, variants, submissions that never change, grades, settings."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0001"
down_revision = None
branch_labels = None
depends_on = None

SQLITE_TRIGGER = """
CREATE TRIGGER submissions_never_change BEFORE UPDATE ON submissions
BEGIN SELECT RAISE(ABORT, 'a submission never changes'); END
"""
POSTGRES_FUNCTION = """
CREATE FUNCTION submissions_never_change() RETURNS trigger LANGUAGE plpgsql AS
$$ BEGIN RAISE EXCEPTION 'a submission never changes'; END $$
"""
POSTGRES_TRIGGER = """
CREATE TRIGGER submissions_never_change BEFORE UPDATE ON submissions
FOR EACH ROW EXECUTE FUNCTION submissions_never_change()
"""


def upgrade() -> None:
    """Make the first tables."""
    _settings_and_owners()
    _variants()
    _submissions()
    _grades()
    _protect()


def _settings_and_owners() -> None:
    op.create_table(
        "settings",
        sa.Column("name", sa.String(64), nullable=False),
        sa.Column("value", sa.String(256), nullable=False),
        sa.PrimaryKeyConstraint("name", name="pk_settings"),
    )
    op.create_table(
        "owners",
        sa.Column("id", sa.String(64), nullable=False),
        sa.Column("anonymous", sa.Boolean(), nullable=False),
        sa.Column("created", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_owners"),
    )


def _variants() -> None:
    op.create_table(
        "variants",
        sa.Column("id", sa.String(32), nullable=False),
        sa.Column("owner", sa.String(64), nullable=False),
        sa.Column("exercise", sa.String(64), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("seed", sa.BigInteger(), nullable=False),
        sa.Column("givens", sa.JSON(), nullable=False),
        sa.Column("created", sa.DateTime(timezone=True), nullable=False),
        sa.Column("last_used", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_variants"),
        sa.ForeignKeyConstraint(["owner"], ["owners.id"], name="fk_variants_owner"),
    )
    op.create_index("ix_variants_owner", "variants", ["owner"])
    op.create_index("ix_variants_last_used", "variants", ["last_used"])


def _submissions() -> None:
    op.create_table(
        "submissions",
        sa.Column("receipt", sa.String(32), nullable=False),
        sa.Column("variant", sa.String(32), nullable=False),
        sa.Column("owner", sa.String(64), nullable=False),
        sa.Column("answers", sa.JSON(), nullable=False),
        sa.Column("time", sa.DateTime(timezone=True), nullable=False),
        sa.Column("key", sa.String(128)),
        sa.Column("body", sa.String(64), nullable=False),
        sa.Column("digest", sa.String(64), nullable=False),
        sa.Column("language", sa.String(2), nullable=False),
        sa.PrimaryKeyConstraint("receipt", name="pk_submissions"),
        sa.ForeignKeyConstraint(["variant"], ["variants.id"], name="fk_submissions_variant"),
        sa.ForeignKeyConstraint(["owner"], ["owners.id"], name="fk_submissions_owner"),
        sa.UniqueConstraint("owner", "variant", "key", name="uq_submissions_owner_variant_key"),
    )
    op.create_index("ix_submissions_variant_time", "submissions", ["variant", "time"])


def _grades() -> None:
    op.create_table(
        "grades",
        sa.Column("id", sa.BigInteger().with_variant(sa.Integer(), "sqlite"), autoincrement=True, nullable=False),
        sa.Column("submission", sa.String(32), nullable=False),
        sa.Column("grader_version", sa.String(32), nullable=False),
        sa.Column("grade", sa.JSON(), nullable=False),
        sa.Column("counted", sa.Boolean(), nullable=False),
        sa.Column("time", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_grades"),
        sa.ForeignKeyConstraint(["submission"], ["submissions.receipt"], name="fk_grades_submission"),
    )
    op.create_index("ix_grades_submission", "grades", ["submission"])


def _protect() -> None:
    if op.get_context().dialect.name == "sqlite":
        op.execute(SQLITE_TRIGGER)
        return
    op.execute(POSTGRES_FUNCTION)
    op.execute(POSTGRES_TRIGGER)
