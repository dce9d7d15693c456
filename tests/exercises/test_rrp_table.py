"""Any frames are right in the table of the RRP arm, and the matrices are judged against the student's own table."""

from __future__ import annotations

from math import cos, degrees, pi, sin

import pytest

from exercises import variants
from exercises.exercise import Grade, Submission, Variant
from exercises.grading import grade
from exercises.manipulators.rrp_table import EXERCISE, Givens, table
from exercises.solving import Solved
from graders import Code, Outcome
from graders.kinds.dh_table import Entries, other_frames
from graders.language import Symbols, parse
from graders.language.text import text_of
from graders.language.tree import Grid
from mechanics import transform
from mechanics.vectors import Matrix
from tests.depth import amount

GIVENS = Givens(0.5, 0.1, 0.6, 1.1, 0.8, "down", "left")  # DH-13
VARIANT = Variant("rrp_table", EXERCISE.version, 0, GIVENS)
POINT = {"x_M": "0,53197", "y_M": "0,48510", "z_M": "0,13712"}
NAMES = ("L1", "d", "q1", "q2", "q3")
Rows = list[tuple[float, float, float, float]]


def shown(matrix: Matrix) -> str:
    return "[" + ", ".join("[" + "; ".join(f"{entry:.6f}" for entry in row) + "]" for row in matrix) + "]"


def elementary(theta: float, s: float, a: float, alpha: float) -> Matrix:
    """One pair matrix from its elementary ones."""
    return transform.product(transform.rot_z(theta), transform.trans_z(s), transform.trans_x(a), transform.rot_x(alpha))


def matrices(rows: Rows) -> dict[str, str]:
    pairs = [elementary(*row) for row in rows]
    return {**{f"A{i}": shown(pair) for i, pair in enumerate(pairs, 1)}, "T": shown(transform.product(*pairs))}


def handed_in(table: str, rows: Rows, **more: str) -> Grade:
    return grade(Submission(VARIANT, {"P": table, **matrices(rows), **POINT, **more}))


OTHERS: dict[str, Rows] = {  # frames of one's own: z1 to the left, x1 backwards, z2 against the slide
    "[[q1; L1; 0; -pi/2]; [-q2; 0; 0; -pi/2]; [0; q3; 0; pi/2]]": [
        (0.6, 0.5, 0, -pi / 2), (-1.1, 0, 0, -pi / 2), (0, 0.8, 0, pi / 2),
    ],
    "[[q1 + pi; L1; 0; 90°]; [180° - q2; 0; 0; -90°]; [0; q3; 0; 90°]]": [
        (0.6 + pi, 0.5, 0, pi / 2), (pi - 1.1, 0, 0, -pi / 2), (0, 0.8, 0, pi / 2),
    ],
    "[[q1; L1; 0; pi/2]; [q2; 0; 0; -pi/2]; [pi/2; -q3; 0; -pi/2]]".replace("pi/2; -q3", "0; -q3"): [
        (0.6, 0.5, 0, pi / 2), (1.1, 0, 0, -pi / 2), (0, -0.8, 0, -pi / 2),
    ],
}  # fmt: skip


@pytest.mark.parametrize("text", OTHERS)
def test_a_table_of_other_frames_is_right_with_its_own_matrices(text: str) -> None:
    found = handed_in(text, OTHERS[text])
    assert {verdict.code for verdict in found.verdicts.values()} == {Code.RIGHT}
    assert found.score == 1


@pytest.mark.parametrize("text", OTHERS)
def test_matrices_of_another_table_than_ones_own_are_not_right(text: str) -> None:
    found = handed_in(text, [(0.6, 0.5, 0, pi / 2), (1.1, 0, 0, pi / 2), (0, 0.8, 0, pi / 2)])
    assert found.verdicts["P"].code is Code.RIGHT
    assert any(found.verdicts[name].outcome in (Outcome.PARTLY, Outcome.WRONG) for name in ("A1", "A2", "A3"))


def test_matrices_follow_from_a_table_with_a_slip() -> None:
    """The sign of alpha1 alone is wrong: the slip is named in the table, the matrices follow from it."""
    rows: Rows = [(0.6, 0.5, 0, -pi / 2), (1.1, 0, 0, pi / 2), (0, 0.8, 0, pi / 2)]
    found = handed_in("[[q1; L1; 0; -pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", rows)
    codes = {name: verdict.code for name, verdict in found.verdicts.items()}
    assert codes["P"] is Code.TABLE_ALPHA_SIGN
    assert (codes["A1"], codes["A2"], codes["A3"], codes["T"]) == (
        Code.FOLLOWED, Code.RIGHT, Code.RIGHT, Code.FOLLOWED,
    )  # fmt: skip


@pytest.mark.parametrize("text", OTHERS)
def test_a_slip_in_the_matrices_is_named_in_ones_own_frames(text: str) -> None:
    """The modified convention's matrices of the student's own table; T and M are its products."""
    pairs = [
        transform.product(transform.rot_x(alpha), transform.trans_x(a), transform.rot_z(theta), transform.trans_z(s))
        for theta, s, a, alpha in OTHERS[text]
    ]
    T = transform.product(*pairs)
    M = transform.moved_point(T, (0, 0, 0.1))
    answers = {**{f"A{i}": shown(pair) for i, pair in enumerate(pairs, 1)}, "T": shown(T)}
    point = {f"{name}_M": f"{value:.6f}" for name, value in zip("xyz", M, strict=True)}
    found = grade(Submission(VARIANT, {"P": text, **answers, **point}))
    assert found.mistake == "factors_of_craig"


@pytest.mark.parametrize("seed", range(amount(4, 12)))
def test_the_point_stands_where_the_words_say(seed: int) -> None:
    """M by going along the arm: up, out or down by q2 as it is measured, then to the side."""
    givens = variants.deal("rrp_table", seed).givens
    rise = {
        "down": givens.q2 - pi / 2,
        "up": pi / 2 - givens.q2,
        "level_up": givens.q2,
        "level_down": -givens.q2,
    }[givens.measure]
    left = 1 if givens.side == "left" else -1
    out, height = givens.q3 * cos(rise), givens.L1 + givens.q3 * sin(rise)
    x = out * cos(givens.q1) - left * givens.d * sin(givens.q1)
    y = out * sin(givens.q1) + left * givens.d * cos(givens.q1)
    values = Solved(EXERCISE, Variant("rrp_table", 1, seed, givens)).values
    assert [values[name] for name in ("x_M", "y_M", "z_M")] == pytest.approx([x, y, height], abs=1e-12)


@pytest.mark.parametrize("measure", ["down", "up", "level_up", "level_down"])
@pytest.mark.parametrize("side", ["left", "right"])
def test_every_way_to_measure_has_a_table_that_may_be_turned_round(measure: str, side: str) -> None:
    variant = Variant("rrp_table", 1, 0, Givens(0.4, 0.12, -0.7, 0.6, 0.5, measure, side))
    rows: Entries = parse(table(variant.givens), Symbols(NAMES)).rows  # type: ignore[union-attr]
    for entries in (rows, *other_frames(rows, "standard")):
        assert grade(Submission(variant, {"P": text_of(Grid(entries))})).verdicts["P"].code is Code.RIGHT


def test_the_angle_is_a_given_of_the_statement_in_degrees() -> None:
    assert degrees(variants.deal("rrp_table", 5).givens.q2) == pytest.approx(
        round(degrees(variants.deal("rrp_table", 5).givens.q2)), abs=1e-9
    )


def test_a_table_without_a_value_at_the_numbers_of_the_variant_carries_nothing() -> None:
    """Its theta is right at every drawn state, but 0/0 at q1 = 0.6."""
    found = handed_in(
        "[[q1 + 0*q1/(q1 - 0.6); L1; 0; -pi/2]; [-q2; 0; 0; -pi/2]; [0; q3; 0; pi/2]]", next(iter(OTHERS.values()))
    )
    assert found.verdicts["P"].code is Code.RIGHT
    assert found.verdicts["A1"].outcome is Outcome.PARTLY
