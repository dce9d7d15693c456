"""The text of a polygon: spellings that are read alike, and errors with their place."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graders import AnswerSyntaxError, Symbols
from graders.kinds.polygon import Polygon
from graders.language import Reason
from graders.language.text import text_of
from graders.polygon.drawn import Drawn
from graders.polygon.reading import read_polygon
from tests.depth import amount
from tests.graders.polygon.mechanisms import FOUR_BAR, OFFSET, ROCKING, SLIDER, TWO_LOOPS

SYMBOLS = Symbols(["l1", "l2", "alpha1"], ["alpha2", "l3"])
NODES = ("A", "B", "C", "A0")


def read(text: str) -> Drawn:
    return read_polygon(text, SYMBOLS, NODES)


PLAIN = read("l1: A > B, length l1, angle alpha1")


@pytest.mark.parametrize(
    "text",
    [
        "l1: A -> B, length l1, angle alpha1",
        "l1: A→B; length: l1; angle: alpha1",
        "- l1: A > B, length l1, angle alpha1",  # an item of the list in the statement
        "•\tl1: A > B, length l1, angle alpha1",
        "l₁: AB, α₁ angle, length l_1",
        "l_1 : from A to B , l1 , alpha1",
        "vector l1: A - B, angle = α1, length = l1.",
        "l1: А > В, length l1, angle alpha1",
        "wektor l1: z A do B, o długości l1 i kąt alfa1".replace(" i kąt", ", kąt"),
        "l1: od A do B, dł. l1, kąt α1 (dany)",
        "вектор l1: из A в B, длина l1, угол альфа1 известен",
        "l1: A ⇒ B, angle alpha1 known, len l1",
        "  l1:A>B,length l1,angle alpha1;  ",
    ],
)
def test_a_vector_has_many_spellings(text: str) -> None:
    (vector,) = read(text).vectors
    (plain,) = PLAIN.vectors
    assert (vector.label.replace("_", ""), vector.start, vector.end) == ("l1", "A", "B")
    assert (text_of(vector.length), text_of(vector.angle)) == (text_of(plain.length), text_of(plain.angle))


def test_nodes_of_two_signs_are_read_together() -> None:
    (vector,) = read("a: A0A, length l1, angle 0").vectors
    assert (vector.start, vector.end) == ("A0", "A")
    (vector,) = read("a: A₀ > B, length l1, angle 0").vectors
    assert (vector.start, vector.end) == ("A0", "B")


def test_the_label_may_be_the_pair_of_nodes() -> None:
    (vector,) = read("BC: length l2, angle alpha2").vectors
    assert (vector.label, vector.start, vector.end) == ("BC", "B", "C")


@pytest.mark.parametrize(
    ("angle", "shown"), [("90", "90°"), ("90 deg", "90°"), ("1,5", "1.5"), ("pi/2", "pi/2"), ("12°30'", "12°30'")]
)
def test_a_bare_number_that_is_more_than_a_turn_is_in_degrees(angle: str, shown: str) -> None:
    assert text_of(read(f"a: AB, length l1, angle {angle}").vectors[0].angle) == shown


@pytest.mark.parametrize(
    "text",
    ["alpha2; l3", "alpha2, l3", "α₂ and l3", "alpha2 i l3", "α2 и l_3", "l3 alpha2", r"\alpha_2; l_3"],
)
def test_unknowns_are_listed_in_many_ways(text: str) -> None:
    read_ = read(f"l2: BC, l2, alpha2\nl3: AC, l3, 0\nunknowns: {text}")
    assert sorted(read_.unknowns or ()) == ["alpha2", "l3"]


def test_an_empty_list_of_unknowns_is_a_list() -> None:
    assert read("l2: BC, l2, alpha2\nunknowns:").unknowns == ()
    assert read("l2: BC, l2, alpha2").unknowns is None


@pytest.mark.parametrize(
    ("text", "reason", "place"),
    [
        ("", Reason.EMPTY, 0),
        ("x: l1 = 0", Reason.NEEDS_VECTORS, 0),
        ("hello", Reason.NOT_A_LINE, 0),
        ("l1: A > Q, length l1, angle 0", Reason.UNKNOWN_NODE, 8),
        ("l1: A > A, length l1, angle 0", Reason.NEEDS_NODES, 4),
        ("l1: length l1, angle 0", Reason.NEEDS_NODES, 4),
        ("l1: A > B, length l1", Reason.NEEDS_LENGTH_AND_ANGLE, 4),
        ("l1: A > B, length, angle 0", Reason.NEEDS_LENGTH_AND_ANGLE, 11),
        ("l1: A > B, length l1, length l2, angle 0", Reason.NEEDS_LENGTH_AND_ANGLE, 22),
        ("l1: A > B, length l1, angle (0", Reason.NEEDS_BRACKET, 30),
        ("l1: A > B, length l1, angle 0 = 0", Reason.NOT_AN_EXPRESSION, 28),
        ("l1: AB, l1, 0\nl1: BC, l2, 0", Reason.REPEATED_ITEM, 14),
        ("l1: AB, l1, 0\nclosure: l1 + l9 = 0", Reason.UNKNOWN_NAME, 28),
        ("l1: AB, l1, 0\nclosure: l1*l1 = 0", Reason.NOT_A_CLOSURE, 23),
        ("l1: AB, l1, 0\nclosure: l1 = 1", Reason.NOT_A_CLOSURE, 23),
        ("l1: AB, l1, 0\nclosure: l1 = pi", Reason.NOT_A_CLOSURE, 23),
        ("l1: AB, l1, 0\nclosure: l1", Reason.NOT_AN_EQUATION, 23),
        ("l1: AB, l1, 0\nx: l1*cos(0)", Reason.NOT_AN_EQUATION, 17),
        ("l1: AB, l1, 0\nx: l1 < 0", Reason.NOT_AN_EQUATION, 17),
        ("l1: AB, l1, 0\nx: l1 = [1; 2]", Reason.NOT_AN_EQUATION, 17),
        ("l1: AB, l1, 0\nx: l1*cos(beta) = 0", Reason.UNKNOWN_NAME, 24),
        ("l1: AB, l1, длиннющий\nx: l1 = 0", Reason.UNKNOWN_NAME, 12),
        ("l1: AB, l1, averyveryverylongname", Reason.UNKNOWN_NAME, 12),
        ("l1: AB, l1, 0\nunknowns: 2*l1", Reason.NOT_A_LINE, 24),
        ("a+b: AB, l1, 0", Reason.NOT_A_LINE, 0),
        ("l1: AB, l1, [1; 2]", Reason.NOT_AN_EXPRESSION, 12),
        ("l1: AB, l1, 0\nx: l1 = 0 @", Reason.BAD_CHARACTER, 24),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_place(text: str, reason: Reason, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        read(text)
    assert (refused.value.reason, refused.value.position) == (reason, place)


def test_too_much_text_is_refused() -> None:
    with pytest.raises(AnswerSyntaxError, match="too_long"):
        read("a" * 7000)
    with pytest.raises(AnswerSyntaxError, match="too_long"):
        read("x: 1 = 1\n" * 50)


def test_a_closure_counts_each_vector_with_its_sign() -> None:
    drawn = read("a: AB, l1, 0\nb: BC, l2, 0\nc: AC, l3, 0\nsum: +a - (-b) + 0 = 2*c + AC - CA/1*0".replace("/1*0", ""))
    assert drawn.closures[0].walked == (("a", 1.0), ("b", 1.0), ("c", -4.0))


@pytest.mark.parametrize("mechanism", [SLIDER, OFFSET, ROCKING, FOUR_BAR, TWO_LOOPS])
def test_the_echo_reads_back_as_the_same_polygon(mechanism: object) -> None:
    assert isinstance(mechanism, type(SLIDER))
    symbols = Symbols(mechanism.states()[0].names)
    grader = Polygon(mechanism.nodes, "alpha2")
    drawn = grader.parse(mechanism.polygon, symbols)
    echo = grader.echo(drawn)
    assert grader.parse(echo.text, symbols) == drawn
    assert echo.mathml.startswith("<math>") and "mtable" in echo.mathml
    assert grader.describe() == {"nodes": list(mechanism.nodes)}
    assert grader.apart(mechanism, mechanism) == 0
    assert grader.apart(mechanism, replace(mechanism, polygon="")) == float("inf")


def test_a_polygon_is_echoed_with_the_decimal_mark_of_the_reader() -> None:
    grader = Polygon(NODES, "alpha2")
    answer = grader.parse("l1: A > B, length 0.5, angle alpha1", SYMBOLS)
    assert "<mn>0.5</mn>" in grader.echo(answer).mathml
    assert "<mn>0,5</mn>" in grader.echo(answer, comma=True).mathml


TEXTS = st.text(alphabet="ABC l1alph2x:y;,=>+-*()0\nκąтcosure→°'_.", max_size=80)


@settings(max_examples=amount(100, 300), deadline=None)
@given(TEXTS)
def test_any_text_is_read_or_refused_inside_it(text: str) -> None:
    for start in ("", "l1: A > B, length l1, angle alpha1\n"):
        try:
            read(start + text)
        except AnswerSyntaxError as error:
            assert 0 <= error.position <= len(start + text)
