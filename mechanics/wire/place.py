"""A place in the plane on the wire: two numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from mechanics.wire.fields import NEEDED, ListOf, Number


@dataclass(frozen=True, slots=True)
class Place:
    """A point [x, y] in metres; read as two floats."""

    doc: str
    default: Any = NEEDED

    def read(self, value: Any, place: str) -> tuple[float, float]:
        """Read the two coordinates."""
        x, y = self._list().read(value, place)
        return x, y

    def schema(self) -> dict[str, Any]:
        """Describe the list of two."""
        return self._list().schema()

    def _list(self) -> ListOf:
        return ListOf(self.doc, Number("", "m"), least=2, most=2)
