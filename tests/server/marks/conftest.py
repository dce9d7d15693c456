"""The school of the task sets, shared by the tests of a module."""

from __future__ import annotations

from tests.server.sets.conftest import course

__all__ = ["course"]
