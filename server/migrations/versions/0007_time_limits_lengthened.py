"""A set remembers when its deadlines were moved by how much: time limits that ran then are longer."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0007"
down_revision = "0006"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the moments and minutes, none for sets that are there."""
    op.add_column("task_sets", sa.Column("extended", sa.JSON(), nullable=False, server_default="[]"))
