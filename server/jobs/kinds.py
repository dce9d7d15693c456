"""The kinds of jobs there are."""

from __future__ import annotations

from server.regrading.job import REGRADE
from server.storage.jobs import Kind

KINDS: dict[str, Kind] = {kind.name: kind for kind in (REGRADE,)}
