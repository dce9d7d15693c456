"""The judge of a system: every equation true, together determining, no assembly lost.

The mutant of this judge that lives on changes nothing that can be seen: no spans where it is only asked whether
equations hold at the true states.
"""

from __future__ import annotations

from math import inf, pi

import pytest

from graders import AnswerSyntaxError, Code, Formula, System
from graders.language import Reason, parse_line
from graders.language.mathml import mathml_of
from graders.verdict import Branches
from tests.graders.solutions.crank import GIVEN, L3, surprises, verdict

CLOSURE = ("l1*cos(alpha1) + l2*cos(alpha2) = l3", "l1*sin(alpha1) + l2*sin(alpha2) = h")
CRANK = System(("alpha2", "l3"), ((-1.2, 1.2), (0.0, 0.8)), CLOSURE)
BOTH = System(("alpha2", "l3"), ((-pi, pi), (-0.8, 0.8)), CLOSURE)


def test_the_judge_passes_its_own_samples() -> None:
    assert surprises(CRANK, L3, GIVEN) == []
    assert surprises(BOTH, L3, GIVEN) == []


@pytest.mark.parametrize(
    ("typed", "code", "score"),
    [
        ("l1 sin α1 + l2 sin α2 - h = 0; l3 - l1 cos α1 - l2 cos α2 = 0", Code.RIGHT, 1),
        ("l3 = l1 cos α1 + l2 cos α2\nsin(α2) = (h - l1 sin α1)/l2", Code.RIGHT, 1),
        ("l3 = l1 cos α1 + l2 cos α2; l1 sin α1 + l2 sin α2 = h; l1 sin α1 = h - l2 sin α2", Code.RIGHT, 1),
        ("l3 = l1 cos α1 + l2 cos α2; l1 sin α1 - l2 sin α2 = h", Code.SOME_EQUATIONS, 0.25),
        ("l3 = l1 cos α1 - l2 cos α2; l1 sin α1 - l2 sin α2 = h", Code.NOT_SATISFIED, 0),
        ("l3 = l1 cos α1 + l2 cos α2; 2*l3 = 2*l1*cos(α1) + 2*l2*cos(α2)", Code.UNDETERMINED, 0),
        ("l3 = l1 cos α1 + l2 cos α2", Code.UNDETERMINED, 0),
        ("l3 = l1 cos α1 + l2 cos α2; √(-l1)*(l1 sin α1 + l2 sin α2 - h) = 0", Code.SOME_EQUATIONS, 0.25),
        ("l3 = l1 cos α1 + l2 cos α2; (l3 - l1 cos α1)² + (h - l1 sin α1)² = l2²", Code.SURPLUS_SOLUTION, 0.5),
    ],
)
def test_a_system_is_judged_by_its_solutions(typed: str, code: Code, score: float) -> None:
    found = verdict(CRANK, typed, L3, GIVEN)
    assert (found.code, found.score) == (code, score)


def test_a_lost_assembly_is_named_where_the_spans_hold_both() -> None:
    one = "l1*sin(alpha1) + l2*sin(alpha2) = h; l3 = l1*cos(alpha1) + sqrt(l2^2 - (h - l1*sin(alpha1))^2)"
    assert verdict(BOTH, one, L3, GIVEN).code in (Code.LOST_SOLUTION, Code.SURPLUS_SOLUTION)
    formula = "alpha2 = asin((h - l1*sin(alpha1))/l2); l3 = l1*cos(alpha1) + l2*cos(alpha2)"
    assert verdict(BOTH, formula, L3, GIVEN).code is Code.LOST_SOLUTION
    assert verdict(CRANK, formula, L3, GIVEN).code is Code.RIGHT


def test_how_many_equations_hold_is_told() -> None:
    typed = "l3 = l1 cos α1 + l2 cos α2; l1 sin α1 - l2 sin α2 = h"
    assert verdict(CRANK, typed, L3, GIVEN).details == Branches(1, 2)


@pytest.mark.parametrize(
    ("typed", "reason", "place"),
    [
        ("l3 = l1; l3", Reason.NOT_AN_EQUATION, 8),
        ("l3 = l1; l3 = ", Reason.NEEDS_OPERAND, 14),
        ("l3 = l1\nl3 = q", Reason.UNKNOWN_NAME, 13),
        (" ; ", Reason.EMPTY, 0),
        ("l3 = l1;" * 13, Reason.TOO_LONG, 96),
    ],
)
def test_what_cannot_be_read_has_its_place_in_the_whole_text(typed: str, reason: Reason, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        CRANK.parse(typed, GIVEN)
    assert (refused.value.reason, refused.value.position) == (reason, place)


def test_a_semicolon_inside_brackets_parts_nothing() -> None:
    read = CRANK.parse("alpha2 = atan2(h; l1); l3 = max(l1; l2)", GIVEN)
    assert len(read) == 2


def test_the_share_of_equations_that_hold_is_that_of_the_task() -> None:
    typed = "l3 = l1 cos α1 + l2 cos α2; l1 sin α1 - l2 sin α2 = h; l3 = h"
    found = verdict(CRANK, typed, L3, GIVEN)
    assert (found.score, found.details) == (0.166667, Branches(1, 3))
    whole = verdict(CRANK, "l1 sin α1 - l2 sin α2 = h", L3, GIVEN)
    assert (whole.code, whole.score, whole.details) == (Code.NOT_SATISFIED, 0, None)


def test_systems_of_other_states_are_far_apart() -> None:
    slip = Formula(parse_line("l1*cos(alpha1) - l2*cos(alpha2)"), L3.states)
    other = Formula(parse_line("l1*cos(alpha1) - 2*l2*cos(alpha2)"), L3.states)
    assert CRANK.apart(L3, slip) == CRANK.apart(slip, L3) == inf
    assert CRANK.apart(L3, L3) == CRANK.apart(slip, other) == 0


def test_a_system_is_far_from_states_without_a_value() -> None:
    nothing = Formula(parse_line("sqrt(-1 - l1)"), L3.states)
    assert CRANK.apart(L3, nothing) == CRANK.apart(nothing, L3) == inf
    assert verdict(CRANK, "; ".join(CLOSURE), nothing, GIVEN).code is Code.UNDECIDED


def test_a_system_of_the_author_that_is_none_stops_the_program() -> None:
    with pytest.raises(TypeError, match=r"^\('l1 = h', 'l1 \+ h'\) are not all equations$"):
        System(("alpha2", "l3"), ((-1.2, 1.2), (0.0, 0.8)), ("l1 = h", "l1 + h")).show(L3)


def test_a_system_is_shown_and_echoed_as_it_may_be_typed() -> None:
    assert CRANK.show(L3) == "; ".join(CLOSURE)
    answer = CRANK.parse("l3 = 0,5; alpha2 = h", GIVEN)
    first, second = (mathml_of(one, True).removeprefix("<math>").removesuffix("</math>") for one in answer)
    assert CRANK.echo(answer, comma=True).mathml == f"<math><mrow>{first}<mo>;</mo>{second}</mrow></math>"
    assert CRANK.echo(answer).text == "l3 = 0.5; alpha2 = h"
    assert "<mn>0.5</mn>" in CRANK.echo(answer).mathml and "<mn>0,5</mn>" in first
    assert CRANK.describe() == {"unknowns": ["alpha2", "l3"]}
    assert System(("a", "b", "c"), ((0, 1),) * 3, ()).step == "c"
