"""Tables of fields: from one table come the reading with its refusals, the published schema and the reference page.

A kind says what a value must be. `read` gives the value to compute with, or refuses it by name; a field that may be
left out has a default, and where that is None it may be null.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import Any, Protocol

from mechanics.wire.reading import Repeated
from mechanics.wire.refusal import Refusal, below, below_foreign, shown

NEEDED: Any = object()  # the default of a field that may not be left out


class Kind(Protocol):
    """What a value must be."""

    @property
    def doc(self) -> str:
        """What it means."""
        ...

    @property
    def default(self) -> Any:
        """What stands for it when it is left out; NEEDED if it may not be."""
        ...

    def read(self, value: Any, place: str) -> Any:
        """Read a value that stands at a place; raises Refusal."""
        ...

    def schema(self) -> dict[str, Any]:
        """Describe it by JSON Schema."""
        ...


@dataclass(frozen=True, slots=True)
class Number:
    """A finite number; read as a float."""

    doc: str
    unit: str = ""
    default: Any = NEEDED
    above: float | None = None  # exclusive
    least: float | None = None  # inclusive
    below: float | None = None  # exclusive
    most: float | None = None  # inclusive

    def read(self, value: Any, place: str) -> float:
        """Read the number."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise _wrong(place, value, "a number" + (f" ({self.unit})" if self.unit else ""))
        try:
            number = float(value)
        except OverflowError:
            number = float("inf")
        if not isfinite(number):
            raise Refusal("not_finite", f"{place} = {shown(value)} must be a finite number", place)
        self._require_range(number, place)
        return number

    def _require_range(self, number: float, place: str) -> None:
        if self.above is self.least is self.below is self.most is None:
            return
        limits = (
            (self.above is not None and number <= self.above, "above", self.above),
            (self.least is not None and number < self.least, "at least", self.least),
            (self.below is not None and number >= self.below, "below", self.below),
            (self.most is not None and number > self.most, "at most", self.most),
        )
        for broken, word, limit in limits:
            if broken:
                said = f"{place} = {number} {self.unit}".rstrip()
                raise Refusal("out_of_range", f"{said} must be {word} {limit:g}", place)

    def schema(self) -> dict[str, Any]:
        """Describe the number."""
        limits = {
            "exclusiveMinimum": self.above,
            "minimum": self.least,
            "exclusiveMaximum": self.below,
            "maximum": self.most,
        }
        unit = {"x-unit": self.unit} if self.unit else {}
        return {"type": "number", **unit, **{key: limit for key, limit in limits.items() if limit is not None}}


@dataclass(frozen=True, slots=True)
class Whole:
    """A whole number."""

    doc: str
    least: int
    most: int
    default: Any = NEEDED

    def read(self, value: Any, place: str) -> int:
        """Read the number; 3.0 is one."""
        if isinstance(value, float) and not isfinite(value):
            raise Refusal("not_finite", f"{place} = {shown(value)} must be a finite number", place)
        if isinstance(value, float) and value.is_integer():
            value = int(value)
        if isinstance(value, bool) or not isinstance(value, int):
            raise _wrong(place, value, "a whole number")
        if not self.least <= value <= self.most:
            raise Refusal("out_of_range", f"{place} = {shown(value)} must be from {self.least} to {self.most}", place)
        return value

    def schema(self) -> dict[str, Any]:
        """Describe the number."""
        return {"type": "integer", "minimum": self.least, "maximum": self.most}


@dataclass(frozen=True, slots=True)
class Flag:
    """True or false."""

    doc: str
    default: Any = NEEDED

    def read(self, value: Any, place: str) -> bool:
        """Read the flag."""
        if not isinstance(value, bool):
            raise _wrong(place, value, "true or false")
        return value

    def schema(self) -> dict[str, Any]:
        """Describe the flag."""
        return {"type": "boolean"}


@dataclass(frozen=True, slots=True)
class Text:
    """A short text, such as a name."""

    doc: str
    default: Any = NEEDED
    most: int = 64  # characters

    def read(self, value: Any, place: str) -> str:
        """Read the text."""
        if not isinstance(value, str):
            raise _wrong(place, value, "a text")
        if not 0 < len(value) <= self.most:
            raise Refusal("out_of_range", f"{place} must have 1 to {self.most} characters, not {len(value)}", place)
        if not value.isprintable():  # control characters, half a character: could not be shown in an answer
            raise Refusal("out_of_range", f"{place} = {shown(value)} must have characters that can be shown", place)
        return value

    def schema(self) -> dict[str, Any]:
        """Describe the text."""
        return {"type": "string", "minLength": 1, "maxLength": self.most}


@dataclass(frozen=True, slots=True)
class Choice:
    """One of a few words."""

    doc: str
    words: tuple[str, ...]
    default: Any = NEEDED

    def read(self, value: Any, place: str) -> str:
        """Read the word."""
        if not isinstance(value, str):
            raise _wrong(place, value, "a text")
        if value not in self.words:
            raise Refusal("out_of_range", f"{place} = {shown(value)} must be one of {', '.join(self.words)}", place)
        return value

    def schema(self) -> dict[str, Any]:
        """Describe the words."""
        return {"enum": list(self.words)}


@dataclass(frozen=True, slots=True)
class ListOf:
    """A list of values of one kind, of a bounded length."""

    doc: str
    item: Kind
    default: Any = NEEDED
    least: int = 0
    most: int = 100

    def read(self, value: Any, place: str) -> tuple[Any, ...]:
        """Read the list."""
        if not isinstance(value, list | tuple):
            raise _wrong(place, value, "a list")
        if not self.least <= len(value) <= self.most:
            count = str(self.least) if self.least == self.most else f"{self.least} to {self.most}"
            raise Refusal("out_of_range", f"{place} must have {count} entries, not {len(value)}", place)
        return tuple(self.item.read(one, f"{place}[{at}]") for at, one in enumerate(value))

    def schema(self) -> dict[str, Any]:
        """Describe the list."""
        return {"type": "array", "items": described(self.item), "minItems": self.least, "maxItems": self.most}


@dataclass(frozen=True, slots=True)
class MapOf:
    """An object whose names are free, with values of one kind."""

    doc: str
    item: Kind
    default: Any = NEEDED
    most: int = 100

    def read(self, value: Any, place: str) -> dict[str, Any]:
        """Read the object."""
        found = _object(value, place)
        if len(found) > self.most:
            raise Refusal("out_of_range", f"{place} must have at most {self.most} entries, not {len(found)}", place)
        return {name: self.item.read(one, below_foreign(place, name)) for name, one in found.items()}

    def schema(self) -> dict[str, Any]:
        """Describe the object."""
        return {"type": "object", "additionalProperties": described(self.item), "maxProperties": self.most}


@dataclass(frozen=True, slots=True)
class Record:
    """An object with the fields of a table and no others; left-out ones are read as their defaults."""

    doc: str
    fields: Mapping[str, Kind]
    default: Any = NEEDED

    def read(self, value: Any, place: str) -> dict[str, Any]:
        """Read all fields."""
        found = _object(value, place)
        for name in found:
            if name not in self.fields:
                known, at = ", ".join(self.fields), below_foreign(place, name)
                raise Refusal("unknown_field", f"there is no field {at}; the fields are {known}", at)
        return {name: _field(kind, found, name, place) for name, kind in self.fields.items()}

    def schema(self) -> dict[str, Any]:
        """Describe the object."""
        return {
            "type": "object",
            "properties": {name: described(kind) for name, kind in self.fields.items()},
            "required": [name for name, kind in self.fields.items() if kind.default is NEEDED],
            "additionalProperties": False,
        }


@dataclass(frozen=True, slots=True)
class Tagged:
    """An object whose first field says which table the others follow; without it the table `otherwise`."""

    doc: str
    tag: str
    tables: Mapping[str, Record]
    default: Any = NEEDED
    otherwise: str | None = None

    def read(self, value: Any, place: str) -> dict[str, Any]:
        """Read the object by its table; the tag stands in what is read."""
        found = _object(value, place)
        at = below(place, self.tag)
        if self.tag not in found and self.otherwise is None:
            raise Refusal("missing_field", f"the field {at} is missing: one of {', '.join(self.tables)}", at)
        word = Choice("", tuple(self.tables)).read(found.get(self.tag, self.otherwise), at)
        others = {name: one for name, one in found.items() if name != self.tag}
        return {self.tag: word, **self.tables[word].read(others, place)}

    def schema(self) -> dict[str, Any]:
        """Describe one table after the other."""
        return {"oneOf": [self._table(word) for word in self.tables]}

    def _table(self, word: str) -> dict[str, Any]:
        found = described(self.tables[word])
        needed = [] if word == self.otherwise else [self.tag]
        return {
            **found,
            "properties": {self.tag: {"const": word}, **found["properties"]},
            "required": [*needed, *found["required"]],
        }


def described(kind: Kind) -> dict[str, Any]:
    """Describe a kind with its meaning and its default."""
    found = kind.schema()
    if kind.doc:
        found["description"] = kind.doc
    if kind.default is not NEEDED:
        found["default"] = list(kind.default) if isinstance(kind.default, tuple) else kind.default
    return found


def _field(kind: Kind, found: Mapping[str, Any], name: str, place: str) -> Any:
    at = below(place, name)
    if name in found and not (found[name] is None and kind.default is None):
        return kind.read(found[name], at)
    if kind.default is NEEDED:
        raise Refusal("missing_field", f"the field {at} is missing ({kind.doc})", at)
    return kind.default


def _object(value: Any, place: str) -> Mapping[str, Any]:
    if isinstance(value, Repeated):
        at = below_foreign(place, value.name)
        raise Refusal("repeated_field", f"the field {at} stands twice", at)
    if not isinstance(value, Mapping):
        raise _wrong(place, value, "an object")
    return value


def _wrong(place: str, value: Any, wanted: str) -> Refusal:
    return Refusal("wrong_type", f"{place} = {shown(value)} must be {wanted}", place)
