"""What rests on disk, and what every store of it promises: one file a noun; `database/` is the store."""

from server.storage.practice import Answers, Dealt, Draft, Handed, Marked, Owner, Problem, Storage
from server.storage.problems import KeyReused, StorageUnavailable, UnknownVariant

__all__ = [
    "Answers", "Dealt", "Draft", "Handed", "KeyReused", "Marked", "Owner", "Problem", "Storage", "StorageUnavailable",
    "UnknownVariant",
]  # fmt: skip
