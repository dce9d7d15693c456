"""Functions with Macaulay brackets: equal on every stretch, slips named by the place at which they begin.

The mutant of this judge that lives on changes nothing that can be seen: `or` for `and` between the ends of a range,
which are both there or both not.
"""

from __future__ import annotations

import json
import random
from functools import partial

import pytest

from graders import AnswerSyntaxError, Code, Formula, Function, States, Symbols
from graders.language import Reason, parse_line
from graders.profile.bracketed import Part, Span, tried
from graders.remarks import Remark, Remarks, Slip
from graders.verdict import Verdict
from graders.words import LANGUAGES, message
from tests.graders.effort import effort

NAMES = ("F1", "a1", "q2", "a2", "c2", "L", "EI", "x")
LOW, HIGH = (1e3, 0.2, 1e3, 0.2, 0.5, 3.0, 5e5, 0.2), (2e4, 7.0, 1.2e4, 5.0, 7.0, 7.0, 5e7, 7.0)
CHANCE = random.Random(7)
POINTS = tuple(tuple(CHANCE.uniform(a, b) for a, b in zip(LOW, HIGH, strict=True)) for _ in range(20))
LINES = (
    ("R_A", parse_line("(F1*(L - a1) + q2*(c2 - a2)*(L - (a2 + c2)/2))/L")),
    ("C", parse_line("-(R_A*L^3/6 - F1*(L - a1)^3/6 - q2/24*((L - a2)^4 - (L - c2)^4))/L")),
)
STATES = States(NAMES, POINTS, LINES)
MOMENT = Formula(parse_line("R_A*x - F1*<x - a1>^1 - q2/2*(<x - a2>^2 - <x - c2>^2)"), STATES)
SAG = Formula(parse_line("(R_A*x^3/6 - F1*<x - a1>^3/6 - q2/24*(<x - a2>^4 - <x - c2>^4) + C*x)/EI"), STATES)
ENDS = ("a1", "a2", "c2", "L")
BENDING, DEFLECTION = Function("M", ENDS), Function("v", ENDS, constants=True)
SYMBOLS = Symbols([*NAMES, "R_A", "C"], ["M", "v"])


def judged(text: str, judge: Function = BENDING, reference: Formula = MOMENT) -> Verdict:
    return judge.check(judge.parse(text, SYMBOLS), reference)


@pytest.mark.parametrize(("judge", "reference"), [(BENDING, MOMENT), (DEFLECTION, SAG)])
def test_a_function_passes_its_own_samples(judge: Function, reference: Formula) -> None:
    samples = judge.samples(reference)
    assert {judged(text, judge, reference).code for text in (*samples.right, judge.show(reference))} == {Code.RIGHT}
    assert all(judged(text, judge, reference).code is not Code.RIGHT for text in samples.wrong)
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            judge.parse(text, SYMBOLS)


PIECES = (
    "0..a1: R_A x",
    "a1..a2: R_A x - F1(x - a1)",
    "a2..c2: R_A x - F1(x - a1) - q2(x - a2)^2/2",
    "c2..L: R_A x - F1(x - a1) - q2(c2 - a2)(x - (a2 + c2)/2)",
)


@pytest.mark.parametrize(
    "text",
    [
        "R_A*x - F1<x-a1> - q2<x-a2>²/2 + q2<x-c2>²/2",
        "M(x) = R_A*x - F1*macaulay(x - a1; 1) - q2/2*(<x-a2>^2 - <x-c2>^2)",
        "R_A*x - F1*(x - a1 + |x - a1|)/2 - q2/2*(<x-a2>^2 - <x-c2>^2)",
        "R_A*x - F1*max(0; x - a1) - q2/2*(<x-a2>^2 - <x-c2>^2)",
        "(F1*(L-a1)+q2*(c2-a2)*(L-(a2+c2)/2))/L*x - F1<x-a1>^1 - q2/2*<x-a2>^2 + q2/2*<x-c2>^2",
        "; ".join(PIECES),
        "\n".join(reversed(PIECES)),
        f"0 <= x <= a1: R_A*x; x ∈ [a1; a2]: R_A x - F1 (x - a1); {PIECES[2]}; {PIECES[3]}",
        f"M = \n{PIECES[0]}\n{PIECES[1]}\na2 .. L: R_A x - F1 (x - a1) - q2/2*((x - a2)^2 - <x - c2>^2)",
    ],
)
def test_a_function_is_right_however_it_is_written(text: str) -> None:
    assert judged(text).code is Code.RIGHT


@pytest.mark.parametrize(
    ("text", "slip", "name", "score"),
    [
        ("R_A*x - F1*(x - a1) - q2/2*(<x-a2>^2 - <x-c2>^2)", Slip.OPEN_TOO_EARLY, "a1", 2 / 3),
        ("R_A*x - F1<x-a1> - q2/2*(x-a2)^2 + q2/2*<x-c2>^2", Slip.OPEN_TOO_EARLY, "a2", 1 / 3),
        ("R_A*x - F1<x-a1> - q2/2*<x-a2>^2", Slip.FROM_HERE, "c2", 2 / 3),
        ("R_A*x - q2/2*(<x-a2>^2 - <x-c2>^2)", Slip.FROM_HERE, "a1", 0),
        ("R_A*x", Slip.FROM_HERE, "a1", 0),
        (f"{PIECES[0]}; a1..a2: R_A x; {PIECES[2]}; {PIECES[3]}", Slip.STRETCH, "a1 .. a2", 2 / 3),
        ("2*R_A*x - 2*F1<x-a1> - q2*(<x-a2>^2 - <x-c2>^2)", Slip.FACTOR, "", 0),
        ("R_A*x + F1*x - F1<x-a1> - q2/2*(<x-a2>^2 - <x-c2>^2)", Slip.EVERYWHERE, "", 0),
        ("24,06*x - 4,5*<x - 0,3>^2 + 4,5*<x - 2,1>^2 - 13*<x - 0,6>", Slip.NUMBERS, "", 0),
        ("24,06", Slip.NUMBERS, "", 0),
        ("0 .. a1: 24,06*x; a1 .. L: 3", Slip.NUMBERS, "", 0),
        ("0 .. a1: 24,06*x; a1 .. L: F1", Slip.EVERYWHERE, "", 0),
        ("; ".join(PIECES[:3]), Slip.NOT_COVERED, "", 2 / 3),
        ("; ".join((*PIECES, "a1 .. a2: 0")), Slip.COVERED_TWICE, "", 2 / 3),
        ("sqrt(-1 - L) .. L: 1; 0 .. L: 2", Slip.NOT_COVERED, "", 0),
    ],
)
def test_a_slip_is_named_by_the_place_at_which_it_begins(text: str, slip: Slip, name: str, score: float) -> None:
    verdict = judged(text)
    assert isinstance(verdict.details, Remarks)
    (remark,) = verdict.details.found
    assert (remark.slip, remark.name) == (slip, name)
    assert verdict.score == pytest.approx(score, abs=1e-5)
    assert verdict.code is (Code.SOME_MARKS if score else Code.NO_MARKS)
    assert all(name in message(verdict, lang) and "{" not in message(verdict, lang) for lang in LANGUAGES)


def test_the_share_of_stretches_is_told_and_one_stretch_alone_earns_nothing() -> None:
    third = judged("R_A*x - F1<x-a1> - q2/2*(x-a2)^2 + q2/2*<x-c2>^2")
    assert third.score == 0.333333
    assert third.details == Remarks(2, 4, (Remark(Slip.OPEN_TOO_EARLY, name="a2"),))
    half, line = Function("M", ("a1", "L")), Formula(parse_line("R_A*x - F1*<x - a1>^1"), STATES)
    assert judged("R_A*x", half, line) == Verdict(0, Code.NO_MARKS, Remarks(1, 2, (Remark(Slip.FROM_HERE, name="a1"),)))
    late = judged("R_A*x - F1*(x - a1)", half, line)
    assert late == Verdict(0, Code.NO_MARKS, Remarks(1, 2, (Remark(Slip.OPEN_TOO_EARLY, name="a1"),)))
    whole = Function("M", ("L",))
    alone = judged("2*x", whole, Formula(parse_line("x"), STATES))
    assert alone == Verdict(0, Code.NO_MARKS, Remarks(0, 1, (Remark(Slip.EVERYWHERE),)))


def test_what_is_off_in_the_first_stretch_alone_is_named_by_its_ends() -> None:
    text = f"0 .. a1: 2*R_A*x; {PIECES[1]}; {PIECES[2]}; {PIECES[3]}"
    assert judged(text).details == Remarks(3, 4, (Remark(Slip.OPEN_TOO_EARLY, name="a1"),))
    text = f"0 .. a1: 2*R_A*x; {PIECES[1]}; a2 .. c2: x; {PIECES[3]}"
    assert judged(text).details == Remarks(2, 4, (Remark(Slip.STRETCH, name="0 .. a1"),))


@pytest.mark.parametrize(
    ("text", "right"),
    [
        ("R_A*x - F1<x-a1> - q2/2*(<x-a2>^2 - <x-c2>^2)", True),
        ("R_A*x - F1<x-a1> - q2/2*<x-a2>^2", False),
        (f"{BENDING.show(MOMENT)} + max(0; 1e-9 - (x - 0.3)^2)", False),
    ],
)
def test_a_function_is_told_to_be_right_without_naming_what_is_off(text: str, right: bool) -> None:
    assert BENDING.right(BENDING.parse(text, SYMBOLS), MOMENT) is right


def test_a_constant_is_missed_only_where_one_is_asked_for() -> None:
    lost = f"{BENDING.show(MOMENT)} + L*F1"
    assert judged(lost).details == Remarks(0, 4, (Remark(Slip.EVERYWHERE),))
    assert judged(lost, Function("M", ENDS, constants=True)).details == Remarks(0, 4, (Remark(Slip.CONSTANT),))


def test_a_lost_constant_of_integration_is_named() -> None:
    loads = "R_A*x^3/6 - F1*<x-a1>^3/6 - q2/24*(<x-a2>^4 - <x-c2>^4)"
    for text in (f"({loads})/EI", f"({loads} + C)/EI", f"({loads} - C*x)/EI", f"({loads} + C*x)/EI + L"):
        details = judged(text, DEFLECTION, SAG).details
        assert isinstance(details, Remarks) and details.found[0].slip is Slip.CONSTANT


def test_the_opposite_sign_is_named_and_a_formula_without_a_value_too() -> None:
    assert judged("-(R_A*x - F1*<x-a1> - q2/2*(<x-a2>^2 - <x-c2>^2))").code is Code.OPPOSITE_SIGN
    assert judged("sqrt(-x - 1)").code is Code.UNDEFINED
    assert judged("1/(x - x)").code is Code.UNDEFINED


@pytest.mark.parametrize(
    "extra", ["max(0; 1e-9 - (x - 0.3)^2)", "<1e-9 - (x - 0.3)^2>^1", "abs(x^2 - x + 0.3) - x^2 + x - 0.3"]
)
def test_a_bracket_that_is_not_cut_at_its_zeros_keeps_a_function_for_the_lecturer(extra: str) -> None:
    assert judged(f"{BENDING.show(MOMENT)} + {extra}").code is Code.UNDECIDED


def test_a_difference_beyond_doubles_is_seen() -> None:
    assert judged("R_A*x*(1 + 1e-25) - F1*<x-a1> - q2/2*(<x-a2>^2 - <x-c2>^2)").score == 0


def test_both_sides_of_every_place_are_tried_in_the_order_of_the_task() -> None:
    spots = tried((Part(None, None, parse_line("x")),), MOMENT, Span("x", ENDS)).spots
    assert {spot.stretch for spot in spots} == {0, 1, 2, 3}
    for spot in spots:
        at = dict(zip(NAMES, spot.point, strict=True))
        assert 0 < at["x"] < at["L"] and 0 < at["a1"] < at["a2"] < at["c2"] < at["L"]
        assert spot.stretch == sum(at["x"] > at[name] for name in ("a1", "a2", "c2"))


@pytest.mark.parametrize(
    ("text", "reason", "place"),
    [
        ("", Reason.EMPTY, 0),
        ("M", Reason.FORBIDDEN_NAME, 0),
        ("x*v + M", Reason.FORBIDDEN_NAME, 6),
        ("0..a1: R_A*x; a1..L: 2*v", Reason.FORBIDDEN_NAME, 23),
        ("0..L: <x-a1>^1 + <x-a1>^-1", Reason.IMPULSE, 17),
        ("0..x: 1", Reason.FORBIDDEN_NAME, 3),
        ("0..a9: 1", Reason.UNKNOWN_NAME, 3),
        ("[[x; 1]]", Reason.NOT_AN_EXPRESSION, 0),
        ("x < 5", Reason.NOT_AN_EXPRESSION, 0),
        ("; ".join(["0..L: x"] * 17), Reason.TOO_LONG, 144),
        ("0..L: x +", Reason.NEEDS_OPERAND, 9),
        ("0..L", Reason.NEEDS_RANGE, 0),
        ("x; L", Reason.NEEDS_RANGE, 0),
    ],
)
def test_what_is_no_function_is_refused_with_its_place(text: str, reason: Reason, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        BENDING.parse(text, SYMBOLS)
    assert (refused.value.reason, refused.value.position) == (reason, place)


@pytest.mark.parametrize(
    ("text", "found"), [("0..L: x; 0..L: v", "v"), ("M*v", "M"), ("x + 5*x*x*x*x*x*x*x*x < 3", "x + 5*x*x*x*x*x*x*x*")]
)
def test_what_is_refused_is_quoted(text: str, found: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        BENDING.parse(text, SYMBOLS)
    assert refused.value.proposal.found == found


def test_a_function_is_echoed_with_the_decimal_mark_of_the_reader() -> None:
    answer = BENDING.parse("2,5*x", SYMBOLS)
    assert "<mn>2,5</mn>" in BENDING.echo(answer, comma=True).mathml
    assert "<mn>2.5</mn>" in BENDING.echo(answer).mathml


def test_a_function_is_echoed_described_and_carried() -> None:
    pieces, whole = BENDING.parse("; ".join(PIECES), SYMBOLS), BENDING.parse("R_A*x", SYMBOLS)
    echo = BENDING.echo(pieces, comma=True)
    assert echo.mathml.count("<mtr>") == 4 and echo.text.startswith("0 .. a1: R_A x; a1 .. a2: ")
    assert "mtable" not in BENDING.echo(whole).mathml and BENDING.echo(whole).text == "R_A*x"
    assert BENDING.carried(pieces) is None and BENDING.carried(whole) == parse_line("R_A*x")
    assert json.loads(json.dumps(BENDING.describe())) == {"variable": "x", "span": "0 .. L"}
    assert BENDING.apart(MOMENT, MOMENT) == 0 and BENDING.apart(MOMENT, SAG) == float("inf")


def test_the_longest_function_is_judged_in_time() -> None:
    worst = [
        "+".join(["<x-a1>^2"] * 150),
        "*".join(["sin(x)"] * 200),
        "; ".join(f"{k}*L/16 .. {k + 1}*L/16: " + "+".join(f"<x-{k}*a1/7>^{n}" for n in range(9)) for k in range(16)),
    ]
    for text in worst:
        assert judged(text).score == 0
        assert effort(partial(judged, text), enough=1.0) < 1.0  # tens of milliseconds on a free core
