"""What the diagrams and the deflection of a beam promise beyond the contract of every exercise."""

from __future__ import annotations

import pytest

from exercises import variants
from exercises.exercise import Submission, Variant
from exercises.grading import grade, reference
from exercises.presenting import solution
from exercises.solving import Solved, solve
from exercises.strength import beam_deflection, beam_diagrams
from exercises.strength._beam.members import (
    ClampedLeft,
    ClampedRight,
    Clockwise,
    Counterclockwise,
    Force,
    InsetA,
    InsetB,
    LeftEnd,
    Load,
    RightEnd,
    Support,
    Uniform,
    structure,
)
from exercises.strength._beam.profile import moment_rows, shear_rows, stretches
from exercises.strength.beam_deflection.sag import deepest, extremes
from graders import Code, Outcome
from graders.remarks import Remarks, Slip
from mechanics import members
from tests.depth import amount

SEEDS = range(amount(5, 16))
KINDS = {("LeftEnd", "RightEnd"), ("ClampedLeft",), ("ClampedRight",), ("LeftEnd", "InsetB"), ("InsetA", "RightEnd")}


def beam(*loads: Load, supports: tuple[Support, ...], L: float = 4.0) -> beam_diagrams.Givens:
    return beam_diagrams.Givens(supports, loads, L)


def variant(givens: beam_diagrams.Givens) -> Variant:
    return Variant("beam_diagrams", 1, 0, givens)


def ends(rows: object) -> tuple[float, float]:
    """The ordinates at both ends of a diagram."""
    assert isinstance(rows, tuple)
    start, end, *curve = rows[-1]
    return rows[0][2], sum(c * (end - start) ** power for power, c in enumerate(curve))


def test_every_kind_of_support_is_drawn() -> None:
    drawn = [variants.deal("beam_diagrams", seed).givens.supports for seed in range(40)]
    assert {tuple(type(support).__name__ for support in supports) for supports in drawn} >= KINDS


@pytest.mark.parametrize("seed", SEEDS)
def test_diagrams_close_and_m_is_the_integral_of_v(seed: int) -> None:
    values = Solved(beam_diagrams.EXERCISE, variants.deal("beam_diagrams", seed)).values
    held = [float(values[name]) for name in ("M_A", "M_B") if name in values]  # type: ignore[arg-type]
    free = [end for end in ends(values["M"]) if all(abs(end - M) > 1e-6 * abs(M) for M in held)]
    assert free == pytest.approx([0] * len(free), abs=1e-6 * max(map(abs, (*held, 1e4))))
    assert isinstance(values["V"], tuple) and isinstance(values["M"], tuple)
    for shear, moment in zip(values["V"], values["M"], strict=True):
        assert (moment[3], 2 * moment[4]) == pytest.approx((shear[2], shear[3]))


def test_a_mirrored_beam_has_the_mirrored_diagrams() -> None:
    one = beam(Force(3e3, 0.5), Uniform(2e3, 1.0, 2.0), Clockwise(1e3, 2.5), supports=(LeftEnd(), InsetB(3.2)))
    loads = (Counterclockwise(1e3, 1.5), Uniform(2e3, 2.0, 3.0), Force(3e3, 3.5))
    other = beam(*loads, supports=(InsetA(0.8), RightEnd()))
    left, right = (solve(beam_diagrams.EXERCISE, givens)["M"] for givens in (one, other))
    assert isinstance(left, tuple) and isinstance(right, tuple)
    assert [row[2] for row in left[1:]] == pytest.approx([ends((row,))[1] for row in reversed(right[:-1])], abs=1e-9)


def test_a_wall_at_either_end_gives_the_same_moment() -> None:
    one = beam(Force(3e3, 4.0), Uniform(2e3, 1.0, 3.0), supports=(ClampedLeft(),))
    other = beam(Force(3e3, 0.0), Uniform(2e3, 1.0, 3.0), supports=(ClampedRight(),))
    left, right = (solve(beam_diagrams.EXERCISE, givens) for givens in (one, other))
    assert left["M_A"] == pytest.approx(right["M_B"]) and left["M_A"] == pytest.approx(-20e3)
    assert (left["R_A"], right["R_B"]) == pytest.approx((7e3, 7e3))


def test_two_places_a_rounding_apart_are_one() -> None:
    found = stretches(2.0, [(0.0, 5.0, 0.0, 0.0)], [members.Force(0.1 + 0.2, -2.0), members.Force(0.3, -3.0)])
    assert [(one.start, one.end) for one in found] == [(0.0, 0.3), (0.1 + 0.2, 2.0)]
    assert shear_rows(found)[1][2] == 0 and moment_rows(found)[1][2] == pytest.approx(1.5)


def test_diagrams_drawn_from_a_wrong_reaction_are_right_in_themselves() -> None:
    givens = beam(Force(6e3, 1.0), supports=(LeftEnd(), RightEnd()))
    typed = {
        "R_A": "1,5 kN",  # the levers exchanged
        "R_B": "4,5 kN",
        "V": "0..1: 1,5; 1..4: -4,5",
        "M": "0..1: 1,5*x; 1..4: 1,5*x - 6*(x-1)",
    }
    verdicts = grade(Submission(variant(givens), typed)).verdicts
    assert verdicts["R_A"].outcome is Outcome.WRONG
    assert {verdicts[name].code for name in ("R_B", "V", "M")} == {Code.FOLLOWED}


def test_a_diagram_that_is_right_in_part_is_explained() -> None:
    givens = beam(Force(6e3, 1.0), Clockwise(2e3, 2.0), supports=(LeftEnd(), RightEnd()))
    right = reference(variant(givens))
    lost = {**right, "M": "0..1: 4*x; 1..4: 4 - 2*(x-1)"}
    found = grade(Submission(variant(givens), lost))
    assert found.mistake == "couple_jump_lost"
    details = found.verdicts["M"].details
    assert isinstance(details, Remarks) and details.found[0].slip is Slip.LOST_JUMP


@pytest.mark.parametrize("lang", ["pl", "en", "ru"])
def test_the_worked_solution_writes_the_pieces_of_a_diagram(lang: str) -> None:
    givens = beam(Force(6e3, 1.0), supports=(LeftEnd(), RightEnd()), L=4.5)
    shear = solution(variant(givens), lang)[2].value
    assert shear == ("0 … 1: 4.6667; 1 … 4.5: −1.3333" if lang == "en" else "0 … 1: 4,6667; 1 … 4,5: −1,3333")


def sagging(*loads: Load, supports: tuple[Support, ...] = (LeftEnd(), RightEnd())) -> beam_deflection.Givens:
    return beam_deflection.Givens(supports, loads, L=4.0, EI=1e6, x=1.0)


def test_a_symmetric_beam_sags_most_in_its_middle() -> None:
    values = solve(beam_deflection.EXERCISE, sagging(Uniform(2e3, 1.0, 3.0)))
    assert values["x_m"] == pytest.approx(2)
    central = solve(beam_deflection.EXERCISE, sagging(Force(6e3, 2.0)))
    assert central["v_m"] == pytest.approx(-6e3 * 4**3 / 48 / 1e6)


def test_slope_and_deflection_agree_with_finite_differences() -> None:
    givens = sagging(Force(3e3, 0.5), Uniform(2e3, 1.0, 2.0), Clockwise(1e3, 2.5), supports=(LeftEnd(), InsetB(3.2)))

    def v(x: float) -> float:
        from dataclasses import replace

        found = solve(beam_deflection.EXERCISE, replace(givens, x=x))["v"]
        assert isinstance(found, float)
        return found

    values = solve(beam_deflection.EXERCISE, givens)
    R_A, R_B, C = (float(values[name]) for name in ("R_A", "R_B", "C"))  # type: ignore[arg-type]
    for x, sag in extremes(givens, R_A, R_B, C)[:-1]:
        assert v(x) == pytest.approx(sag / givens.EI)
        assert abs(v(x + 1e-4) - v(x - 1e-4)) < 1e-3 * abs(v(x + 0.1) - v(x - 0.1)) + 1e-12
    assert deepest(givens, R_A, R_B, C) == values["x_m"]
    assert (v(0.0), v(3.2)) == pytest.approx((0, 0), abs=1e-15)
    curvature = (v(1.01) - 2 * v(1.0) + v(0.99)) / 1e-4
    assert curvature * givens.EI == pytest.approx(values["M"], rel=1e-3)


@pytest.mark.parametrize("seed", range(8))
def test_places_are_named_from_left_to_right(seed: int) -> None:
    givens = variants.deal("beam_deflection", seed).givens
    names = beam_deflection.stretch_ends(givens)
    of = {**{f"a{i}": load.a for i, load in enumerate(givens.loads, 1)}, "L": givens.L}
    of |= {f"c{i}": load.c for i, load in enumerate(givens.loads, 1) if isinstance(load, Uniform)}
    of |= {f"s{i}": s.s for i, s in enumerate(givens.supports, 1) if isinstance(s, InsetB)}
    assert [of[name] for name in names] == sorted(of.values()) and set(names) == set(of)


def test_numbers_follow_from_the_students_own_function() -> None:
    given = variants.deal("beam_deflection", 0)
    solved = Solved(beam_deflection.EXERCISE, given)
    right = reference(given)
    value = solved.values["v"]
    assert isinstance(value, float)
    typed = {**right, "v": f"({right['v']})/2", "v_K": f"{value / 2 * 1e3:.8g} mm"}
    verdicts = grade(Submission(given, typed)).verdicts
    assert verdicts["v"].outcome is Outcome.WRONG and verdicts["v_K"].code is Code.FOLLOWED


def test_a_structure_takes_the_stiffness_it_is_given() -> None:
    assert structure(sagging(Force(6e3, 2.0)), E=1.0, second_moment=5e5).second_moment == 5e5
