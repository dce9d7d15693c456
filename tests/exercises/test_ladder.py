"""The ladder of hints: the symbols, the equation, the equation with the data; no step holds what is sought."""

from __future__ import annotations

import re
from math import degrees

import pytest

from exercises import catalogue
from exercises.presenting import NUMBERS, Rung, ladder
from exercises.solving import solved
from exercises.variants import deal
from graders.language import parse_line
from graders.language.mathml import mathml_of

CRANK = deal("slider_crank", 7)


LABORATORIES = [name for name in catalogue.ids() if catalogue.load(name).exercise.report]


def written(step: Rung) -> str:
    """Give a step without its elements; a fraction shows as its parts one after the other."""
    return re.sub("<[^>]+>", "", step.html)


def test_the_last_step_puts_the_printed_data_in_the_places_of_their_symbols() -> None:
    given = CRANK.givens
    symbols, equation, data = map(written, ladder(CRANK, "l3", "en"))
    assert (symbols, equation) == ("l1, l2, α1, α2", "l3=l1·cosα1+l2·cosα2")
    assert data == f"l3={given.l1:g}·cos({degrees(given.alpha1):g}°)+{given.l2:g}·cosα2"
    assert written(ladder(CRANK, "l3", "pl")[2]) == data.replace(".", ",")


def test_a_power_of_ten_is_kept_together() -> None:
    shaft = deal("stepped_shaft", 4)
    assert "(8·107)3" in written(ladder(shaft, "d_tau", "en")[2])  # raised: 8·10^7 to the third


def test_an_equation_that_names_a_given_alone_is_not_given_its_number() -> None:
    assert [written(step) for step in ladder(deal("stepped_shaft", 4), "T1", "en")] == ["M1", "T1=M1"]


def test_a_laboratory_tells_the_shape_of_a_formula_then_all_but_its_signs() -> None:
    steps = ladder(deal("tmm2_oop", 4), "v_x", "en")
    assert [step.kind for step in steps] == ["follows", "shape", "signs"]
    shape, signs = map(written, steps[1:])
    assert shape == "vx=±lAB·Θ˙1·f(Θ1)±lBC·ω3·f(α2)±h˙3·f(α3)±h3·ω3·f(α3)"
    assert signs == "vx=±lAB·Θ˙1·sinΘ1±lBC·ω3·sinα2±h˙3·cosα3±h3·ω3·sinα3"


def test_a_formula_of_a_laboratory_without_functions_leaves_its_signs_open_at_once() -> None:
    relative = next(variant for seed in range(20) if (variant := deal("tmm2_oop", seed)).givens.measured == "relative")
    assert [step.kind for step in ladder(relative, "omega3", "en")] == ["follows", "signs"]


@pytest.mark.parametrize("exercise", LABORATORIES)
def test_no_step_of_a_laboratory_is_the_whole_formula(exercise: str) -> None:
    for variant in (deal(exercise, seed) for seed in range(6)):
        found = solved(variant)
        for name, judge in found.answers.items():
            line, steps = found.steps[found.step_of(name)], ladder(variant, name, "en")
            assert isinstance(line, str) and (judge.kind in NUMBERS or not steps)
            whole = re.sub("<[^>]+>", "", mathml_of(parse_line(line)))
            assert all("±" in written(step) and not written(step).endswith(f"={whole}") for step in steps[1:])
            assert len(steps) != 1 or not re.search(r"[-+(]", line)


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_the_data_show_no_number_that_is_sought(exercise: str) -> None:
    variant = deal(exercise, 4)
    for name in solved(variant).answers:
        for step in map(written, ladder(variant, name, "en")[2:]):
            said = {float(number) for number in re.findall(r"(?<![\d.])\d+\.?\d*", step.partition("=")[2])}
            result = solved(variant).values[solved(variant).step_of(name)]
            assert isinstance(result, int | float) and abs(result) not in said, (name, step)
