"""A8: look-alike, invisible and foreign characters are mapped or refused by name; superscripts are never flattened."""

from __future__ import annotations

import pytest

from graders import Choice, Code, Integer, Quantity, Symbols
from graders.language import AnswerSyntaxError, Reason, parse
from graders.verdict import Reading
from tests.security.conftest import Attack

INVISIBLE = "\u202e\u202a\u2066\u200b\u200c\u200d\u2060\ufeff\u00ad\u0000\u0007\u001b\ud800\udfff\ue000\U000e0041\u061c"
FOREIGN = "٣۳३๓߃٫"
NAMES = Symbols(["a", "x", "l1", "alpha1"])
NOTHING = Symbols(())


@pytest.mark.parametrize("char", [*INVISIBLE, *FOREIGN])
@pytest.mark.parametrize("answer", ["omega2_formula", "l3"])
def test_a_character_nobody_sees_or_types_is_refused_by_name(attack: Attack, char: str, answer: str) -> None:
    verdict = attack(f"1{char}2", answer)
    assert verdict.code is Code.UNREADABLE
    assert isinstance(verdict.details, Reading)
    assert (verdict.details.reason, verdict.details.position) == (Reason.BAD_CHARACTER, 1)
    assert verdict.details.proposal.found in (f"U+{ord(char):04X}", char)


@pytest.mark.parametrize("char", INVISIBLE)
def test_an_invisible_character_makes_no_whole_number(char: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        Integer().parse(f"4{char}5", NOTHING)
    with pytest.raises(AnswerSyntaxError):
        Choice(("a", "b")).parse(f"{char}a", NOTHING)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("а*х", "a*x"),
        ("ａ＊ｘ", "a*x"),
        ("（a＋x）", "(a+x)"),
        ("a − x", "a-x"),
        ("a∕x", "a/x"),
        ("α₁", "alpha1"),
        ("l₁", "l1"),
    ],
)
def test_a_look_alike_is_mapped_where_it_is_certain(typed: str, meant: str) -> None:
    assert parse(typed, NAMES) == parse(meant, NAMES)


@pytest.mark.parametrize("typed", ["12²", "1²2", "12³", "1⁰5", "²5", "5₂", "1₂", "½", "①", "Ⅻ", "㎜"])
def test_raised_figures_are_never_flattened(typed: str) -> None:
    try:
        value = Quantity("mm").parse(typed, NOTHING).number
    except AnswerSyntaxError:
        return
    assert (typed, value) in [("12²", 144.0), ("12³", 1728.0)]


@pytest.mark.parametrize("typed", ["a\u0338", "a\u0301x", "x\u20dd", "\u0307a", "a\u0336"])
def test_a_combining_mark_is_not_dropped(typed: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        parse(typed, NAMES)


def test_a_letter_of_another_alphabet_is_named_with_what_is_meant() -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        parse("1 + Вa2", NAMES)
    assert (refused.value.reason, refused.value.position) == (Reason.LOOK_ALIKE, 4)
    assert refused.value.proposal.meant == "B"
