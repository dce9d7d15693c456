"""What is told of a table of frames beside right and wrong: places of what cannot be read, what is kept and carried.

Mutants of this judge that live on change nothing that can be seen: another agreement before the first table is tried,
the second reading tried although the first agrees, and one line more where the place behind the last one is looked for;
the bound of rounded angles a radian further, or a single step beyond it, which no such number is near; other samples
that are as wrong or as unreadable.
"""

from __future__ import annotations

import pytest

from graders import AnswerSyntaxError, Code, DHTable, Symbols
from graders.language import Reason
from graders.language.text import text_of
from graders.verdict import RIGHT
from tests.graders.chain.truth import TABLES, motion

TRUTH = motion("RRP")
SYMBOLS = Symbols(TRUTH.names, ["P"])
JUDGE = DHTable("RRP")
LINES = "q1; L1; 0; pi/2\nq2; 0; 0; pi/2\n0; q3; 0; pi/2"
SURE = "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2 + {}]]"


@pytest.mark.parametrize(
    ("entry", "code"),
    [
        ("0*sign(q1 + 9)", Code.UNDECIDED),
        ("0*abs(L1)", Code.RIGHT),
        ("0*sign(L1)", Code.RIGHT),
        ("1 - sign(L1)", Code.RIGHT),
        ("1 - sign(q3 + 9)", Code.UNDECIDED),
        ("sign(sin(q1)^2 + cos(q1)^2 - 1)", Code.UNDECIDED),
        ("sign(L1)", Code.TABLE_TOOL),
    ],
)
def test_what_may_be_another_formula_between_the_states_is_kept_for_the_lecturer(entry: str, code: Code) -> None:
    verdict = JUDGE.check(JUDGE.parse(SURE.format(entry), SYMBOLS), TRUTH)
    assert verdict.code is code


@pytest.mark.parametrize(
    ("typed", "reason", "place", "found"),
    [
        ("[[q1; L1; 0; P]; [q2; 0; 0; 0]; [0; q3; 0; 0]]", Reason.FORBIDDEN_NAME, 13, "P"),
        ("[[q1; L1; 0; [1; 2345678901234567890]]; [q2; 0; 0; 0]]", Reason.NOT_AN_EXPRESSION, 0, "[[1], [2345678901234"),
        ("q1; 0; 0; 0\nq2; zz; 0; 0", Reason.UNKNOWN_NAME, 16, "zz"),
        ("zz; 0; 0; 0\nq2; 0; 0; 0", Reason.UNKNOWN_NAME, 0, "zz"),
        ("q1; 0; 0; 0\nzz; 0; 0; 0\n0; q3; 0; 0", Reason.UNKNOWN_NAME, 12, "zz"),
        ("q1; 0; 0; 0\nq2; 0; 0; 0\nzz; q3; 0; 0", Reason.UNKNOWN_NAME, 24, "zz"),
        ("q1; 0; 0; 0\nq2; 0; 0; 0\n0; q3; 0; zz", Reason.UNKNOWN_NAME, 34, "zz"),
        ("\n q1; 0; 0; 0\nq2; 0; zz; 0\n0; q3; 0; 0", Reason.UNKNOWN_NAME, 21, "zz"),
        (r"q1; 0; 0; \frac{\pi}{2}" + "\n" + r"q2; 0; 0; \qq", Reason.UNKNOWN_NAME, 34, r"\qq"),
        ("q1; 0; 0; 0\n0; q3; 0; (2", Reason.EXTRA_BRACKET, 24, "]"),
        ("q1; 0; 0; 0\n0; q3; 0; 2]", Reason.EXTRA_BRACKET, 24, "]"),
        ("q1; 0; 0; 0\nq2; 0; 0\n0; q3; 0; 0", Reason.RAGGED_MATRIX, 0, "["),
        ("q1; 0; 0; 0\nq2; 0; 0; \n0; q3; 0; 0", Reason.MISSING_ENTRY, 22, "(2, 4)"),
        ("q1; 0; 0; 0 +\nq2; 0; 0; 0\n0; q3; 0; 0", Reason.MISSING_ENTRY, 13, "(1, 4)"),
    ],
)
def test_what_cannot_be_read_is_named_with_its_place(typed: str, reason: Reason, place: int, found: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        JUDGE.parse(typed, SYMBOLS)
    error = refused.value
    assert (error.reason, error.position, error.proposal.found) == (reason, place, found)


@pytest.mark.parametrize(
    "typed",
    [
        LINES,
        f"\n{LINES}\n",
        "[" + ";\n".join(f"[{line}]" for line in LINES.split("\n")) + "]",
        LINES.replace("; ", "\t"),
        LINES.replace("pi/2", r"\frac{\pi}{2}").replace("L1", "L_1"),
        "\\begin{bmatrix}\n" + LINES.replace(";", " &").replace("\n", " \\\\\n") + "\n\\end{bmatrix}",
    ],
)
def test_rows_may_stand_on_lines_with_brackets_and_without(typed: str) -> None:
    assert JUDGE.check(JUDGE.parse(typed, SYMBOLS), TRUTH) is RIGHT


def test_a_rounded_angle_is_carried_as_what_it_stands_for() -> None:
    typed = JUDGE.parse(TABLES["RRP"].replace("pi/2", "1.5708"), SYMBOLS)
    carried = JUDGE.carried(typed)
    assert carried is not None
    assert text_of(carried) == "[[q1; L1; 0; 6*pi/12], [q2; 0; 0; 6*pi/12], [0; q3; 0; 6*pi/12]]"
    coarse = JUDGE.carried(JUDGE.parse(TABLES["RRP"].replace("pi/2", "1.57"), SYMBOLS))
    assert coarse is not None and "pi" not in text_of(coarse)


def test_a_table_is_echoed_with_the_decimal_mark_of_the_reader() -> None:
    answer = JUDGE.parse("[[q1; 0.5; 0; 0]; [q2; 0; 0; 0]; [0; q3; 0; 0]]", SYMBOLS)
    assert "<mn>0.5</mn>" in JUDGE.echo(answer).mathml
    assert "<mn>0,5</mn>" in JUDGE.echo(answer, comma=True).mathml


@pytest.mark.parametrize(
    ("joints", "typed", "code"),
    [
        ("PRR", "[[-1.5708; q1; -L1; 0]; [3.1416 - q2; 0; L2; 0]; [q3; 0; 0; 0]]", Code.RIGHT),
        ("PRR", "[[-(1.5708); q1; -L1; 0]; [-(q2 - 3.1416); 0; L2; 0]; [q3; 0; 0; 0]]", Code.RIGHT),
        ("PRR", "[[-1.5708; q1; -L1; 0]; [+3.1416 + (-q2); 0; L2; 0]; [+q3; 0; 0; 0]]", Code.RIGHT),
        ("PRR", "[[-1.57; q1; -L1; 0]; [-(q2 - 3.14); 0; L2; 0]; [q3; 0; 0; 0]]", Code.TABLE_ROUNDED),
        ("PRR", "[[-90; q1; -L1; 0]; [-(q2 - 180); 0; L2; 0]; [q3; 0; 0; 0]]", Code.TABLE_DEGREES),
        ("PRR", "[[-90; q1; -L1; 0]; [+(180 - q2); 0; L2; 0]; [q3; 0; 0; 0]]", Code.TABLE_DEGREES),
        ("PRR", "[[-90°; q1; -L1; 0]; [180 - q2; 0; L2; 0]; [q3; 0; 0; 0]]", Code.TABLE_DEGREES),
        ("RRP", "[[q1; L1; 0; 90°]; [q2; 0; 0; 90]; [0; q3; 0; 90]]", Code.TABLE_DEGREES),
        ("RRP", "[[q1; L1; 0; 0.15708e1]; [q2; 0; 0; 15708e-4]; [0; q3; 0; 1.57079632679489661923132]]", Code.RIGHT),
        ("RRP", "[[q1; L1; 0; 1e400]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.UNDEFINED),
        ("RRP", "[[q1; L1; 0; 26.7035]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Code.WRONG),
    ],
)  # fmt: skip
def test_angles_are_read_as_rounded_or_in_degrees_wherever_they_stand(joints: str, typed: str, code: Code) -> None:
    truth, judge = motion(joints), DHTable(joints)
    verdict = judge.check(judge.parse(typed, Symbols(truth.names)), truth)
    assert verdict.code is code
