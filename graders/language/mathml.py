"""Tree to MathML (presentation) as the echo shows it."""

from __future__ import annotations

import re
from functools import lru_cache
from html import escape

from graders.language.symbols import GREEK
from graders.language.text import ATOM, level
from graders.language.tree import Angle, Binary, Call, Grid, Index, Name, Number, Relation, Tree, Unary

LETTERS = {name: letter for letter, name in reversed(GREEK.items())} | {"mu": "μ", "Omega": "Ω", "Delta": "Δ"}
PARTS = re.compile(r"([A-Za-z]+?)_?(\d+|_?[A-Za-z]{1,3})?(_dd?)?('*)$")
OPERATORS = {"*": "·", "-": "−", "+": "+", "±": "±", "<": "&lt;", ">": "&gt;", "<=": "≤", ">=": "≥", "=": "="}
PRINTED = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "acot": "arccot"}
GAP = '<mspace width=".17em"/>'


def mathml_of(tree: Tree, comma: bool = False) -> str:
    """Write `<math>` for a tree; decimals with a comma if asked."""
    return f"<math><mrow>{_inner(tree, comma)}</mrow></math>"


@lru_cache(maxsize=1024)
def symbol_mathml(name: str) -> str:
    """Write `<math>` for one symbol: `alpha1` as α with subscript 1, `s_d` with a dot, `R_A` with subscript A."""
    return f"<math>{_name(name)}</math>"


def split_symbol(name: str) -> tuple[str, str, int, str]:
    """Split a symbol into letter, subscript, number of dots, primes: `omega1_d` to (ω, 1, 1, '')."""
    stem = name.rstrip("'")
    primes = name[len(stem) :]
    dots = 2 if stem.endswith("_dd") else int(stem.endswith("_d"))
    stem = stem.removesuffix("_dd") if dots == 2 else stem.removesuffix("_d") if dots else stem
    head, underscore, below = stem.partition("_")
    if not underscore:
        head = stem.rstrip("0123456789")
        below = stem[len(head) :]
        if head and head[:-1] in LETTERS and head not in LETTERS and head[-1] == "p":
            head = head[:-1]
    return LETTERS.get(head, head), LETTERS.get(below, below), dots, primes


def _name(name: str) -> str:
    letter, below, dots, primes = split_symbol(name)
    core = f"<mi>{escape(letter)}</mi>"
    if dots:
        core = f'<mover accent="true">{core}<mo>{"˙" if dots == 1 else "¨"}</mo></mover>'
    if below:
        tag = "mn" if below.isdigit() else "mi"
        core = f"<msub>{core}<{tag}>{escape(below)}</{tag}></msub>"
    return f"<msup>{core}<mo>{'′' * len(primes)}</mo></msup>" if primes else core


def _inner(tree: Tree, comma: bool) -> str:
    match tree:
        case Number():
            return _number(tree, comma)
        case Name(name="pi"):
            return "<mi>π</mi>"
        case Name(name=name):
            return _name(name)
        case Unary(operator="°", operand=operand):
            return _fenced(operand, ATOM, comma) + "<mo>°</mo>"
        case Unary(operator=operator, operand=operand):
            return f'<mo form="prefix">{OPERATORS[operator]}</mo>' + _fenced(operand, 2, comma)
        case Binary():
            return _binary(tree, comma)
        case Call(function=function, arguments=arguments):
            return _call(function, arguments, comma)
        case Angle(degrees=degrees, minutes=minutes, seconds=seconds):
            tail = _number(seconds, comma) + "<mo>″</mo>" if seconds else ""
            return f"{_number(degrees, comma)}<mo>°</mo>{_number(minutes, comma)}<mo>′</mo>{tail}"
        case Grid(rows=rows):
            body = "".join("<mtr>" + "".join(f"<mtd>{_row(e, comma)}</mtd>" for e in row) + "</mtr>" for row in rows)
            return f"<mo>[</mo><mtable>{body}</mtable><mo>]</mo>"
        case Index(matrix=matrix, row=row, column=column):
            return f"<msub>{_row(matrix, comma)}<mrow><mn>{row}</mn><mo>,</mo><mn>{column}</mn></mrow></msub>"
        case Relation(operators=operators, sides=sides):
            pieces = [_inner(sides[0], comma)]
            for operator, side in zip(operators, sides[1:], strict=True):
                pieces.append(f"<mo>{OPERATORS[operator]}</mo>{_inner(side, comma)}")
            return "".join(pieces)


def _number(number: Number, comma: bool) -> str:
    digits = f"<mn>{number.digits.replace('.', ',') if comma else number.digits}</mn>"
    if not number.exponent:
        return digits
    sign = "<mo>−</mo>" if number.exponent < 0 else ""
    power = f"<mrow>{sign}<mn>{abs(number.exponent)}</mn></mrow>"
    return f"{digits}<mo>·</mo><msup><mn>10</mn>{power}</msup>"


def _row(tree: Tree, comma: bool) -> str:
    return f"<mrow>{_inner(tree, comma)}</mrow>"


def _fenced(tree: Tree, least: int, comma: bool) -> str:
    inner = _row(tree, comma)
    return inner if level(tree) >= least else f"<mrow><mo>(</mo>{inner}<mo>)</mo></mrow>"


def _binary(tree: Binary, comma: bool) -> str:
    if tree.operator == "/":
        return f"<mfrac>{_row(tree.left, comma)}{_row(tree.right, comma)}</mfrac>"
    if tree.operator == "^":
        return f"<msup>{_fenced(tree.left, ATOM, comma)}{_row(tree.right, comma)}</msup>"
    pieces: list[str] = []
    node: Tree = tree
    while isinstance(node, Binary) and node.operator in "+-±*":  # a long sum is no deep one
        least = 1 if node.operator in "+-±" else 2
        sign = GAP if node.implicit else f"<mo>{OPERATORS[node.operator]}</mo>"
        pieces.append(sign + _fenced(node.right, least + (node.operator != "+"), comma))
        node = node.left
        if level(node) < least:
            break
    pieces.append(_fenced(node, least, comma))
    return "".join(reversed(pieces))


def _call(function: str, arguments: tuple[Tree, ...], comma: bool) -> str:
    if function == "sqrt":
        return f"<msqrt>{_inner(arguments[0], comma)}</msqrt>"
    if function == "root":
        return f"<mroot>{_row(arguments[0], comma)}{_row(arguments[1], comma)}</mroot>"
    if function == "abs":
        return f"<mo>|</mo>{_row(arguments[0], comma)}<mo>|</mo>"
    if function == "macaulay":
        return f"<msup><mrow><mo>⟨</mo>{_row(arguments[0], comma)}<mo>⟩</mo></mrow>{_row(arguments[1], comma)}</msup>"
    inside = "<mo>;</mo>".join(_row(a, comma) for a in arguments)
    name = PRINTED.get(function, function)
    if function != "f" and len(arguments) == 1 and level(arguments[0]) == ATOM and not isinstance(arguments[0], Call):
        return f"<mi>{name}</mi>{GAP}{inside}"
    return f"<mi>{name}</mi><mrow><mo>(</mo>{inside}<mo>)</mo></mrow>"
