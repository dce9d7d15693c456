"""What equations of rates may hold, which are missing, what their names mean: the borders of the judge.

Mutants of the judge that live on change nothing that can be seen:

* words cut from the right, one state or row of names for another, digits beside letters that end no name; a tie that is
  off by just as much as is allowed, lengths that are not compared where they are the same;
* rates of values that are not derived; another state at which slopes are taken, one that is never reached; how many
  pairs of slips are tried; what is no rate of anything, whatever it is called.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from graders import AnswerSyntaxError, Code, Symbols
from graders.kinds.rates import Rates
from graders.language import Reason
from graders.polygon.mechanism import Mechanism, State
from graders.polygon.reading import MAX_EQUATIONS
from tests.graders.polygon.mechanisms import SLIDER, TWO_LOOPS
from tests.graders.polygon.test_rates import SA, SV, flaws, judged

LOOPS = """x1: -l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2) + l3*omega3*sin(alpha3) = 0
y1: l1*omega1*cos(alpha1) + l2*omega2*cos(alpha2) - l3*omega3*cos(alpha3) = 0
x2: -l3*omega3*sin(alpha3) - l5*omega5*sin(alpha5) - v6 = 0
y2: l3*omega3*cos(alpha3) + l5*omega5*cos(alpha5) = 0""".splitlines()
X, Y = SV.splitlines()


@pytest.mark.parametrize(
    ("text", "reason", "place"),
    [
        ("", Reason.EMPTY, 0),
        ("speeds: l1 = l1", Reason.NOT_A_LINE, 0),
        ("W = alpha2_d", Reason.NOT_AN_EQUATION, 0),
        ("\n".join(["x: l1 = 1"] * (MAX_EQUATIONS + 1)), Reason.TOO_LONG, 10 * MAX_EQUATIONS + 3),
    ],
)
def test_what_cannot_be_read_is_told_with_its_place(text: str, reason: Reason, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Rates("polygon", 1, "omega2").parse(text, Symbols(["l1"], ["alpha2"]))
    assert (refused.value.reason, refused.value.position) == (reason, place)


def test_as_many_equations_as_allowed_are_read() -> None:
    text = "\n".join(["x: l1 = 1"] * MAX_EQUATIONS)
    assert len(Rates("polygon", 1, "omega2").parse(text, Symbols(["l1"])).equations) == MAX_EQUATIONS


def test_names_are_explained_by_one_another_three_times_over() -> None:
    text = SV.replace("omega2", "T")
    chain = ["T = U_d", "U_d = W_d", "W_d = alpha2_d"]
    assert judged("\n".join([text, *chain]), 1).code is Code.RIGHT
    longer = ["T = U_d", "U_d = W_d", "W_d = Z_d", "Z_d = alpha2_d"]
    assert flaws("\n".join([text, *longer]), 1)[0] == ("unknown_rate", "T", "")


def test_no_name_is_a_third_rate() -> None:
    text = f"W = alpha2_dd\n{SA.replace('epsilon2', 'W_d')}"
    assert flaws(text, 2) == [("unknown_rate", "W_d", "")]


def test_a_name_that_is_not_clear_is_told_in_every_equation() -> None:
    text = f"{X.replace('v3', 'q7')}\n{Y.replace('omega2', 'q8')}"
    assert flaws(text, 1) == [("unknown_rate", "q7", ""), ("unknown_rate", "q8", "")]


@pytest.mark.parametrize(
    ("lines", "axes"),
    [
        (LOOPS[:1], ["y", "x"]),
        (LOOPS[1::2], ["x"]),
        ([*LOOPS[:2], LOOPS[2][4:]], ["y"]),
        ([LOOPS[0], *(line[4:] for line in LOOPS[1:3])], ["y"]),
    ],
)
def test_the_projections_that_are_missing_are_told(lines: list[str], axes: list[str]) -> None:
    assert flaws("\n".join(lines), 1, TWO_LOOPS) == [("no_projection", "", axis) for axis in axes]


def test_an_equation_of_two_loops_that_says_nothing_new_costs_its_share() -> None:
    text = "\n".join([*LOOPS[:3], LOOPS[0].replace("x1: ", "y2: 2*0 + ")])
    found = judged(text, 1, TWO_LOOPS)
    assert found.score == 0.75
    assert [code for code, *_ in flaws(text, 1, TWO_LOOPS)] == ["not_determined"]


def test_an_equation_without_a_label_is_diagnosed_along_both_axes() -> None:
    for lost, place in ((" - l1*omega1^2*cos(alpha1)", "1"), (" - l1*omega1^2*sin(alpha1)", "2")):
        text = "\n".join(line[3:] for line in SA.replace(lost, "").splitlines())
        assert flaws(text, 2) == [("centripetal_missing", "l1", place)]


def test_an_equation_of_the_first_loop_without_a_label_is_diagnosed() -> None:
    text = "\n".join(line[4:] for line in LOOPS).replace("l2*omega2*cos(alpha2)", "l2*cos(alpha2)")
    assert flaws(text, 1, TWO_LOOPS) == [("chain_rule", "l2", "2")]


def test_rates_of_rates_are_told_whatever_the_order_of_the_givens() -> None:
    def turned() -> tuple[State, ...]:
        return tuple(replace(state, names=dict(reversed(list(state.names.items())))) for state in SLIDER.states())

    mechanism: Mechanism = replace(SLIDER, states=turned)
    assert judged(SV, 1, mechanism).code is Code.RIGHT
    assert judged(SA, 2, mechanism).code is Code.RIGHT
