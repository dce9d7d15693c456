"""A person can be erased; only then may answers that were handed in be taken out of a submission."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0006"
down_revision = "0005"
branch_labels = None
depends_on = None

ERASED = """SELECT 1 FROM variants JOIN persons ON persons.id = variants.owner
WHERE variants.id = OLD.variant AND persons.erased IS NOT NULL"""
STAYS = " AND ".join(f'NEW."{name}" = OLD."{name}"' for name in ("receipt", "variant", "owner", "time", "digest"))
SQLITE_TRIGGER = f"""
CREATE TRIGGER submissions_never_change BEFORE UPDATE ON submissions WHEN NOT (EXISTS ({ERASED}) AND {STAYS})
BEGIN SELECT RAISE(ABORT, 'a submission never changes'); END
"""
POSTGRES_FUNCTION = f"""
CREATE OR REPLACE FUNCTION submissions_never_change() RETURNS trigger LANGUAGE plpgsql AS
$$ BEGIN
IF EXISTS ({ERASED}) AND {STAYS} THEN RETURN NEW; END IF;
RAISE EXCEPTION 'a submission never changes';
END $$
"""


def upgrade() -> None:
    """Add the moment, and let the trigger know it."""
    op.add_column("persons", sa.Column("erased", sa.DateTime(timezone=True)))
    if op.get_context().dialect.name == "sqlite":
        op.execute("DROP TRIGGER submissions_never_change")
        op.execute(SQLITE_TRIGGER)
    else:
        op.execute(POSTGRES_FUNCTION)
