"""The audit log: who did what to whom, written in the transaction of the act itself."""

from __future__ import annotations

from server.reader import Reader
from server.storage.audit import Action, Detail, Entry

COMMAND_LINE, SERVER = "command line", "server"  # who acts without being a person


def entry(reader: Reader, action: Action, what: str, **details: Detail) -> Entry:
    """Describe an act of a reader, in the course of the address; the store writes it down with the act.

    Args:
        reader: Who acts.
        action: What is done.
        what: The number of what it is done to.
        details: Numbers and counts, never a secret, an answer or a name.
    """
    return Entry(actor_of(reader), action, what, reader.course.id if reader.course else None, details)


def actor_of(reader: Reader) -> str:
    """Give the number of the person who acts, or of the token where it is nobody's."""
    if reader.person is not None:
        return reader.person.id
    return f"token {reader.owner_id[:16]}" if reader.owner_id else "nobody"
