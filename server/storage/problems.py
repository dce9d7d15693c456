"""Why something could not be stored."""

from __future__ import annotations


class StorageUnavailable(RuntimeError):
    """Nothing was stored and nothing is promised; the same request may be tried again."""


class KeyReused(ValueError):
    """The idempotency key was used before with another body."""


class UnknownVariant(KeyError):
    """No such variant, or it has expired."""
