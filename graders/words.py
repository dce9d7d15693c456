"""The wording of verdicts and tolerances in Polish, English and Russian; the sentences stand in `locales/`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

from graders.common_slips import CommonSlip
from graders.language.errors import Reason
from graders.language.notes import Note
from graders.remarks import Remark, Remarks
from graders.verdict import Branches, Code, Entries, Flaws, Named, Reading, Verdict

NAMES = {"pl": "polski", "en": "English", "ru": "русский"}  # of the languages, as each calls itself
LANGUAGES = tuple(NAMES)
POINT = frozenset({"en"})  # languages with a decimal point; the others have a comma
MOST_REMARKS = 3  # read at once
LOCALES = Path(__file__).parent / "locales"
UNITS: Mapping[str, Mapping[str, str]] = {
    "pl": {"deg": "°", "rpm": "obr/min"}, "en": {"deg": "°"},
    "ru": {
        "deg": "°", "rpm": "об/мин", "m": "м", "mm": "мм", "cm": "см", "s": "с", "rad": "рад", "N": "Н", "kN": "кН",
        "MN": "МН", "Pa": "Па", "kPa": "кПа", "MPa": "МПа", "GPa": "ГПа", "kg": "кг", "g": "г", "t": "т", "J": "Дж",
        "kJ": "кДж", "W": "Вт", "kW": "кВт", "Hz": "Гц", "min": "мин", "h": "ч",
    },
}  # fmt: skip
UNIT_NAME = re.compile("[A-Za-z]+")
GAP = re.compile(r"\{\w+\}")


@lru_cache(maxsize=8)
def locale(lang: str) -> Mapping[str, Any]:
    """Give the words of a language; raises KeyError for one that is not spoken here."""
    if lang not in LANGUAGES:
        raise KeyError(lang)
    import tomllib  # only for those who are told something

    return tomllib.loads((LOCALES / f"{lang}.toml").read_text("utf-8"))


def decimal(value: float, lang: str, figures: int = 5) -> str:
    """Write a number with the decimal mark of the language and a true minus; powers of ten as 1.2·10⁵."""
    text = f"{value:.{figures}g}"
    digits, _, power = text.partition("e")
    if power:
        raised = str(int(power)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        digits = f"{digits}·10{raised}"
    digits = "0" if digits == "-0" else digits.replace("-", "−")
    return marked(digits, lang)


def comma(lang: str) -> bool:
    """Tell whether a language writes a decimal comma."""
    return lang not in POINT


def marked(number: str, lang: str) -> str:
    """Write a number that has a point with the decimal mark of the language."""
    return number.replace(".", ",") if comma(lang) else number


def message(verdict: Verdict, lang: str, *, used: bool = False) -> str:
    """Word a verdict: what a student reads beside the field; `used` tells that an attempt was used up all the same."""
    text = _worded(verdict, lang)
    free = verdict.code is Code.UNREADABLE and not used
    return f"{text} {locale(lang)['uncounted']}" if free else text


def _worded(verdict: Verdict, lang: str) -> str:
    words = locale(lang)
    match verdict.details:
        case Reading(reason=reason, position=position, proposal=proposal) if verdict.code is Code.UNREADABLE:
            return str(words["unreadable"]).format(
                why=_reading(words, reason, position, proposal.found, proposal.meant)
            )
        case Entries(wrong=off, total=total):
            places = ", ".join(f"({row}, {column})" for row, column in off[:6]) + ("…" if len(off) > 6 else "")
            return str(words["codes"][verdict.code.value]).format(right=total - len(off), total=total, places=places)
        case Named(name=name):
            return str(words["codes"][verdict.code.value]).format(name=name)
        case Branches(right=right, given=given):
            return str(words["codes"][verdict.code.value]).format(right=right, given=given)
        case Remarks(right=right, total=total, found=remarks):
            front = str(words["codes"][verdict.code.value]).format(right=right, total=total)
            return " ".join([front, *(_remarked(words, remark, lang) for remark in remarks[:MOST_REMARKS])])
        case Flaws(found=found):
            return " ".join(
                str(words["codes"][flaw.code.value]).format(subject=flaw.subject, place=flaw.place) for flaw in found
            )
        case _:
            return str(words["codes"][verdict.code.value])


def titled(code: str, lang: str) -> str:
    """Word a verdict of which the code alone is kept, its gaps left open; empty for a code that has no sentence."""
    return GAP.sub("…", str(locale(lang)["codes"].get(code, ""))).replace("….", "…")


def _remarked(words: Mapping[str, Any], remark: Remark, lang: str) -> str:
    place, until = ("" if x is None else decimal(x, lang, 4) for x in (remark.place, remark.until))
    shown = printed_unit(remark.unit, lang)
    unit = shown if shown in ("", "°") else f"\u202f{shown}"
    return str(words["slips"][remark.slip.value]).format(place=place + unit, until=until + unit, name=remark.name)


@lru_cache(maxsize=1024)
def printed_unit(unit: str, lang: str) -> str:
    """Write a unit as people of the language read it: `kN*m^2` is kN·m², and кН·м² in Russian."""
    names = UNITS[lang]
    text = "" if unit == "1" else UNIT_NAME.sub(lambda found: names.get(found[0], found[0]), unit)
    return text.replace("*", "·").replace("^2", "²").replace("^3", "³").replace("^4", "⁴")


def taken(unit: str, lang: str) -> str:
    """Say in which units an angle may be typed, that of a bare number first; empty for what is no angle."""
    return str(locale(lang)["angles"].get(unit, ""))


def common_hint(slip: CommonSlip, lang: str) -> str:
    """Word the hint of a slip of any kind of task; it holds no value of the reference."""
    return str(locale(lang)["common_slips"][slip.value])


def noted(notes: Iterable[Note], lang: str) -> str:
    """Word what was read otherwise than typed; empty where nothing was."""
    words = locale(lang)
    return " ".join(
        str(words["notes"][note.kind]).format(
            found=note.found, meant=note.meant, name=words["functions"].get(note.meant, "")
        )
        for note in notes
    )


def _reading(words: Mapping[str, Any], reason: Reason, position: int, found: str, meant: str) -> str:
    why = str(words["reasons"][reason.value]).format(found=found, place=position + 1)
    return f"{why} {str(words['meant']).format(meant=meant)}" if meant else why


def tolerance(description: Mapping[str, Any], lang: str) -> str:
    """Word the tolerance of a field from its rule: `±0,5 %`; empty where answers are judged exactly."""
    if "components" in description:
        return _tolerances(description["components"], lang)
    for scale in ("largest", "amplitude"):
        if scale in description:
            return str(locale(lang)["tolerance"][scale]).format(percent=decimal(100 * description[scale], lang))
    if "figures" in description or "forms" in description:
        return _asked(description, lang)
    rtol, atol, unit = description.get("rtol"), description.get("atol"), description.get("unit", "")
    words = locale(lang)["tolerance"]
    if not rtol and not atol:
        return str(words["exact"]) if description.get("exact") else ""
    relative = decimal(100 * rtol, lang) if rtol else ""
    if "rows" in description:
        return str(words["entries"]).format(percent=relative)
    if not atol:
        return str(words["relative"]).format(percent=relative)
    gap = "" if unit in ("", "°") else "\u202f"
    return str(words["both"]).format(percent=relative, least=decimal(atol, lang) + gap + unit)


def _asked(description: Mapping[str, Any], lang: str) -> str:
    """Word how a formula may be rounded and in which form it is asked for."""
    words, without = locale(lang)["tolerance"], description.get("without", ())
    asked = [str(words[form]) for form in description.get("forms", ())]
    asked += [str(words["without"]).format(names=", ".join(without))] if without else []
    figures = description.get("figures")
    return "; ".join(asked + ([str(words["figures"]).format(figures=figures)] if figures else []))


def _tolerances(components: Sequence[Mapping[str, Any]], lang: str) -> str:
    """Word the tolerances of the numbers of an item: once where they are the same."""
    rules = [tolerance(component, lang) for component in components]
    named = [f"{c['name']}: {rule}" if c["name"] else rule for c, rule in zip(components, rules, strict=True)]
    return rules[0] if len(set(rules)) == 1 else "; ".join(named)
