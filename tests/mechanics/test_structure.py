"""Counts of domain STR-2..9, each by its formula and by the loops."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.assur import decompose, dyad_form, lower_pairs
from mechanics.errors import AssemblyError
from mechanics.structure import (
    CLASSES,
    Pair,
    chain_of,
    count_loops,
    expanded,
    freedoms,
    fundamental_loops,
    incidence_matrix,
    independent,
    manoeuvrability,
    planar_mobility,
    spatial_mobility,
)

FOUR_BAR = [Pair("0", "1"), Pair("1", "2"), Pair("2", "3"), Pair("3", "0")]
VP5 = [*FOUR_BAR, Pair("3", "5"), Pair("5", "6"), Pair("6", "0")]  # a dyad 5-6 on the rocker 3


def test_a_planar_six_link_mechanism_has_one_freedom_and_two_loops() -> None:
    assert planar_mobility(5, 7) == 1
    assert count_loops(VP5) == 2
    assert 7 - 3 * count_loops(VP5) == 1  # loop form, STR-3


def test_three_links_with_two_revolutes_and_two_spheres_have_two_freedoms_in_space() -> None:
    assert spatial_mobility(3, {5: 2, 3: 2}) == 2
    assert 2 * 1 + 2 * 3 - 6 * 1 == 2  # loop form, STR-2


def test_the_planar_four_bar_has_three_passive_constraints_in_space() -> None:
    assert spatial_mobility(3, {5: 4}) == -2


@pytest.mark.parametrize(("moving", "p5", "p4", "freedom"), [(3, 3, 1, 2), (2, 2, 1, 1), (4, 6, 0, 0), (7, 10, 0, 1)])
def test_counts_of_the_domain(moving: int, p5: int, p4: int, freedom: int) -> None:
    assert planar_mobility(moving, p5, p4) == freedom


def test_a_joint_of_three_links_counts_as_two_pairs() -> None:
    assert expanded(("2", "3", "4")) == (Pair("2", "3"), Pair("2", "4"))
    for links in (("1",), ("1", "1")):
        with pytest.raises(ValueError, match="two or more different links"):
            expanded(links)


def test_impossible_counts_are_refused() -> None:
    with pytest.raises(ValueError, match="not negative"):
        planar_mobility(3, -1)
    with pytest.raises(ValueError, match="no pair has class 6"):
        spatial_mobility(3, {6: 1})
    with pytest.raises(ValueError, match="not negative"):
        manoeuvrability(-1)
    with pytest.raises(ValueError, match="do not connect"):
        count_loops([Pair("0", "1"), Pair("2", "3")])


def test_the_loops_of_the_spanning_tree_are_independent_and_closed() -> None:
    loops = fundamental_loops(VP5)
    assert len(loops) == 2 and independent(loops)
    for loop in loops:
        ends = [link for at in loop for link in (VP5[at].one, VP5[at].other)]
        assert all(ends.count(link) == 2 for link in ends)


def test_a_third_loop_made_of_the_two_others_is_dependent() -> None:
    first, second = (set(loop) for loop in fundamental_loops(VP5))
    assert not independent([first, second, first ^ second])
    assert independent([first, first ^ second])


@given(st.integers(2, 7).flatmap(lambda n: st.lists(st.tuples(st.integers(0, n), st.integers(0, n)), max_size=9)))
def test_the_number_of_loops_is_that_of_the_tree_for_any_connected_graph(edges: list[tuple[int, int]]) -> None:
    nodes = sorted({node for edge in edges for node in edge})
    spine = [Pair(str(a), str(b)) for a, b in pairwise(nodes)]
    pairs = [*spine, *(Pair(str(a), str(b)) for a, b in edges if a != b)]
    loops = fundamental_loops(pairs)
    assert len(loops) == count_loops(pairs) and independent(loops)


def test_a_walked_loop_is_a_combination_of_columns_that_vanishes() -> None:
    """STR-6: the number of loops is that of pairs less the rank of the incidence matrix."""
    columns = np.array(incidence_matrix(VP5))
    assert np.array_equal(columns.sum(axis=0), np.zeros(7))
    assert len(VP5) - np.linalg.matrix_rank(columns) == count_loops(VP5)
    assert np.array_equal(columns[:, :4].sum(axis=1), np.zeros(6))  # 0-1-2-3-0, walked as the pairs are written


@pytest.mark.parametrize(("kind", "left"), list(zip("RPHCUSELB", (1, 1, 1, 2, 2, 3, 3, 4, 5), strict=True)))
def test_freedoms_and_constraints_of_a_pair_are_six(kind: str, left: int) -> None:
    assert freedoms(kind) == left and freedoms(kind) + CLASSES[kind] == 6


def test_an_unknown_pair_is_refused() -> None:
    with pytest.raises(ValueError, match="pair 'X'"):
        freedoms("X")


def test_chains_are_told_apart() -> None:
    assert (chain_of(FOUR_BAR).compound, chain_of(FOUR_BAR).form) == (False, "closed")  # VP-4
    assert (chain_of(VP5).compound, chain_of(VP5).form) == (True, "closed")
    assert chain_of([*VP5, Pair("5", "7")]).form == "mixed"
    assert chain_of([Pair("0", "1"), Pair("1", "2")]).form == "open"


def test_manoeuvrability_is_what_is_left_when_the_gripper_is_held() -> None:
    assert (manoeuvrability(7), manoeuvrability(5), manoeuvrability(4, planar=True)) == (1, 0, 1)


def test_a_dyad_mechanism_is_of_class_two() -> None:
    found = decompose(VP5, ["1"])
    assert [group.links for group in found.groups] == [{"2", "3"}, {"5", "6"}]
    assert found.klass == 2 and found.formula == "I(0,1) -> II(2,3) -> II(5,6)"
    for group in found.groups:
        assert 3 * len(group.links) == 2 * len(group.pairs)
    assert sum(len(group.pairs) for group in found.groups) + 1 == len(VP5)


def test_a_ternary_link_with_three_arms_is_of_class_three() -> None:
    arms = [("0", "1"), ("1", "3"), ("2", "3"), ("2", "4"), ("2", "5"), ("4", "0"), ("5", "0")]
    found = decompose([Pair(one, other) for one, other in arms], ["1"])
    assert found.klass == 3 and found.formula == "I(0,1) -> III(2,3,4,5)"


def test_a_closed_contour_of_four_links_is_of_class_four() -> None:
    """Two links 2 and 4 joined by 3 and 5 in a quadrilateral; 2 hangs on the driver, 4 on the frame."""
    inner = [Pair("2", "3"), Pair("3", "4"), Pair("4", "5"), Pair("5", "2")]
    found = decompose([Pair("0", "1"), Pair("1", "2"), Pair("4", "0"), *inner], ["1"])
    assert found.klass == 4


def test_the_class_depends_on_the_driver() -> None:
    """Stephenson chain: driven at 1 the ternary group stays whole, driven at 5 it falls into dyads."""
    pairs = [
        Pair("0", "1"), Pair("1", "2"), Pair("2", "3"), Pair("3", "0"), Pair("2", "4"), Pair("4", "5"), Pair("5", "0"),
    ]  # fmt: skip
    assert decompose(pairs, ["1"]).klass == 2
    assert decompose(pairs, ["5"]).klass == 3


def test_a_cam_becomes_a_four_bar_of_the_same_mobility() -> None:
    """Cam 1 on the frame, follower 2 that swings on it: the contact is replaced by a link."""
    cam = [Pair("0", "1"), Pair("1", "2", 4), Pair("2", "0")]
    lower = lower_pairs(cam)
    assert lower == (Pair("0", "1"), Pair("1", "1~2"), Pair("1~2", "2"), Pair("2", "0"))
    assert planar_mobility(2, 2, 1) == planar_mobility(3, len(lower)) == 1
    assert decompose(lower, ["1"]).formula == "I(0,1) -> II(1~2,2)"


def test_the_forms_of_a_dyad_are_five() -> None:
    words = [a + b + c for a in "RP" for b in "RP" for c in "RP" if a + b + c != "PPP"]
    assert {dyad_form(*word) for word in words} == {"RRR", "RRP", "RPR", "PRP", "RPP"}
    assert dyad_form(*"PRR") == "RRP" and dyad_form(*"PPR") == "RPP"
    with pytest.raises(ValueError, match="PPP is no dyad"):
        dyad_form(*"PPP")


def test_what_is_no_sum_of_groups_is_refused() -> None:
    with pytest.raises(AssemblyError, match="no structural group"):
        decompose([*FOUR_BAR, Pair("1", "3")], ["1"])
    with pytest.raises(ValueError, match="class 5"):
        decompose([Pair("0", "1", 4)], ["1"])


LOCKED = [Pair("0", "1"), Pair("1", "2"), Pair("2", "0"), Pair("2", "3")]  # a triangle, and a link that dangles from it
TWO_PINS = [Pair("0", "1"), Pair("0", "2"), Pair("0", "2"), Pair("1", "3")]


@pytest.mark.parametrize("pairs", [LOCKED, TWO_PINS])
def test_a_locked_link_and_a_loose_one_are_no_group_though_the_formula_gives_zero(pairs: list[Pair]) -> None:
    assert planar_mobility(3, len(pairs)) == 1
    with pytest.raises(AssemblyError, match="links 2, 3 form no structural group"):
        decompose(pairs, ["1"])


def test_a_driver_is_a_link_of_the_mechanism() -> None:
    with pytest.raises(ValueError, match="driver 9 is no link"):
        decompose(FOUR_BAR, ["9"])
