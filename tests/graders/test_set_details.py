"""What is told of a set beside right and wrong: slips in one number or in all, scores, echoes, the field.

Mutants of this judge that live on change nothing that can be seen:

* symbols, which no number reads; `max(2, …)` where one branch is expected, under a sum that is then nothing;
* division by the factor of a slip, which stands in the list with its reciprocal.
"""

from __future__ import annotations

from math import pi, radians

import pytest

from graders import Code, Set, Symbols
from graders.common_slips import CommonSlip

NOTHING = Symbols(())
ARM = Set(("deg", "deg", "mm"), names=("q1", "theta2", "s3"), rtol=0.002, atol=(0.002, 0.002, 0.0005))
TWO = ((radians(30), radians(-45.5), 0.4), (radians(-150), radians(45.5), 0.5))
ROOTS = Set("mm")
LENGTHS = ((0.0125,), (0.03,), (-0.004,))
SIGN, KILO, DEGREES = CommonSlip.OPPOSITE_SIGN, CommonSlip.KILO_PREFIX, CommonSlip.DEGREES_RADIANS


@pytest.mark.parametrize(
    ("typed", "slips"),
    [
        ("(-30; 45,5; -400); (150; -45,5; -500)", {SIGN}),
        ("(-30; -45,5; 400); (150; 45,5; 500)", {SIGN}),
        ("(30; -45,5; -400); (-150; 45,5; -500)", {SIGN}),
        ("(30; -45,5; 0,4); (-150; 45,5; 0,5)", {KILO}),
        ("(30; -45,5; 400000); (-150; 45,5; 500000)", {KILO}),
        ("(0,5236; -45,5; 400); (-2,618; 45,5; 500)", {DEGREES}),
        ("(0,5236; -0,7941; 400); (-2,618; 0,7941; 500)", {DEGREES}),
        ("(30; -45,5; 22918); (-150; 45,5; 28648)", set()),
        ("(-30; -45,5; 400); (-150; -45,5; 500)", set()),
        ("(30; -45,5; -400 N); (-150; 45,5; -500 N)", set()),
        ("(-30; 45,5; -400)", set()),
        ("(31; -45,5; 400); (-150; 45,5; 500)", set()),
    ],
)
def test_a_slip_is_told_where_it_is_the_only_one(typed: str, slips: set[CommonSlip]) -> None:
    assert ARM.slips(ARM.parse(typed, NOTHING), TWO) == slips


@pytest.mark.parametrize(
    ("unit", "typed", "truth", "slip"),
    [
        ("rad", "30; 45", ((pi / 6,), (pi / 4,)), DEGREES),
        ("m", "0,0125; 3", ((12.5,), (3000.0,)), KILO),
        ("m", "12500; 3000000", ((12.5,), (3000.0,)), KILO),
    ],
)
def test_a_slip_is_told_both_ways(
    unit: str, typed: str, truth: tuple[tuple[float, ...], ...], slip: CommonSlip
) -> None:
    narrow = Set(unit, rtol=1e-6)
    assert narrow.slips(narrow.parse(typed, NOTHING), truth) == {slip}


@pytest.mark.parametrize(
    ("typed", "code"),
    [
        ("(30; -45,5; 400); (1 mm; 2; 3); (4; 5; 6)", Code.WRONG),
        ("(1 mm; 2; 3); (4; 5; 6)", Code.WRONG_DIMENSION),
    ],
)
def test_a_unit_of_another_quantity_is_told_where_no_branch_is_found(typed: str, code: Code) -> None:
    verdict = ARM.check(ARM.parse(typed, NOTHING), TWO)
    assert (verdict.code, verdict.score) == (code, 0)


def test_the_tolerance_is_that_of_each_number() -> None:
    loose = Set("mm", rtol=0.1)
    assert loose.check(loose.parse("13; 32; -4,3", NOTHING), LENGTHS).code is Code.RIGHT
    assert ROOTS.check(ROOTS.parse("13; 32; -4,3", NOTHING), LENGTHS).code is Code.WRONG


def test_a_set_is_written_as_it_may_be_typed() -> None:
    assert ROOTS.show(LENGTHS) == "12.5; 30; -4"
    assert ARM.show(TWO) == "(30; -45.5; 400); (-150; 45.5; 500)"
    assert Set(("deg", "mm")).show(((pi / 6, 0.4),)) == "(30; 400)"
    assert ROOTS.show(()) == "∅"
    assert ROOTS.apart((), ()) == 0


def test_a_set_of_numbers_is_echoed_in_its_unit() -> None:
    echo = ROOTS.echo(ROOTS.parse("3; 4", NOTHING))
    assert (echo.text, echo.unit) == ("3; 4", "mm")
    numbers = "<mrow><mn>3</mn></mrow><mo>;</mo><mrow><mn>4</mn></mrow>"
    assert echo.mathml == f"<math><mrow>{numbers}</mrow></math>"
    assert ROOTS.echo(()).mathml == "<math><mrow><mi>∅</mi></mrow></math>"


def test_numbers_without_a_unit_are_echoed_without_one() -> None:
    judge = Set(("deg", "1"))
    echo = judge.echo(judge.parse("(30; 0,5); (45°30'; 2)", NOTHING))
    assert (echo.text, echo.unit) == ("(30 deg; 0.5); (45°30'; 2)", None)
    first = "<mrow><mn>30</mn></mrow><mtext> deg</mtext><mo>;</mo><mrow><mn>0.5</mn></mrow>"
    assert echo.mathml.startswith(f"<math><mrow><mo>(</mo>{first}<mo>)</mo><mo>;</mo><mo>(</mo><mrow>")
    assert echo.mathml.count("<mtext>") == 1 and echo.mathml.endswith("<mo>)</mo></mrow></math>")


def test_the_field_has_one_unit_where_all_numbers_have_it() -> None:
    part = {"rtol": 0.005, "atol": 0.0}
    assert ROOTS.describe() == {"components": [{"name": "", "unit": "mm", **part}], "unit": "mm"}
    assert Set(("deg", "mm")).describe() == {
        "components": [{"name": "", "unit": "deg", **part}, {"name": "", "unit": "mm", **part}]
    }
