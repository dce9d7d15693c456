"""How many parts a batch has, and how many of them are done."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0009"
down_revision = "0008"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the columns; what is done already is done in full."""
    op.add_column("batches", sa.Column("parts", sa.Integer(), nullable=False, server_default="1"))
    op.add_column("batches", sa.Column("reached", sa.Integer(), nullable=False, server_default="0"))
    op.execute("UPDATE batches SET reached = 1 WHERE state = 'done'")
