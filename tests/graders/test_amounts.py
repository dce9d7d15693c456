"""Amounts as students write them: the usual spellings are read at a glance, and as the whole language reads them."""

from __future__ import annotations

from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graders import AnswerSyntaxError, Quantity, Symbols
from graders.language import Reason
from graders.language.text import text_of
from tests.graders.effort import calls, effort

NOTHING = Symbols(())
STRESS = Quantity("MPa")
NAMES = ("", "=", "= ", "sigma = ", "σ₁=", "R_A =", "  x ≈ ", "сила = ", "F' = ")
literals = st.from_regex(r"-?[0-9]{1,6}([.,][0-9]{1,6})?([eE][-+]?[0-9])?", fullmatch=True)
units = st.sampled_from(("", " MPa", "kPa", " [MPa]", " N/mm^2", " kN/cm²"))


@given(st.sampled_from(NAMES), literals, units)
def test_a_literal_is_read_as_the_same_literal_in_brackets(name: str, literal: str, unit: str) -> None:
    glanced, read = STRESS.parse(name + literal + unit, NOTHING), STRESS.parse(f"{name}({literal}){unit}", NOTHING)
    assert (glanced.number, glanced.unit, glanced.unit_text) == (read.number, read.unit, read.unit_text)
    assert glanced.value == read.value and text_of(glanced.tree) == text_of(read.tree)


@pytest.mark.parametrize("text", ["12 000 MPa", "  12 000", "12 000,0 [MPa]", "sigma = 12 000 MPa"])
def test_thousands_may_stand_apart(text: str) -> None:
    assert STRESS.parse(text, NOTHING).number == 12000


@pytest.mark.parametrize(
    "text",
    ["cos(q3) = 12", "cos q3 = 12", r"\cos\left(q_3\right)=12", "sigma = 24/2 = 12 MPa", "= 24/2 = 12", "|v| = 12",
     "M(x) = 12", r"omega_2=12\,\mathrm{N\cdot mm^{-2}}"],
)  # fmt: skip
def test_what_stands_before_the_last_equals_sign_is_a_name_of_the_amount(text: str) -> None:
    assert STRESS.parse(text, NOTHING).value == 12e6


@pytest.mark.parametrize(
    ("text", "place"),
    [("== 12 MPa", 1), ("x y = 12", 0), ("sigma =", 7), ("12 Mpz", 3), ("R = 12 Mpz", 7), ("12 000 qq", 7)],
)
def test_what_is_no_amount_is_refused_at_its_place(text: str, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as caught:
        STRESS.parse(text, NOTHING)
    assert caught.value.position == place


def test_a_long_run_of_a_name_is_refused_without_delay() -> None:
    for text in ("a" * 1999 + "=", " " * 1998 + "1=", "1" * 1999, "x = " + "1 " * 900):
        with pytest.raises(AnswerSyntaxError):
            STRESS.parse(text, NOTHING)


@pytest.mark.parametrize(
    "text", ["(204 mm)", " ( 204 mm ) ", "(204) mm", "204 mm;", "((204 mm))", "(20,4 cm)", "(200 + 4) mm"]
)
def test_brackets_around_an_amount_and_a_semicolon_behind_it_say_nothing(text: str) -> None:
    assert Quantity("mm").parse(text, Symbols(())).value == pytest.approx(0.204)


@pytest.mark.parametrize(
    ("text", "place", "meant"),
    [
        ("d ≥ 68,6 mm", 2, "68,6 mm"),
        ("> 68.6", 0, "68.6"),
        ("68,6 mm <= d", 8, "68,6 mm"),
        ("d_min>=5 cm", 5, "5 cm"),
        ("R_A*x - q*<x - a>^2", 10, ""),
    ],
)
def test_a_bound_is_asked_for_its_value(text: str, place: int, meant: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Quantity("mm").parse(text, Symbols(()))
    assert (refused.value.position, refused.value.proposal.meant) == (place, meant)


@pytest.mark.parametrize(
    "text",
    ["ok. 204 mm", "l3 = ok. 204 mm", "≈ około 204 mm", "ок. 204 мм", "Około 204", "w przybliżeniu 20,4 cm",
     "approx. 204 mm", "~204 mm", "204~mm", "$204\\,\\mathrm{mm}$", "l3: 204 mm", "Ø204 mm", "⌀ 204", "204.", "204 mm.",
     "about -(-204) mm", "408/2 = 204 mm", "= 204", r"ok. 20{,}4\,\mathrm{cm}", "204 [mm]", "∛(204^3) mm",
     "l3 := 204 mm", "Odp. 204 mm", "Odp.: l3 = 204 mm", "отв. 204 мм", "Ans.: 204",
     "204*mm", r"204\cdot\mathrm{mm}", "20,4·cm", "$$204$$", "$ 204 mm $"],
)  # fmt: skip
def test_what_says_nothing_of_an_amount_is_passed_over(text: str) -> None:
    assert Quantity("mm").parse(text, NOTHING).value == pytest.approx(0.204)


@pytest.mark.parametrize(
    "text",
    [
        "okno 204 mm",
        "ok.",
        "about",
        "l3: l3",
        "reakcja R 204",
        "2*x = 204",
        "x/2 = 204",
        "not 204",
        "odp 204",
        "odp.",
        "2 l3 := 204",
    ],
)
def test_what_may_say_something_is_not_passed_over(text: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        Quantity("mm").parse(text, NOTHING)


@pytest.mark.parametrize("text", [r"1,5 м\с", r"1,5 m\s", r"v = 1,5 м\сек", r"1500 mm\s", r"90 m\min"])
def test_a_backslash_between_units_is_a_stroke(text: str) -> None:
    assert Quantity("m/s").parse(text, NOTHING).value == pytest.approx(1.5)


@pytest.mark.parametrize("text", [r"1,5 \s", r"1,5\m", r"1,5 м\кс", r"\s"])
def test_another_backslash_is_a_command(text: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        Quantity("m/s").parse(text, NOTHING)


def test_a_colon_behind_pi_divides() -> None:
    assert Quantity("1").parse("π:4", NOTHING).value == pytest.approx(0.78539816)


@pytest.mark.parametrize("text", ["2,45 [-]", "2.45 [–]", "2,45"])
def test_a_dash_in_brackets_says_that_there_is_no_unit(text: str) -> None:
    amount = Quantity("1").parse(text, NOTHING)
    assert (amount.value, amount.unit) == (2.45, None)


@pytest.mark.parametrize(
    ("text", "degrees"),
    [("π/6", 30), ("-3*pi/4", -135), ("pi", 180), ("pi/2 - pi/3", 30), ("0,5*180/pi", 90 / 3.14159265359), ("30", 30),
     ("180 - pi/6", 179.4764012), ("1,14·10^1°", 11.4), ("1,14·10¹ °", 11.4), ("90'", 1.5), ("-1°30'", -1.5),
     ('5400"', 1.5)],
)  # fmt: skip
def test_an_angle_says_in_which_unit_it_is(text: str, degrees: float) -> None:
    assert Quantity("deg").parse(text, NOTHING).value == pytest.approx(degrees * 3.14159265359 / 180)


@pytest.mark.parametrize("text", ["-M3 = -900 N*m", "- M3 = -900", "+M3"])
def test_a_symbol_for_a_number_is_asked_for_its_value(text: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Quantity("N*m").parse(text, NOTHING)
    assert refused.value.reason is Reason.NOT_A_NUMBER


@pytest.mark.parametrize(
    "words",
    [
        "w górę",
        "w dół.",
        "do góry",
        "w prawo",
        "up",
        "downwards",
        "(down)",
        "to the left",
        "вверх",
        "ВНИЗ",
        "↑",
        "clockwise",
    ],
)
def test_a_direction_is_asked_for_as_a_sign(words: str) -> None:
    for amount in ("12 MPa ", "sigma = 12 ", "-12,5 "):
        with pytest.raises(AnswerSyntaxError) as told:
            STRESS.parse(amount + words, NOTHING)
        assert told.value.reason is Reason.DIRECTION and told.value.position == len(amount) + words.startswith("(")
        assert told.value.proposal.found == words.strip("().")


ANGLE, LENGTH = Quantity("deg"), Quantity("mm")


@pytest.mark.parametrize(
    ("field", "text", "value"),
    [
        (ANGLE, "-0,01364 rad = -0,78°", -0.01364),
        (ANGLE, "-0,78° = -0,01364 rad", -0.01364),
        (LENGTH, "0,5 m = 502 mm", 0.502),
        (LENGTH, "l = 0,502 m", 0.502),
        (STRESS, "12 MPa=12,0 N/mm^2", 12e6),
        (LENGTH, "(1/4) m = 250 mm", 0.25),
        (LENGTH, "0 m = 0 mm", 0.0),
        (LENGTH, "0,5 m ≈ 502 mm", 0.502),
        (LENGTH, "l = 0,5 m = 502 mm", 0.502),
        (LENGTH, "l = 0,5021 m = 502 mm", 0.5021),
        (LENGTH, "l = 500 mm = 0,50 m = 50,0 cm", 0.5),
        (LENGTH, "l = 12,34 = 12,3", 0.01234),
        (ANGLE, "alpha2 = 0,78 = 45°", pi / 4),
        (LENGTH, "l = 0,5 = 500 mm", 0.5),
        (LENGTH, "l = 2*250 = 501", 0.501),
        (LENGTH, "l = 2*0,25 m = 501 mm", 0.501),
    ],
)
def test_one_value_in_two_units_is_read_to_the_more_figures(field: Quantity, text: str, value: float) -> None:
    assert field.parse(text, NOTHING).value == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("field", "text", "told"),
    [
        (ANGLE, "-0,01364 rad = 0,78°", "-0,01364 rad ≠ 0,78°"),
        (ANGLE, "-0,01364 rad = -0,80°", "-0,01364 rad ≠ -0,80°"),
        (LENGTH, "0,50 m = 510 mm", "0,50 m ≠ 510 mm"),
        (STRESS, "12 Pa = 12 N", "12 Pa ≠ 12 N"),
        (LENGTH, "5 mm = 6 mm", "5 mm ≠ 6 mm"),
        (LENGTH, "0,5 m ≈ 610 mm", "0,5 m ≠ 610 mm"),
        (LENGTH, "l = 0,5 m = 610 mm", "0,5 m ≠ 610 mm"),
        (LENGTH, "l = 0,50 m = 510 mm", "0,50 m ≠ 510 mm"),
        (LENGTH, "l = 500 mm = 0,5 m = 51 cm", "500 mm ≠ 51 cm"),
        (LENGTH, "l = 500 = 510", "500 ≠ 510"),
        (LENGTH, "l = -500 mm = 0,5 m", "-500 mm ≠ 0,5 m"),
    ],
)
def test_two_values_that_differ_are_both_named(field: Quantity, text: str, told: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        field.parse(text, NOTHING)
    assert (refused.value.reason, refused.value.proposal.found) == (Reason.TWO_VALUES, told)
    assert refused.value.position == max(text.rfind("="), text.rfind("≈"))


def test_what_looks_like_a_unit_but_is_a_symbol_here_tells_no_other_value() -> None:
    assert LENGTH.parse("d = 20 m = 40 mm", Symbols(("m",))).value == pytest.approx(0.04)
    with pytest.raises(AnswerSyntaxError, match="20 m ≠ 40 mm"):
        LENGTH.parse("d = 20 m = 40 mm", Symbols(("z",)))


def test_latex_that_tells_two_values_is_refused_with_both() -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        LENGTH.parse(r"l = 0{,}5\,\mathrm{m} = 610\,\mathrm{mm}", NOTHING)
    assert refused.value.reason is Reason.TWO_VALUES


@pytest.mark.parametrize("text", ["4\n" * 20_000, "5 " * 20_000, "1~k" * 15_000, "(" * 20_000 + "5"])
def test_a_text_that_is_too_long_is_refused_before_it_is_looked_through(text: str) -> None:
    def refused() -> None:
        with pytest.raises(AnswerSyntaxError, match="too_long"):
            STRESS.parse(text, NOTHING)

    refused()
    assert calls(refused) < 100
    assert effort(refused, enough=1e-3) < 1e-3
