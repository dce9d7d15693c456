"""American Institute of Steel Construction, Steel Construction Manual, 14th ed., Chicago 2011, table 3-23 "Shears,
Moments and Deflections", pages 3-213 to 3-226: cases by number, coefficients to the digits printed there.
"""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from mechanics.beam import Beam, BeamResult, Distributed, Force, Load, Moment, Support, solve

l, E, I = 3.0, 2.1e11, 8e-6  # m, Pa, m^4
EI = E * I
P, w = 1000.0, 2000.0  # N, N/m


def over(*supports: tuple[float, str] | float, loads: tuple[Load, ...], L: float = l) -> BeamResult:
    held = [place if isinstance(place, tuple) else (place, "pin") for place in supports]
    return solve(Beam(L, E, tuple(Support(x, kind) for x, kind in held), loads, I=I))  # type: ignore[arg-type]


def spread(x1: float, x2: float, w1: float = w, w2: float = w) -> Distributed:
    return Distributed(x1, x2, -w1, -w2)


@dataclass(frozen=True)
class Case:
    """What the table prints: forces in parts of the unit, moments of unit l, deflections of unit l^3/EI."""

    number: int
    found: BeamResult
    unit: float  # N
    reactions: tuple[float, ...]
    M_abs_max: float
    v: float
    x_v: float | None = None  # in parts of l
    M_max: float | None = None


END, WALL = (l, "fixed"), (0.0, "fixed")
W = w * l / 2  # the table's W of a triangular load
CASES = [
    Case(1, over(0, l, loads=(spread(0, l),)), w * l, (0.5, 0.5), 1 / 8, 5 / 384, 0.5),
    Case(2, over(0, l, loads=(spread(0, l, 0),)), W, (1 / 3, 2 / 3), 0.1283, 0.0130, 0.519),
    Case(3, over(0, l, loads=(spread(0, l / 2, 0), spread(l / 2, l, w, 0))), W, (0.5, 0.5), 1 / 6, 1 / 60, 0.5),
    Case(7, over(0, l, loads=(Force(l / 2, -P),)), P, (0.5, 0.5), 1 / 4, 1 / 48, 0.5),
    Case(9, over(0, l, loads=(Force(l / 3, -P), Force(2 * l / 3, -P))), P, (1, 1), 1 / 3, 23 / 648, 0.5),
    Case(12, over(0, END, loads=(spread(0, l),)), w * l, (3 / 8, 5 / 8), 1 / 8, 1 / 185, 0.4215, 9 / 128),
    Case(13, over(0, END, loads=(Force(l / 2, -P),)), P, (5 / 16, 11 / 16), 3 / 16, 0.009317, 0.4472, 5 / 32),
    Case(15, over(WALL, END, loads=(spread(0, l),)), w * l, (0.5, 0.5), 1 / 12, 1 / 384, 0.5, 1 / 24),
    Case(16, over(WALL, END, loads=(Force(l / 2, -P),)), P, (0.5, 0.5), 1 / 8, 1 / 192, 0.5, 1 / 8),
    Case(18, over(END, loads=(spread(0, l, 0),)), W, (1,), 1 / 3, 1 / 15, 0.0),
    Case(19, over(END, loads=(spread(0, l),)), w * l, (1,), 1 / 2, 1 / 8, 0.0),
    Case(22, over(END, loads=(Force(0.0, -P),)), P, (1,), 1, 1 / 3, 0.0),
    Case(29, over(0, l, 2 * l, loads=(spread(0, l),), L=2 * l), w * l, (7 / 16, 5 / 8, -1 / 16), 49 / 512,
         0.0092, 0.472),
    Case(30, over(0, l, 2 * l, loads=(Force(l / 2, -P),), L=2 * l), P, (13 / 32, 11 / 16, -3 / 32), 13 / 64,
         0.015, 0.480),
    Case(39, over(0, l, 2 * l, 3 * l, loads=(spread(0, 3 * l),), L=3 * l), w * l, (0.400, 1.10, 1.10, 0.400), 0.100,
         0.0069, 0.446, 0.0800),
    Case(42, over(0, l, 2 * l, 3 * l, 4 * l, loads=(spread(0, 4 * l),), L=4 * l), w * l,
         (0.393, 1.14, 0.928, 1.14, 0.393), 0.1071, 0.0065, 0.440, 0.0772),
]  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"case {case.number}")
def test_a_case_of_the_table(case: Case) -> None:
    reactions = [one.Fy / case.unit for one in case.found.reactions]
    assert reactions == pytest.approx(case.reactions, rel=3e-3)
    assert case.found.M_abs_max / (case.unit * l) == pytest.approx(case.M_abs_max, rel=6e-4)
    assert -case.found.v_extreme * EI / (case.unit * l**3) == pytest.approx(case.v, rel=1e-2)
    if case.x_v is not None:
        assert case.found.x_v_extreme / l == pytest.approx(case.x_v, abs=2.5e-3)
    if case.M_max is not None:
        assert case.found.M_max / (case.unit * l) == pytest.approx(case.M_max, rel=6e-4)


def test_a_couple_at_the_end_of_a_simple_beam() -> None:
    """Largest deflection M l^2/(9 sqrt(3) EI) at l/sqrt(3) from the other end (the derivative of the cubic)."""
    found = over(0, l, loads=(Moment(l, -500.0),))
    assert abs(found.v_extreme) == pytest.approx(500 * l * l / (9 * 3**0.5 * EI), rel=1e-12)
    assert found.x_v_extreme == pytest.approx(l / 3**0.5, rel=1e-9)
