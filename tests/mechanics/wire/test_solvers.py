"""Each solver on the wire answers its example as described, and refuses every field that is broken, by its name."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from copy import deepcopy
from types import FrameType
from typing import Any

import pytest

from mechanics.wire import reading, solvers
from mechanics.wire.refusal import Refusal

NAMES = sorted(solvers.SOLVERS)


def answered(name: str, request: Any) -> dict[str, Any]:
    text = request if isinstance(request, str | bytes) else json.dumps(request)
    found = solvers.answer(name, text.encode() if isinstance(text, str) else text)
    wire: dict[str, Any] = json.loads(json.dumps(found, allow_nan=False))
    return wire


def code(name: str, request: Any) -> str:
    return str(answered(name, request)["error"]["code"])


def counted(work: Callable[[], dict[str, Any]]) -> tuple[int, dict[str, Any]]:
    """Give how many functions a piece of work calls, and what it gives."""
    calls = 0

    def count(_frame: FrameType, event: str, _argument: object) -> None:
        nonlocal calls
        calls += event == "call"

    sys.setprofile(count)
    try:
        found = work()
    finally:
        sys.setprofile(None)
    return calls, found


def leaves(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], Any]]:
    """Every place of a request, with what stands there."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, one in inner:
        yield (*path, key), one
        yield from leaves(one, (*path, key))


def changed(request: Any, path: tuple[Any, ...], value: Any) -> Any:
    made = deepcopy(request)
    inner = made
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    return made


@pytest.mark.parametrize("name", NAMES)
def test_the_example_is_answered_as_described(name: str) -> None:
    solver = solvers.load(name)
    found = answered(name, {**solver.EXAMPLE, "id": "n1"})
    assert found.pop("id") == "n1"
    assert found and set(found) <= set(solver.ANSWER)
    assert solvers.schema(name)["title"] == name


@pytest.mark.parametrize("name", NAMES)
def test_each_broken_number_is_refused_by_its_name(name: str) -> None:
    example = json.loads(json.dumps(solvers.load(name).EXAMPLE))
    for path, value in leaves(example):
        if not isinstance(value, int | float) or isinstance(value, bool):
            continue
        last = next(str(key) for key in reversed(path) if isinstance(key, str))
        for broken, wanted in (
            (True, "wrong_type"),
            ("7", "wrong_type"),
            (float("nan"), "not_finite"),
            ({}, "wrong_type"),
        ):
            error = answered(name, changed(example, path, broken))["error"]
            assert (error["code"], last in error["message"]) == (wanted, True), (path, broken, error)


@pytest.mark.parametrize("name", NAMES)
def test_each_unknown_field_is_refused_at_every_depth(name: str) -> None:
    example = json.loads(json.dumps(solvers.load(name).EXAMPLE))
    places = [()] + [path for path, value in leaves(example) if isinstance(value, dict)]
    for path in places:
        error = answered(name, changed(example, (*path, "bogus"), 1))["error"]
        assert "bogus" in error["message"] and error["code"] in ("unknown_field", "wrong_type"), (path, error)


@pytest.mark.parametrize("name", NAMES)
def test_extreme_numbers_are_answered_or_refused(name: str) -> None:
    example = json.loads(json.dumps(solvers.load(name).EXAMPLE))
    for path, value in leaves(example):
        if isinstance(value, int | float) and not isinstance(value, bool):
            for extreme in (0, -value, 1e-300, 1e300, 5e-324, -1e308, 2**70):
                found = answered(name, changed(example, path, extreme))
                assert "error" in found or set(found) <= set(solvers.load(name).ANSWER)


@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        (b"", "bad_json"),
        (b"{", "bad_json"),
        (b"[]", "bad_json"),
        (b"null", "bad_json"),
        (b"1e5", "bad_json"),
        (b'{"L": 1,}', "bad_json"),
        (b"\xff\xfe", "bad_json"),
        (b'{"L": 1} {"L": 2}', "bad_json"),
        (b"[" * 60000, "bad_json"),
        (b'{"a":' * 10000, "bad_json"),
        (b'{"L": 1, "L": 2}', "repeated_field"),
        (b"{" + b"".join(b'"%d":1,' % name for name in range(5900)) + b'"5899":2}', "repeated_field"),
        (b'{"x": "' + b"a" * 70000 + b'"}', "too_large"),
        (b'{"L": 1e999}', "not_finite"),
        (b'{"L": ' + b"9" * 60000 + b"}", "not_finite"),
        (b'{"L": Infinity}', "not_finite"),
        (b'{"id": [1], "L": 1}', "wrong_type"),
        (b'{"id": true, "L": 1}', "wrong_type"),
        (b'{"id": NaN, "L": 1}', "not_finite"),
        (b'{"id": "' + b"a" * 300 + b'"}', "out_of_range"),
        (b'{"supports": [' + b"{}," * 20000 + b"{}]}", "missing_field"),
        (b'{"L": 4, "E": 1, "I": 1, "supports": [' + b"{}," * 20000 + b"{}]}", "out_of_range"),
    ],
)
def test_a_hostile_line_is_refused_at_once(line: bytes, wanted: str) -> None:
    """The work, counted in calls of functions, grows no faster than the line: an object of it costs one call."""
    solvers.load("beam")
    calls, found = counted(lambda: solvers.answer("beam", line))
    assert calls < 100 + len(line) / 2
    assert found["error"]["code"] == wanted, found
    assert len(json.dumps(found)) < 500


def test_a_repeated_field_is_found_inside_and_keeps_the_id() -> None:
    line = b'{"id": 7, "L": 4, "E": 1, "I": 1, "supports": [{"x": 0, "x": 1, "type": "pin"}]}'
    found = solvers.answer("beam", line)
    assert found["id"] == 7 and found["error"]["message"] == "the field supports[0].x stands twice"


@pytest.mark.parametrize("identity", ["a", "", 0, 1.5, None, 12345678901234567890, "\ud800", "\u2028"])
def test_an_id_comes_back_as_it_was(identity: Any) -> None:
    assert answered("beam", {"id": identity})["id"] == identity
    assert answered("beam", {**solvers.load("beam").EXAMPLE, "id": identity})["id"] == identity


def test_an_unknown_solver_is_named_with_those_there_are() -> None:
    with pytest.raises(Refusal, match="beam, shaft, bar") as found:
        solvers.load("baem")
    assert found.value.code == "unknown_solver"


def test_a_text_that_goes_on_is_told_from_a_broken_one() -> None:
    assert all(map(reading.is_cut_off, (b"{", b'{"a": 1,', b'{"a": [', b'{"a":', b'{"a": 1')))
    assert not any(map(reading.is_cut_off, (b"", b"[", b'{"a": 1}', b'{"a" 1, "b": 2', b"x", b"[" * 60000)))


BEAM = {"L": 4, "E": 2e11, "I": 1e-6, "supports": [{"x": 0, "type": "fixed"}]}
BAR = {"segments": [{"L": 1, "A": 1e-4, "E": 2e11}]}


@pytest.mark.parametrize(
    ("name", "request_", "wanted", "word"),
    [
        ("beam", {**BEAM, "section": {"type": "circle", "d": 0.1}}, "contradictory", "section"),
        ("beam", {k: v for k, v in BEAM.items() if k != "I"}, "missing_field", "section"),
        ("beam", {**BEAM, "supports": []}, "unstable", "too few supports"),
        ("beam", {**BEAM, "supports": [{"x": 0, "type": "pin"}]}, "unstable", "x = 0.0 m"),
        ("beam", {**BEAM, "hinges": [2.0]}, "unstable", "hinge at x = 2.0 m"),
        ("beam", {**BEAM, "supports": [{"x": 5, "type": "fixed"}]}, "out_of_range", "5.0 m"),
        ("beam", {**BEAM, "sample_x": [4.5]}, "out_of_range", "4.5 m"),
        ("shaft", {"G": 8e10, "segments": [{"L": 1, "D": 0.1}], "torques": [{"x": 1, "T": 5}], "support": "free_free"},
         "unbalanced", "5.0 N m"),
        ("shaft", {"G": 8e10, "segments": [{"L": 1, "D": 0.1, "d": 0.1}], "torques": []}, "out_of_range", "bore"),
        ("bar", {**BAR, "gap_right": 0.1}, "contradictory", "gap_right"),
        ("bar", {**BAR, "support": "fixed_gap"}, "missing_field", "gap_right"),
    ],
)  # fmt: skip
def test_what_cannot_be_solved_says_why(name: str, request_: Any, wanted: str, word: str) -> None:
    error = answered(name, request_)["error"]
    assert error["code"] == wanted and word in error["message"], error


def test_the_contract_s_beam_is_in_equilibrium() -> None:
    found = answered("beam", solvers.load("beam").EXAMPLE)
    left, right = found["reactions"]
    assert left["Fy"] + right["Fy"] == pytest.approx(5000 + 6000)
    # The trapezium of 2 and 4 kN/m over 1 .. 3 m: its resultant 6 kN stands at 1 + 2 (2 + 2*4)/(3 (2 + 4)) m.
    assert 4 * right["Fy"] == pytest.approx(5000 * 1.5 - 1200 + 6000 * (1 + 10 / 9))


def test_a_place_that_misses_the_end_by_a_rounding_is_the_end() -> None:
    third = 3 * 0.1
    request = {
        "L": 0.3, "E": 2e11, "I": 1e-8, "sample_x": [third],
        "supports": [{"x": 0, "type": "pin"}, {"x": third, "type": "roller"}],
        "loads": [{"type": "force", "x": third, "F": -7}, {"type": "dist", "x1": 0, "x2": third, "w1": -9, "w2": -9}],
    }  # fmt: skip
    found = answered("beam", request)
    assert found["reactions"][1] == {"x": 0.3, "Fy": pytest.approx(7 + 9 * 0.15), "M": 0.0}
    assert found["samples"][0]["x"] == 0.3 and found["samples"][0]["v"] == pytest.approx(0, abs=1e-18)


def test_a_place_that_misses_the_start_by_a_rounding_is_the_start() -> None:
    less = 0.3 - 3 * 0.1  # -5.6e-17
    request = {
        "L": 0.3, "E": 2e11, "I": 1e-8, "sample_x": [less], "supports": [{"x": less, "type": "fixed"}],
        "loads": [{"type": "dist", "x1": less, "x2": 0.3, "w1": -9, "w2": -9}, {"type": "moment", "x": less, "M": 2}],
    }  # fmt: skip
    found = answered("beam", request)
    assert found["reactions"] == [{"x": 0.0, "Fy": pytest.approx(2.7), "M": pytest.approx(0.3 * 2.7 / 2 - 2)}]
    assert found["samples"][0]["x"] == 0.0
    assert code("beam", request | {"sample_x": [-1e-6]}) == "out_of_range"


HUGE = [{"type": "rect", "b": 1e200, "h": 1e200, "y": y, "hole": y < 0} for y in (1e300, -1e300, 0.0)]
FOUR_BAR = {
    "kind": "four_bar", "l1": 0.1, "l2": 0.26, "l3": 0.22, "l4": 0.3, "m1": 0.5, "m2": 1.0, "m3": 0.8,
    "s1": 0.04, "s2": 0.12, "s3": 0.1, "e1": 0.08, "e3": 0.1,
}  # fmt: skip


@pytest.mark.parametrize(
    ("name", "request_"),
    [
        ("beam", {"L": 1e-300, "E": 2e11, "I": 1e-6, "supports": [{"x": 0, "type": "fixed"}]}),
        ("bar", {"segments": [{"L": 0.5, "A": 5e-324, "E": 2e11}], "forces": [{"x": 0.5, "F": 100}]}),
        ("shaft", {"G": 8e10, "segments": [{"L": 1, "D": 1e-60}], "torques": [{"x": 1, "T": 1e200}]}),
        ("bar", {"segments": [{"L": 5, "A": 1, "E": 1, "q": q} for q in (1e308, -1e308)]}),
        ("balance", {**FOUR_BAR, "m1": 1e308, "s1": 4, "s3": -1e308}),
        (
            "reduction",
            {"l1": 0.2, "l2": 1e9, "alpha1": -1.9, "m2": 1.7e308, "m3": 1.7e308, "F3_x": -1e308, "M1": -1e308},
        ),
        (
            "beam",
            {
                "L": 1,
                "E": 2e11,
                "supports": [{"x": 0, "type": "fixed"}],
                "section": {"type": "composed", "parts": HUGE},
            },
        ),
        ("linkage", {"kind": "four_bar", "l1": 0.2, "l2": 1.3, "l3": 0.3, "l4": 1e155, "alpha1": 2}),
        ("linkage", {"kind": "two_loop", "l1": 0.3, "l2": 0.5, "l3": 0.2, "l4": 1e308, "l5": 1, "h6": 0, "alpha1": 1}),
    ],
)
def test_a_refusal_shows_no_number_that_nobody_sent(name: str, request_: dict[str, Any]) -> None:
    refused = answered(name, request_)["error"]
    assert refused["code"] == "out_of_range"
    assert "leaves the range of floats" in refused["message"] and "nan" not in refused["message"]


def test_a_refusal_is_one_line_whatever_the_names() -> None:
    refused = answered("gear_train", {"members": ["1"], "input_omega": {"a\nb": 1}})["error"]
    assert refused["code"] == "unknown_field" and "\n" not in refused["message"]
    with pytest.raises(Refusal, match=r"vars\.c\\nd stands twice"):
        reading.distinct(reading.read(b'{"vars": {"c\\nd": 1, "c\\nd": 2}}'))
