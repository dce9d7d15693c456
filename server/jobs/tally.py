"""How far a batch is: counted in the process that computes it, read by the worker that waits for it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from server.storage.jobs import Fenced


@dataclass(frozen=True, slots=True)
class Tally:
    """A number that two processes see, in a file of its own."""

    path: Path

    def __call__(self, reached: int) -> None:
        """Tell how many parts of a batch are done.

        Raises:
            Fenced: Nobody waits for them any more.
        """
        try:
            with self.path.open("r+b", buffering=0) as file:
                file.write(reached.to_bytes(4))
        except FileNotFoundError:
            raise Fenced(f"nobody waits for part {reached}") from None

    def read(self) -> int:
        """Give how many parts are done."""
        return int.from_bytes(self.path.read_bytes())

    def drop(self) -> None:
        """Let the process that computes give up at its next part."""
        self.path.unlink()


@contextmanager
def tallied() -> Iterator[Tally]:
    """Make a tally that stands at nothing; whoever still counts afterwards gives up."""
    with TemporaryDirectory(prefix="grubler-", ignore_cleanup_errors=True) as folder:
        tally = Tally(Path(folder) / "reached")
        tally.path.write_bytes(bytes(4))
        yield tally
