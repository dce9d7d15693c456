"""What stands around a number and says nothing of it: `ok.`, `~`, `about`, `Ø`, `l3:`, `$`, brackets, a full stop."""

from __future__ import annotations

import re
from collections.abc import Collection

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.latex_source import undollared
from graders.language.symbols import Symbols, function_named, key
from graders.language.tokens import LETTER

FENCES = 4  # pairs of brackets around an amount that say nothing
ABOUT = (
    "ok", "około", "ca", "circa", "w przybliżeniu", "mniej więcej", "about", "approx", "approximately", "roughly",
    "ок", "около", "примерно", "приблизительно",
)  # fmt: skip
ROUGHLY = re.compile(
    rf"((?:^|[=≈:])\s{{0,9}})((?:{'|'.join(ABOUT)})(?:\.\s{{0,3}}|\s{{1,3}})|[øØ⌀~]\s{{0,3}})(?=[-+−–.\d(\\√])",
    re.IGNORECASE,
)
NAMED = re.compile(rf" *(?:{LETTER}(?:{LETTER}|[0-9_₀-₉])* *)?[=≈] *")  # `R_A = 12 kN`, `= 12 kN`
TIE = re.compile(r"(?<=\d)~(?=[^\W\d])")  # 12~kN
LETTERED = re.compile(r"(?:(?<=\d)|(?<=\d[.,]))(?:[OoОо]+(?![^\W\d_])|[lI](?=\d))|(?<!\w)[OoОо](?=[.,]\d)")
FIGURES = {"l": "1", "I": "1"}  # the others look like 0
LITERAL = re.compile(r"\d[\d.,]*")
DRAWN = re.compile(r"\\(?:mathrm|d?frac)|[\\{}()/\s]")  # what a derivative is drawn with besides its letters
LABEL = re.compile(rf"^(\s{{0,9}}(?!pi\b|π){LETTER}(?:{LETTER}|[\d_₀-₉])*\s?):(=?)(?=\s{{0,9}}[-+−–.\d(\\√])")
ANSWER = re.compile(r"^\s{0,9}(?:odp|отв|ans)\.\s{0,3}:?", re.IGNORECASE)  # Odp.: 12 kN
BACKSLASH = re.compile(r"(?<=[^\W\d_])\\(?=(?:s|sec|sek|min|m|mm|с|сек|мин|м|мм)(?:[\^²]?\d?)\W{0,3}$)")  # м\с


DIRECTION = re.compile(
    r"(?<=[\s(,\d])(?:w (?:górę|dół|prawo|lewo)|(?:ku|do) (?:górze|dołowi|góry|dołu)|na dół"
    r"|(?:to the )?(?:left|right)|upwards?|downwards?|up|down|(?:counter|anti)?clockwise"
    r"|вверх|вниз|вправо|влево|[↑↓→←↺↻])(?=[\s).;]{0,9}$)",
    re.IGNORECASE,
)  # behind an amount


def without_asides(text: str) -> str:
    """Blank out what says nothing of the number: `ok. 12 kN`, `R_A: 12 kN`, `(12 kN)`, `12 kN.`; places stay."""
    text = ANSWER.sub(lambda found: " " * len(found[0]), BACKSLASH.sub("/", undollared(text)))
    text = TIE.sub(" ", LABEL.sub(lambda found: found[1] + " " * len(found[2]) + "=", text))
    text = ROUGHLY.sub(lambda found: found[1] + " " * len(found[2]), text)
    found = text.rstrip()
    for mark in (";", "."):
        found = found.removesuffix(mark).rstrip()
    found = _unfenced(found.ljust(len(text)))
    return found if found.strip() else text


def refuse_direction(text: str) -> None:
    """Ask for the sign where a direction stands behind an amount, `12 kN up`; raises AnswerSyntaxError."""
    found = DIRECTION.search(text) if any(char.isdigit() for char in text[:-1]) else None
    if found:
        raise AnswerSyntaxError(Reason.DIRECTION, found.start(), found.group())


def refuse_letters(text: str) -> None:
    """Ask for the figure where a letter that looks like one stands in a number, `204,O2`; raises AnswerSyntaxError."""
    found = LETTERED.search(text)
    if found is None:
        return
    mended = LETTERED.sub(lambda one: FIGURES.get(one.group(), "0" * len(one.group())), text)
    number = next(one.group() for one in LITERAL.finditer(mended) if one.end() > found.start())
    raise AnswerSyntaxError(Reason.BAD_CHARACTER, found.start(), found.group(), number)


def without_label(text: str, symbols: Symbols) -> str:
    """Blank out a name in front of `=` that means nothing here, `i = z2/z1` where the ratio is u; places stay."""
    found = NAMED.match(text) if text.count("=") == 1 else None
    name = found.group().strip(" =≈") if found else ""
    meant = function_named(name) or key(name) == "pi" or symbols.find(name) or symbols.split(name[:24])
    if found is None or (name and meant):
        return text
    return " " * found.end() + text[found.end() :]


def without_derivatives(text: str, rates: Collection[str]) -> str:
    r"""Blank out `dα2/dt =` or `\frac{d\alpha_2}{dt} =` in front of a formula of one of some rates; places stay."""
    meant = {f"d{key(rate.removesuffix('_d'))}dt" for rate in rates if not rate.endswith("_dd")}
    *fronts, formula = text.split("=")
    told = [part + "=" if key(DRAWN.sub("", part)) not in meant else " " * (len(part) + 1) for part in fronts]
    return "".join(told) + formula


def _unfenced(text: str) -> str:
    for _ in range(FENCES):
        start, end = len(text) - len(text.lstrip()), len(text.rstrip()) - 1
        if text[start : start + 1] != "(" or _closing(text, start) != end:
            break
        text = f"{text[:start]} {text[start + 1 : end]} {text[end + 1 :]}"
    return text


def _closing(text: str, start: int) -> int:
    """Find where a bracket closes; -1 where it does not."""
    depth = 0
    for at in range(start, len(text)):
        depth += (text[at] == "(") - (text[at] == ")")
        if not depth:
            return at
    return -1
