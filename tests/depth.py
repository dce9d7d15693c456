"""How much the tests try: a share by default, so that they stay short; all of it where ``GRUBLER_DEPTH=full``.

Either way each test runs, and each law, exercise, judge and page is tried; only how often differs.
"""

from __future__ import annotations

import os
from typing import TypeVar

Amount = TypeVar("Amount")
DEPTH = os.environ.get("GRUBLER_DEPTH", "quick")
assert DEPTH in ("quick", "full"), f"GRUBLER_DEPTH is quick or full, not {DEPTH!r}"


def amount(quick: Amount, full: Amount) -> Amount:
    """Choose by the depth that is asked for."""
    return full if DEPTH == "full" else quick
