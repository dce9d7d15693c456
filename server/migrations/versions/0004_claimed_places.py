"""A course may let its code give places of the roster away; a place says when, and whether its person came by it."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0004"
down_revision = "0003"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the permission, off for courses that are there; who is there has come by own will."""
    op.add_column("courses", sa.Column("claims", sa.Boolean(), nullable=False, server_default=sa.false()))
    op.add_column("memberships", sa.Column("claimed", sa.DateTime(timezone=True)))
    op.add_column("memberships", sa.Column("vouched", sa.Boolean(), nullable=False, server_default=sa.true()))
