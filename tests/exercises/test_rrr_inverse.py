"""The branches of the inverse task of the RRR arm, as students write and lose them."""

from __future__ import annotations

from math import degrees

import pytest

from exercises import variants
from exercises.exercise import Submission, Variant
from exercises.grading import grade
from exercises.manipulators.rrr_inverse import EXERCISE, Givens
from exercises.solving import Solved
from graders import Code, Verdict
from mechanics import rod_groups
from tests.depth import amount

GIVENS = Givens(0.45, 0.5, 0.4, 0.580072, 0.3968486, 0.9211312)  # DH-15 at q = (0.6, 0.9, 0.7)
VARIANT = Variant("rrr_inverse", EXERCISE.version, 0, GIVENS)
BRANCHES = ["(34,38; 51,57; 40,11)", "(34,38; 16,10; -40,11)", "(-145,62; 163,90; 40,11)", "(-145,62; 128,43; -40,11)"]


def judged(text: str) -> Verdict:
    return grade(Submission(VARIANT, {"q": text})).verdicts["q"]


def test_all_four_branches_of_the_printed_point_are_right() -> None:
    assert judged("; ".join(BRANCHES)).code is Code.RIGHT
    assert judged("\n".join(reversed(BRANCHES))).code is Code.RIGHT


def test_angles_count_modulo_a_turn_and_in_radians_where_so_written() -> None:
    first = "q1 = 0,6 rad, q2 = 0,9 rad, q3 = 0,7 rad"
    assert judged("; ".join([first, BRANCHES[1], "(214,38; 163,9; 400,11)", BRANCHES[3]])).code is Code.RIGHT


@pytest.mark.parametrize(
    ("kept", "code", "score"),
    [((0, 1, 2), Code.LOST_BRANCH, 0.75), ((0, 2), Code.LOST_BRANCH, 0.5), ((0, 0, 1, 2), Code.DOUBLED_BRANCH, 0.75)],
)
def test_a_lost_branch_costs_its_share(kept: tuple[int, ...], code: Code, score: float) -> None:
    verdict = judged("; ".join(BRANCHES[at] for at in kept))
    assert (verdict.code, verdict.score) == (code, score)


@pytest.mark.parametrize("seed", range(amount(10, 40)))
def test_every_branch_carries_the_point_back(seed: int) -> None:
    givens = variants.deal("rrr_inverse", seed).givens
    rows = Solved(EXERCISE, Variant("rrr_inverse", 1, seed, givens)).values["q"]
    assert isinstance(rows, tuple) and len(rows) == 4
    for row in rows:
        found = rod_groups.direct("RRR", {"L1": givens.L1, "L2": givens.L2, "L3": givens.L3}, row)
        assert found == pytest.approx((givens.x, givens.y, givens.z), abs=1e-12)


def test_branches_follow_from_a_wrong_cosine() -> None:
    """The sign of the cosine and nothing else is wrong: that is the inner angle, and what comes after follows."""
    values = Solved(EXERCISE, VARIANT).again(fixed={"c3": -0.7648422})
    rows = values["q"]
    assert isinstance(rows, tuple)
    typed = "; ".join("(" + "; ".join(f"{degrees(angle):.4f}" for angle in row) + ")" for row in rows)
    marks = grade(Submission(VARIANT, {"c3": "-0,7648", "q": typed}))
    assert [verdict.code for verdict in marks.verdicts.values()][:2] == [Code.OPPOSITE_SIGN, Code.FOLLOWED]
    assert marks.mistake == "inner_angle"
