"""Givens of a variant: their domains, their names as a student types them, and their stored form."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import Field, dataclass, field, fields, is_dataclass
from functools import lru_cache
from typing import Any, TypeAlias, get_args, get_type_hints

Json: TypeAlias = Any


@dataclass(frozen=True, slots=True)
class Domain:
    """The values a given can have: an interval, of whole numbers or of doubles."""

    low: float
    high: float
    integer: bool = False


def given(low: float, high: float, *, integer: bool = False) -> Any:
    """Declare a given's domain, in SI units; symbolic answers are tested inside it."""
    return field(metadata={"domain": Domain(low, high, integer)})


def option(*choices: str) -> Any:
    """Declare a given that is a word (a kind, a sense), not a number."""
    return field(metadata={"choices": choices})


def _fields(value: Any) -> tuple[Field[Any], ...]:
    kind: Any = type(value)
    return _fields_of(kind)


@lru_cache(maxsize=512)
def _fields_of(kind: Any) -> tuple[Field[Any], ...]:
    return fields(kind)


def _members(givens: Any) -> Iterator[tuple[str, Any, str]]:
    """Visit all scalar givens: the field, its owner, and the name a student types (a member's index behind it)."""
    for entry in _fields(givens):
        value = getattr(givens, entry.name)
        if isinstance(value, tuple):
            for index, member in enumerate(value, 1):
                for inner in _fields(member):
                    yield inner.name, member, f"{inner.name}{index}"
        else:
            yield entry.name, givens, entry.name.rstrip("_")


def numbers(givens: Any) -> dict[str, float]:
    """Give the numeric givens by the names students type, in the order of the fields."""
    found = {typed: getattr(owner, name) for name, owner, typed in _members(givens)}
    return {name: value for name, value in found.items() if not isinstance(value, str)}


def words_of(givens: Any) -> dict[str, str]:
    """Give the givens that are words by their names."""
    found = {typed: getattr(owner, name) for name, owner, typed in _members(givens)}
    return {name: value for name, value in found.items() if isinstance(value, str)}


def domains(givens: Any) -> dict[str, Domain]:
    """Give the domains of the numeric givens by the names students type."""
    found = {}
    for name, owner, typed in _members(givens):
        metadata = next(entry.metadata for entry in _fields(owner) if entry.name == name)
        if "domain" in metadata:
            found[typed] = metadata["domain"]
        elif not isinstance(getattr(owner, name), str):
            raise TypeError(f"given {name!r} of {type(owner).__name__} declares no domain: use given(low, high)")
    return found


def each(givens: Any, line: Callable[[Any], str], x: str = "x") -> list[str]:
    """Write one line for each member of a drawn list.

    In it `{i}` stands for the member's index, `{i-1}` for the one before, `{x}` for a place.

    Args:
        givens: The givens (their drawn lists are taken in order), or one drawn list.
        line: Gives the text of a member, for example its class's `moment`.
        x: The name of the place at which the line is taken.
    """
    lists: Sequence[Sequence[Any]]
    if is_dataclass(givens):
        values = [getattr(givens, entry.name) for entry in _fields(givens)]
        lists = [value for value in values if isinstance(value, tuple)]
    else:
        lists = [givens]
    return [_filled(line(member), i, x) for members in lists for i, member in enumerate(members, 1)]


def _filled(text: str, index: int, x: str) -> str:
    return text.replace("{i}", str(index)).replace("{i-1}", str(index - 1)).replace("{x}", x)


def dump(givens: Any) -> dict[str, Json]:
    """Write givens as JSON values; the members of a list carry the name of their class."""
    return {entry.name: _dumped(getattr(givens, entry.name)) for entry in _fields(givens)}


def _dumped(value: Any) -> Json:
    if isinstance(value, tuple):
        return [{"kind": type(member).__name__, **dump(member)} for member in value]
    return value


def restore(kind: type, stored: Mapping[str, Json]) -> Any:
    """Build givens from their stored form.

    Raises:
        ValueError: A field is missing, unknown, or not of the declared shape.
    """
    made: Any = kind
    expected = {entry.name for entry in _fields_of(made)}
    if set(stored) != expected:
        raise ValueError(f"stored givens {sorted(stored)} do not fit {kind.__name__} with {sorted(expected)}")
    hints = _hints(made)
    return made(**{name: _restored(hints[name], value) for name, value in stored.items()})


@lru_cache(maxsize=512)
def _hints(kind: Any) -> dict[str, Any]:
    return get_type_hints(kind)


def _restored(hint: Any, value: Json) -> Any:
    if not isinstance(value, list):
        return value
    inner = get_args(hint)[0]
    classes = {member.__name__: member for member in get_args(inner) or (inner,)}
    return tuple(restore(classes[m["kind"]], {k: v for k, v in m.items() if k != "kind"}) for m in value)
