"""A line of the audit log tells its course, whose lecturers may read it."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the course."""
    op.add_column("audit", sa.Column("course", sa.String(32)))
    op.create_index("ix_audit_course_id", "audit", ["course", "id"])
