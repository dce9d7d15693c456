"""The judge of an inequality: the region, its border and its sense."""

from __future__ import annotations

import pytest

from graders import AnswerSyntaxError, Code, Domain, Formula, Inequality, Symbols
from graders.language import Reason, parse_line
from graders.states import drawn
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
