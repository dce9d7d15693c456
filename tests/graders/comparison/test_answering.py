"""Requests to compare: every kind, every refusal, and what each answer carries."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest

from graders import comparison

X = {"x": [-2, 2], "a": ["0.1", "1"], "b": ["1/10", "1"], "phi": ["-pi", "pi"]}


def answered(kind: str, a: Any, b: Any, **more: Any) -> dict[str, Any]:
    return comparison.answer({"kind": kind, "a": a, "b": b, "vars": X, **more})


@pytest.mark.parametrize(
    ("kind", "a", "b", "more", "verdict", "code"),
    [
        ("expression", "sin(phi)^2 + cos(phi)^2", "1", {}, "equal", "equal"),
        ("expression", "x + a", "x + a + 1e-9", {}, "different", "value"),
        ("expression", "x", "x*x/x", {}, "equal", "equal"),
        ("expression", "atan2(x; a)", "atan(x/a)", {}, "equal", "equal"),
        ("expression", "x", "sqrt(x)^2", {}, "different", "undefined"),
        ("expression", "sqrt(x)^2", "x", {}, "different", "undefined"),
        ("expression", "x", "x = a", {}, "different", "shape"),
        ("expression", "x", "[[x]]", {}, "different", "shape"),
        ("expression", "1/3", "0.333333333333", {}, "different", "value"),
        ("equation", "x = a", "2*a = 2*x", {"solve_for": "x"}, "equal", "equal"),
        ("equation", "x^2 = a^2", "x = a", {"solve_for": "x"}, "different", "lost_solution"),
        ("equation", "x = a", "x^2 = a^2", {"solve_for": "x"}, "different", "surplus_solution"),
        ("equation", "x = a", "x = x", {"solve_for": "x"}, "different", "surplus_solution"),
        ("equation", "x = a", "0 = 1", {"solve_for": "x"}, "different", "lost_solution"),
        ("equation", "x = a", "x - a", {"solve_for": "x"}, "different", "shape"),
        ("equation", "x = a", "x = a = b", {"solve_for": "x"}, "different", "shape"),
        ("equation", "x = a", "x < a", {"solve_for": "x"}, "different", "shape"),
        ("equation", "x^2 = -1", "x^2 = -4", {"solve_for": "x"}, "undecided", "undecided"),
        ("system", ["x = a", "b = phi"], ["b = phi", "x = a"], {"solve_for": ["x", "phi"]}, "equal", "equal"),
        ("system", ["x = a", "b = phi"], ["x = a"], {"solve_for": ["x", "phi"]}, "different", "count"),
        ("system", ["x = a", "b = phi"], ["x = a", "x"], {"solve_for": ["x", "phi"]}, "different", "shape"),
        ("system", [], [], {"solve_for": ["x"]}, "different", "shape"),
        ("system", ["x = a", "b = phi"], ["x = a", "x = a"], {"solve_for": ["x", "phi"]}, "different", None),
        ("matrix", "[[cos(phi), -a], [0, 1]]", "[cos(-phi), -a; 0, 1]", {}, "equal", "equal"),
        ("matrix", "[[cos(phi), -a], [0, 1]]", "[cos(phi), a; 0, 1]", {}, "different", "value"),
        ("matrix", "[[x, a], [0, 1]]", "[[x, a]]", {}, "different", "shape"),
        ("matrix", "[[x, a]]", "x", {}, "different", "shape"),
        ("quantity", "12,5 MPa", "12500 kPa", {"rtol": 0}, "equal", "equal"),
        ("quantity", "100 N", "101 N", {"rtol": 0.01}, "equal", "equal"),
        ("quantity", "100 N", "101.001 N", {"rtol": 0.01}, "different", "value"),
        ("quantity", "101.001 N", "100 N", {"rtol": 0.01}, "equal", "equal"),
        ("quantity", "5 N*m", "5 J", {"rtol": 0.01}, "different", "dimension"),
        ("quantity", "5 rad/s", "5 Hz", {"rtol": 0.01}, "different", "dimension"),
        ("quantity", "12 kN", "12", {"rtol": 0.01}, "different", "dimension"),
        ("quantity", "12", "12 m", {"rtol": 0.01}, "different", "dimension"),
        ("quantity", "1500 obr/min", "157.0796327 rad/s", {"rtol": 1e-8}, "equal", "equal"),
        ("quantity", "370°", "10 deg", {"rtol": 1e-9}, "equal", "equal"),
        ("quantity", "0.5 rad", "0.5", {"rtol": 1e-9}, "equal", "equal"),
        ("quantity", "3/8", "0.375", {}, "equal", "equal"),
        ("inequality", "0 < x < a", "x*(a - x) > 0", {}, "equal", "equal"),
        ("inequality", "0 < x <= a", "0 < x < a", {}, "different", "lost_solution"),
        ("inequality", "x < a", "x <= a", {}, "different", "surplus_solution"),
        ("inequality", "x < a", "x = a", {}, "different", "shape"),
        ("inequality", "x < a", "x", {}, "different", "shape"),
        ("unordered_list", ["x", "2*a"], ["a + a", "x"], {}, "equal", "equal"),
        ("unordered_list", ["x", "x"], ["x", "a"], {}, "different", "value"),
        ("unordered_list", ["x"], ["x", "x"], {}, "different", "count"),
        ("unordered_list", [], [], {}, "equal", "equal"),
        ("unordered_list", ["x = a"], ["x"], {}, "different", "shape"),
    ],
)
def test_each_kind_is_compared(kind: str, a: Any, b: Any, more: dict[str, Any], verdict: str, code: str | None) -> None:
    found = answered(kind, a, b, **more)
    assert (found["verdict"], found["position"]) == (verdict, None)
    assert code is None or found["code"] == code
    assert json.loads(json.dumps(found, allow_nan=False)) == found
    assert ("witness" in found) == (verdict == "different")
    if (
        code in ("value", "undefined", "lost_solution", "surplus_solution")
        and kind != "quantity"
        and "x" in str((a, b))
    ):
        assert found["witness"].keys() <= X.keys() and found["witness"]


@pytest.mark.parametrize(
    ("kind", "a", "b", "more", "where"),
    [
        ("expression", "", "x", {}, ("empty", 0, "a", None)),
        ("expression", "x", "x + y", {}, ("unknown_name", 4, "b", None)),
        ("expression", "x", "(x + 1", {}, ("needs_bracket", 6, "b", None)),
        ("expression", "x", "__import__('os')", {}, ("bad_character", 0, "b", None)),
        ("expression", "x", "9" * 70, {}, ("too_large", 0, "b", None)),
        ("expression", "x", "x" * 3000, {}, ("too_long", 2000, "b", None)),
        ("equation", "x = a", "x = q", {"solve_for": "x"}, ("unknown_name", 4, "b", None)),
        ("system", ["x = a", "x ="], ["x = a"], {"solve_for": ["x"]}, ("needs_operand", 3, "a", 1)),
        ("quantity", "5 qq", "5 m", {}, ("unknown_unit", 2, "a", None)),
        ("quantity", "5 m", "NaN", {}, ("not_a_number", 0, "b", None)),
        ("inequality", "x < a", "x <", {}, ("needs_operand", 3, "b", None)),
        ("unordered_list", ["x"], [""], {}, ("empty", 0, "b", 0)),
        ("matrix", "[[x]]", "[[x; 1], [2]]", {}, ("ragged_matrix", 0, "b", None)),
    ],
)
def test_what_cannot_be_read_has_reason_and_place(
    kind: str, a: Any, b: Any, more: dict[str, Any], where: tuple[str, int, str, int | None]
) -> None:
    found = answered(kind, a, b, **more)
    assert found["verdict"] == "unreadable"
    assert (found["code"], found["position"], found["side"], found.get("item")) == where


@pytest.mark.parametrize(
    ("change", "code", "field"),
    [
        ({"kind": "formula"}, "unknown_kind", "kind"),
        ({"kind": 3}, "wrong_type", "kind"),
        ({"a": 3}, "wrong_type", "a"),
        ({"b": None}, "wrong_type", "b"),
        ({"b": ["x"]}, "wrong_type", "b"),
        ({"a": "x" * 20_000}, "out_of_range", "a"),
        ({"bogus": 1}, "unknown_field", "bogus"),
        ({"solve_for": "x"}, "unknown_field", "solve_for"),
        ({"rtol": 0.1}, "unknown_field", "rtol"),
        ({"vars": []}, "wrong_type", "vars"),
        ({"vars": {"x": 1}}, "wrong_type", "vars.x"),
        ({"vars": {"x": [0]}}, "wrong_type", "vars.x"),
        ({"vars": {"x": [0, True]}}, "wrong_type", "vars.x"),
        ({"vars": {"x": [0, None]}}, "wrong_type", "vars.x"),
        ({"vars": {"x": ["2", "1"]}}, "out_of_range", "vars.x"),
        ({"vars": {"x": ["0", "1/0"]}}, "not_finite", "vars.x"),
        ({"vars": {"x": ["0", "1e400"]}}, "not_finite", "vars.x"),
        ({"vars": {"x": [0, math.inf]}}, "not_finite", "vars.x"),
        ({"vars": {"x": [0, math.nan]}}, "not_finite", "vars.x"),
        ({"vars": {"x": [0, 10**400]}}, "not_finite", "vars.x"),
        ({"vars": {"x": ["0", "y"]}}, "unreadable_bound", "vars.x"),
        ({"vars": {"x": ["0", ""]}}, "unreadable_bound", "vars.x"),
        ({"vars": {"x": ["0", "[[1]]"]}}, "unreadable_bound", "vars.x"),
        ({"vars": {"x": ["0", "1 < 2"]}}, "unreadable_bound", "vars.x"),
        ({"vars": {"2x": [0, 1]}}, "unknown_symbol", "vars.2x"),
        ({"vars": {"": [0, 1]}}, "unknown_symbol", "vars."),
        ({"vars": {"x y": [0, 1]}}, "unknown_symbol", "vars.x y"),
        ({"vars": {"l1": [0, 1], "l_1": [0, 1]}}, "contradictory", "vars"),
        ({"vars": {f"x{k}": [0, 1] for k in range(99)}}, "out_of_range", "vars"),
    ],
)
def test_what_is_no_request_is_refused_by_name(change: dict[str, Any], code: str, field: str) -> None:
    with pytest.raises(comparison.BadRequest) as refused:
        comparison.answer({"kind": "expression", "a": "1", "b": "1", **change})
    assert (refused.value.code, refused.value.field) == (code, field)
    assert refused.value.message.isprintable()


@pytest.mark.parametrize(
    ("kind", "given", "code"),
    [
        ("equation", {}, "missing_field"),
        ("equation", {"solve_for": "q"}, "unknown_symbol"),
        ("equation", {"solve_for": ["x"]}, "wrong_type"),
        ("system", {"solve_for": "x"}, "wrong_type"),
        ("system", {"solve_for": []}, "wrong_type"),
        ("system", {"solve_for": ["x", "x"]}, "contradictory"),
        ("quantity", {"rtol": -1}, "out_of_range"),
        ("quantity", {"rtol": math.nan}, "out_of_range"),
        ("quantity", {"rtol": True}, "wrong_type"),
    ],
)
def test_the_fields_of_a_kind_are_checked(kind: str, given: dict[str, Any], code: str) -> None:
    texts = [["x = a"], ["x = a"]] if kind == "system" else ["x = a", "x = a"]
    with pytest.raises(comparison.BadRequest) as refused:
        answered(kind, *texts, **given)
    assert refused.value.code == code


@pytest.mark.parametrize("missing", ["kind", "a", "b"])
def test_a_missing_field_is_named(missing: str) -> None:
    request = {"kind": "expression", "a": "1", "b": "1"}
    del request[missing]
    with pytest.raises(comparison.BadRequest) as refused:
        comparison.answer(request)
    assert (refused.value.code, refused.value.field) == ("missing_field", missing)


def test_a_symbol_whose_range_is_one_value_has_this_value_exactly() -> None:
    fixed = {"x": ["0", "2"], "k": ["pi/3", "pi/3"]}
    request = {"kind": "expression", "a": "x*cos(k)", "b": "x/2", "vars": fixed}
    assert comparison.answer(request)["verdict"] == "equal"
    solved = {"kind": "equation", "a": "x = cos(k)", "b": "2*x = 1", "solve_for": "x", "vars": fixed}
    assert comparison.answer(solved)["verdict"] == "equal"
    assert comparison.answer({**solved, "b": "2*x = 1 + 1e-12"})["verdict"] == "different"


def test_the_secret_chooses_the_witness_and_the_same_secret_the_same_one() -> None:
    request = {"kind": "equation", "a": "x = a", "b": "x = b", "solve_for": "x", "vars": X}
    one, other, again = (comparison.answer(request, secret) for secret in (b"1", b"2", b"1"))
    assert one == again
    assert one["witness"] != other["witness"]
