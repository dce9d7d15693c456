"""The set judge: all branches of a position task, in any order and however they are bracketed."""

from __future__ import annotations

from itertools import permutations
from math import degrees, inf, pi, radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graders import AnswerSyntaxError, Code, Outcome, Set, Symbols
from graders.kinds.set import matching
from graders.language import Reason
from graders.verdict import Branches
from graders.words import LANGUAGES, message, tolerance

NOTHING = Symbols(())
ARM = Set(("deg", "deg", "mm"), names=("q1", "theta2", "s3"), rtol=0.002, atol=(0.002, 0.002, 0.0005))
TWO = ((radians(30), radians(-45.5), 0.4), (radians(-150), radians(45.5), 0.5))
ROOTS = Set("mm", rtol=0.005)
LENGTHS = ((0.0125,), (0.03,), (-0.004,))


def code(text: str, grader: Set = ARM, reference: tuple[tuple[float, ...], ...] = TWO) -> Code:
    return grader.check(grader.parse(text, NOTHING), reference).code


@pytest.mark.parametrize(
    "typed",
    [
        "(30; -45,5; 400); (-150; 45,5; 500)",
        "(-150; 45.5; 500); (30; -45.5; 400)",
        "(30, -45.5, 400); (-150, 45.5, 500)",
        "(30, -45,5, 400); (-150, 45,5, 500)",
        "(30,-45.5,400), (-150,45.5,500)",
        "[[30; -45,5; 400], [-150; 45,5; 500]]",
        "[30; -45,5; 400], [-150; 45,5; 500]",
        "{(30; -45,5; 400); (-150; 45,5; 500)}",
        "q = {(30; -45,5; 400), (-150; 45,5; 500)}",
        "(30; -45,5; 400)\n(-150; 45,5; 500)\n",
        "30; -45,5; 400\n-150; 45,5; 500",
        "30, -45,5, 400; -150, 45,5, 500",
        "q1 = 30, theta2 = -45,5, s3 = 400; q1 = -150, theta2 = 45,5, s3 = 500",
        "s3 = 0,4 m, q_1 = 30°, θ2 = -45,5°; q₁ = -150 deg, θ₂ = 45,5, s3 = 50 cm",
        "(q1 = 30; θ2 = -45,5; s3 = 400); (q1 = -150; θ2 = 45,5; s3 = 500)",
        "q1 = 30; theta2 = -45,5; s3 = 400\nq1 = -150; theta2 = 45,5; s3 = 500",
        "(30°; -45°30'; 0.4 m); (210°; 405.5 deg; 500 mm)",
        "(pi/6 rad; -45,5; 400); (-5*pi/6 rad; 45,5; 1000/2)",
        "(390; 314,5; 400); (210; -314.5; 500);",
        r"\left(30;-45{,}5;400\right);\left(-150;45{,}5;500\right)",
        "(30.01; -45.52; 400.2); (-150.03; 45.45; 499.6)",
        "30\t-45,5\t400\n-150\t45,5\t500",
        "30 °\t-45,5 °\t400 mm\n-150 °\t45,5 °\t500 mm\n",
        "(30;\t-45,5;\t400)\t;\t(-150;\t45,5;\t500)",
        "q1\t=\t30\ttheta2 = -45,5\ts3 = 400\nq1 = -150\ttheta2 = 45,5\ts3 = 500",
        "30\t°;\t-45,5\t°;\t400\tmm\n-150\t°;\t45,5\tdeg;\t500\tmm",
        "pi/6\t-45,5\t400\n-5π/6\t45,5\t500",
        "30 -45,5 400\n-150 45,5 500",
        "30°  -45.5°  400; -150°  45.5°  500",
        "1) (30; -45,5; 400)\n2) (-150; 45,5; 500)",
        "1) q1 = 30; theta2 = -45,5; s3 = 400\n2) q1 = -150; theta2 = 45,5; s3 = 500",
        "1. (30; -45,5; 400); 2. (-150; 45,5; 500)",
        "I: (30; -45,5; 400)\nII: (-150; 45,5; 500)",
        "I. 30; -45,5; 400\nII) -150; 45,5; 500",
        "(30; -45,5;\n400)\n(-150; 45,5;\n500)",
        "(30; -45,5; 400); (-150; 45,5; 500). ",
    ],
)
def test_all_branches_are_right_in_any_order_and_spelling(typed: str) -> None:
    assert code(typed) is Code.RIGHT


@pytest.mark.parametrize(
    ("typed", "found", "score"),
    [
        ("(30; -45.5; 400)", Code.LOST_BRANCH, 0.5),
        ("(-150; 45.5; 500)", Code.LOST_BRANCH, 0.5),
        ("(30; -45.5; 400); (30; -45.5; 400)", Code.DOUBLED_BRANCH, 0.5),
        ("(30; -45.5; 400); (-150; 45.5; 500); (390; -45.5; 400)", Code.DOUBLED_BRANCH, 0.5),
        ("(30; -45.5; 400); (-150; 45.5; 500); (10; 20; 300)", Code.SURPLUS_BRANCH, 0.5),
        ("(30; -45.5; 400); (-150; -45.5; 500)", Code.SOME_BRANCHES, 0.5),
        ("(-30; -45.5; 400); (-150; -45.5; 500)", Code.WRONG, 0.0),
        ("(30; -45.5; 400); (1; 2; 3); (4; 5; 6)", Code.WRONG, 0.0),
        ("none", Code.WRONG, 0.0),
        ("(30 mm; -45.5; 400); (-150 mm; 45.5; 500)", Code.WRONG_DIMENSION, 0.0),
        ("(30; -45.5; 4); (-150; 45.5; 5)", Code.WRONG, 0.0),
    ],
)
def test_a_lost_a_surplus_and_a_doubled_branch_are_told_apart(typed: str, found: Code, score: float) -> None:
    verdict = ARM.check(ARM.parse(typed, NOTHING), TWO)
    assert (verdict.code, verdict.score) == (found, score)


@pytest.mark.parametrize(
    "typed",
    [
        "12,5\tmm\n30\tmm\n-4\tmm",
        "12,5\t30\t-4",
        "12,5 mm i 30 mm oraz -4 mm",
        "12,5 и 30 или -4",
        "12,5; 30; -4",
        "x1 = 12.5 mm, x2 = 3 cm, x3 = -0,004 m",
        "{-4; 12,5; 30}",
        "-4\n30\n12.5",
    ],
)
def test_plain_numbers_make_a_set_too(typed: str) -> None:
    assert code(typed, ROOTS, LENGTHS) is Code.RIGHT


@pytest.mark.parametrize("typed", ["none", "brak", "нет", "∅", "{}", "Brak rozwiązań.", "нет решений", "No solution"])
def test_the_empty_set_has_words(typed: str) -> None:
    assert code(typed, ROOTS, ()) is Code.RIGHT
    assert code(typed) is Code.WRONG
    assert ARM.carried(ARM.parse(typed, NOTHING)) is None


def test_a_number_given_where_there_is_no_solution_is_wrong() -> None:
    assert code("12", ROOTS, ()) is Code.WRONG
    assert code("0", ROOTS, ()) is Code.WRONG


@pytest.mark.parametrize(
    ("typed", "reason", "position"),
    [
        ("", Reason.EMPTY, 0),
        (" ; ", Reason.EMPTY, 0),
        ("(30; -45.5)", Reason.NEEDS_COMPONENTS, 0),
        ("(30; -45.5; 400); (1; 2)", Reason.NEEDS_COMPONENTS, 18),
        ("(34,4, 51,6)", Reason.NEEDS_COMPONENTS, 0),
        ("1; 2; 3; 4", Reason.NEEDS_COMPONENTS, 0),
        ("(30; -45; \\sqrt2 x)", Reason.UNKNOWN_UNIT, 17),
        ("(30; -45; \\sqrt37)", Reason.NEEDS_OPERATOR, 16),
        ("q1 = 3, theta2 = 4, x = 5", Reason.UNKNOWN_NAME, 20),
        ("q1 = 3, theta2 = 4, q1 = 5", Reason.REPEATED_ITEM, 20),
        ("q1 = 3, theta2 = 4, 5", Reason.NEEDS_COMPONENTS, 20),
        ("(30; -45.5; 40q)", Reason.UNKNOWN_UNIT, 14),
        ("(30; ; 400)", Reason.EMPTY, 5),
        ("(30; 1 +* 2; 400)", Reason.NEEDS_OPERAND, 8),
        ("1 +* (", Reason.NEEDS_COMPONENTS, 0),
        ("x" * 2001, Reason.TOO_LONG, 2000),
        ("(1;2;3);" * 80, Reason.TOO_LONG, None),
    ],
)
def test_what_cannot_be_read_is_named_with_its_place(typed: str, reason: Reason, position: int | None) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        ARM.parse(typed, NOTHING)
    assert refused.value.reason is reason
    assert position is None or refused.value.position == position


@pytest.mark.parametrize("reference", [TWO, TWO[:1], (), (TWO[0], TWO[0])])
def test_the_judge_passes_its_own_samples(reference: tuple[tuple[float, ...], ...]) -> None:
    samples = ARM.samples(reference)
    assert {code(text, ARM, reference) for text in samples.right} == {Code.RIGHT}
    assert Code.RIGHT not in {code(text, ARM, reference) for text in samples.wrong}
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            ARM.parse(text, NOTHING)


def test_a_slip_is_looked_for_only_among_as_many_branches_as_there_are() -> None:
    many = ARM.parse("; ".join(f"({k}; {k + 1}; {k + 2})" for k in range(24)), NOTHING)
    assert ARM.slips(many, TWO) == frozenset()
    assert not ARM.right(many, TWO)
    assert ARM.right(ARM.parse(ARM.show(TWO), NOTHING), TWO)


def test_a_double_root_is_expected_twice() -> None:
    reference = ((0.012,), (0.012,), (0.03,))
    assert code("12; 12; 30", ROOTS, reference) is Code.RIGHT
    assert code("12; 30", ROOTS, reference) is Code.LOST_BRANCH
    assert code("12; 12; 12; 30", ROOTS, reference) is Code.DOUBLED_BRANCH


def test_branches_nearer_than_the_tolerance_are_paired_at_their_best() -> None:
    """The first number fits both branches, the second only one of them."""
    close = Set("1", rtol=0.0, atol=0.1)
    assert code("1.05; 0.95", close, ((1.0,), (1.12,))) is Code.RIGHT
    assert code("0.95; 1.05", close, ((1.0,), (1.12,))) is Code.RIGHT


@given(st.lists(st.lists(st.booleans(), min_size=5, max_size=5), min_size=5, max_size=5))
def test_the_matching_is_the_largest_one(fits: list[list[bool]]) -> None:
    best = max(sum(fits[row][column] for row, column in enumerate(order)) for order in permutations(range(5)))
    assert matching(fits) == best


@given(
    st.lists(st.tuples(st.floats(-3.1, 3.1), st.floats(-3.1, 3.1), st.floats(0.1, 0.9)), min_size=1, max_size=5),
    st.randoms(),
)
def test_the_order_of_branches_does_not_count(rows: list[tuple[float, float, float]], chance: object) -> None:
    shuffled = sorted(rows, key=lambda _: chance.random())  # type: ignore[attr-defined]
    assert code(ARM.show(tuple(shuffled)), ARM, tuple(rows)) is Code.RIGHT
    assert ARM.apart(tuple(rows), tuple(shuffled)) == 0


def test_distance_is_the_worst_of_the_best_pairing_in_tolerances() -> None:
    moved = ((radians(-150), radians(45.5), 0.503), TWO[0])
    assert ARM.apart(TWO, moved) == pytest.approx(0.003 / (0.002 * 0.503))
    assert ARM.apart(TWO, TWO[:1]) == inf
    turned = ((TWO[0][0] + 2 * pi, *TWO[0][1:]), TWO[1])
    assert ARM.apart(TWO, turned) == pytest.approx(0, abs=1e-9)


def test_the_echo_says_what_was_read_and_names_mixed_units() -> None:
    echo = ARM.echo(ARM.parse("(30; 2; 0,4 m)", NOTHING))
    assert echo.text == "(30 deg; 2 deg; 0.4 m)" and echo.unit is None and "<mtext> m</mtext>" in echo.mathml
    assert ROOTS.echo(ROOTS.parse("3; 4", NOTHING)).unit == "mm"
    assert "0,4" in ARM.echo(ARM.parse("(30; 2; 0,4 m)", NOTHING), comma=True).mathml
    assert ARM.echo(()).text == "∅"
    assert ARM.carried(ARM.parse("(180; 2; 0,4 m)", NOTHING)) == ((pi, radians(2), 0.4),)


@pytest.mark.parametrize("lang", LANGUAGES)
def test_verdicts_and_tolerances_are_worded(lang: str) -> None:
    verdict = ARM.check(ARM.parse("(30; -45.5; 400); (1; 2; 3)", NOTHING), TWO)
    assert verdict.details == Branches(1, 2) and verdict.outcome is Outcome.PARTLY
    assert "1" in message(verdict, lang) and "{" not in message(verdict, lang)
    assert "s3: ±0" in tolerance(ARM.describe(), lang)
    assert tolerance(ROOTS.describe(), lang).startswith("±0")
    assert degrees(ARM.parts[0].atol) == pytest.approx(0.1146, abs=1e-4)
