"""A7: NaN, infinities, booleans, lists and numbers beyond 1e99 are unreadable, in a judge and in JSON."""

from __future__ import annotations

import math

import pytest
from starlette.testclient import TestClient

from graders import AnswerSyntaxError, Code, Integer, Matrix, Quantity, Symbols
from tests.security.conftest import Attack

NOTHING = Symbols(())
NOT_NUMBERS = [
    "NaN", "nan", "-nan", "inf", "-inf", "+Infinity", "∞", "True", "False", "None", "null", "[12]", "[[1; 2]]", "1/0",
    "0/0", "sqrt(-1)", "ln(0)", "1e100", "-1e100", "1e99 m", "10^200", "asin(2)", "tan(1)/0", "0^-1", "0x10", "1_000",
    "1e", "log(-1)", "(-8)^(1/3)", "1e98*1e98", "12,5,5", "i", "1e400 - 1e400", "acos(1,5)",
]  # fmt: skip


@pytest.mark.parametrize("text", NOT_NUMBERS)
def test_what_is_no_finite_number_is_unreadable(attack: Attack, text: str) -> None:
    assert attack(text, "l3").code is Code.UNREADABLE


@pytest.mark.parametrize("text", ["NaN", "1e400", "2.5", "True", "[3]", "1e3", "0x10", "1" * 16, "٣", "3j"])
def test_what_is_no_whole_number_is_unreadable(text: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        Integer().parse(text, NOTHING)


@pytest.mark.parametrize("entry", ["NaN", "inf", "1/0", "1e100", "[1]", "sqrt(-1)", "True", "1e400"])
def test_an_entry_that_is_no_finite_number_is_unreadable(entry: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        Matrix(2, 2).parse(f"[[{entry}; 0], [0; 1]]", NOTHING)


@pytest.mark.parametrize("unit", ["mm", "rad/s", "MPa", "deg", "1"])
@pytest.mark.parametrize("number", ["1e97", "1,5e99", "-9e98", "1e-97", "1e-320", "0"])
def test_what_is_read_is_finite(unit: str, number: str) -> None:
    try:
        amount = Quantity(unit).parse(f"{number} {unit}", NOTHING)
    except AnswerSyntaxError:
        return
    assert math.isfinite(amount.value) and abs(amount.value) <= 1e99


@pytest.mark.parametrize(
    "value", ["NaN", "Infinity", "-Infinity", "true", "12.5", "null", "{}", "[1]", "[true]", "[[]]"]
)
def test_json_that_is_no_text_is_refused(client: TestClient, value: str) -> None:
    path = f"/api/v1/variants/{client.headers['x-variant']}/submissions"
    body = f'{{"answers": {{"l3": {value}}}}}'
    reply = client.post(path, content=body, headers={"content-type": "application/json"})
    assert reply.status_code == 422
    assert set(reply.json()) == {"error"}
