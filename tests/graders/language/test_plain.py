"""The quick reader of plain texts gives the trees of the parser, or leaves the text to it."""

from __future__ import annotations

import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graders.language import AnswerSyntaxError, Symbols, Tree, parse, plain
from graders.language.parser import _Parser
from graders.language.text import text_of
from graders.language.tokens import tokenize
from tests.depth import amount
from tests.graders.language.trees import NAMES, trees

DECLARED = Symbols([*NAMES, "E", "ln1", "pi0"], ["omega2"])
OPERANDS = [
    *"xE2-q<",
    "2e-3",
    "1.5e4",
    "e-3",
    "(x",
    "(a",
    "<x",
    "l_1",
    "omega2",
    "pi",
    "0.5",
    "007",
    "sin(a",
    "atan2(x",
    "tg(",
    "log10(2",
]
OPERATORS = [*"+-*/^).;e<>+*/^)=", "*(", ")^", "1e5", "*1e-5", "-2e-", "deg", ">^2", ">^1+"]


def parsed(text: str) -> Tree | None:
    try:
        return _Parser(tokenize(text), DECLARED).whole()
    except AnswerSyntaxError:
        return None


@settings(max_examples=amount(66, 200), deadline=None)
@given(trees)
def test_a_printed_tree_is_read_alike(tree: Tree) -> None:
    text = text_of(tree)
    assert plain.read(text, DECLARED) in (None, parsed(text))


def test_whatever_is_read_quickly_the_parser_reads_alike() -> None:
    chance, read = random.Random(5), 0
    for _ in range(amount(1500, 6000)):
        text = "".join(chance.choice(OPERATORS if k % 2 else OPERANDS) for k in range(chance.randint(1, 9)))
        found = plain.read(text, DECLARED)
        read += found is not None
        assert found is None or found == parsed(text), text
    assert read > amount(75, 300)


@pytest.mark.parametrize(
    "text",
    [
        "-l1*x^2/(a + 2)",
        "1e-6*x - 2.5e3",
        "sin(x)^2",
        "2^-x^2",
        "-2^2",
        "a - x - l1",
        "a/x/2",
        "x^a^2",
        "atan2(a; x)",
        "tg(x)",
        "--x*a",
        "((x))",
        "x*<x - a>^2",
        "-<x>^0",
        "x=2",
        "a*x - l1 = -(a + 2)^2",
        "pi*x^2/4",
    ],
)
def test_a_plain_text_is_read_quickly(text: str) -> None:
    assert plain.read(text, DECLARED) == parsed(text) is not None


@pytest.mark.parametrize(
    "text",
    [
        "",
        "2x",
        "x a",
        "sin x",
        "sin^2(x)",
        "0,5",
        "1 +",
        "(x",
        "x)",
        "x <= 2",
        "x = a = 2",
        "x =",
        "x < = 2",
        "<x>",
        "q",
        "a(x)",
        "-" * 90 + "x",
        "9" * 50,
    ],
)
def test_anything_else_is_left_to_the_parser(text: str) -> None:
    assert plain.read(text, DECLARED) is None


@given(st.integers(1, 80))
def test_depth_is_bounded(depth: int) -> None:
    text = "(" * depth + "x" + ")" * depth
    assert plain.read(text, DECLARED) == (parsed(text) if depth <= plain.DEPTH else None)
    assert (depth > 60) is (parsed(text) is None)
    if depth <= 60:
        assert parse(text, DECLARED) == parsed("x")


@pytest.mark.parametrize(
    "text",
    [
        "[[x; 0], [a; 1]]",
        "[[x, 0],[a, 1]]",
        "[x, 0; a, 1]",
        "[[cos(x); -sin(x)*0.5];[sin(x); cos(x)]]",
        "[[x, a]]",
        "[[x]]",
    ],
)
def test_a_plain_matrix_is_read_quickly(text: str) -> None:
    assert plain.read(text, DECLARED) == parsed(text) is not None


@pytest.mark.parametrize(
    "text",
    [
        "[x]",
        "[x, a]",
        "[[x; 1], [a]]",
        "[1,5; 2]",
        "[[x; 1,5], [a; 2]]",
        "[[x; ], [a; 2]]",
        "[[x]",
        "[[[x]]]",
        "[x[1,2]; 3]",
    ],
)
def test_any_other_matrix_is_left_to_the_parser(text: str) -> None:
    assert plain.read(text, DECLARED) is None


def test_whatever_matrix_is_read_quickly_the_parser_reads_alike() -> None:
    chance, read, pieces = (
        random.Random(6),
        0,
        ["x", "1", "2.5", "a", ",", ", ", ";", "[", "]", "],[", "]; [", "-", "sin(", ")"],
    )
    for _ in range(amount(2000, 8000)):
        inner = "".join(chance.choices(pieces, k=chance.randint(1, 8)))
        text = chance.choice(["[[{}]]", "[{}]"]).format(inner)
        found = plain.read(text, DECLARED)
        read += found is not None
        assert found is None or found == parsed(text), text
    assert read > amount(15, 60)
