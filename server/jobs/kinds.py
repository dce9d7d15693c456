"""The kinds of jobs there are."""

from __future__ import annotations

from server.regrading.job import REGRADE
from server.sets.printing import SHEETS
from server.sets.publishing import PUBLISH
from server.storage.jobs import Kind

KINDS: dict[str, Kind] = {kind.name: kind for kind in (PUBLISH, REGRADE, SHEETS)}
