"""The school of the sets, for those who regrade there."""

from __future__ import annotations

from tests.server.sets.conftest import course

__all__ = ["course"]
