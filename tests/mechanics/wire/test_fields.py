"""A table of fields reads what it describes and refuses the rest by name."""

from __future__ import annotations

from typing import Any

import pytest

from mechanics.wire.fields import Choice, Flag, Kind, ListOf, MapOf, Number, Record, Tagged, Text, Whole
from mechanics.wire.refusal import Refusal

LENGTH = Number("length", "m", above=0)
TABLE = Record(
    "a thing",
    {
        "L": LENGTH,
        "n": Whole("count", 1, 9, default=2),
        "gap": Number("gap", "m", default=None),
        "parts": ListOf("parts", Record("", {"x": Number("place", "m")}), default=(), most=2),
        "kind": Tagged("", "type", {"a": Record("", {"p": LENGTH}), "b": Record("", {})}, default=None),
    },
)


def refused(kind: Kind, value: Any) -> tuple[str, str]:
    with pytest.raises(Refusal) as found:
        kind.read(value, "q")
    assert "q" in found.value.message
    return found.value.code, found.value.field


@pytest.mark.parametrize(
    ("kind", "value", "code"),
    [
        (LENGTH, True, "wrong_type"),
        (LENGTH, "1", "wrong_type"),
        (LENGTH, None, "wrong_type"),
        (LENGTH, [1], "wrong_type"),
        (LENGTH, {}, "wrong_type"),
        (LENGTH, float("nan"), "not_finite"),
        (LENGTH, float("-inf"), "not_finite"),
        (LENGTH, 10**400, "not_finite"),
        (LENGTH, 0, "out_of_range"),
        (Number("", least=1), 0.5, "out_of_range"),
        (Number("", below=1), 1, "out_of_range"),
        (Number("", most=1), 1.5, "out_of_range"),
        (Whole("", 1, 9), 10, "out_of_range"),
        (Whole("", 1, 9), 10**30, "out_of_range"),
        (Whole("", 1, 9), 1.5, "wrong_type"),
        (Whole("", 1, 9), True, "wrong_type"),
        (Whole("", 1, 9), float("inf"), "not_finite"),
        (Flag(""), 1, "wrong_type"),
        (Text(""), 1, "wrong_type"),
        (Text(""), "", "out_of_range"),
        (Text(""), "a" * 65, "out_of_range"),
        (Text(""), "a\n", "out_of_range"),
        (Text(""), "\ud800", "out_of_range"),
        (Choice("", ("a", "b")), "c", "out_of_range"),
        (Choice("", ("a", "b")), ["a"], "wrong_type"),
        (ListOf("", LENGTH), {"0": 1}, "wrong_type"),
        (ListOf("", LENGTH), "12", "wrong_type"),
        (ListOf("", LENGTH, least=1), [], "out_of_range"),
        (ListOf("", LENGTH, most=2), [1, 2, 3], "out_of_range"),
        (ListOf("", LENGTH, least=3, most=3), [1], "out_of_range"),
        (MapOf("", LENGTH), [1], "wrong_type"),
        (MapOf("", LENGTH, most=1), {"a": 1, "b": 2}, "out_of_range"),
        (TABLE, [], "wrong_type"),
        (TABLE, None, "wrong_type"),
    ],
)
def test_a_value_of_another_kind_is_refused_by_its_place(kind: Kind, value: Any, code: str) -> None:
    assert refused(kind, value) == (code, "q")


@pytest.mark.parametrize(
    ("value", "code", "field"),
    [
        ({}, "missing_field", "q.L"),
        ({"L": 1, "l": 1}, "unknown_field", "q.l"),
        ({"L": 1, "parts": [{"x": 1}, {"y": 1}]}, "unknown_field", "q.parts[1].y"),
        ({"L": 1, "parts": [{}]}, "missing_field", "q.parts[0].x"),
        ({"L": 1, "kind": {}}, "missing_field", "q.kind.type"),
        ({"L": 1, "kind": {"type": "c"}}, "out_of_range", "q.kind.type"),
        ({"L": 1, "kind": {"type": "b", "p": 1}}, "unknown_field", "q.kind.p"),
        ({"L": 1, "kind": {"type": "a", "p": -1}}, "out_of_range", "q.kind.p"),
        ({"L": 1, "n": None}, "wrong_type", "q.n"),
    ],
)
def test_a_field_is_refused_by_its_place(value: Any, code: str, field: str) -> None:
    assert refused(TABLE, value) == (code, field)


def test_what_is_read_has_every_field() -> None:
    assert TABLE.read({"L": 1, "gap": None}, "") == {"L": 1.0, "n": 2, "gap": None, "parts": (), "kind": None}
    found = TABLE.read({"L": 1, "n": 3.0, "parts": [{"x": 2}], "kind": {"type": "a", "p": 4}}, "")
    assert found["n"] == 3 and isinstance(found["n"], int)
    assert found["parts"] == ({"x": 2.0},) and found["kind"] == {"type": "a", "p": 4.0}
    assert MapOf("", LENGTH).read({"a": 1}, "") == {"a": 1.0}


def test_a_table_may_be_meant_without_its_tag() -> None:
    plain = Tagged("", "kind", {"a": Record("", {"p": LENGTH}), "b": Record("", {})}, otherwise="a")
    assert plain.read({"p": 1}, "") == plain.read({"kind": "a", "p": 1}, "") == {"kind": "a", "p": 1.0}
    assert plain.schema()["oneOf"][0]["required"] == ["p"]


def test_the_schema_says_what_is_read() -> None:
    schema = TABLE.schema()
    assert schema["required"] == ["L"] and schema["additionalProperties"] is False
    assert schema["properties"]["L"] == {
        "type": "number", "x-unit": "m", "exclusiveMinimum": 0, "description": "length",
    }  # fmt: skip
    assert schema["properties"]["n"] == {
        "type": "integer", "minimum": 1, "maximum": 9, "description": "count", "default": 2,
    }  # fmt: skip
    assert schema["properties"]["kind"]["oneOf"][0]["properties"]["type"] == {"const": "a"}


def test_a_foreign_name_is_printable_and_short_in_a_message() -> None:
    with pytest.raises(Refusal) as found:
        TABLE.read({"L": 1, "\x1b[31m" + "y" * 5000: 1}, "")
    assert found.value.message.isprintable() and len(found.value.message) < 200
