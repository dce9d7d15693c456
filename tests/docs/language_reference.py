"""Writes `docs/reference/language.md` from the code: ``uv run python -m tests.docs.language_reference``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from graders import KINDS, Quantity, Symbols, units
from graders.kinds import rational, text
from graders.language import cursor, latex_reader, parse, parser, tokens
from graders.language.commands import ACCENTS, ENVIRONMENTS, LETTERS, SIGNS, UPRIGHT, WORDS
from graders.language.errors import Reason
from graders.language.symbols import ALIASES, FUNCTIONS, GREEK, LOOK_ALIKES, SUPERSCRIPTS
from graders.language.symbols import LETTERS as LETTER_NAMES
from graders.language.text import text_of
from graders.unit_words import FORMS, WHOLE
from graders.words import locale

ROOT = Path(__file__).parents[2]
WORDED = FORMS | WHOLE
PAGE = ROOT / "docs" / "reference" / "language.md"
SYMBOLS = Symbols(["l1", "l2", "alpha1", "omega1", "R_A", "F", "x", "a", "b", "phi1_d", "y_d"])
EXAMPLES = (
    "-l1*ω1*sin(α1)", "2 l₁ sin α1", "l_1·cos(alfa1)", "sin²(α1) + cos^2 α1", "tg α1", "1/2 a x²", "3,5·10^-2 x",
    "√(a² + x²)", "|a − x|", "R_A*x - F<x-a>^1", "12°22'12\" + 30 deg", "[(a + b)*x]*2", "atan2(a; 0,5)", "log_2(8)",
    "0 < x <= a", "[[1; 0], [0; 0,5]]", r"\frac{l_{1}}{\sqrt[3]{x}}",
    r"\dot{\varphi}_{1}\,\sin^{2}\left(\alpha_{1}\right)",
    "y'", r"1{,}5\times10^{-3}",
)  # fmt: skip
AMOUNTS = (
    "12,5",
    "12,5 MPa",
    "12 500 N",
    "25/2",
    "1.25e4 N",
    "1,25 x 10^4 N",
    "R_A = 12,5 [kN]",
    "12,5 кН",
    "12,5 kN = 12 500 N",
)
HEAD = """# The answer language

This page is written from the code by `uv run python -m tests.docs.language_reference`; a test compares the two.

Everything a student types is read by one small grammar of our own. Nothing typed ever reaches an evaluator. Only the
symbols shown at the field exist; what is not declared is asked about, never guessed. An answer that cannot be read is
no wrong answer: the message names the character (counted from 1; from 0 in the API) and, where it can, what was meant.

## Grammar

```ebnf
answer   = sum { ( "=" | "<" | ">" | "<=" | ">=" ) sum } ;            (* a chain: 0 < x <= a *)
sum      = product { ( "+" | "-" ) product } ;
product  = signed { ( "*" | "/" ) signed | power } ;                  (* no sign between: a product *)
signed   = ( "+" | "-" ) signed | power ;
power    = postfix [ "^" signed | raised ] ;                          (* 2^3^2 is 2^(3^2), -x^2 is -(x^2) *)
postfix  = atom { "[" row ( ";" | "," ) column "]" } [ degrees ] ;
degrees  = ( "°" | "deg" ) [ number "'" [ number ( '"' | "''" ) ] ] ;
atom     = number | name | call | "√" power | "(" sum ")" | "[" sum "]" | "|" sum "|" | macaulay | matrix ;
call     = function [ "^" number | raised ] ( "(" sum { ( ";" | "," ) sum } ")" | argument ) ;
argument = [ number ] power ;                                         (* sin 2α; more needs brackets *)
macaulay = "<" sum ">" [ "^" signed | raised ] ;                      (* <x - a>^n; without a power n = 1 *)
matrix   = "[" "[" entries "]" { ( "," | ";" ) "[" entries "]" } "]" | "[" entries { ";" entries } "]" ;
entries  = sum { ( ";" | "," ) sum } ;                                (* between single brackets only "," *)
number   = digits [ ( "." | "," ) digits ] [ ( "e" | "E" ) [ "+" | "-" ] digits ] ;
name     = letter { letter | digit | "_" } { "'" } ;
raised   = [ "⁻" ] ( "⁰" … "⁹" ) { "⁰" … "⁹" } ;
```

- A comma directly between digits is a decimal comma. Inside a matrix row or the brackets of a function of several
  arguments it separates, unless that bracket also holds `;`, which then separates and makes the comma decimal.
- `α₁`, `alpha_1`, `alpha1` and `alfa1` are one symbol; so are `R_A` and `RA`. Case counts. A run such as `ab` is not
  cut silently: `ab(x+1)` is asked about with the proposal `a·b·(x+1)`. Only the italic letters of a formula editor are
  declared names side by side, the longest in front first: `8EI` in LaTeX is 8·E·I.
- A chain of relations runs in one sense: `a < x < b`, not `a < x > b`. What looks like a bracket of Macaulay behind a
  factor is one: `a <b> + c` is a sum.
- Where a task declares a rate `x_d` (`x_dd`), `ẋ` (`ẍ`), `x'` (`x''`) and `x_dot` (`x_ddot`) mean it.
- Two formulas are one where they differ by less than a part in 10³⁰ of the larger. Where a symbol never exceeds
  2·10⁻⁴ its powers up to the eighth still count, however small: `sin(x)` is never `x`.
- `a/2b` is asked about; `1/2 a` is half of a. `sin^-1 x` is asked about. `2 1/2` is asked about: a sum or a product?
- A Macaulay bracket `<u>^n` is 0 before u = 0 and u^n behind; n is a whole number from 0, and -1 and -2 stand for a
  force and a moment at a point. Behind a factor `F<x-a>^1` is a product, and so is `F<x-a>` in a sum.
- One amount in two units, `-0,01364 rad = -0,78°`, is read where the two agree to the figures typed, and the finer one
  is judged; where they do not, both are named. A direction behind an amount, `12 kN up`, is no part of it: the sign
  tells it, and the message says so.
- An entry of a matrix of numbers may carry a unit, `[[30°; 150 cm]]`, where it measures what its column measures in
  the field; elsewhere the message asks for the number alone.
- `E`, `I`, `N`, `e`, `lambda`, `beta` are ordinary names where a task declares them.
"""


def page() -> str:
    """Give the whole page."""
    parts = [HEAD, *_examples(), *_functions(), *_letters(), *_units(), *_characters(), *_latex(), *_bounds()]
    return "\n".join([*parts, *_reasons(), *_kinds()]).rstrip() + "\n"


def _table(*rows: Iterable[str]) -> Iterator[str]:
    for number, row in enumerate(rows):
        cells = [cell.replace("|", "\\|") for cell in row]
        yield "| " + " | ".join(cells) + " |"
        if number == 0:
            yield "|" + "---|" * len(cells)
    yield ""


def _code(texts: Iterable[str]) -> str:
    return " ".join(f"`{text}`" for text in texts)


def _examples() -> Iterator[str]:
    yield from ("## Examples", "", "What is typed, and how it is printed back as text:", "")
    read = ((f"`{typed}`", f"`{text_of(parse(typed, SYMBOLS))}`") for typed in EXAMPLES)
    yield from _table(("typed", "read as"), *read)
    judge = Quantity("kN")
    amounts = (judge.parse(typed.replace("MPa", "kN"), Symbols(())) for typed in AMOUNTS)
    yield from ("An amount, at a field that prints kN:", "")
    shown = zip((typed.replace("MPa", "kN") for typed in AMOUNTS), amounts, strict=True)
    yield from _table(("typed", "value in N"), *((f"`{typed}`", f"{amount.value:.6g}") for typed, amount in shown))


def _functions() -> Iterator[str]:
    named = {lang: locale(lang)["functions"] for lang in ("en", "pl", "ru")}
    rows = (
        (f"`{name}`", str(least) if least == most else f"{least}–{most}",
         _code(alias for alias, meant in ALIASES.items() if meant == name), *(words[name] for words in named.values()))
        for name, (least, most) in FUNCTIONS.items()
    )  # fmt: skip
    yield from ("## Functions", "", "Angles are in radians unless a degree sign stands behind the number.", "")
    yield from _table(("function", "arguments", "also typed", "en", "pl", "ru"), *rows)


def _letters() -> Iterator[str]:
    letters: dict[str, list[str]] = {}
    for letter, name in GREEK.items():
        letters.setdefault(name, []).append(letter)
    other = {name: [a for a, meant in LETTER_NAMES.items() if meant == name] for name in letters}
    yield from ("## Greek letters", "", "`pi` is the number, unless a task declares a symbol of this name.", "")
    rows = ((f"`{name}`", _code(signs), _code(other[name])) for name, signs in letters.items())
    yield from _table(("name", "letter", "also typed"), *rows)


def _units() -> Iterator[str]:
    yield from ("## Units", "")
    yield from (
        "A unit is a product or quotient of these with whole powers up to 9: `N/mm^2`, `N·mm⁻²`, `kN m`, `kNm`,",
        "`1/s`, `obr./min`. Square or round brackets around it are read. A bare number is read in the unit printed",
        "at the field, but a multiple of π at a field of angles, such as `π/6`, in radians. Energy (J) is no torque",
        "(N·m) and a frequency (Hz) no angular velocity; `1/min` is a turn a",
        "minute.", "",
    )  # fmt: skip
    latin, cyrillic = _alphabets(units.PREFIXES)
    yield from _table(
        ("prefixes", "units that take them"),
        (_code(latin), _code(_alphabets(units.PREFIXED)[0])),
        (_code(cyrillic), _code(_alphabets(units.PREFIXED)[1])),
    )
    yield from ("In words, with and without a prefix in the same language, `per`, `na` and `в` for the stroke:", "")
    yield from _table(("unit", "words"), *((f"`{unit}`", _code(forms.split())) for unit, forms in WORDED.items()))
    same: dict[units.Unit, list[str]] = {}
    for spelling, unit in units.PLAIN.items():
        same.setdefault(unit, []).append(spelling)
    yield from _table(("without prefixes", "in SI"), *((_code(s), f"{unit.factor:.6g}") for unit, s in same.items()))


def _alphabets(symbols: Iterable[str]) -> tuple[list[str], list[str]]:
    russian = [s for s in symbols if any("а" <= c.lower() <= "я" for c in s)]
    return [s for s in symbols if s and s not in russian], russian


def _characters() -> Iterator[str]:
    yield from ("## Characters", "", "These are read as what they look like:", "")
    meanings: dict[str, list[str]] = {}
    for char, meant in tokens.SAME.items():
        meanings.setdefault(meant, []).append(char)
    yield from _table(("read as", "typed"), *((f"`{meant}`", _code(chars)) for meant, chars in meanings.items()))
    yield from (
        f"Raised figures {_code(SUPERSCRIPTS)} are powers. Full-width forms are read as ASCII. The Cyrillic letters",
        f"{_code(LOOK_ALIKES)} are read as the Latin {_code(LOOK_ALIKES.values())} where that makes a declared symbol",
        "or a function, and named otherwise. Invisible characters, controls and figures of other scripts are refused.",
        "",
    )


def _latex() -> Iterator[str]:
    yield from ("## LaTeX", "")
    yield from (
        r"A text with a backslash, or with braces behind `^` and `_`, is read as LaTeX, as formula editors write it:",
        r"`\frac{a}{b}`, `\frac12`, `\sqrt[n]{x}`, `\left( … \right)`, `\left| … \right|`,",
        r"`\left\langle x-a\right\rangle^{1}`, `3{,}5`, `l_{1}`, `x^{2}`, `x^{\prime}`, `30^{\circ}`. An empty box",
        r"(`\placeholder{}`) is named with its place. Another command is an unknown name.", "",
    )  # fmt: skip
    yield from _table(
        ("commands", "read as"),
        (_code(f"\\{name}" for name in SIGNS), "the sign"),
        (_code(f"\\{name}" for name in LETTERS), "the letter"),
        (_code(f"\\{name}" for name in WORDS), "the function"),
        (_code(f"\\{name}{{x}}" for name in ACCENTS), "a rate: " + _code(f"x{mark}" for mark in ACCENTS.values())),
        (_code(f"\\{name}{{…}}" for name in sorted(UPRIGHT)), "a name, a function or a unit"),
        (_code(f"\\begin{{{name}}}" for name in sorted(ENVIRONMENTS)), "a matrix"),
    )


def _bounds() -> Iterator[str]:
    yield from ("## Bounds", "", "All are checked before any arithmetic.", "")
    yield from _table(
        ("of", "at most"),
        ("characters of a text", str(tokens.MAX_LENGTH)),
        ("characters of LaTeX", str(latex_reader.MAX_LATEX)),
        ("characters of a unit", str(units.LONGEST)),
        ("characters of a ratio", str(rational.LONGEST)),
        ("characters of sentences kept for the lecturer", str(text.Text().longest)),
        ("digits of a number", str(tokens.MAX_DIGITS)),
        ("power of ten of a number", str(tokens.MAX_EXPONENT)),
        ("size of an amount, in the unit typed and in SI", "10^99"),
        ("brackets, signs and powers within one another", str(cursor.MAX_DEPTH)),
        ("terms and factors beside and within one another", str(cursor.MAX_HEIGHT)),
        ("numbers, names and operations", str(cursor.MAX_NODES)),
        ("rows and columns of a matrix", str(parser.MAX_MATRIX)),
    )


def _reasons() -> Iterator[str]:
    yield from ("## Reading errors", "", "`{found}` is what stood there, `{place}` its character counted from 1.", "")
    words = locale("en")["reasons"]
    yield from _table(("reason", "message"), *((f"`{reason}`", words[reason.value]) for reason in Reason))


def _kinds() -> Iterator[str]:
    yield from ("## Answer kinds", "")
    rows = ((f"`{kind}`", _sentence(judge.__doc__ or "")) for kind, judge in KINDS.items())
    yield from _table(("kind", "typed"), *rows)


def _sentence(doc: str) -> str:
    return " ".join(doc.split("\n\n")[0].split())


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
