"""A3: brackets, characters, terms and entries beyond the caps are refused at once, in a judge and at the server."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

from exercises.exercise import Submission
from exercises.grading import grade
from exercises.variants import deal
from graders import AnswerSyntaxError, Code, Matrix, Symbols
from graders.language import Reason
from graders.verdict import Reading
from tests.graders.effort import effort
from tests.security.conftest import LONGEST, Attack

LONG = [
    "(" * 10_000 + ")" * 10_000,
    "l1" * 50_000,
    "+".join(["l1"] * 10_000),
    "[" + "1," * 10_000 + "1]",
    " " * 100_000,
]
DEEP = [
    "(" * 990 + "1" + ")" * 990, "-" * 1990 + "1", "√" * 1990 + "1", "1" + "^1" * 990, "sin(" * 300 + "1" + ")" * 300,
    "|" * 1000 + "1" + "|" * 1000, "<" * 900 + "1" + ">" * 900, "[" * 990 + "1" + "]" * 990, "sin " * 490 + "1",
    "+-" * 990 + "1", "1°" + "°" * 1900, "sin^2 " * 300 + "1",
]  # fmt: skip


@pytest.mark.parametrize("text", LONG)
@pytest.mark.parametrize("answer", ["omega2_formula", "l3"])
def test_a_text_beyond_the_cap_is_too_long(attack: Attack, text: str, answer: str) -> None:
    verdict = attack(text, answer)
    if text.strip():
        assert isinstance(verdict.details, Reading)
        assert (verdict.details.reason, verdict.details.position) == (Reason.TOO_LONG, 2000)
    else:
        assert verdict.code is Code.EMPTY


@pytest.mark.parametrize("text", DEEP)
@pytest.mark.parametrize("answer", ["omega2_formula", "l3"])
def test_nesting_is_bounded_before_the_interpreter_is(attack: Attack, text: str, answer: str) -> None:
    assert attack(text, answer).code is Code.UNREADABLE


def test_a_thousand_short_terms_are_judged_in_time(attack: Attack) -> None:
    assert attack("+".join(["1"] * 1000)).score == 0
    assert attack("*".join(["sin(l1)"] * 240)).score == 0


@pytest.mark.parametrize("text", ["[" + ", ".join(["1"] * 17) + "]", "[" + "; ".join(["1"] * 900) + "]", "[1; 2, 3]"])
def test_a_wide_or_ragged_matrix_is_refused(text: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        Matrix(4, 4).parse(text, Symbols(()))


def test_every_answer_of_every_shape_is_bounded() -> None:
    variant, scores = deal("slider_crank", 7), list[float]()
    every = [Submission(variant, dict.fromkeys(("alpha2", "l3", "omega2", "v3"), text)) for text in (*LONG, *DEEP)]
    assert effort(lambda: scores.extend(grade(one).score for one in every), 1) < 8 * LONGEST
    assert set(scores) == {0}


@pytest.mark.parametrize("text", LONG[:4])
def test_the_server_stores_nothing_that_large(client: TestClient, text: str) -> None:
    path = f"/api/v1/variants/{client.headers['x-variant']}/submissions"
    reply = client.post(path, json={"answers": {"l3": text * 4}})
    assert reply.status_code in (413, 422)
    assert set(reply.json()) == {"error"}
