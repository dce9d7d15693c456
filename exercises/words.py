"""Words of an exercise: TOML beside it, filled with a variant's numbers, as HTML with MathML or as plain text.

Two constructs stand in a statement: `{{ name | unit("mm") }}`, and `{{ loads }}` for a drawn list whose members are
worded by class. `$…$` is LaTeX and becomes MathML when the words are shown as HTML.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from html import escape
from pathlib import Path
from typing import Any

from graders.language.commands import LETTERS
from graders.units import read_unit
from graders.words import decimal, printed_unit

Words = Mapping[str, Any]
NARROW = "\u202f"  # narrow no-break space between a number and its unit
PLACE = re.compile(r"\{\{ *(\w+) *(?:\| *unit\(\"([^\"]*)\"\) *)?\}\}")
BLANKS = re.compile(r"[ \t\n]+")  # never the narrow space that holds number and unit together
MATHS = re.compile(r"\$([^$]*)\$")
QUOTIENT = re.compile(r"\d\S*\u202f[^\s/]+/[\w·²³⁴]+")
OPEN_END = re.compile(r"<mo>((?:=|&#x0003D;)</mo>(?:</mrow>)?</math>)$")  # `$l_1 =$ 45`: a space follows
COMMAND = re.compile(r"\\([A-Za-z]+|.)")
ACCENT = re.compile(r"\\(d?dot)\{([^{}]*)\}")
DOTS = {"dot": "\u0307", "ddot": "\u0308"}
SCRIPT = re.compile(r"([_^])\{([^{}]*)\}")
UPRIGHT = re.compile(r"\\(?:mathrm|text|operatorname)\{([^{}]*)\}")
FRACTION = re.compile(r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}")
FUNCTIONS = ("sin", "cos", "tan", "cot", "arcsin", "arccos", "arctan", "exp", "ln", "min", "max")
BESIDE = re.compile(rf"\b({'|'.join(FUNCTIONS)}) \(")
SPOKEN = {
    **LETTERS,
    **{name: f" {name} " for name in FUNCTIONS},
    "cdot": "·", "times": "×", "pm": "±", "mp": "∓", "le": "≤", "ge": "≥", "ne": "≠", "approx": "≈", "circ": "°",
    "to": "→", "infty": "∞", "sqrt": "√", "langle": "⟨", "rangle": "⟩", "ldots": "…", "dots": "…", "prime": "′",
    "left": "", "right": "", "quad": " ", "qquad": " ", ",": " ", ";": " ", " ": " ", "!": "", "%": "%",
}  # fmt: skip
REQUIRED = ("title", "summary", "statement", "givens", "answers", "mistakes", "figure", "steps")


@dataclass(frozen=True, slots=True)
class Printed:
    """A number of a statement as printed: the given's symbol, the number, the unit; of a member its class."""

    name: str
    number: str
    unit: str
    kind: str = ""


def read_words(path: Path) -> Words:
    """Read a word file; raises ValueError naming file and section if a section is missing."""
    words = tomllib.loads(path.read_text("utf-8"))
    missing = [section for section in REQUIRED if section not in words]
    if missing:
        raise ValueError(f"{path.parent.name}/{path.name} lacks {', '.join(missing)}")
    return words


def printed_number(value: float, unit: str, lang: str) -> str:
    """Write a value in a unit, ten figures at most, with the decimal mark of the language."""
    return decimal(value / read_unit(unit or "1").factor, lang, 10)


def with_unit(number: str, unit: str, lang: str) -> str:
    """Join a number and its unit; a degree sign follows without a space."""
    shown = printed_unit(unit, lang)
    return number + (shown if shown == "°" else NARROW + shown if shown else "")


def fill(text: str, givens: Any, words: Words, lang: str, seen: list[Printed] | None = None) -> str:
    """Fill the places of a text with a variant's numbers; each number filled in is noted in `seen`.

    Raises:
        KeyError: A place names something that is no given.
    """

    def place(found: re.Match[str]) -> str:
        name, unit = found[1], found[2] or ""
        value = getattr(givens, name if hasattr(givens, name) else name + "_", None)
        if value is None:
            raise KeyError(f"no given {name!r} for the place {found[0]!r}")
        if isinstance(value, tuple):
            return _listed(name, value, words, lang, seen)
        if isinstance(value, str):
            return str(words["options"][value])
        number = printed_number(value, unit, lang)
        if seen is not None:
            seen.append(Printed(name, number, unit))
        return with_unit(number, unit, lang)

    return PLACE.sub(place, text)


def _listed(name: str, members: tuple[Any, ...], words: Words, lang: str, seen: list[Printed] | None) -> str:
    """Word a drawn list, one line a member, under the class of the member; `{i}` and `{i-1}` are indices."""
    lines = []
    for index, member in enumerate(members, 1):
        noted, kind = list[Printed](), type(member).__name__
        text = str(words[name][kind])
        text = text.replace("{i}", f"{{{index}}}").replace("{i-1}", f"{{{index - 1}}}")
        lines.append("- " + BLANKS.sub(" ", fill(text, member, words, lang, noted)).strip())
        if seen is not None:
            seen.extend(Printed(f"{p.name}{index}", p.number, p.unit, kind) for p in noted)
    return "\n" + "\n".join(lines) + "\n"


def html(text: str) -> str:
    """Turn filled words into HTML: paragraphs, lists, and MathML for `$…$`."""
    blocks = []
    for block in re.split(r"\n\s*\n", text.strip()):
        for run in _runs(block.split("\n")):
            if run[0].startswith("- "):
                blocks.append("<ul>" + "".join(f"<li>{inline(line[2:])}</li>" for line in run) + "</ul>")
            else:
                blocks.append(f"<p>{inline(' '.join(run))}</p>")
    return "".join(blocks)


def _runs(lines: list[str]) -> list[list[str]]:
    runs: list[list[str]] = []
    for line in (line.strip() for line in lines if line.strip()):
        if runs and runs[-1][0].startswith("- ") == line.startswith("- "):
            runs[-1].append(line)
        else:
            runs.append([line])
    return runs


@lru_cache(maxsize=4096)
def inline(text: str) -> str:
    """Turn a line into HTML, `$…$` into MathML kept together with the punctuation after it."""
    pieces = MATHS.split(text)
    shown = [_held(pieces[0])]
    for latex, after in zip(pieces[1::2], pieces[2::2], strict=True):
        mark = after[: len(after) - len(after.lstrip(".,;:?)"))]
        formula = mathml(latex) + mark
        shown.append(f'<span class="nowrap">{formula}</span>' if mark else formula)
        shown.append(_held(after[len(mark) :]))
    return "".join(shown)


def _held(text: str) -> str:
    """Escape a text; a number with a broken unit, as 5 m/s, stays on one line."""
    return QUOTIENT.sub(r'<span class="nowrap">\g<0></span>', escape(text, quote=False))


@lru_cache(maxsize=4096)
def mathml(latex: str) -> str:
    """Turn LaTeX into MathML."""
    from latex2mathml.converter import convert

    shown = re.sub(r' (?:xmlns|display)="[^"]*"', "", convert(latex))
    return OPEN_END.sub(r'<mo rspace="0">\1', shown.replace("<mover>", '<mover accent="true">'))  # dots, arrows


@lru_cache(maxsize=4096)
def plain(text: str) -> str:
    """Turn filled words into plain text for a terminal: symbols by their letters, no LaTeX."""
    return MATHS.sub(lambda found: _spoken(found[1]), text).strip()


def _spoken(latex: str) -> str:
    bare = SCRIPT.sub(r"\1\2", ACCENT.sub(lambda found: found[2] + DOTS[found[1]], latex))
    bare = FRACTION.sub(lambda found: f"{_grouped(found[1])}/{_grouped(found[2])}", UPRIGHT.sub(r"\1", bare))
    text = COMMAND.sub(lambda found: SPOKEN.get(found[1], f" {found[1]} "), bare)
    return BESIDE.sub(r"\1(", " ".join(re.sub(r"[{}]|_|\^(?=°)", "", text).split()))


def _grouped(latex: str) -> str:
    return f"({latex})" if re.search(r"\w *[-+]", latex) else latex


def indexed(section: Mapping[str, str], name: str) -> str:
    """Find the words of a name; `T2` is worded by `T{i}` with its index filled in.

    Raises:
        KeyError: The section words neither.
    """
    if name in section:
        return section[name]
    stem = name.rstrip("0123456789")
    index = name[len(stem) :]
    return section[stem + "{i}"].replace("{i}", f"{{{index}}}")


def named(given: Printed, givens: Any, words: Words, lang: str) -> str:
    """Say what a given is called; where members of a list differ in it, each class has a section of its own.

    Raises:
        KeyError: The words call it nothing.
    """
    section = words["givens"]
    return fill(indexed({**section, **section.get(given.kind, {})}, given.name), givens, words, lang)
