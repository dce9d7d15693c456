"""Who changed a draft last, and the weights of a card's answers beside what it shows."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

from server.tables.base import Moment

revision = "0011"
down_revision = "0010"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the columns; a card that was dealt before has no weights of its own, they are read from what it shows."""
    op.add_column("task_sets", sa.Column("changed", Moment()))
    op.add_column("task_sets", sa.Column("changed_by", sa.String(32)))
    op.add_column("deck", sa.Column("weights", sa.JSON()))
