"""A row of the table: our solver, what was asked of it, and other people's solvers of the same task."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

Task = Callable[[], object]


@dataclass(frozen=True, slots=True)
class Row:
    """One task.

    Attributes:
        name: What is solved.
        run: Our solver on it.
        limit: The longest time asked for, in microseconds.
        peers: By its name, what makes a peer's task; it imports the peer, and ImportError leaves the peer out.
    """

    name: str
    run: Task
    limit: float | None = None
    peers: Mapping[str, Callable[[], Task]] = field(default_factory=dict)
