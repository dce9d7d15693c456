"""An index of the dealt cards, so that a gradebook need not read what the cards show."""

from __future__ import annotations

from alembic import op

revision = "0010"
down_revision = "0009"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Make the index."""
    columns = ["slot", "person", "turn", "variant", "code", "exercise", "version", "seed", "dealt"]
    op.create_index("ix_deck_dealt", "deck", columns)
