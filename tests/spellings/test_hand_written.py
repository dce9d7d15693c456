"""A hundred spellings in each language, written by hand as students of that country type: all are right."""

from __future__ import annotations

import tomllib
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest

from graders import AnswerSyntaxError, Choice, Code, Expression, Formula, Integer, Matrix, Quantity, States, Symbols
from graders.language import parse_line
from graders.words import LANGUAGES

Field = dict[str, Any]
NOTHING = Symbols(())


@lru_cache
def fields(lang: str) -> tuple[Field, ...]:
    text = Path(__file__).with_name(f"{lang}.toml").read_text(encoding="utf-8")
    return tuple(tomllib.loads(text)["field"])


def judge_of(field: Field) -> tuple[Any, Any, Symbols]:
    match field["kind"]:
        case "quantity":
            return Quantity(field["unit"]), field["value"], NOTHING
        case "integer":
            return Integer(), float(field["value"]), NOTHING
        case "choice":
            return Choice(tuple(field["options"])), field["chosen"], NOTHING
        case "matrix":
            rows = tuple(map(tuple, field["rows"]))
            return Matrix(len(rows), len(rows[0])), rows, Symbols((), ["A"])
    return formula_of(field)


def formula_of(field: Field) -> tuple[Expression, Formula, Symbols]:
    """The states lie on a lattice through the declared ranges."""
    given, earlier = field["given"], field.get("earlier", {})
    steps = (0.618034, 0.754878, 0.819173, 0.856675, 0.880271)
    points = tuple(
        tuple(low + (high - low) * (k * s % 1) for (low, high), s in zip(given.values(), steps, strict=False))
        for k in range(1, 17)
    )
    states = States(tuple(given), points, tuple((name, parse_line(line)) for name, line in earlier.items()))
    names = Symbols([*given, *earlier], [field["step"]])
    return Expression(field["step"]), Formula(parse_line(field["line"]), states), names


def code(field: Field, text: str) -> str:
    judge, reference, symbols = judge_of(field)
    try:
        return str(judge.check(judge.parse(text, symbols), reference).code)
    except AnswerSyntaxError as error:
        return str(error)


@pytest.mark.parametrize("lang", LANGUAGES)
def test_every_hand_written_spelling_is_right(lang: str) -> None:
    judged = {(field["kind"], text): code(field, text) for field in fields(lang) for text in field["texts"]}
    assert {typed: found for typed, found in judged.items() if found != Code.RIGHT} == {}


@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_hundred_spellings_of_every_kind_are_written(lang: str) -> None:
    assert sum(len(set(field["texts"])) for field in fields(lang)) >= 100
    assert {field["kind"] for field in fields(lang)} == {"quantity", "integer", "choice", "matrix", "formula"}
