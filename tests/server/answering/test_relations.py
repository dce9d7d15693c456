"""Relations as lists say what the text says: evaluated apart, they agree with the language's own evaluation."""

from __future__ import annotations

import math
import operator
from typing import Any

import pytest

from exercises.grading import reference
from exercises.solving import evaluate
from exercises.variants import deal
from graders.language import parse_line
from server.answering.relations import listed, relations

VALUES = {"l1": 0.3, "l2": 0.7, "alpha1": 0.4}
CALLS: dict[str, Any] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "^": operator.pow,
    "negate": operator.neg, "degrees": math.radians, "sin": math.sin, "cos": math.cos, "sqrt": math.sqrt,
    "atan2": math.atan2,
}  # fmt: skip


def value(tree: Any) -> float:
    if isinstance(tree, float):
        return tree
    if isinstance(tree, str):
        return math.pi if tree == "pi" else VALUES[tree]
    name, *parts = tree
    found: float = CALLS[name](*map(value, parts))
    return found


@pytest.mark.parametrize(
    "text", ["l1*cos(alpha1 - 30°) - l2^2/2", "-sqrt(l1) + pi*l2", "+l1 - 1,5*sin(12°22'12\")", "atan2(l1; l2)*2.5"]
)
def test_a_formula_as_lists_has_the_value_of_its_text(text: str) -> None:
    assert value(listed(parse_line(text))) == pytest.approx(evaluate(text, VALUES), rel=1e-14)


def test_a_polygon_gives_vectors_and_what_is_zero_on_each_axis() -> None:
    variant = deal("slider_crank_polygon", 7)
    found = relations(variant, "polygon", reference(variant)["polygon"])
    assert found is not None
    assert found["vectors"][2] == {"start": "A", "end": "C", "length": "l3", "angle": 0.0}
    assert [equation["axis"] for equation in found["equations"]] == ["x", "y"]
    assert found["equations"][1]["zero"][0] == "-"


def test_what_the_student_says_of_a_rate_comes_along() -> None:
    found = relations(deal("slider_crank_polygon", 7), "velocities", "x: -l1*w2 - v = 0\ny: l1 = 0\nw2 = alpha2_d")
    assert found is not None and found["said"] == [["w2", "alpha2_d"]]


@pytest.mark.parametrize(
    ("answer", "text"), [("polygon", "x: l1"), ("velocities", "x: 1e999*l1 = v3\ny: l1 = 0"), ("alpha2", "12°")]
)
def test_what_holds_no_formula_of_doubles_gives_none(answer: str, text: str) -> None:
    assert relations(deal("slider_crank_polygon", 7), answer, text) is None


def test_a_diagram_gives_the_rows_of_its_table_over_the_bar_of_the_task() -> None:
    beam = deal("beam_diagrams", 7)
    assert relations(beam, "V", "0 .. 2: 4; 2 .. 3: 1 - x") == {
        "rows": [[0.0, 4.0, None, None], [2.0, 4.0, -1.0, None], [3.0, -2.0, None, None]]
    }
    found = relations(beam, "V", "4 - 2*x")
    assert found is not None and found["rows"][-1][:2] == [beam.givens.L, 4 - 2 * beam.givens.L]
    assert relations(beam, "V", "0 .. 1: x^3") == {"rows": None}
