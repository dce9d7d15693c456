"""Long texts that repeat one thing: letters, names, units, brackets, signs, chains, commands, lines.

What costs as the square of the length, or looks for what may have been meant at every letter, shows in one of them.
"""

from __future__ import annotations

from collections.abc import Iterator

LONGEST = 1990  # characters: as long as a formula may be
LETTERS = ["a", "l", "q", "m", "é", "Ж", "ω", "ẋ", "a\u0307", "ab", "ac", "qa", "mm", "kN", "sin", "cos", "tgx", "arc"]
NAMES = ["l1", "x_", "x_1", "alpha1", "l1ω1", "cosα1", "ₐ", "ω₁", "x'", "a1", "1a", "2ac", "log_2", "stopni", "qwerty"]
WORDS = [
    "l2 ",
    "l1 l2 ",
    "a b ",
    "sin ",
    "sin x ",
    "deg ",
    "30 deg ",
    "1 1/2 ",
    "1 000 ",
    "x 10^",
    "o długości ",
    "pi ",
]
UNITS = [
    "N·m ",
    "mm*",
    "mm/",
    "m^2",
    "kN m ",
    "(m",
    "m)",
    "1/s ",
    "5 mm ",
    "5 mm; ",
    "Mpa ",
    "obr/min ",
    "кН",
    "об/мин ",
]
BRACKETS = [
    "(",
    "((",
    "[",
    "[[",
    "|",
    "<",
    "√",
    "(-",
    "|-",
    "<-",
    "{",
    "sin(",
    "|a",
    "a(",
    "√(",
    "exp(-",
    "max(1;",
    "log_2(",
]
CLOSED = ["(x)", "<x>", "|a|", "[a]", "];[", "[a;", "[1, ", "(1;2);", "<a>^1", "()", ")(", "max(a;b)", "[[1]]", "{1,2}"]
SIGNS = [
    "-",
    "+",
    "*",
    "/",
    "^",
    "**",
    "°",
    "'",
    '"',
    "%",
    "!",
    ",",
    ";",
    "..",
    ":",
    "=",
    "²",
    "⁻¹",
    "½",
    "·",
    "\t",
    "٣",
]
NUMBERS = [
    "1",
    "1.",
    "1,",
    "1;",
    "1e",
    "1e9",
    "1e-9,",
    "0",
    "3/4 ",
    "-4:1 ",
    "1°",
    "1°1'",
    "1°1'1\"",
    "a^2",
    "a^",
    "^-",
    "2^",
]
CHAINS = [
    "x<",
    "x>",
    "l2= ",
    "l2>= ",
    "x ≤ ",
    "a = b, ",
    "1 < x < ",
    "x = 1; ",
    "1 .. 2: ",
    "0 .. x: x; ",
    "a/b/",
    "a-b+",
]
LATEX = [
    r"\frac", r"\frac{", r"\frac{a}{", r"\frac{a}{b}", r"\sqrt", r"\sqrt[", r"\sqrt{", r"\left(", r"\left|", r"\right)",
    r"\cdot ", r"\mathrm{", r"\mathrm{a}", r"\dot{", r"\dot x", r"\alpha", r"\alpha_1", r"\operatorname{sin}", r"\,",
    r"\begin{bmatrix}", r"\begin{bmatrix}a", r"a\\", "a&", "^{", "^{a", "_{", "{,}", "1{,}", "a{=}", "a_{1}",
    r"1\times10^{2}", r"\left[a\right]", r"\text{a}", "\\", r"\quad", "a^{2}", r"\left\langle x\right\rangle^", "a'",
    r"\sin\left(",
]  # fmt: skip
LINES = [
    "\n", "a\n", "a=\n", "a: ", "a: b\n", "x: a\n", "x: a = b; ", "closure: a\n", "l1: A > B\n", "A > B, ",
    "length l1, ", "unknowns: a\n", "l: A > B, length l, angle a\n", "1 .. 2: x\n", "t;x\n", "1;2;3\n", "1;", "a; b; ",
]  # fmt: skip
FRONT_AND_BACK = (("", ""), ("5 ", " mm"), ("l2 = ", ""), ("", " = l2"), ("(", ")"))


def families() -> Iterator[str]:
    """Give each repeated thing as often as a text may hold it, once bare and once with something around it."""
    things = [*LETTERS, *NAMES, *WORDS, *UNITS, *BRACKETS, *CLOSED, *SIGNS, *NUMBERS, *CHAINS, *LATEX, *LINES]
    for at, thing in enumerate(things):
        for front, back in (FRONT_AND_BACK[0], FRONT_AND_BACK[1 + at % 4]):
            yield front + thing * ((LONGEST - 10) // len(thing)) + back
        if "\\" in thing or "\n" in thing:  # LaTeX and lines may be longer
            yield thing * (2 * LONGEST // len(thing))
