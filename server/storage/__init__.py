"""What rests on disk, and what every store of it promises: one file a noun; `database/` is the store."""

from server.storage.practice import Answers, Dealt, Handed, Marked, Owner, Storage
from server.storage.problems import KeyReused, StorageUnavailable, UnknownVariant

__all__ = [
    "Answers", "Dealt", "Handed", "KeyReused", "Marked", "Owner", "Storage", "StorageUnavailable", "UnknownVariant",
]  # fmt: skip
