"""What a student sees of a variant in one language: statement, fields, figure, hints, worked solution."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from html import escape
from math import degrees
from typing import Any

from exercises import catalogue, solving
from exercises.exercise import Grade, Variant
from exercises.givens import numbers
from exercises.solving import Solved
from exercises.words import Printed, Words, fill, html, indexed, inline, named, plain, with_unit
from figures.picture import Picture
from graders import Quantity, Value
from graders.language import parse_line
from graders.language.mathml import mathml_of, split_symbol, symbol_mathml
from graders.language.text import text_of
from graders.language.tree import Binary, Call, Name, Number, Tree, Unary, mapped
from graders.language.tree import names as names_in
from graders.units import read_unit
from graders.words import comma, common_hint, decimal, printed_unit, taken, tolerance

NUMBERS = {"quantity", "integer", "rational"}  # kinds whose answer is not the equation itself
WITH_UNIT = {"quantity", "set"}  # kinds whose numbers may be typed with a unit of their own
OF_ANGLES = frozenset(("sin", "cos", "tan", "cot", "asin", "acos", "atan", "acot", "atan2"))


@dataclass(frozen=True, slots=True)
class Field:
    """One answer to give: how it is asked, in which unit, with which symbols and tolerance."""

    name: str
    kind: str
    prompt_html: str
    prompt_text: str
    symbol_mathml: str
    unit: str
    unit_text: str
    symbols: tuple[str, ...]
    tolerance_text: str
    rtol: float | None
    atol: float | None
    rows: int
    columns: int
    column_units: tuple[str, ...]
    options: tuple[tuple[str, str], ...]
    weight: float
    options_text: tuple[tuple[str, str], ...] = ()
    shape: Mapping[str, Any] = field(default_factory=dict)  # all that the judge says of its field
    taken_text: str = ""  # in which units it may be typed, where words say more than the unit


@dataclass(frozen=True, slots=True)
class Presented:
    """A variant in one language; nothing here depends on the reference values."""

    title: str
    summary: str
    statement_html: str
    statement_text: str
    givens: tuple[tuple[str, str], ...]
    answers: dict[str, Field]
    picture: Picture | None
    givens_named: tuple[str, ...] = ()  # HTML, in the order of the givens; empty where the card is older than the names

    @property
    def data(self) -> tuple[tuple[str, str, str], ...]:
        """The givens as name, symbol and value; a name may be empty."""
        names = self.givens_named or ("",) * len(self.givens)
        return tuple((name, *pair) for name, pair in zip(names, self.givens, strict=True))


@dataclass(frozen=True, slots=True)
class SolvedLine:
    """One line of the worked solution: what, by which formula, with which result."""

    heading_html: str
    formula_mathml: str
    formula_text: str
    value: str


@dataclass(frozen=True, slots=True)
class Rung:
    """A step of a ladder of hints as HTML, and what it tells: follows, equation, data, shape or signs."""

    kind: str
    html: str


def words_of(exercise_id: str, lang: str) -> Words:
    """Give an exercise's words in a language."""
    return catalogue.load(exercise_id).words[lang]


def presented(variant: Variant, lang: str) -> Presented:
    """Present a variant in a language."""
    entry = catalogue.load(variant.exercise)
    words, solved, seen = entry.words[lang], solving.solved(variant), list[Printed]()
    statement = fill(words["statement"], variant.givens, words, lang, seen)
    return Presented(
        title=words["title"],
        summary=words["summary"],
        statement_html=html(statement),
        statement_text=plain(statement),
        givens=tuple((symbol_mathml(p.name), with_unit(p.number, p.unit, lang)) for p in seen),
        answers={name: _field(solved, name, words, lang) for name in solved.answers},
        picture=entry.picture(variant.givens, lang),
        givens_named=tuple(inline(named(p, variant.givens, words, lang)) for p in seen),
    )


def printed_givens(variant: Variant, lang: str) -> tuple[Printed, ...]:
    """Give the numbers that the statement prints, in the order printed."""
    words, seen = words_of(variant.exercise, lang), list[Printed]()
    fill(words["statement"], variant.givens, words, lang, seen)
    return tuple(seen)


def _field(solved: Solved, name: str, words: Words, lang: str) -> Field:
    grader = solved.answers[name]
    described, prompt = grader.describe(), indexed(words["answers"], name)
    given = numbers(solved.variant.givens) if grader.symbolic else {}
    symbols = solved.symbols(name).names if grader.symbolic else ()
    options = words["choices"][name] if "options" in described else {}
    return Field(
        name=name,
        kind=grader.kind,
        prompt_html=inline(prompt),
        prompt_text=plain(prompt),
        symbol_mathml=_symbol(solved.step_of(name)),
        unit=described.get("unit", ""),
        unit_text=printed_unit(described.get("unit", ""), lang),
        symbols=tuple(sorted(symbols, key=lambda s: (s not in given, s))),
        tolerance_text=tolerance(_rule(described, lang), lang),
        rtol=described.get("rtol"),
        atol=described.get("atol"),
        rows=described.get("rows", 0),
        columns=described.get("columns", 0),
        column_units=tuple(printed_unit(unit, lang) for unit in described.get("units", ())),
        options=tuple((key, inline(options[key])) for key in described.get("options", ())),
        options_text=tuple((key, plain(options[key])) for key in described.get("options", ())),
        weight=grader.weight,
        shape=_shape(described, lang),
        taken_text=taken(described.get("unit", ""), lang) if grader.kind in WITH_UNIT else "",
    )


def _shape(described: Mapping[str, Any], lang: str) -> Mapping[str, Any]:
    """Give the description of a field as its editor shows it."""
    return {**described, **{key: printed_unit(described[key], lang) for key in ("x_unit",) if key in described}}


def _symbol(step: str) -> str:
    """Write the symbol of a step; a step that is named by a word has none."""
    return symbol_mathml(step) if len(split_symbol(step)[0]) <= 2 else ""


def _rule(described: Mapping[str, Any], lang: str) -> dict[str, Any]:
    """Give the description of a field with its units as they are printed."""
    rule = {**described, "unit": printed_unit(described.get("unit", ""), lang)}
    return {**rule, **{key: [_rule(one, lang) for one in described[key]] for key in ("components",) if key in rule}}


def hint(variant: Variant, mistake: str, lang: str) -> str:
    """Give the hint of a known slip as HTML; it holds no value of the reference."""
    return inline(words_of(variant.exercise, lang)["mistakes"][mistake])


def hint_text(variant: Variant, mistake: str, lang: str) -> str:
    """Give the hint of a known slip as plain text."""
    return plain(words_of(variant.exercise, lang)["mistakes"][mistake])


def hints(variant: Variant, grade: Grade, lang: str) -> tuple[str, ...]:
    """Give the hints of a grade as HTML: of the exercise's own slip, then of the common one."""
    own = (hint(variant, grade.mistake, lang),) if grade.mistake else ()
    return (*own, escape(common_hint(grade.slip, lang))) if grade.slip else own


def ladder(variant: Variant, answer: str, lang: str) -> tuple[Rung, ...]:
    """Give what helps on with a wrong answer: the symbols it follows from, its equation, that with the data.

    The equation stays hidden where another answer asks for it. In a laboratory, whose work is to find the equations,
    its shape is told instead: functions and signs left open, then the signs alone. A step that is no formula has no
    ladder. With the data means with the numbers the statement prints, in SI units; results of earlier steps stay
    symbols, so no step holds a value of the reference.
    """
    solved = solving.solved(variant)
    step = solved.step_of(answer)
    line = solved.steps.get(step)
    if not isinstance(line, str) or solved.answers[answer].kind not in NUMBERS:
        return ()
    tree = parse_line(line)
    named = names_in(tree)
    used = [symbol_mathml(name) for name in (*numbers(variant.givens), *solved.steps) if name in named]
    told = _told(variant, step, tree, lang) if used else {}
    further = (Rung(kind, _equation(step, mathml_of(one, comma(lang)))) for one, kind in told.items())
    return (Rung("follows", ", ".join(used)), *further) if used else ()


def _told(variant: Variant, step: str, tree: Tree, lang: str) -> dict[Tree, str]:
    """Give the formulas of a ladder in order, with what each tells."""
    if catalogue.load(variant.exercise).exercise.report:
        shapes = {_left_open(tree, OF_ANGLES): "shape"} | {_left_open(tree): "signs"}
        return {one: kind for one, kind in shapes.items() if one != tree}
    solved = solving.solved(variant)
    if {judge.kind for name, judge in solved.answers.items() if solved.step_of(name) == step} - NUMBERS:
        return {}
    told = {tree: "equation"}
    told.setdefault(_with_data(variant, tree, lang), "data")
    return told


def _left_open(tree: Tree, functions: frozenset[str] = frozenset()) -> Tree:
    """Put ± for every sign of a formula, and f for some functions."""

    def opened(node: Tree) -> Tree:
        match node:
            case Binary(operator="+" | "-"):
                return replace(node, operator="±")
            case Unary(operator="-"):
                return replace(node, operator="±")
            case Call(function=function) if function in functions:
                return replace(node, function="f")
        return node

    return mapped(tree, opened)


def _with_data(variant: Variant, tree: Tree, lang: str) -> Tree:
    """Put the printed numbers of a variant in the places of their symbols, in SI units, angles in degrees.

    An equation that names a given alone stays as it is: with its number it would be the answer.
    """
    if isinstance(tree, Name) or (isinstance(tree, Unary) and isinstance(tree.operand, Name)):
        return tree
    given, printed = numbers(variant.givens), {one.name: one for one in printed_givens(variant, lang)}

    def filled(node: Tree) -> Tree:
        match node:
            case Binary():
                return replace(node, implicit=False)  # two numbers side by side would be one
            case Name(name=name) if name in given and name in printed:
                return _datum(given[name], printed[name].unit == "deg")
        return node

    return mapped(tree, filled)


def _datum(value: float, angle: bool) -> Tree:
    """Write a number as a tree: six figures, a power of ten where it is far from one, a degree sign."""
    digits, _, power = f"{degrees(value) if angle else value:.6g}".partition("e")
    number: Tree = Number(digits.lstrip("-"))
    if power:
        tens = Number(str(abs(int(power))))
        number = Binary("*", number, Binary("^", Number("10"), tens if int(power) > 0 else Unary("-", tens)))
    number = Unary("°", number) if angle else number
    return Unary("-", number) if value < 0 else number


def hints_text(variant: Variant, grade: Grade, lang: str) -> str:
    """Give the hints of a grade as plain text; empty where none fits."""
    own = (hint_text(variant, grade.mistake, lang),) if grade.mistake else ()
    return " ".join((*own, common_hint(grade.slip, lang)) if grade.slip else own)


def solution(variant: Variant, lang: str) -> tuple[SolvedLine, ...]:
    """Give the worked solution: the steps in order with the variant's numbers."""
    entry = catalogue.load(variant.exercise)
    words, solved = entry.words[lang], solving.solved(variant)
    units = _units(solved)
    lines = []
    for name, line in solved.steps.items():
        tree = parse_line(line) if isinstance(line, str) else None
        value = _written(solved, name, lang) or _shown(
            solved.values[name], units.get(name, _unit_of(name, words)), lang
        )
        chosen = words.get("choices", {}).get(name, {})
        value = "; ".join(plain(chosen.get(part, part)) for part in value.split("; "))
        formula = mathml_of(tree, comma(lang)) if tree else ""
        heading = inline(indexed(words["steps"], name))
        lines.append(SolvedLine(heading, _equation(name, formula), f"{name} = {text_of(tree)}" if tree else "", value))
    return tuple(lines)


def _written(solved: Solved, name: str, lang: str) -> str:
    """Write a diagram as its pieces, a cycle by every third of its rows; empty for any other step."""
    judge = next((g for answer, g in solved.answers.items() if solved.step_of(answer) == name), None)
    value = solved.values[name]
    if judge is None or judge.kind not in ("diagram", "samples") or not isinstance(value, tuple):
        return ""
    if judge.kind == "samples":
        shown = judge.show(value[:: max(1, len(value) // 12)]).replace("; ", " · ").replace("\n", " | ")
    else:
        shown = judge.show(value).replace("..", "…").replace("\n", "; ")
    return re.sub(r"\d+\.\d+", lambda number: decimal(float(number[0]), lang), shown.replace("-", "−"))


def _equation(name: str, formula: str) -> str:
    inner = formula.removeprefix("<math>").removesuffix("</math>")
    symbol = symbol_mathml(name).removesuffix("</math>")
    return f"{symbol}<mo>=</mo>{inner}</math>" if formula else ""


def _units(solved: Solved) -> dict[str, str]:
    return {solved.step_of(name): g.unit for name, g in solved.answers.items() if isinstance(g, Quantity)}


def _unit_of(name: str, words: Words) -> str:
    """Find the unit in which a step that is no answer is shown; none is named for a pure number."""
    try:
        return indexed(words.get("units", {}), name)
    except KeyError:
        return ""


def _shown(value: Value, unit: str, lang: str) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, tuple):
        return "[" + ", ".join("[" + "; ".join(decimal(_clean(e), lang, 4) for e in row) + "]" for row in value) + "]"
    return with_unit(decimal(value / read_unit(unit or "1").factor, lang), unit, lang)


def _clean(entry: Any) -> float:
    return 0.0 if abs(entry) < 1e-12 else float(entry)
