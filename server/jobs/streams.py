"""How many streams of events are open: each keeps a connection and looks at the store, so there are only so many."""

from __future__ import annotations

from collections import Counter
from collections.abc import AsyncIterator
from dataclasses import dataclass, field

from starlette.responses import StreamingResponse
from starlette.types import Receive, Scope, Send

MOST = 200  # of one server
MOST_OF_ONE = 8  # of one person: some pages, each with its job
AGAIN = 5  # s after which a place may be free


@dataclass(slots=True)
class Streams:
    """Counts the open streams by whose they are."""

    open: Counter[str] = field(default_factory=Counter)

    def enter(self, name: str) -> bool:
        """Take a place; tells whether there was one."""
        if self.open[name] >= MOST_OF_ONE or self.open.total() >= MOST:
            return False
        self.open[name] += 1
        return True

    def leave(self, name: str) -> None:
        """Give a place back."""
        self.open[name] -= 1
        if not self.open[name]:
            del self.open[name]


class Stream(StreamingResponse):
    """Events for somebody who has taken a place; however it ends, the place is free again."""

    media_type = "text/event-stream"

    def __init__(self, streams: Streams, name: str, events: AsyncIterator[str]) -> None:
        super().__init__(events)
        self._streams, self._name = streams, name

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send the events."""
        try:
            await super().__call__(scope, receive, send)
        finally:
            self._streams.leave(self._name)
