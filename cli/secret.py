"""The secret from which the test points of formulas are drawn, for the commands that judge without a store."""

from __future__ import annotations

import os

from exercises.solving import NO_SECRET


def secret() -> bytes:
    """Give the secret: a fixed public one unless the environment sets it."""
    return os.environ.get("GRUBLER_SECRET", "").encode() or NO_SECRET
