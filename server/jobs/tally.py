"""How far a batch is: counted in the process that computes it, read by the worker that waits for it.

The count stands in memory that both share: a container may have no folder for files that pass.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing.shared_memory import SharedMemory

from server.storage.jobs import Fenced

SIZE = 4  # bytes of the count


@dataclass(frozen=True, slots=True)
class Tally:
    """A number that two processes see, in memory of this name."""

    name: str

    def __call__(self, reached: int) -> None:
        """Tell how many parts of a batch are done.

        Raises:
            Fenced: Nobody waits for them any more.
        """
        try:
            place = SharedMemory(self.name)
        except FileNotFoundError:
            raise Fenced(f"nobody waits for part {reached}") from None
        assert place.buf is not None  # until it is closed
        place.buf[:SIZE] = reached.to_bytes(SIZE)
        place.close()

    def read(self) -> int:
        """Give how many parts are done."""
        place = SharedMemory(self.name)
        assert place.buf is not None
        reached = int.from_bytes(place.buf[:SIZE])
        place.close()
        return reached

    def drop(self) -> None:
        """Let the process that computes give up at its next part."""
        with suppress(FileNotFoundError):  # dropped before
            place = SharedMemory(self.name)
            place.close()
            place.unlink()


@contextmanager
def tallied() -> Iterator[Tally]:
    """Make a tally that stands at nothing; whoever still counts afterwards gives up."""
    place = SharedMemory(create=True, size=SIZE)
    place.close()
    tally = Tally(place.name)
    try:
        yield tally
    finally:
        tally.drop()
