"""The tables of the store. `migrations/` builds them; a test compares the two."""

from server.tables.base import metadata
from server.tables.courses import courses, groups, memberships
from server.tables.jobs import batches, jobs
from server.tables.people import api_tokens, links, persons, sessions
from server.tables.practice import grades, owners, settings, submissions, variants
from server.tables.sets import accommodations, attempts, deck, hints, slots, task_sets
from server.tables.work import audit, drafts, marks, problems

__all__ = [
    "accommodations", "api_tokens", "attempts", "audit", "batches", "courses", "deck", "drafts", "grades", "groups",
    "hints", "jobs", "links", "marks", "memberships", "metadata", "owners", "persons", "problems", "sessions",
    "settings", "slots", "submissions", "task_sets", "variants",
]  # fmt: skip
