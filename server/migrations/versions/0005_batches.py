"""Jobs are done in batches, each taken under a fence; on PostgreSQL Procrastinate hands them out."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op
from procrastinate.schema import SchemaManager

revision = "0005"
down_revision = "0004"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Make the tables anew (none has been written so far), and those of Procrastinate 3.10."""
    op.drop_table("jobs")
    _jobs()
    _batches()
    connection = op.get_bind()
    if connection.dialect.name == "postgresql":
        driver = connection.connection.driver_connection
        assert driver is not None
        driver.execute(SchemaManager.get_schema())  # many statements: only the driver itself takes them


def _jobs() -> None:
    op.create_table(
        "jobs",
        sa.Column("id", sa.String(32), nullable=False),
        sa.Column("kind", sa.String(32), nullable=False),
        sa.Column("subject", sa.String(64), nullable=False),
        sa.Column("course", sa.String(32)),
        sa.Column("payload", sa.JSON(), nullable=False),
        sa.Column("state", sa.String(16), nullable=False),
        sa.Column("live", sa.String(100)),
        sa.Column("done", sa.Integer(), nullable=False),
        sa.Column("total", sa.Integer(), nullable=False),
        sa.Column("result", sa.JSON()),
        sa.Column("error", sa.String(500)),
        sa.Column("person", sa.String(64)),
        sa.Column("created", sa.DateTime(timezone=True), nullable=False),
        sa.Column("finished", sa.DateTime(timezone=True)),
        sa.PrimaryKeyConstraint("id", name="pk_jobs"),
        sa.ForeignKeyConstraint(["course"], ["courses.id"], name="fk_jobs_course"),
        sa.ForeignKeyConstraint(["person"], ["persons.id"], name="fk_jobs_person"),
    )
    op.create_index("ix_jobs_live", "jobs", ["live"], unique=True)
    op.create_index("ix_jobs_subject_created", "jobs", ["subject", "created"])
    op.create_index("ix_jobs_state_created", "jobs", ["state", "created"])


def _batches() -> None:
    op.create_table(
        "batches",
        sa.Column("job", sa.String(32), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("piece", sa.JSON(), nullable=False),
        sa.Column("state", sa.String(16), nullable=False),
        sa.Column("fence", sa.Integer(), nullable=False),
        sa.Column("lease", sa.DateTime(timezone=True)),
        sa.Column("worker", sa.String(64)),
        sa.Column("failures", sa.Integer(), nullable=False),
        sa.Column("result", sa.JSON()),
        sa.Column("content", sa.LargeBinary()),
        sa.PrimaryKeyConstraint("job", "number", name="pk_batches"),
        sa.ForeignKeyConstraint(["job"], ["jobs.id"], name="fk_batches_job"),
    )
    op.create_index("ix_batches_state_lease", "batches", ["state", "lease"])
