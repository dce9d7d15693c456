"""The judge of an equation: true at every state, determining, no solution lost or brought in.

Two mutants of this judge that live on change nothing that can be seen: `any` for `all` over the one equation, and no
span where it is only asked whether an equation holds at the true states.
"""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin

import pytest

from graders import AnswerSyntaxError, Code, Equation, Formula, States
from graders.language import Reason, parse_line
from graders.solutions.posed import box_of
from graders.verdict import Witness
from tests.graders.solutions.crank import ALPHA2, GIVEN, L3, STATES, WITH_ROD, surprises, verdict

ROD = Equation("alpha2", (-1.2, 1.2), "l1*sin(alpha1) + l2*sin(alpha2) = h")
BOTH = Equation("alpha2", (-pi, pi), "l1*sin(alpha1) + l2*sin(alpha2) = h")
SLIDER = Equation("l3", (0.0, 0.8))


def test_the_judge_passes_its_own_samples() -> None:
    assert surprises(ROD, ALPHA2, GIVEN) == []
    assert surprises(BOTH, ALPHA2, GIVEN) == []
    assert surprises(SLIDER, L3, WITH_ROD) == []


@pytest.mark.parametrize(
    ("typed", "code", "score"),
    [
        ("h - l2*sin(α2) = l1*sin(α1)", Code.RIGHT, 1),
        ("sin(α2) = (h - l1 sin α1)/l2", Code.RIGHT, 1),
        ("α2 = arcsin((h - l1*sin(α1))/l2)", Code.RIGHT, 1),
        ("(l1*sin(α1) + l2*sin(α2) - h)^2 = 0", Code.RIGHT, 1),
        ("l1*sin(α1) + l2*sin(α2) = -h", Code.NOT_SATISFIED, 0),
        ("l1*sin(α1) + l2*cos(α2) = h", Code.NOT_SATISFIED, 0),
        ("l1*sin(α1) + l2*sin(α2) = h*(1 + 1e-9)", Code.NOT_SATISFIED, 0),
        ("α2 = α2", Code.UNDETERMINED, 0),
        ("0 = 0*α2", Code.UNDETERMINED, 0),
        ("sin(α2)^2 + cos(α2)^2 = 1", Code.UNDETERMINED, 0),
        ("sign(l1*sin(α1) + l2*sin(α2) - h)/(1 + α2^2) = 0", Code.UNDECIDED, 0),  # its slope is anything
        ("sqrt(h - l1*sin(α1) - l2*sin(α2)) = l1*sin(α1) + l2*sin(α2) - h", Code.UNDECIDED, 0),  # no value behind
        ("0 = 1", Code.NOT_SATISFIED, 0),
        ("sqrt(-1)*(l1*sin(α1) + l2*sin(α2) - h) = 0", Code.NOT_SATISFIED, 0),
        ("arcsin(2 + l1)*(l1*sin(α1) + l2*sin(α2) - h) = 0", Code.NOT_SATISFIED, 0),
        ("sqrt(l1*sin(α1) + l2*sin(α2) - h) = 0", Code.RIGHT, 1),
        ("sqrt(l1)*(l1*sin(α1) + l2*sin(α2) - h) = 0", Code.RIGHT, 1),
        ("(l2*sin(α2))^2 = (h - l1*sin(α1))^2", Code.SURPLUS_SOLUTION, 0.5),
    ],
)
def test_an_equation_is_judged_by_its_solutions(typed: str, code: Code, score: float) -> None:
    found = verdict(ROD, typed, ALPHA2, GIVEN)
    assert (found.code, found.score) == (code, score)


def test_a_lost_assembly_is_named_where_the_span_holds_both() -> None:
    one = "alpha2 = asin((h - l1*sin(alpha1))/l2)"
    assert verdict(BOTH, one, ALPHA2, GIVEN).code is Code.LOST_SOLUTION
    assert verdict(ROD, one, ALPHA2, GIVEN).code is Code.RIGHT


def test_the_solution_that_the_task_means_is_right_alone_and_no_other() -> None:
    meant = replace(BOTH, branch=True)
    assert verdict(meant, "alpha2 = asin((h - l1*sin(alpha1))/l2)", ALPHA2, GIVEN).code is Code.RIGHT
    assert verdict(meant, "l1*sin(alpha1) + l2*sin(alpha2) = h", ALPHA2, GIVEN).code is Code.RIGHT
    assert verdict(meant, "alpha2 = pi - asin((h - l1*sin(alpha1))/l2)", ALPHA2, GIVEN).code is Code.NOT_SATISFIED


def test_a_replaced_step_moves_the_equation_with_it() -> None:
    slip = Formula(parse_line("-asin((h - l1*sin(alpha1))/l2)"), STATES)
    assert verdict(ROD, "l1*sin(alpha1) - l2*sin(alpha2) = h", slip, GIVEN).code is Code.RIGHT
    assert ROD.apart(ALPHA2, slip) == float("inf")


@pytest.mark.parametrize(
    ("typed", "reason"),
    [
        ("l1*sin(alpha1)", Reason.NOT_AN_EQUATION),
        ("l1 = l2 = h", Reason.NOT_AN_EQUATION),
        ("l1 < l2", Reason.NOT_AN_EQUATION),
        ("alpha2 = l3", Reason.FORBIDDEN_NAME),
        ("alpha2 = q", Reason.UNKNOWN_NAME),
        ("", Reason.EMPTY),
    ],
)
def test_what_is_no_equation_of_the_task_is_unreadable(typed: str, reason: Reason) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        ROD.parse(typed, GIVEN)
    assert refused.value.reason is reason


def test_a_point_is_told_at_which_a_solution_is_lost() -> None:
    found = verdict(BOTH, "alpha2 = asin((h - l1*sin(alpha1))/l2)", ALPHA2, GIVEN)
    assert isinstance(found.details, Witness)
    at = dict(found.details.point)
    assert at["l1"] * sin(at["alpha1"]) + at["l2"] * sin(at["alpha2"]) == pytest.approx(at["h"])
    assert cos(at["alpha2"]) < 0


def test_what_cannot_be_decided_is_kept_for_the_lecturer() -> None:
    waves = " + ".join(f"sin({k}*α2 + l1)" for k in range(3, 60))
    held = f"(h - l2*sin(α2) - l1*sin(α1))*(5 + {waves}) = 0"
    assert verdict(ROD, held, ALPHA2, GIVEN).code is Code.UNDECIDED


def test_an_equation_of_the_author_that_is_none_stops_the_program() -> None:
    with pytest.raises(TypeError, match=r"^'l1 \+ h' is no equation$"):
        Equation("alpha2", (-1.2, 1.2), "l1 + h").show(ALPHA2)


def test_an_equation_is_shown_and_echoed_as_it_may_be_typed() -> None:
    assert ROD.show(ALPHA2) == "l1*sin(alpha1) + l2*sin(alpha2) = h"
    assert SLIDER.show(L3) == "l3 = l1*cos(alpha1) + l2*cos(alpha2)"
    answer = ROD.parse("0,5*alpha2 = h", GIVEN)
    assert ROD.echo(answer).text == "0.5*alpha2 = h"
    assert "<mn>0.5</mn>" in ROD.echo(answer).mathml
    assert "<mn>0,5</mn>" in ROD.echo(answer, comma=True).mathml
    assert ROD.describe() == {"unknowns": ["alpha2"]}


def test_the_box_of_states_that_name_none_is_that_of_their_points() -> None:
    scene = box_of(States(("a", "b"), ((1.0, 5.0), (3.0, 4.0))))
    assert scene.ranges == ((1.0, 3.0), (4.0, 5.0))
    assert scene.points == ((1.0, 5.0), (3.0, 4.0))
