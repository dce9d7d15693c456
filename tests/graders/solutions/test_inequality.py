"""The judge of an inequality: the region, its border and its sense."""

from __future__ import annotations

import pytest

from graders import AnswerSyntaxError, Code, Domain, Formula, Inequality, Symbols
from graders.language import Reason, parse_line
from graders.states import drawn
from graders.verdict import Witness
from tests.graders.solutions.crank import surprises, verdict

BOX = {"l1": Domain(0.05, 0.3), "l2": Domain(0.1, 0.4), "h": Domain(0.0, 0.1)}
MARGIN = Formula(parse_line("l2 - l1 - h"), drawn(BOX, b"turning", lambda point: True))
NAMES = Symbols(tuple(BOX), ("margin",))
TURNS = Inequality("l1 + h <= l2", "margin")


def test_the_judge_passes_its_own_samples() -> None:
    assert surprises(TURNS, MARGIN, NAMES) == []
    assert surprises(Inequality("l1 + h < l2", "margin"), MARGIN, NAMES) == []


@pytest.mark.parametrize(
    ("typed", "code", "score"),
    [
        ("l2 - l1 ≥ h", Code.RIGHT, 1),
        ("(l1 + h)/l2 <= 1", Code.RIGHT, 1),
        ("l1 + h =< l2", Code.RIGHT, 1),
        ("l2 => l1 + h.", Code.RIGHT, 1),
        ("l1 + h < l2", Code.BORDER, 0.5),
        ("l1 + h >= l2", Code.SENSE_TURNED, 0),
        ("l1 - h <= l2", Code.WRONG, 0),
        ("l1 < l2", Code.WRONG, 0),
        ("l1 + h <= l2*(1 + 1e-9)", Code.WRONG, 0),
        ("0 < 1", Code.WRONG, 0),
    ],
)
def test_an_inequality_is_judged_by_its_region(typed: str, code: Code, score: float) -> None:
    found = verdict(TURNS, typed, MARGIN, NAMES)
    assert (found.code, found.score) == (code, score)


@pytest.mark.parametrize(
    ("typed", "reason"),
    [
        ("l1 + h = l2", Reason.NOT_AN_INEQUALITY),
        ("l1 + h", Reason.NOT_AN_INEQUALITY),
        ("margin > 0", Reason.FORBIDDEN_NAME),
        ("", Reason.EMPTY),
    ],
)
def test_what_is_no_inequality_of_the_task_is_unreadable(typed: str, reason: Reason) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        TURNS.parse(typed, NAMES)
    assert refused.value.reason is reason


def test_a_symbol_that_is_not_allowed_is_marked_where_it_stands() -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        TURNS.parse("l1 + h > margin", NAMES)
    assert (refused.value.reason, refused.value.position) == (Reason.FORBIDDEN_NAME, 9)


def test_a_point_is_told_at_which_the_answer_differs() -> None:
    for typed in ("l1 + h < l2", "l1 + h >= l2", "l1 < l2"):
        witness = verdict(TURNS, typed, MARGIN, NAMES).details
        assert isinstance(witness, Witness)
        at = dict(witness.point)
        assert set(at) == set(BOX)
        assert typed != "l1 < l2" or at["l1"] < at["l2"] < at["l1"] + at["h"]


def test_a_border_is_told_whichever_side_holds_it() -> None:
    strict = Inequality("l1 + h < l2", "margin")
    found = verdict(strict, "l2 >= l1 + h", MARGIN, NAMES)
    assert (found.code, found.score) == (Code.BORDER, 0.5)
    assert verdict(strict, "l2 < l1 + h", MARGIN, NAMES).code is Code.SENSE_TURNED
    assert verdict(strict, "l2 <= l1 + h", MARGIN, NAMES).code is Code.WRONG
    assert verdict(TURNS, "l2 <= l1 + h", MARGIN, NAMES).code is Code.SENSE_TURNED


def test_what_cannot_be_decided_is_kept_for_the_lecturer() -> None:
    held = "l1 + h + sign(sin(l1)^2 + cos(l1)^2 - 1) <= l2"
    assert verdict(TURNS, held, MARGIN, NAMES).code is Code.UNDECIDED


def test_an_inequality_of_the_author_that_is_none_stops_the_program() -> None:
    with pytest.raises(TypeError, match=r"^'l1 \+ h' is no inequality$"):
        Inequality("l1 + h", "margin").show(MARGIN)


def test_an_inequality_is_shown_and_echoed_as_it_may_be_typed() -> None:
    assert TURNS.show(MARGIN) == "l1 + h <= l2"
    answer = TURNS.parse("0,5*l1 <= l2", NAMES)
    assert TURNS.echo(answer).text == "0.5*l1 <= l2"
    assert "<mn>0.5</mn>" in TURNS.echo(answer).mathml
    assert "<mn>0,5</mn>" in TURNS.echo(answer, comma=True).mathml
    assert TURNS.describe() == {}


@pytest.mark.parametrize(
    ("typed", "code"),
    [
        ("l2 > l1 + h", Code.BORDER),
        ("0 < l2 - l1 - h", Code.BORDER),
        ("l1 + h > l2", Code.WRONG),
        ("l1 + h <= l2 <= 9", Code.RIGHT),
        ("l1 + h < l2 <= 9", Code.BORDER),
    ],
)
def test_every_sign_of_an_inequality_has_its_border_and_its_opposite(typed: str, code: Code) -> None:
    assert verdict(TURNS, typed, MARGIN, NAMES).code is code
    strict = Inequality("l1 + h < l2", "margin")
    assert verdict(strict, "l1 + h > l2", MARGIN, NAMES).code is Code.SENSE_TURNED


def test_a_sign_that_hangs_on_numbers_alone_is_not_searched_for_in_the_box() -> None:
    turning_nowhere = "l1 <= h*cot(<acot(<acot(1e100cot(1e100)^-1e100)^-1>^0)^-1-1>^1^0.5)^-1"
    assert verdict(TURNS, turning_nowhere, MARGIN, NAMES).code is Code.WRONG
