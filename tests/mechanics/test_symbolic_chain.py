"""Poses in letters against numbers and against the printed matrices."""

from __future__ import annotations

import pytest
import sympy as sp

from mechanics import rod_groups, symbolic_chain, transform
from tests.mechanics.test_rod_groups import LENGTHS

Q = (0.6, -0.9, 0.7)


@pytest.mark.parametrize("group", rod_groups.GROUPS)
def test_letters_replaced_by_numbers_give_the_pose_and_the_point(group: str) -> None:
    found = symbolic_chain.rod_group(group)
    lengths = LENGTHS[group]
    numbers = dict(zip(found.q, Q, strict=True)) | {sp.Symbol(name, real=True): x for name, x in lengths.items()}
    T = transform.chain_pose(rod_groups.table(group, lengths)[0], Q)
    assert [float(x) for x in found.T.subs(numbers)] == pytest.approx([x for row in T for x in row], abs=1e-14)
    assert [float(x) for x in found.M.subs(numbers)] == pytest.approx(rod_groups.direct(group, lengths, Q), abs=1e-14)


def test_turns_about_parallel_axes_are_written_as_one() -> None:
    q1, q2, q3, L2 = sp.symbols("q1 q2 q3 L2", real=True)
    found = symbolic_chain.rod_group("RRR").T
    assert found.row(0).tolist() == [
        [sp.cos(q1) * sp.cos(q2 - q3), -sp.cos(q1) * sp.sin(q2 - q3), sp.sin(q1), L2 * sp.cos(q1) * sp.cos(q2)]
    ]
    assert found.row(2)[:3] == [sp.sin(q2 - q3), sp.cos(q2 - q3), 0]


def test_an_unknown_group_is_refused() -> None:
    with pytest.raises(ValueError, match="'RRH' must be one of"):
        symbolic_chain.rod_group("RRH")
