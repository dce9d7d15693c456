"""Hints that were opened at a price: each step of a ladder once."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0008"
down_revision = "0007"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Make the table."""
    op.create_table(
        "hints",
        sa.Column("variant", sa.String(32), nullable=False),
        sa.Column("answer", sa.String(64), nullable=False),
        sa.Column("rung", sa.Integer(), nullable=False),
        sa.Column("time", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["variant"], ["variants.id"], name="fk_hints_variant_variants"),
        sa.PrimaryKeyConstraint("variant", "answer", "rung", name="pk_hints"),
    )
