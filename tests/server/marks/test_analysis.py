"""The numbers of the analysis against NumPy, tables worked by hand, published tables, and the rule of five."""

from __future__ import annotations

from itertools import permutations
from statistics import fmean

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from server.marks.analysis import LEAST, Try, analysed, common, correlation, fairness, fisher, holm, negative
from tests.depth import amount

PAIRS = st.lists(st.tuples(st.floats(0, 1), st.floats(0, 40)), min_size=3, max_size=40)


def tries(*groups: tuple[str, int, int]) -> list[Try]:
    """Students by group: how many there are and how many solved it."""
    found = []
    for name, number, solved in groups:
        found += [Try(f"{name}{at}", name, float(at < solved), 1, None) for at in range(number)]
    return found


@settings(max_examples=amount(16, 50), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(PAIRS)
def test_the_correlation_is_that_of_numpy(pairs: list[tuple[float, float]]) -> None:
    one, other = map(list, zip(*pairs, strict=True))
    found = correlation(one, other)
    if found is not None and np.std(one) > 1e-6 and np.std(other) > 1e-6:
        assert found == pytest.approx(float(np.corrcoef(one, other)[0, 1]), abs=1e-6)
    assert correlation(other, one) == pytest.approx(found)


def test_a_task_that_all_solve_separates_nobody() -> None:
    assert correlation([1.0] * 6, [1.0, 2, 3, 4, 5, 6]) is None


@pytest.mark.parametrize(
    ("table", "p"),
    [
        ((3, 4, 4, 8), 0.485714),  # Fisher's lady tasting tea, three of four right: two-sided 34/70
        ((4, 4, 4, 8), 0.028571),  # all right: 2/70
        ((1, 12, 10, 24), 0.002759),  # studying and not studying, 1 of 12 against 9 of 12
        ((10, 13, 12, 30), 0.0005367),  # convictions of twins of convicts (Fisher, the same section)
    ],
)
def test_fisher_gives_the_values_of_worked_tables(table: tuple[int, int, int, int], p: float) -> None:
    assert fisher(*table) == pytest.approx(p, rel=1e-3)


@settings(max_examples=amount(8, 25), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.integers(1, 4), st.integers(1, 4), st.data())
def test_fisher_is_the_share_of_all_deals_that_are_as_unlikely(students: int, others: int, data: st.DataObject) -> None:
    """Counted out: every order in which the same marks could have been dealt to the two groups."""
    marks = data.draw(st.lists(st.booleans(), min_size=students + others, max_size=students + others))
    deals = [sum(deal[:students]) for deal in permutations(marks)]
    often = {k: deals.count(k) for k in set(deals)}
    found = sum(marks[:students])
    expected = sum(times for times in often.values() if times <= often[found]) / len(deals)
    assert fisher(found, students, sum(marks), len(marks)) == pytest.approx(expected)


@pytest.mark.parametrize("table", [(5, 4, 5, 8), (-1, 4, 4, 8), (0, 4, 6, 8), (1, 9, 1, 8)])
def test_a_table_that_cannot_be_is_refused(table: tuple[int, int, int, int]) -> None:
    with pytest.raises(ValueError, match="cannot be"):
        fisher(*table)


def test_holm_rejects_in_order_until_the_first_that_is_likely() -> None:
    assert holm([0.01, 0.04, 0.03, 0.005]) == [True, False, False, True]  # 0.05/4, 0.05/3 pass; 0.03 > 0.05/2
    assert holm([]) == []


def test_an_unfair_exercise_of_a_pool_is_flagged_and_a_fair_one_is_not() -> None:
    flags = {one.group: one.unfair for one in fairness(tries(("hard", 40, 5), ("a", 40, 30), ("b", 40, 29)))}
    assert flags["hard"] and not any(one.unfair for one in fairness(tries(("a", 40, 30), ("b", 40, 28))))


def test_fewer_than_five_people_are_hidden_wherever_they_stand() -> None:
    few = analysed(tries(("a", LEAST - 1, 2)), {})
    assert (few.students, few.solved, few.groups) == (0, None, ())
    assert [one.group for one in fairness(tries(("a", 30, 9), ("b", LEAST - 1, 1), ("c", 30, 9)))] == ["a", "c"]
    assert fairness(tries(("a", 30, 9), ("b", LEAST - 1, 1))) == ()  # what is left over would tell of the four
    each = [frozenset({"x"})] * LEAST + [frozenset({"y"})] * (LEAST - 1)
    assert common(each) == [("x", LEAST)]
    quick = [Try(str(n), "a", 1.0, 1, 3.0 if n < LEAST - 1 else None) for n in range(9)]
    assert analysed(quick, {}).first_right is None


@pytest.mark.parametrize(
    ("correlation", "students", "told"),
    [(-0.05, 39, False), (-0.13, 300, True), (-0.26, 39, False), (-0.27, 39, True), (-1.0, 5, True), (-0.8, 5, False),
     (1.0, 5, False), (0.3, 300, False)],
)  # fmt: skip
def test_only_a_correlation_that_chance_hardly_leads_to_is_called_negative(
    correlation: float, students: int, told: bool
) -> None:
    assert negative(correlation, students) is told


def test_chance_alone_calls_about_one_task_in_twenty_negative() -> None:
    rng = np.random.default_rng(7)
    pairs = rng.normal(size=(2000, 2, 40))
    assert 0.04 < fmean(negative(float(np.corrcoef(one, other)[0, 1]), 40) for one, other in pairs) < 0.06


def test_a_class_worked_by_hand() -> None:
    shares = [1.0, 1.0, 0.5, 0.0, 0.0, 1.0]
    rest = [9.0, 8.0, 6.0, 3.0, 2.0, 8.0]
    slips = frozenset({"e:sine"})
    made = [
        Try(str(n), "e", share, n % 2 + 1, 2.0 * n, slips if n < 5 else frozenset()) for n, share in enumerate(shares)
    ]
    found = analysed(made, {str(n): points for n, points in enumerate(rest)})
    assert (found.students, found.solved, found.attempts) == (6, 0.5, 1.5)
    assert found.success == pytest.approx(fmean(shares)) and found.first_right == 5.0
    assert found.separates == pytest.approx(float(np.corrcoef(shares, rest)[0, 1]))
    assert found.mistakes == (("e:sine", 5 / 6),)
