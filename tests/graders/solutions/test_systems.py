"""Systems are equal when they have the same solutions; a lost or a surplus assembly is proved at a witness.

Mutants of the comparison that live on change nothing that can be seen:

* one point more or less at which the dependence is tested, one zero more or less that is shared; no stop where the two
  do not depend on one another: too few points are left, and zeros decide;
* zeros of one side alone in branches, other assemblies from other places: the rest of the starts leads to them too.
"""

from __future__ import annotations

import pytest

from graders.equality import Finding
from graders.solutions.found import Found
from graders.solutions.systems import compare_systems
from tests.graders.effort import effort
from tests.graders.solutions.boxes import RANGES, SCENE, relation

BAR = ("l1*cos(a1) + l2*cos(phi) = l4 + r3*cos(psi)", "l1*sin(a1) + l2*sin(phi) = r3*sin(psi)")
CRANK = ("l1*cos(a1) + l2*cos(phi) = l3", "l1*sin(a1) + l2*sin(phi) = e")
SPEEDS = (
    "w2*l2*cos(phi) + w1*l1*cos(a1) = w3*r3*cos(psi)",
    "w2*l2*sin(phi) + w1*l1*sin(a1) = w3*r3*sin(psi)",
)
SUM = ("y + z = a", "y - z = b")
EQUAL = [
    (("phi", "psi"), BAR, (BAR[1], BAR[0])),
    (("phi", "psi"), BAR, (
        "l4 + r3*cos(psi) - l1*cos(a1) = l2*cos(phi)", "2*r3*sin(psi) - 2*l2*sin(phi) = 2*l1*sin(a1)",
    )),
    (("phi", "psi"), BAR, (
        BAR[1], "l1*(cos(a1) + sin(a1)) + l2*(cos(phi) + sin(phi)) = l4 + r3*(cos(psi) + sin(psi))",
    )),
    (("phi", "l3"), CRANK, ("l2*cos(phi) = l3 - l1*cos(a1)", "sin(phi) = (e - l1*sin(a1))/l2")),
    (("w2", "w3"), SPEEDS, (
        "w2 = -w1*l1*sin(a1 - psi)/(l2*sin(phi - psi))", "w3 = w1*l1*sin(a1 - phi)/(r3*sin(psi - phi))",
    )),
    (("y", "z"), SUM, ("y = (a + b)/2", "z = (a - b)/2")),
    (("y", "z"), SUM, ("(y + z - a)^2 = 0", "y - z = b")),
    (("y", "z"), ("y + z = a", "y*z = b"), ("z = a - y", "y^2 - a*y + b = 0")),
    (("y", "z"), ("y = |a - b|", "z = x"), ("2*y = 2*|a - b|", "z - x = 0")),
    (("x", "z"), ("sqrt(y)*(x - a) = 0", "z = a"), ("sqrt(y)*x - sqrt(y)*a = 0", "z = a")),
    (("y", "z"), ("y*sqrt(z - b) = a*sqrt(z - b)", "z = x"), ("(y - a)*sqrt(z - b) = 0", "z = x")),
    (("x", "y", "z"), ("x + y = a", "y + z = b", "x + z = a + b"), ("x = a", "y = 0", "z = b")),
]  # fmt: skip
DIFFERENT = [
    (("phi", "psi"), BAR, (BAR[0], "l1*sin(a1) - l2*sin(phi) = r3*sin(psi)"), None),
    (("phi", "psi"), BAR, (BAR[0], BAR[0]), False),
    (("phi", "psi"), BAR, (BAR[0], "x = x"), False),
    (("phi", "psi"), BAR, (BAR[0], "0 = 1"), True),
    (("phi", "psi"), BAR, (BAR[1], "(l1*cos(a1) + l2*cos(phi) - l4)^2 + (l1*sin(a1) + l2*sin(phi))^2 = r3^2"), False),
    (("phi", "l3"), CRANK, (CRANK[1], "l3 = l1*cos(a1) + sqrt(l2^2 - (e - l1*sin(a1))^2)"), None),
    (("w2", "w3"), SPEEDS, (
        "w2 = -w1*l1*sin(a1 - psi)/(l2*sin(phi - psi))", "w3 = w1*l1*sin(a1 - phi)/(r3*sin(phi - psi))",
    ), None),
    (("y", "z"), SUM, ("y = (a + b)/2", "z = (a - b)/2*(1 + 1e-9)"), None),
    (("y", "z"), SUM, ("y = (a + b)/2", "z = (a - b)/2 + 1e-20"), None),
    (("y", "z"), ("y^2 = a^2", "z = y"), ("y = a", "z = y"), True),
    (("y", "z"), ("y = a", "z = y"), ("y = a", "z^2 = y^2"), False),
    (("y", "z"), ("y = a", "z = x"), ("y = a", "z = x + max(0; x - 1.99)"), None),
]  # fmt: skip


def compared(unknowns: tuple[str, ...], reference: tuple[str, ...], answer: tuple[str, ...]) -> Found:
    return compare_systems(list(map(relation, answer)), list(map(relation, reference)), SCENE, unknowns)


@pytest.mark.parametrize(("unknowns", "one", "other"), EQUAL)
def test_the_same_solutions_are_equal_either_way(
    unknowns: tuple[str, ...], one: tuple[str, ...], other: tuple[str, ...]
) -> None:
    assert compared(unknowns, one, other).finding is Finding.EQUAL
    assert compared(unknowns, other, one).finding is Finding.EQUAL


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (("y*(x^2 - a) = 0", "x + z^2 = a"), ("y*x^2 - y*a = 0", "(x + z^2 - a)*(1 + z^2) = 0")),
        (("(a^2*y*<<3>^1>^2 - 0)*(2 + sin(x)) = 0", "z = a"), ("a^2*y*<<3>^1>^2 = 0", "z = a")),
    ],
)
def test_where_what_went_is_zero_the_same_systems_are_left_open(one: tuple[str, ...], other: tuple[str, ...]) -> None:
    assert compared(("x", "z"), one, other).finding is Finding.UNDECIDED
    assert compared(("x", "z"), other, one).finding is Finding.UNDECIDED


@pytest.mark.parametrize(("unknowns", "one", "other", "lost"), DIFFERENT)
def test_a_lost_or_a_surplus_solution_is_told(
    unknowns: tuple[str, ...], one: tuple[str, ...], other: tuple[str, ...], lost: bool | None
) -> None:
    found, back = compared(unknowns, one, other), compared(unknowns, other, one)
    assert found.finding is back.finding is Finding.DIFFERENT
    assert lost is None or (found.lost, back.lost) == (lost, not lost)
    assert [name for name, _ in found.witness] == list(RANGES)
    assert all(RANGES[name][0] - 1e-12 <= value <= RANGES[name][1] + 1e-12 for name, value in found.witness)


def test_systems_without_a_solution_in_the_box_are_undecided() -> None:
    assert compared(("y", "z"), ("y = 5", "z = a"), ("y = 6", "z = a")).finding is Finding.UNDECIDED


def test_a_hostile_system_costs_little() -> None:
    long = "y = " + "+".join(f"asin(y/{k} + a)" for k in range(2, 100))
    back = "y = " + "+".join(f"asin(a + y/{k})" for k in range(99, 1, -1))
    assert effort(lambda: compared(("y", "z"), (long, "z = a"), (back, "z = a")), enough=0.1) < 0.1
