"""Givens of a variant: their domains, their names as a student types them, and their stored form."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import Field, field, fields, is_dataclass
from functools import lru_cache
from typing import Any, TypeAlias, get_args, get_type_hints

from graders import Domain

Json: TypeAlias = Any


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


Place: TypeAlias = tuple[int, int, str, str, Domain | None]  # field, member (or -1), its field, name typed, domain
Shape: TypeAlias = tuple[tuple[type, ...] | None, ...]  # of the fields: the classes of a drawn list


def _scalars(givens: Any) -> Iterator[tuple[str, Any, Domain | None]]:
    """Visit all scalar givens: the name a student types (a member's index behind it), value and domain."""
    values = [getattr(givens, entry.name) for entry in _fields(givens)]
    shape = tuple([tuple(map(type, value)) if isinstance(value, tuple) else None for value in values])
    kind: Any = type(givens)
    for at, index, inner, typed, domain in _places(kind, shape):
        yield typed, values[at] if index < 0 else getattr(values[at][index], inner), domain


@lru_cache(maxsize=2048)
def _places(kind: Any, shape: Shape) -> tuple[Place, ...]:
    """Find the scalars of all givens of a shape."""
    found: list[Place] = []
    for at, (entry, members) in enumerate(zip(_fields_of(kind), shape, strict=True)):
        if members is None:
            found.append((at, -1, "", entry.name.rstrip("_"), entry.metadata.get("domain")))
        for index, member in enumerate(members or ()):
            inner = _fields_of(member)
            found += [(at, index, one.name, f"{one.name}{index + 1}", one.metadata.get("domain")) for one in inner]
    return tuple(found)


def numbers(givens: Any) -> dict[str, float]:
    """Give the numeric givens by the names students type, in the order of the fields."""
    return {typed: value for typed, value, _ in _scalars(givens) if not isinstance(value, str)}


def words_of(givens: Any) -> dict[str, str]:
    """Give the givens that are words by their names."""
    return {typed: value for typed, value, _ in _scalars(givens) if isinstance(value, str)}


def domains(givens: Any) -> dict[str, Domain]:
    """Give the domains of the numeric givens by the names students type."""
    found = {}
    for typed, value, domain in _scalars(givens):
        if domain is not None:
            found[typed] = domain
        elif not isinstance(value, str):
            raise TypeError(f"given {typed!r} of {type(givens).__name__} declares no domain: use given(low, high)")
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
