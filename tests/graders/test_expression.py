"""Formulas: forms, rounded decimals, impulses, and everything that turns between the points."""

from __future__ import annotations

import tracemalloc

import pytest

from graders import AnswerSyntaxError, Code, Domain, Expression, Formula, Symbols
from graders.equality import Finding, between, compare
from graders.formulas import Form
from graders.language import Reason, parse_line
from graders.states import spread
from graders.verdict import Verdict
from graders.words import LANGUAGES, message, tolerance
from tests.graders.effort import effort

BOX = {"a": Domain(0.2, 1), "b": Domain(0.2, 1), "x": Domain(0, 2)}
STATES = spread(BOX, b"forms")
SYMBOLS = Symbols(BOX, ["y"])


def judged(judge: Expression, text: str, line: str) -> Verdict:
    return judge.check(judge.parse(text, SYMBOLS), Formula(parse_line(line), STATES))


def found(a: str, b: str, /, **box: tuple[float, float]) -> Finding:
    domains = {name: Domain(*ends) for name, ends in box.items()}
    return between(parse_line(a), parse_line(b), domains, b"pairs").finding


def test_less_than_a_part_in_ten_to_the_thirty_is_no_difference() -> None:
    third = f"0.{31 * '3'}"
    assert found(f"{third}*x", "x/3", x=(0, 1)) is Finding.EQUAL
    assert found(f"{third[:-2]}*x", "x/3", x=(0, 1)) is Finding.DIFFERENT


@pytest.mark.parametrize("size", [1e-4, 1e-8, 1e-15, 1e-30])
@pytest.mark.parametrize(
    ("a", "b"), [("sin(x)", "x"), ("cos(x)", "1 - x^2/2"), ("sin(x)", "x - x^3/6 + x^5/120 - x^7/5040"), ("l + x", "l")]
)
def test_a_symbol_next_to_nothing_makes_no_two_formulas_one(a: str, b: str, size: float) -> None:
    assert found(a, b, x=(-size, size), l=(1, 2)) is Finding.DIFFERENT
    assert found(f"{a} + abs(x)", f"{b} + abs(x)", x=(-size, size), l=(1, 2)) is Finding.DIFFERENT
    assert found(f"2*({a})", f"{a} + {a}", x=(-size, size), l=(1, 2)) is Finding.EQUAL


@pytest.mark.parametrize(
    ("text", "line", "code"),
    [
        ("0.333*a*x", "a*x/3", Code.ROUNDED_NUMBER),
        ("0,33 a x", "a*x/3", Code.ROUNDED_NUMBER),
        ("3.14*a^2", "pi*a^2", Code.ROUNDED_NUMBER),
        ("1,414*a + 0.577*b", "sqrt(2)*a + b/sqrt(3)", Code.ROUNDED_NUMBER),
        ("0.35*a*x", "a*x/3", Code.WRONG),
        ("0.333*a*x", "a*b/3", Code.WRONG),
        ("0.5*a*x", "a*x/2", Code.RIGHT),
        ("a*x*0.3", "a*x/3", Code.WRONG),
    ],
)
def test_a_rounded_number_in_a_formula_is_named(text: str, line: str, code: Code) -> None:
    assert judged(Expression("y"), text, line).code is code


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("a*(x + b)", Code.RIGHT),
        ("(x + b) a", Code.RIGHT),
        ("-a*(-x - b)", Code.RIGHT),
        ("(a*x + a*b)/1", Code.NOT_A_PRODUCT),
        ("a*x + a*b", Code.NOT_A_PRODUCT),
        ("-(-a*x - a*b)", Code.NOT_A_PRODUCT),
        ("2*(a*x + a*b)/2", Code.NOT_A_PRODUCT),
        ("a*(x - b)", Code.WRONG),
    ],
)
def test_a_product_is_asked_for(text: str, code: Code) -> None:
    verdict = judged(Expression("y", forms=(Form.PRODUCT,)), text, "a*(x + b)")
    assert (verdict.code, verdict.score) == (code, {Code.RIGHT: 1, Code.WRONG: 0}.get(code, 0.5))


@pytest.mark.parametrize(("text", "code"), [("sqrt(1 - a^2)", Code.RIGHT), ("cos(asin(a))", Code.HOLDS_INVERSE)])
def test_inverse_functions_may_be_unwanted(text: str, code: Code) -> None:
    assert judged(Expression("y", forms=(Form.NO_INVERSE,)), text, "sin(acos(a))").code is code


def test_an_earlier_name_may_be_unwanted() -> None:
    judge = Expression("y", without=("b",), form_credit=0.25)
    verdict = judged(judge, "a + b - b", "a")
    assert (verdict.code, verdict.score) == (Code.NOT_SOLVED, 0.25)
    assert all("b" in message(verdict, lang) and "{" not in message(verdict, lang) for lang in LANGUAGES)
    assert judged(judge, "a*1", "a").code is Code.RIGHT


@pytest.mark.parametrize("lang", LANGUAGES)
def test_what_is_asked_for_is_said_at_the_field(lang: str) -> None:
    judge = Expression("y", figures=3, without=("b",), forms=(Form.PRODUCT, Form.NO_INVERSE))
    assert all(mark in tolerance(judge.describe(), lang) for mark in ("3", "b", "; "))
    assert tolerance(Expression("y").describe(), lang) == ""


@pytest.mark.parametrize(
    ("text", "line", "code"),
    [
        ("0.286*x", "2/7*x", Code.RIGHT),
        ("0.2857*x", "2/7*x", Code.RIGHT),
        ("2.86e-1*x", "2/7*x", Code.RIGHT),
        ("2/7*x", "2/7*x", Code.RIGHT),
        ("0.29*x", "2/7*x", Code.WRONG),
        ("0.285*x", "2/7*x", Code.WRONG),
        ("0.2858*x", "2/7*x", Code.WRONG),
        ("3*x", "22/7*x", Code.WRONG),
        ("0.333*x + 0.143*a", "x/3 + a/7", Code.RIGHT),
        ("0.333*x + 0.145*a", "x/3 + a/7", Code.WRONG),
        ("0.0625*x", "x/16", Code.RIGHT),
        ("0.0626*x", "x/16", Code.WRONG),
        ("(1000.00 - 999.999)*x", "x/500", Code.UNDECIDED),
        ("sqrt(-1.57)*x", "pi/2*x", Code.UNDEFINED),
    ],
)
def test_decimals_may_be_rounded_where_the_task_says_so(text: str, line: str, code: Code) -> None:
    assert judged(Expression("y", figures=3), text, line).code is code
    exact = judged(Expression("y"), text, line).code
    assert exact in (Code.RIGHT, Code.WRONG, Code.ROUNDED_NUMBER, Code.UNDEFINED) and (
        exact is not Code.RIGHT or code is Code.RIGHT
    )


@pytest.mark.parametrize(
    ("text", "place"), [("a*<x-a>^-1", 2), ("<x>^2 + <x-a>^-2", 8), ("macaulay(x; -1)", 0), ("⟨x - a⟩⁻¹", 0)]
)
def test_an_impulse_is_read_and_refused_as_a_value(text: str, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Expression("y").parse(text, SYMBOLS)
    assert (refused.value.reason, refused.value.position) == (Reason.IMPULSE, place)


@pytest.mark.parametrize(
    ("a", "b", "box"),
    [
        ("x", "x + 1e-9*<x - 0.9371>^1", {"x": (0, 1)}),
        ("abs(x - 0.5)", "x - 0.5", {"x": (0.49999, 1)}),
        ("x", "x + max(0; 1e-8 - (x - 0.3123)^2)", {"x": (0, 1)}),
        ("x", "x + max(0; 1e-7 - (x - 0.3123)^2 - (y - 0.7)^2)", {"x": (0, 1), "y": (0, 1)}),
        ("x", "x + <x - a>^1*<a + 1e-7 - x>^1", {"x": (0, 1), "a": (0, 1)}),
        ("sqrt((x - 0.9371)^2)", "0.9371 - x", {"x": (0, 0.93711)}),
        ("sqrt((x - y)^2)", "x - y", {"x": (0, 1), "y": (0, 1e-4)}),
        ("atan2(y; x)", "atan(y/x)", {"x": (-1e-4, 1), "y": (-1, 1)}),
        ("atan(1/x)", "pi/2 - atan(x)", {"x": (-1e-5, 1)}),
        ("atan(tan(x))", "x", {"x": (-1, 1.5709)}),
        ("asin(sin(x))", "x", {"x": (0, 1.5709)}),
        ("sign(x - 0.3)", "tanh(1e9*(x - 0.3))", {"x": (0, 1)}),
        ("x", "x + 1e-3*exp(-1000*x)", {"x": (0.04, 1)}),
        ("ln(x^2)", "2*ln(-x)", {"x": (-1, 1e-3)}),
        ("root(x; 3)", "x^(1/3)", {"x": (-1e-3, 1)}),
        ("(x^2)^0.5", "x", {"x": (-1e-4, 1)}),
        ("acos(cos(x))", "x", {"x": (0, 3.1417)}),
    ],
)
def test_a_narrow_branch_is_found(a: str, b: str, box: dict[str, tuple[float, float]]) -> None:
    assert found(a, b, **box) in (Finding.DIFFERENT, Finding.UNDEFINED)
    assert found(b, a, **box) in (Finding.DIFFERENT, Finding.UNDEFINED)


@pytest.mark.parametrize(
    ("a", "b", "box"),
    [
        ("abs(x - 0.5)", "x - 0.5", {"x": (0.5, 1)}),
        ("sqrt((x - y)^2)", "abs(y - x)", {"x": (0, 1), "y": (0, 1)}),
        ("atan2(y; x)", "2*atan(y/(x + sqrt(x^2 + y^2)))", {"x": (-1, 1), "y": (-1, 1)}),
        ("(x^2 - 1)/(x - 1)", "x + 1", {"x": (0, 2)}),
        ("x*ln(x)/ln(x)", "x", {"x": (0, 2)}),
        ("x*abs(x - 1)/abs(x - 1)", "x", {"x": (0, 2)}),
        ("acos(x)", "pi/2 - asin(x)", {"x": (-1, 1)}),
        ("<x - a>^0*(1 - <x - a>^0) + x", "x", {"x": (0, 1), "a": (0, 1)}),
        ("sin(x)^2 + cos(x)^2 - 1", "0", {"x": (0, 1)}),
        ("max(a; b)", "(a + b + abs(a - b))/2", {"a": (0, 1), "b": (0, 1)}),
    ],
)
def test_what_is_equal_beside_every_border_is_equal(a: str, b: str, box: dict[str, tuple[float, float]]) -> None:
    assert found(a, b, **box) is Finding.EQUAL


def test_a_root_beyond_its_edge_on_a_stretch_is_told_from_a_hole() -> None:
    assert found("x", "x*sqrt(x - 0.5)/sqrt(x - 0.5)", x=(0.4999, 1)) is Finding.UNDEFINED
    assert found("x*sqrt(x - 0.5)/sqrt(x - 0.5)", "x", x=(0.4999, 1)) is Finding.UNDEFINED
    assert found("x", "x*sqrt(x - 0.5)/sqrt(x - 0.5)", x=(0.5, 1)) is Finding.EQUAL
    assert found("x", "x/(x - 0.5)*(x - 0.5)", x=(0.4999, 1)) is Finding.EQUAL


def test_what_has_no_value_anywhere_is_neither_equal_nor_different() -> None:
    assert found("1/0", "1/0", x=(0, 1)) is Finding.NOWHERE
    assert found("sqrt(-1 - x^2)", "ln(-x^2)", x=(0, 1)) is Finding.NOWHERE


def test_a_jump_at_what_is_always_zero_stays_undecided() -> None:
    assert found("sign(sin(x)^2 + cos(x)^2 - 1)", "0", x=(0, 1)) is Finding.UNDECIDED
    assert found("1/(sin(x)^2 + cos(x)^2 - 1)", "x", x=(0, 1)) is Finding.UNDECIDED


def test_a_reference_ends_the_states_and_an_answer_may_go_on() -> None:
    """Beyond the edge of the reference there are no states; two formulas side by side must end together."""
    states = spread({"x": Domain(0.5, 2)}, b"edge")
    reference = Formula(parse_line("sqrt(x - 0.5)^2"), states)
    assert compare(parse_line("x - 0.5"), reference).finding is Finding.EQUAL
    assert found("sqrt(x - 0.5)^2", "x - 0.5", x=(0.4, 2)) is Finding.UNDEFINED


def test_a_whole_number_is_tried_as_one() -> None:
    box = {"n": Domain(0, 12, integer=True)}
    assert between(parse_line("cos(pi*n)"), parse_line("(-1)^n"), box).finding is Finding.EQUAL
    assert between(parse_line("sin(pi*n/2)^2"), parse_line("sin(pi*n/2)"), box).finding is Finding.DIFFERENT
    assert between(parse_line("abs(n - 11)"), parse_line("11 - n"), box).finding is Finding.DIFFERENT


def test_a_difference_carries_the_point_that_proves_it() -> None:
    comparison = between(parse_line("abs(x - 0.5)"), parse_line("x - 0.5"), {"x": Domain(0.4999, 1)})
    ((name, place),) = comparison.witness
    assert name == "x" and 0.4999 <= place < 0.5


WORST = {
    "moduli": "+".join(f"|x - 0.{k}|" for k in range(100, 260)),
    "angles": "+".join(f"atan2(x - 0.{k}; a - b)" for k in range(100, 180)),
    "arcs": "+".join(f"asin(sin({k}*x + a))" for k in range(1, 90)),
    "roots": "+".join(f"root(x - 0.{k}; 3)" for k in range(100, 200)),
    "brackets": "+".join(f"<x - 0.{k}*a>^{k % 5}" for k in range(100, 200)),
    "powers": "+".join(f"(x + a)^{900 + k}" for k in range(90)),
    "nested": "sqrt(" * 40 + "x" + ")" * 40,
    "cancelling": "sign(sin(x)^2 + cos(x)^2 - 1)*" + "*".join(["sin(x + a)"] * 100),
}


@pytest.mark.parametrize("name", WORST)
def test_the_worst_formula_is_judged_in_time_and_space(name: str) -> None:
    judge, text = Expression("y"), f"x + 0*({WORST[name]})"
    assert judged(judge, text, "x").code in (Code.RIGHT, Code.UNDECIDED)
    assert effort(lambda: judged(judge, text, "x"), enough=0.3) < 0.3  # tens of milliseconds on a free core
    tracemalloc.start()
    judged(judge, text, "x")
    assert tracemalloc.get_traced_memory()[1] < 20e6
    tracemalloc.stop()


def test_what_turns_too_often_to_be_searched_is_never_accepted_for_that() -> None:
    decoys = "+".join(f"0*|x - 1.{k}|" for k in range(10, 40))
    assert judged(Expression("y"), f"x + {decoys}", "x").code is Code.UNDECIDED
    assert judged(Expression("y"), f"x + {decoys} + 1e-9", "x").code is Code.WRONG


def test_large_powers_of_whole_numbers_stay_doubles() -> None:
    states = spread({"n": Domain(12, 120, integer=True), "x": Domain(0, 2)}, b"powers")
    reference = Formula(parse_line("abs(x - 1)"), states)
    judge = Expression("y")
    typed = judge.parse("abs(1 - x) + 0*n^999*n^999", Symbols(["n", "x"]))
    assert judge.check(typed, reference).code is Code.RIGHT
