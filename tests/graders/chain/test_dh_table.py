"""The judge of Denavit-Hartenberg tables: any frames on the joint axes are right, each slip is named."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graders import AnswerSyntaxError, Code, DHTable, Outcome, Symbols
from graders.chain.motion import Motion
from graders.kinds.dh_table import Entries, x_turned, z_turned
from graders.language import Reason, parse
from graders.language.text import text_of
from graders.language.tree import Binary, Grid, Name, Number
from graders.verdict import Flaw, Flaws, Verdict
from graders.words import LANGUAGES, message, tolerance
from tests.depth import amount
from tests.graders.chain.truth import TABLES, modified, motion
from tests.graders.effort import effort

MOTIONS = {group: motion(group) for group in TABLES}
MODIFIED = modified()


def judged(group: str, text: str) -> Verdict:
    judge, truth = (DHTable("RRP", "modified"), MODIFIED) if group == "modified" else (DHTable(group), MOTIONS[group])
    return judge.check(judge.parse(text, Symbols(truth.names, ["P"])), truth)


RIGHT = {
    "RRP": [
        "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]",
        "[[q1, L1, 0, π/2], [q2, 0, 0, π/2], [0, q3, 0, π/2]]",
        "[[q1; L1; 0; 90°]; [q2; 0; 0; 90°]; [0; q3; 0; 90 deg]]",
        "P = [[q1; L1; 0; 1.5708]; [q2; 0; 0; 1,5708]; [0; q3; 0; 1.57080]]",
        "[[q1; 0.5; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]",
        "[[q1 + pi; L1; 0; -pi/2]; [q2 + pi; 0; 0; pi/2]; [0; q3; 0; pi/2]]",
        "[[q1; L1; 0; -pi/2]; [-q2; 0; 0; -pi/2]; [0; q3; 0; pi/2]]",
        "[[q1 + pi; L1; 0; pi/2]; [pi - q2; 0; 0; -pi/2]; [0; q3; 0; pi/2]]",
        "[[q1; L1; 0; pi/2]; [q2 + pi; 0; 0; -pi/2]; [pi; q3; 0; pi/2]]",
        "[[q1; L1; 0; pi/2]; [q2; 0; 0; -pi/2]; [0; -q3; 0; -pi/2]]",
        "[[q1; L1; 0; pi/2]; [q2 + pi; 0; 0; pi/2]; [pi; -q3; 0; -pi/2]]",
        "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [pi; q3; 0; -pi/2]]",
        "[[q1 - 2*pi; L1; 0; -3*pi/2]; [q2; 0; 0; 5*pi/2]; [0; q3; 0; pi/2]]",
        "q1; L1; 0; pi/2\nq2; 0; 0; pi/2\n0; q3; 0; pi/2",
        "[[q1; L1; 0; atan2(1; 0)]; [q2; 0; 0; acos(0)]; [q2 - q2; q3; 0; pi - pi/2]]",
    ],
    "RRR": [
        "[[q1; L1; 0; pi/2]; [q2; 0; L2; 0]; [-q3; 0; 0; 0]]",
        "[[q1; L1; 0; 90°]; [q2; 0; L2; 0°]; [-q3; 0; 0; 0]]",
        "[[q1; L1; 0; -pi/2]; [-q2; 0; L2; 0]; [q3; 0; 0; 0]]",
        "[[q1; L1; 0; -pi/2]; [-q2; 0; L2; pi]; [-q3; 0; 0; 0]]",
        "[[q1; L1; 0; pi/2]; [q2; 0; L2; pi]; [q3; 0; 0; 0]]",
        "[[q1 + pi; L1; 0; pi/2]; [pi - q2; 0; L2; pi]; [-q3; 0; 0; 0]]",
        "[[q1; L1; 0; pi/2]; [q2 + pi; 0; -L2; 0]; [pi - q3; 0; 0; 0]]",
        "[[q1; L1; 0; pi/2]; [q2; 0.3; L2; 0]; [-q3; -0.3; 0; 0]]",
        "[[q1; L1; 0; pi/2]; [q2; L3; L2; 0]; [-q3; -L3; 0; 0]]",
        "[[q1; L1; 0; pi/2]; [q2; 0.2; L2; pi]; [q3; 0.2; 0; 0]]",
        "[[q1; L1; 0; pi/2]; [q2; 0; L2; 0]; [-q3; 0; 0; pi/7]]",
        "[[q1; L1; 0; pi/2]; [q2; 0; L2; 0]; [2*pi - q3; 0; 0; pi]]",
    ],
    "PRR": [
        "[[pi/2; q1; L1; 0]; [-q2; 0; L2; 0]; [q3; 0; 0; 0]]",
        "[[90°; q1; L1; 0]; [-q2; 0; L2; 0]; [q3; 0; 0; 0]]",
        "[[-90°; q1; -L1; 0]; [180° - q2; 0; L2; 0]; [q3; 0; 0; 0]]",
        "[[pi/2; q1; L1; pi]; [q2; 0; L2; 0]; [-q3; 0; 0; 0]]",
        "[[pi/2; q1; L1; pi]; [q2; 0; L2; pi]; [q3; 0; 0; 0]]",
        "[[pi/2; q1 - 0.2; L1; 0]; [-q2; 0.2; L2; 0]; [q3; 0; 0; 0]]",
        "[[pi/2; q1 - L2; L1; 0]; [-q2; L3; L2; 0]; [q3; L2 - L3; 0; 0]]",
        "[[pi/2; q1 + 0.1; L1; pi]; [q2; 0.1; L2; 0]; [-q3; 0; 0; pi]]",
        "[[pi/2; q1; L1; 0]; [pi - q2; 0; -L2; 0]; [q3 + pi; 0; 0; 0]]",
        "[[450°; q1; 0.2; 0]; [-q2; 0; 0.5; 0]; [q3; 0; 0; 0]]",
        "[[pi/2; q1; L1; 0]; [-q2; 0; L2; 0]; [q3; 0; 0; 1]]",
    ],
    "RPP": [
        "[[q1; 0; 0; 0]; [pi; q2; 0; pi/2]; [0; q3; 0; 0]]",
        "[[q1 + pi; 0; 0; 0]; [0; q2; 0; pi/2]; [0; q3; 0; 0]]",
        "[[q1 + 1; 0; 0; 0]; [pi - 1; q2; 0; pi/2]; [0; q3; 0; 0]]",
        "[[q1; 0.3; 0; 0]; [pi; q2 - 0.3; 0; pi/2]; [0; q3; 0; 0]]",
        "[[q1; d; 0; 0]; [pi; q2 - d; 0; pi/2]; [0; q3; 0; 0]]",
        "[[q1; 0; 0; pi]; [pi; -q2; 0; -pi/2]; [0; q3; 0; 0]]",
        "[[q1; 0; 0; pi]; [-pi; -q2; 0; 3*pi/2]; [0; q3; 0; 0]]",
        "[[q1; 0; 0; 0]; [pi; q2; 0; -pi/2]; [0; -q3; 0; pi]]",
        "[[q1; 0; 0; 0]; [0; q2; 0; -pi/2]; [pi; q3; 0; 0]]",
        "[[q1; 0; 0; 0]; [0; q2; 0; pi/2]; [pi; -q3; 0; pi]]",
        "[[q1; 0; 0.4; 0]; [0; q2; -0.4; -pi/2]; [pi; q3; 0; 0]]",
        "[[q1 - pi/2; 0; 0; 0]; [-pi/2; q2; 0; pi/2]; [0; q3; 0; 0]]",
    ],
    "modified": [
        "[[q1; L1; 0; 0]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]",
        "[[q1; 0; 0; 0]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]".replace("q1; 0;", "q1; 0.5;"),
        "[[q1; L1; 0; 0°]; [q2; 0; 0; 90°]; [0; q3; 0; 90°]]",
        "[[-q1; -L1; 0; pi]; [q2; 0; 0; -pi/2]; [0; q3; 0; pi/2]]",
        "[[q1 + pi; L1; 0; 0]; [q2 + pi; 0; 0; -pi/2]; [0; q3; 0; pi/2]]",
        "[[q1; L1; 0; 0]; [-q2; 0; 0; -pi/2]; [0; q3; 0; -pi/2]]",
        "[[q1; L1; 0; 0]; [q2 + pi; 0; 0; pi/2]; [pi; q3; 0; -pi/2]]",
        "[[q1; L1; 0; 0]; [pi - q2; 0; 0; -pi/2]; [pi; q3; 0; pi/2]]",
        "[[q1 - pi; L1; 0; 0]; [q2 - pi; 0; 0; -pi/2]; [0; q3; 0; pi/2]]",
        "[[q1; L1; 0; 0]; [q2; 0; 0; pi/2]; [pi; q3; 0; pi/2]]".replace("[pi;", "[2*pi;"),
        "[[q1; L1; 0; 0]; [q2; 0; 0; 1.5708]; [0; q3; 0; 1.5708]]",
    ],
}


@pytest.mark.parametrize(("group", "typed"), [(group, text) for group, texts in RIGHT.items() for text in texts])
def test_any_choice_of_frames_is_right(group: str, typed: str) -> None:
    assert judged(group, typed).code is Code.RIGHT


@pytest.mark.parametrize(
    ("group", "typed", "code", "row", "score"),
    [
        ("RRP", "[[q1; L1; 0; 90]; [q2; 0; 0; 90]; [0; q3; 0; 90]]", Code.TABLE_DEGREES, "", 0.5),
        ("RRP", "[[q1 + 180; L1; 0; -90]; [q2 - 180; 0; 0; 90]; [0; q3; 0; 90]]", Code.TABLE_DEGREES, "", 0.5),
        ("PRR", "[[90; q1; L1; 0]; [-q2; 0; L2; 0]; [q3; 0; 0; 0]]", Code.TABLE_DEGREES, "", 0.5),
        ("RRP", "[[q1; L1; 0; 1.57]; [q2; 0; 0; 1.57]; [0; q3; 0; 1,57]]", Code.TABLE_ROUNDED, "", 0.5),
        ("RPP", "[[q1; 0; 0; 0]; [3.14; q2; 0; 1.57]; [0; q3; 0; 0]]", Code.TABLE_ROUNDED, "", 0.5),
        ("RRP", "[[q1; L1; 0; 0]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.TABLE_CONVENTION, "", 0.0),
        ("RRR", "[[q1; L1; 0; 0]; [q2; 0; 0; pi/2]; [-q3; 0; L2; 0]]", Code.TABLE_CONVENTION, "", 0.0),
        ("RRR", "[[0; 0; L1; q1]; [pi/2; 0; 0; q2]; [0; L2; 0; -q3]]", Code.TABLE_CONVENTION, "", 0.0),
        ("modified", "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; 0]]", Code.TABLE_CONVENTION, "", 0.0),
        ("RRR", "[[q1; 0; L1; pi/2]; [q2; L2; 0; 0]; [-q3; 0; 0; 0]]", Code.TABLE_SWAPPED, "1–3", 0.0),
        ("RRR", "[[q1; 0; L1; pi/2]; [q2; 0; L2; 0]; [-q3; 0; 0; 0]]", Code.TABLE_SWAPPED, "1", 0.0),
        ("RRR", "[[q1; L1; 0; pi/2]; [q2; L2; 0; 0]; [-q3; 0; 0; 0]]", Code.TABLE_SWAPPED, "2", 1 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; 0; q3; pi/2]]", Code.TABLE_SWAPPED, "3", 2 / 3),
        ("RRP", "[[pi/2; 0; L1; q1]; [pi/2; 0; 0; q2]; [pi/2; 0; q3; 0]]", Code.TABLE_COLUMNS, "", 0.5),
        ("RRR", "[[0; pi/2; L1; q1]; [L2; 0; 0; q2]; [0; 0; 0; -q3]]", Code.TABLE_COLUMNS, "", 0.5),
        ("RRR", "[[pi/2; L1; 0; q1]; [0; 0; L2; q2]; [0; 0; 0; -q3]]", Code.TABLE_COLUMNS, "", 0.5),
        ("RRR", "[[-q3; 0; 0; 0]; [q2; 0; L2; 0]; [q1; L1; 0; pi/2]]", Code.TABLE_ROWS, "", 0.5),
        ("RRP", "[[q1; L1; 0; pi/2]; [0; q3; 0; pi/2]; [q2; 0; 0; pi/2]]", Code.TABLE_ROWS, "", 0.5),
        ("RRP", "[[0; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.TABLE_VARIABLE, "1", 0.0),
        ("RRP", "[[q1; L1; 0; pi/2]; [pi/2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.TABLE_VARIABLE, "2", 1 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; d; 0; pi/2]]", Code.TABLE_VARIABLE, "3", 2 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [q3; 0; 0; pi/2]]", Code.TABLE_PLACE, "3", 2 / 3),
        ("RPP", "[[0; 0; 0; 0]; [q1 + pi; q2; 0; pi/2]; [0; q3; 0; 0]]", Code.TABLE_PLACE, "1", 0.0),
        ("RRR", "[[q1; L1; 0; pi/2]; [q2; 0; L2; 0]; [q3; 0; 0; 0]]", Code.TABLE_VARIABLE_SIGN, "3", 2 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [-q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.TABLE_VARIABLE_SIGN, "2", 1 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; -q3; 0; pi/2]]", Code.TABLE_VARIABLE_SIGN, "3", 2 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2 + pi/2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.TABLE_OFFSET, "2", 1 / 3),
        ("PRR", "[[0; q1; L1; 0]; [-q2; 0; L2; 0]; [q3; 0; 0; 0]]", Code.TABLE_OFFSET, "1", 0.0),
        ("RPP", "[[q1; 0; 0; 0]; [0; q2; 0; pi/2]; [0; q3; 0; 0]]", Code.TABLE_VARIABLE_SIGN, "3", 2 / 3),
        ("RRP", "[[q1; L1; 0; -pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.TABLE_ALPHA_SIGN, "1", 1 / 3),
        ("RRR", "[[q1; L1; 0; -pi/2]; [q2; 0; L2; 0]; [-q3; 0; 0; 0]]", Code.TABLE_ALPHA_SIGN, "1–3", 1 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2; 0; 0; -pi/2]; [0; q3; 0; pi/2]]", Code.TABLE_ALPHA_SIGN, "2", 2 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; -pi/2]]", Code.TABLE_ALPHA_SIGN, "3", 2 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; 0]]", Code.TABLE_ALPHA, "3", 2 / 3),
        ("RRR", "[[q1; L1; 0; 0]; [q2; 0; L2; 0]; [-q3; 0; 0; 0]]", Code.TABLE_ALPHA, "1", 0.0),
        ("RRR", "[[q1; -L1; 0; pi/2]; [q2; 0; L2; 0]; [-q3; 0; 0; 0]]", Code.TABLE_LENGTH_SIGN, "1", 0.0),
        ("RRR", "[[q1; L1; 0; pi/2]; [q2; 0; -L2; 0]; [-q3; 0; 0; 0]]", Code.TABLE_LENGTH_SIGN, "2", 1 / 3),
        ("RRP", "[[q1; 0; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.TABLE_LENGTH, "1", 0.0),
        ("RRR", "[[q1; L1; 0; pi/2]; [q2; 0; 0; 0]; [-q3; 0; 0; 0]]", Code.TABLE_LENGTH, "2", 1 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3 + d; 0; pi/2]]", Code.TABLE_LENGTH, "3", 2 / 3),
        ("RRR", "[[q1; L1; 0; pi/2]; [q2; 0; L2; 0]; [-q3; 0; L3; 0]]", Code.TABLE_LENGTH, "3", 2 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0.7; q3; 0; 0.3]]", Code.TABLE_TOOL, "", 2 / 3),
        ("RRP", "[[q1; L1; 0; pi/2]; [2*q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.TABLE_ROW, "2", 1 / 3),
        ("RRR", "[[q1; L1; 0; pi/2]; [q2; 0; L2; pi/6]; [-q3; 0; 0; 0]]", Code.TABLE_ROW, "2", 1 / 3),
    ],
)  # fmt: skip
def test_a_slip_is_named_with_its_row(group: str, typed: str, code: Code, row: str, score: float) -> None:
    verdict = judged(group, typed)
    assert isinstance(verdict.details, Flaws)
    assert [(flaw.code, flaw.subject) for flaw in verdict.details.found] == [(code, row)]
    assert verdict.score == pytest.approx(score)
    assert verdict.outcome is (Outcome.PARTLY if score else Outcome.WRONG)
    assert all("{" not in message(verdict, lang) for lang in LANGUAGES)


@pytest.mark.parametrize(
    ("typed", "code"),
    [
        ("[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]]", Code.WRONG_SHAPE),
        ("[[q1; L1; 0]; [q2; 0; 0]; [0; q3; 0]]", Code.WRONG_SHAPE),
        ("[[q1; L1; 0; 1/0]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.UNDEFINED),
        ("[[sqrt(q1); L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.UNDEFINED),
    ],
)
def test_a_table_of_another_size_or_without_values_is_wrong(typed: str, code: Code) -> None:
    verdict = judged("RRP", typed)
    assert (verdict.code, verdict.score) == (code, 0)


@pytest.mark.parametrize(
    ("typed", "reason", "position"),
    [
        ("", Reason.EMPTY, 0),
        ("q1 + 2", Reason.WRONG_SHAPE, 0),
        ("[[q1; L1; 0; P]; [q2; 0; 0; 0]; [0; q3; 0; 0]]", Reason.FORBIDDEN_NAME, 13),
        ("[[q1; L1; 0; zz]; [q2; 0; 0; 0]; [0; q3; 0; 0]]", Reason.UNKNOWN_NAME, 13),
        ("[[q1; L1; 0]; [q2; 0; 0; 0]]", Reason.RAGGED_MATRIX, 0),
        ("[[q1; L1; 0; [1; 2]]; [q2; 0; 0; 0]]", Reason.NOT_AN_EXPRESSION, 0),
        ("q1; L1; 0; pi/2\nq2; 0; zz; 0\n0; q3; 0; 0", Reason.UNKNOWN_NAME, 23),
        ("  q1; L1; 0; 2 +* 3\nq2; 0; 0; 0\n0; q3; 0; 0", Reason.NEEDS_OPERAND, 16),
    ],
)
def test_what_is_no_table_is_unreadable_with_its_place(typed: str, reason: Reason, position: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        judged("RRP", typed)
    assert (refused.value.reason, refused.value.position) == (reason, position)


@pytest.mark.parametrize("group", [*TABLES, "modified"])
def test_the_judge_passes_its_own_samples(group: str) -> None:
    judge, truth = (DHTable("RRP", "modified"), MODIFIED) if group == "modified" else (DHTable(group), MOTIONS[group])
    samples = judge.samples(truth)
    assert {judged(group, text).code for text in (*samples.right, judge.show(truth))} == {Code.RIGHT}
    assert Code.RIGHT not in {judged(group, text).code for text in samples.wrong}
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            judged(group, text)


def rows_of(text: str, truth: Motion) -> Entries:
    tree = parse(text, Symbols(truth.names))
    assert isinstance(tree, Grid)
    return tree.rows


CHOICES = st.lists(st.tuples(st.booleans(), st.integers(0, 1)), max_size=8)


@given(st.sampled_from(sorted(TABLES)), CHOICES, st.lists(st.sampled_from((-2, 2, 4)), min_size=3, max_size=3))
@settings(max_examples=amount(20, 60), deadline=None)
def test_turning_frames_about_their_axes_and_whole_turns_change_nothing(
    group: str, choices: list[tuple[bool, int]], turns: list[int]
) -> None:
    rows = rows_of(TABLES[group], MOTIONS[group])
    for about_x, at in choices:
        rows = (z_turned if about_x else x_turned)(rows, at, "standard")
    whole = [Binary("*", Number(str(abs(turn))), Name("pi")) for turn in turns]
    rows = tuple((Binary("-", r[0], w), r[1], r[2], Binary("+", r[3], w)) for r, w in zip(rows, whole, strict=True))
    assert judged(group, text_of(Grid(rows))).code is Code.RIGHT


@given(CHOICES)
@settings(max_examples=amount(10, 30), deadline=None)
def test_turning_modified_frames_changes_nothing(choices: list[tuple[bool, int]]) -> None:
    rows = rows_of(MODIFIED.table, MODIFIED)
    for about_x, at in choices:
        rows = (z_turned if about_x else x_turned)(rows, at, "modified")
    assert judged("modified", text_of(Grid(rows))).code is Code.RIGHT


@given(
    st.sampled_from(sorted(TABLES)), st.integers(0, 2), st.integers(0, 3), st.sampled_from(("0.03", "0.7", "1", "L9"))
)
@settings(max_examples=amount(26, 80), deadline=None)
def test_an_entry_that_moves_a_link_or_the_tool_is_never_right(group: str, row: int, column: int, by: str) -> None:
    """Right only where the entry is free: the turn about the last x of an arm whose tool point lies on that x."""
    truth = MOTIONS[group]
    rows = [list(entries) for entries in rows_of(TABLES[group], truth)]
    more = Name("q2") if by == "L9" else Number(by)
    rows[row][column] = Binary("+", rows[row][column], more)
    free = row == 2 and column == 3 and group in ("RRR", "PRR") and by != "L9"
    assert (judged(group, text_of(Grid(tuple(map(tuple, rows))))).code is Code.RIGHT) is free


def test_a_printed_last_frame_is_asked_for_exactly() -> None:
    truth = replace(MOTIONS["RRR"], tool=None)
    judge, symbols = DHTable("RRR"), Symbols(truth.names)
    assert judge.check(judge.parse(TABLES["RRR"], symbols), truth).code is Code.RIGHT
    turned = judge.check(judge.parse("[[q1; L1; 0; pi/2]; [q2; 0; L2; 0]; [-q3; 0; 0; pi/7]]", symbols), truth)
    assert turned.details == Flaws((Flaw(Code.TABLE_TOOL),))


def test_a_wrong_table_is_told_from_the_right_one_and_equal_ones_are_not() -> None:
    truth, judge = MOTIONS["RRP"], DHTable("RRP")
    same = replace(truth, table=RIGHT["RRP"][6])
    other = replace(truth, table="[[q1; L1; 0; -pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]")
    assert judge.apart(truth, truth) == judge.apart(truth, same) == 0
    assert judge.apart(truth, other) == inf


def test_the_table_itself_is_carried_and_echoed() -> None:
    judge, truth = DHTable("RRP"), MOTIONS["RRP"]
    answer = judge.parse(TABLES["RRP"], Symbols(truth.names))
    assert judge.carried(answer) == answer.tree
    assert judge.carried(judge.parse("[[q1; 2]]", Symbols(truth.names))) is None
    assert "q1" in judge.echo(answer).text and judge.echo(answer).mathml.startswith("<math>")
    assert judge.describe() == {"rows": 3, "columns": 4, "convention": "standard", "joints": "RRP"}
    assert [tolerance(judge.describe(), lang) for lang in LANGUAGES] == ["", "", ""]


def test_a_long_wrong_table_costs_little_time() -> None:
    entry = "sin(" * 20 + "q1" + ")" * 20
    text = "[" + "; ".join(["[" + "; ".join([entry] * 4) + "]"] * 3) + "]"
    assert effort(lambda: judged("RRP", text), enough=0.25) < 0.25
