"""LaTeX as MathLive and MathQuill write it: the same tree as the text, errors with the place in the LaTeX."""

from __future__ import annotations

import pytest

from graders import Code, Integer, Quantity
from graders.language import AnswerSyntaxError, Reason, Symbols, parse
from graders.language.latex import latex_of
from graders.language.latex_reader import MAX_LATEX, rewritten
from graders.language.latex_source import is_latex
from graders.language.text import text_of

DECLARED = Symbols(
    [
        "l1",
        "l2",
        "alpha1",
        "omega1",
        "x",
        "a",
        "b",
        "c",
        "R_A",
        "F",
        "q",
        "k_adm",
        "phi_d",
        "phi1_d",
        "x_dd",
        "y_d",
        "T",
    ]
)
NOTHING = Symbols(())


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"\frac{a}{b}", "a/b"),
        (r"\dfrac{l_{1}}{l_2}", "l1/l2"),
        (r"\tfrac ab", "a/b"),
        (r"\frac12x", "(1/2) x"),
        (r"\frac{a+b}{2c}", "(a+b)/(2 c)"),
        (r"\sqrt{x}", "sqrt(x)"),
        (r"\sqrt2", "sqrt(2)"),
        (r"\sqrt[3]{x}", "root(x; 3)"),
        (r"\sqrt[a]{x}", "root(x; a)"),
        (r"\left(a+b\right)\left(a-b\right)", "(a+b) (a-b)"),
        (r"\mleft(a\mright)", "a"),
        (r"3{,}5x", "3.5 x"),
        (r"3,5\,x", "3.5 x"),
        (r"a\cdot b\times c", "a*b*c"),
        (r"a\div b", "a/b"),
        (r"\mathrm{R}_{A}+\mathit{R}_A", "R_A + R_A"),
        (r"\operatorname{arctg}\left(x\right)", "atan(x)"),
        (r"\operatorname{atan2}\left(a;b\right)", "atan2(a; b)"),
        (r"\arcsin x", "asin(x)"),
        (r"\sin^2\alpha_{1}", "sin(alpha1)^2"),
        (r"\sin^{2}\left(\alpha_1\right)", "sin(alpha1)^2"),
        (r"\sin\left(\alpha_1\right)", "sin(alpha1)"),
        (r"\sin\alpha_1", "sin(alpha1)"),
        (r"\tg\alpha_1+\ctg x", "tan(alpha1) + cot(x)"),
        (r"-l_{1}\omega_{1}\sin\left(\alpha_{1}\right)", "-l1 omega1 sin(alpha1)"),
        (r"xl_{1}", "x l1"),
        (r"x^{2}", "x^2"),
        (r"x^{-1}", "x^(-1)"),
        ("k_{adm}", "k_adm"),
        (r"k_{\mathrm{adm}}", "k_adm"),
        (r"k_{\text{adm}}^2", "k_adm^2"),
        (r"\dot{\varphi}", "phi_d"),
        (r"\dot\varphi x", "phi_d x"),
        (r"\dot{\varphi}_{1}", "phi1_d"),
        (r"\dot{\varphi_1}", "phi1_d"),
        (r"\ddot{x}", "x_dd"),
        (r"y'", "y_d"),
        (r"y^{\prime}+\pi", "y_d + pi"),
        (r"x''\cdot a", "x_dd*a"),
        (r"30\degree", "30°"),
        (r"\sin30^{\circ}", "sin(30°)"),
        (r"12^{\circ}22'12''", "12°22'12\""),
        (r"12^\circ22^{\prime}", "12°22'"),
        (r"\begin{bmatrix}1 & 0\\ 0{,}5 & a\end{bmatrix}", "[[1; 0], [0,5; a]]"),
        (r"\begin{pmatrix}\frac{1}{2}\\ x\end{pmatrix}", "[[1/2], [x]]"),
        (r"\left[\begin{matrix}1 & 0\\ 0 & a\end{matrix}\right]", "[[1; 0], [0; a]]"),
        (r"\left[\begin{array}{c|c}1 & 0\\ 0 & a\end{array}\right]", "[[1; 0], [0; a]]"),
        (r"alpha_{1}+x^{2}", "alpha1 + x^2"),
        (r"\left|x-a\right|", "abs(x - a)"),
        (r"F\left\langle x-a\right\rangle^{1}", "F <x - a>^1"),
        (r"\left\langle x-a\right\rangle", "<x - a>"),
        (r"\left\langle x-a\right\rangle^{-2}", "<x - a>^-2"),
        (r"1.5\times10^{-3}", "1.5e-3"),
        (r"1{,}5\times 10^3x", "1,5e3 x"),
        (r"a/2\times10^{3}", "a/2*10^3"),
        (r"2\cdot10^{3}", "2*10^3"),
        (r"a\times b", "a*b"),
        (r"2\times 10x", "2*10 x"),
        (r"2\times 10^{a}", "2*10^a"),
        (r"a\le x<b", "a <= x < b"),
        (r"a\geq b", "a >= b"),
        (r"\log_{2}\left(8\right)", "log(8; 2)"),
        (r"\log_2 8", "log(8; 2)"),
        (r"T_{1,2}", "T[1; 2]"),
        (r"{T}_{1,2}", "T[1; 2]"),
        (r"\left[a+b\right]c", "(a+b) c"),
        (r"{a+b}\cdot c", "(a+b)*c"),
        (r"\pi~b", "pi b"),
        (r"\displaystyle a\quad b", "a b"),
        (r"\exp\left(x\right)", "exp(x)"),
        (r"2\,\frac{1}{2}", "2 (1/2)"),
        (r"x^{\frac12}", "x^(1/2)"),
        (r"\vert x\vert", "|x|"),
    ],
)
def test_a_formula_editor_and_a_hand_write_the_same_tree(latex: str, text: str) -> None:
    assert parse(latex, DECLARED) == parse(text, DECLARED)


@pytest.mark.parametrize(
    ("latex", "reason", "place"),
    [
        (r"\placeholder{}+1", Reason.EMPTY_BOX, 0),
        (r"a+\frac{a}{\placeholder{}}", Reason.EMPTY_BOX, 11),
        (r"\frac{}{2}", Reason.EMPTY_BOX, 5),
        (r"\frac{a}", Reason.EMPTY_BOX, 8),
        (r"a^{}", Reason.EMPTY_BOX, 2),
        (r"\sqrt", Reason.EMPTY_BOX, 5),
        (r"\sqrt{}", Reason.EMPTY_BOX, 5),
        (r"a+\int x", Reason.UNKNOWN_NAME, 2),
        (r"a+\frac{q7}{2}", Reason.UNKNOWN_NAME, 8),
        (r"2\frac{1}{2}", Reason.MIXED_NUMBER, 1),
        (r"\left(x", Reason.NEEDS_BRACKET, 7),
        (r"\left(x\right]", Reason.EXTRA_BRACKET, 13),
        (r"\left\{x\right\}", Reason.BAD_CHARACTER, 5),
        (r"\left", Reason.BAD_CHARACTER, 5),
        (r"x\right)", Reason.EXTRA_BRACKET, 1),
        (r"x\\a", Reason.EXTRA_BRACKET, 1),
        (r"\pi}", Reason.EXTRA_BRACKET, 3),
        (r"\sqrt[3{x}", Reason.NEEDS_BRACKET, 10),
        (r"\sqrt{x", Reason.NEEDS_BRACKET, 7),
        (r"\begin{cases}x\end{cases}", Reason.UNKNOWN_NAME, 6),
        (r"\begin{bmatrix}x", Reason.NEEDS_BRACKET, 16),
        (r"\begin{bmatrix}x\end{pmatrix}", Reason.EXTRA_BRACKET, 16),
        (r"\begin{bmatrix}1&2\\3\end{bmatrix}", Reason.RAGGED_MATRIX, 0),
        (r"\dot{x+1}", Reason.BAD_CHARACTER, 0),
        (r"x_{a+1}", Reason.BAD_CHARACTER, 2),
        (r"\left(x\right)_a", Reason.BAD_CHARACTER, 14),
        (r"\sin^{-1}\left(x\right)", Reason.INVERSE_OR_RECIPROCAL, 0),
        (r"a+\exponentialE^{x}", Reason.UNKNOWN_NAME, 2),
        ("\\", Reason.BAD_CHARACTER, 0),
        (r"\," * 3, Reason.EMPTY, 0),
        (r"\sqrt" * 100 + "x", Reason.TOO_DEEP, 300),
        ("\\" + "a" * MAX_LATEX, Reason.TOO_LONG, MAX_LATEX),
        (r"\alpha " * 800, Reason.TOO_LONG, 5600),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_place_in_the_latex(latex: str, reason: Reason, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        parse(latex, DECLARED)
    assert refused.value.reason is reason
    assert refused.value.position == place or reason is Reason.TOO_LONG


@pytest.mark.parametrize(
    ("unit", "reference", "latex"),
    [
        ("MPa", 12.5e6, r"12{,}5\,\mathrm{MPa}"),
        ("MPa", 12.5e6, r"12.5\,\frac{\mathrm{N}}{\mathrm{mm}^{2}}"),
        ("MPa", 12.5e6, r"\sigma=1{,}25\cdot10^{7}\ \text{Pa}"),
        ("MPa", 12.5e6, r"1{,}25\times10^7\,\mathrm{N/m^2}"),
        ("deg", 0.5235987756, r"30^{\circ}"),
        ("deg", 0.5235987756, r"30\degree"),
        ("N*m", 25.0, r"25\,\mathrm{N\cdot m}"),
        ("N", 12500.0, r"12\,500\,\mathrm{N}"),
        ("kN", 12500.0, r"\frac{25}{2}"),
        ("m/s", 5.0, r"5\mathrm{\frac{m}{s}}"),
        ("rad/s", 0.27, r"0{,}27\,\frac{1}{\mathrm{s}}"),
        ("rad/s", 0.27, r"\frac{27}{100}\frac{1}{s}"),
    ],
)
def test_an_amount_from_a_formula_editor_is_right(unit: str, reference: float, latex: str) -> None:
    judge = Quantity(unit)
    answer = judge.parse(latex, NOTHING)
    assert judge.check(answer, reference).code is Code.RIGHT
    assert "\\" not in (judge.echo(answer).unit or "") and " " not in (judge.echo(answer).unit or "")


def test_a_whole_number_from_a_formula_editor_is_read() -> None:
    assert Integer().parse(r"z_{3}=45", NOTHING) == 45


@pytest.mark.parametrize("text", ["x^2", "12,5 kN", "{12,5}", "a{x}", "l_1"])
def test_text_without_commands_is_no_latex(text: str) -> None:
    assert not is_latex(text)


def test_every_character_keeps_its_place() -> None:
    latex = r"\frac{a}{\sqrt{x}}"
    plain = rewritten(latex)
    assert len(plain.places) == len(plain.text) + 1
    assert all(latex[plain.places[at]] == char for at, char in enumerate(plain.text) if char in "ax")


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        ("-l1*omega1*cos(alpha1)", r"-l_{1} \cdot \omega_{1} \cdot \cos\left(\alpha_{1}\right)"),
        ("(a+b)/2", r"\frac{a + b}{2}"),
        ("sin(x)^2", r"\sin^{2}\left(x\right)"),
        ("asin(x)/root(x; 3)", r"\frac{\arcsin\left(x\right)}{\sqrt[3]{x}}"),
        ("1.5e-3", r"1{,}5 \times 10^{-3}"),
        ("phi1_d*x_dd*y_d", r"\dot{\phi}_{1} \cdot \ddot{x} \cdot \dot{y}"),
        ("a*(-b)", r"a \cdot \left(-b\right)"),
        ("2 (3)^2", r"2 \, \left(3^{2}\right)"),
        ("F*<x-a>^1", r"F \cdot \left\langle x - a \right\rangle^{1}"),
        ("k_adm <= |x|", r"k_{\mathrm{adm}} \le \left|x\right|"),
        ("T[1; 2]", r"{T}_{1,2}"),
        ("(a/b)^2", r"\left(\frac{a}{b}\right)^{2}"),
    ],
)
def test_latex_is_written_as_a_book_prints_it(text: str, latex: str) -> None:
    assert latex_of(parse(text, DECLARED), comma=True) == latex


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"\frac{qL^{4}}{8EI}", "q L^4/(8 E I)"),
        (r"EIy\cdot 2", "E I y*2"),
        (r"abx+\sqrt{a}", "ab x + sqrt(a)"),
        (r"-\frac{1}{2}ax^{2}", "-(1/2) a x^2"),
    ],
)
def test_letters_of_an_editor_are_declared_names_side_by_side(latex: str, text: str) -> None:
    symbols = Symbols(["E", "I", "q", "L", "x", "y", "a", "b", "ab"])
    assert text_of(parse(latex, symbols)) == text


@pytest.mark.parametrize("latex", [r"\mathrm{EI}x", r"\frac{1}{EJ}", r"\operatorname{EI}+1"])
def test_upright_letters_and_what_is_left_over_are_asked_about(latex: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        parse(latex, Symbols(["E", "I", "x"]))
    assert refused.value.reason is Reason.UNKNOWN_NAME
