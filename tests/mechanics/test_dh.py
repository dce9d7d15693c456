"""Denavit-Hartenberg tables refuse what is not a table."""

from __future__ import annotations

from math import inf, nan

import pytest

from mechanics.chain import Chain, pair_matrix
from mechanics.dh import Row


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"type": "H"}, "joint type 'H'"),
        ({"theta": nan}, "theta"),
        ({"d": inf}, "d = inf m"),
        ({"a": nan}, "a = nan m"),
        ({"alpha": -inf}, "alpha"),
        ({"sign": 2}, "sign 2"),
    ],
)
def test_a_row_that_is_no_joint_is_refused_by_name(fields: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Row(**{"type": "R", **fields})  # type: ignore[arg-type]


def test_the_variable_joins_theta_of_a_turn_and_d_of_a_slide() -> None:
    assert Row("R", 1.0, 2.0).moved(0.5) == (1.5, 2.0)
    assert Row("P", 1.0, 2.0, sign=-1).moved(0.5) == (1.0, 1.5)


def test_an_empty_table_and_an_unknown_convention_are_refused() -> None:
    with pytest.raises(ValueError, match="at least one row"):
        Chain(())
    with pytest.raises(ValueError, match="'craig' must be standard or modified"):
        pair_matrix(0, 0, 0, 0, "craig")  # type: ignore[arg-type]
