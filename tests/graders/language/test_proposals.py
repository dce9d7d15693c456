"""What may have been meant, what was read otherwise than typed, and how both are told in three languages."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exercises.grading import preview
from exercises.variants import deal
from graders import AnswerSyntaxError, Echo, Quantity, Symbols
from graders.language import Reason, parse
from graders.language.notes import Note, notes_of
from graders.language.proposals import nearest, slips_between, spellings
from graders.units import read_unit
from graders.verdict import unreadable
from graders.words import LANGUAGES, message, noted

DECLARED = Symbols(["a", "c", "x", "l1", "l2", "alpha1", "omega1", "R_A", "x_d", "x_dd", "F"], ["v3"])
NOTHING = Symbols(())
letters = st.text("abc", max_size=6)


@pytest.mark.parametrize(
    ("typed", "reason", "place", "found", "meant"),
    [
        ("ac(x+1)", Reason.UNKNOWN_NAME, 0, "ac", "a·c·(x+1)"),
        ("2ac", Reason.UNKNOWN_NAME, 1, "ac", "a·c"),
        ("x/(ac)+x(a)", Reason.UNKNOWN_NAME, 3, "ac", "a·c"),
        ("sin30", Reason.UNKNOWN_NAME, 0, "sin30", "sin(30)"),
        ("tgx", Reason.UNKNOWN_NAME, 0, "tgx", "tan(x)"),
        ("tgx(a+c)", Reason.UNKNOWN_NAME, 0, "tgx", "tan(x)·(a+c)"),
        ("xtg(a)", Reason.UNKNOWN_NAME, 0, "xtg", "x·tan(a)"),
        ("sinn(x)", Reason.UNKNOWN_NAME, 0, "sinn", "sin"),
        ("arktg(x)", Reason.UNKNOWN_NAME, 0, "arktg", "arctg"),
        ("apha1", Reason.UNKNOWN_NAME, 0, "apha1", "alpha1"),
        ("alhpa1 + 1", Reason.UNKNOWN_NAME, 0, "alhpa1", "alpha1"),
        ("1 + L1", Reason.UNKNOWN_NAME, 4, "L1", "l1"),
        ("R_B", Reason.UNKNOWN_NAME, 0, "R_B", "R_A"),
        ("q", Reason.UNKNOWN_NAME, 0, "q", ""),
        ("qqqqqqqq", Reason.UNKNOWN_NAME, 0, "qqqqqqqq", ""),
        ("q" * 60, Reason.UNKNOWN_NAME, 0, "q" * 60, ""),
        ("e^x", Reason.UNKNOWN_NAME, 0, "e", "exp()"),
        ("a*sec(x)", Reason.UNKNOWN_NAME, 2, "sec", "1/cos()"),
        ("½*x", Reason.UNKNOWN_NAME, 0, "½", "1/2"),
        ("grad", Reason.UNKNOWN_NAME, 0, "grad", "°"),
        ("30*deg", Reason.UNKNOWN_NAME, 3, "deg", "°"),
        ("Вa", Reason.LOOK_ALIKE, 0, "В", "B"),
        ("(a + x", Reason.NEEDS_BRACKET, 6, ")", ""),
        ("[a; x", Reason.NEEDS_BRACKET, 5, "]", ""),
        ("|a + x", Reason.NEEDS_BRACKET, 6, "|", ""),
        ("(a + x]", Reason.EXTRA_BRACKET, 6, "]", ")"),
        ("x 2", Reason.NEEDS_OPERATOR, 2, "2", "x·2"),
        ("(a) 2", Reason.NEEDS_OPERATOR, 4, "2", ")·2"),
        ("2 1/2", Reason.MIXED_NUMBER, 2, "1/2", "2+1/2"),
        ("sin^-1 x", Reason.INVERSE_OR_RECIPROCAL, 0, "sin", "asin"),
        ("a*/c", Reason.NEEDS_OPERAND, 2, "/", ""),
    ],
)
def test_an_error_names_its_place_and_what_may_be_meant(
    typed: str, reason: Reason, place: int, found: str, meant: str
) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        parse(typed, DECLARED)
    error = refused.value
    assert (error.reason, error.position) == (reason, place)
    assert (error.proposal.found, error.proposal.meant) == (found, meant)


@pytest.mark.parametrize(
    ("typed", "place", "meant"),
    [
        ("5 KN", 2, "kN"),
        ("5 Mpa", 2, "MPa"),
        ("5 kNN", 2, "kN"),
        ("5 NM", 2, "Nm"),
        ("5 Kg", 2, "kg"),
        ("5 obr/mni", 6, "min"),
        ("5 radd/s", 2, "rad"),
        ("5 parsek", 2, ""),
        ("5 q", 2, ""),
    ],
)
def test_an_unknown_unit_is_told_with_the_nearest_one(typed: str, place: int, meant: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Quantity("kN").parse(typed, NOTHING)
    error = refused.value
    assert (error.reason, error.position, error.proposal.meant) == (Reason.UNKNOWN_UNIT, place, meant)


def test_what_is_proposed_for_a_unit_is_one() -> None:
    for typed in ("KN", "Mpa", "NM", "mni", "radd"):
        with pytest.raises(AnswerSyntaxError) as refused:
            read_unit(typed)
        assert read_unit(refused.value.proposal.meant).factor > 0


def full(one: str, other: str) -> int:
    return slips_between(one, other, 12)


@given(letters, letters, letters)
def test_slips_are_counted_as_a_distance(one: str, other: str, third: str) -> None:
    assert full(one, other) == full(other, one)
    assert (full(one, other) == 0) == (one == other)
    assert abs(len(one) - len(other)) <= full(one, other) <= max(len(one), len(other))
    assert full(one + "x", other + "x") <= full(one, other)
    assert full(third + one, third + other) <= full(one, other)


@given(letters, letters, st.integers(0, 4))
def test_slips_are_counted_as_far_as_asked(one: str, other: str, most: int) -> None:
    assert min(slips_between(one, other, most), most + 1) == min(full(one, other), most + 1)


@pytest.mark.parametrize(
    ("one", "other", "slips"),
    [("ab", "ba", 1), ("alpha", "alhpa", 1), ("sin", "sinn", 1), ("kN", "kNm", 1), ("abc", "", 3), ("abcd", "badc", 2)],
)
def test_letters_exchanged_with_a_neighbour_are_one_slip(one: str, other: str, slips: int) -> None:
    assert full(one, other) == slips
    assert slips_between(one, other, 2) == slips


@given(st.text("abAB", min_size=1, max_size=6), st.lists(st.text("abABc", min_size=1, max_size=6), max_size=8))
def test_no_spelling_that_is_near_is_left_out(typed: str, known: list[str]) -> None:
    slips = 0 if len(typed) < 2 else 1 if len(typed) < 5 else 2
    near = [s for s in known if s.lower() == typed.lower() or 0 < full(typed, s) <= min(slips, len(s) - 1)]
    assert nearest(typed, spellings({name: name for name in known})) in (near or [""])


def test_another_case_is_nearer_than_another_letter() -> None:
    assert nearest("mpa", spellings({"Mpo": "o", "MPa": "p"})) == "p"


@pytest.mark.parametrize(
    ("typed", "notes"),
    [
        ("tg(x) + tg(a)", (Note("function", "tg", "tan"),)),
        ("arctg x·ctg(a)", (Note("function", "arctg", "atan"), Note("function", "ctg", "cot"))),
        ("l1·соs(x)", (Note("letter", "с", "c"), Note("letter", "о", "o"))),
        ("а + x", (Note("letter", "а", "a"),)),
        ("sin(alfa1) + ω1 + α₁", ()),
        ("a + x + q", ()),
        ("a ~ x", ()),
        (r"\tg\left(x\right)", (Note("function", "tg", "tan"),)),
        ("sh(x) + ch(x) + th(x) + tg(x)", tuple(Note("function", f"{a}h", f"{m}h") for a, m in ("ss", "cc", "tt"))),
    ],
)
def test_what_was_read_otherwise_than_typed_is_noted(typed: str, notes: tuple[Note, ...]) -> None:
    found = notes_of(typed, DECLARED)
    meant = {"s": "sin", "c": "cos", "t": "tan"}
    expected = tuple(
        Note(n.kind, n.found, meant[n.meant[0]] + "h") if n.meant in ("sh", "ch", "th") else n for n in notes
    )
    assert found == expected


@pytest.mark.parametrize("lang", LANGUAGES)
def test_notes_and_proposals_are_worded(lang: str) -> None:
    note = noted(notes_of("tg(x) + а", DECLARED), lang)
    assert "tg" in note and "tan" in note and "а" in note and "{" not in note
    assert noted((), lang) == ""
    for typed in ("ac(x+1)", "(a", "x 2", "2 1/2", r"\frac{}{a}", "Вa"):
        with pytest.raises(AnswerSyntaxError) as refused:
            parse(typed, DECLARED)
        text = message(unreadable(refused.value), lang)
        assert "{" not in text.replace("{}", "")
        assert (refused.value.proposal.meant or refused.value.proposal.found) in text or typed.startswith("\\")


def test_a_preview_says_what_was_read_otherwise() -> None:
    shown = preview(deal("slider_crank", 7), "omega2_formula", "l1*tg(α1)")
    assert isinstance(shown, Echo)
    assert shown.notes == (Note("function", "tg", "tan"),)


@pytest.mark.parametrize("typed", ["x_d", "ẋ", "x'", "x_dot", "xdot", r"\dot{x}", "ẋ"])
def test_a_rate_is_typed_with_a_dot_a_prime_or_a_word(typed: str) -> None:
    if typed == "xdot":
        with pytest.raises(AnswerSyntaxError):
            parse(typed, DECLARED)
    else:
        assert parse(typed, DECLARED) == parse("x_d", DECLARED)


@pytest.mark.parametrize("typed", ["x_dd", "ẍ", "x''", "x_ddot", r"\ddot{x}"])
def test_a_second_rate_is_typed_with_two(typed: str) -> None:
    assert parse(typed, DECLARED) == parse("x_dd", DECLARED)


def test_a_prime_means_no_rate_that_is_not_declared() -> None:
    with pytest.raises(AnswerSyntaxError):
        parse("a'", DECLARED)


@pytest.mark.parametrize(
    ("typed", "meant"), [("w1", "omega1"), ("w_1", "omega1"), ("eps1", "epsilon1"), ("al2", "alpha2")]
)
def test_a_letter_that_sounds_or_looks_so_is_told_with_the_greek_name(typed: str, meant: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        parse(f"2*{typed}", Symbols(["omega1", "epsilon1", "alpha2", "l1"]))
    assert refused.value.proposal.meant == meant
