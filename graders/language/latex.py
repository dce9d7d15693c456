r"""Tree to LaTeX, for reports and worked solutions; `parse` reads the same tree back.

A fraction bar and braces group, so fewer brackets are written than in text. A literal with a power of ten is written
with `\times`, a product with `\cdot`.
"""

from __future__ import annotations

from graders.language.mathml import split_symbol
from graders.language.symbols import GREEK
from graders.language.text import ATOM, level
from graders.language.tree import Angle, Binary, Call, Grid, Index, Name, Number, Relation, Tree, Unary

OPERATORS = {
    "*": r" \cdot ",
    "+": " + ",
    "-": " - ",
    "<": " < ",
    ">": " > ",
    "<=": r" \le ",
    ">=": r" \ge ",
    "=": " = ",
}
HEADS = {"asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan"} | {
    name: f"\\{name}" for name in ("sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "exp", "ln", "log", "min", "max")
}
BUILT = ("sqrt", "root", "abs", "macaulay")


def latex_of(tree: Tree, comma: bool = False) -> str:
    """Write a tree as LaTeX mathematics (no dollar signs), decimals with a comma if asked."""
    match tree:
        case Number():
            return _number(tree, comma)
        case Name(name=name):
            return _name(name)
        case Unary(operator="°", operand=operand):
            return _fenced(operand, ATOM, comma) + r"^{\circ}"
        case Unary(operator=operator, operand=operand):
            return operator + _fenced(operand, 3, comma)
        case Binary():
            return _binary(tree, comma)
        case Call(function=function, arguments=arguments):
            return _call(function, "", [latex_of(a, comma) for a in arguments])
        case Angle(degrees=degrees, minutes=minutes, seconds=seconds):
            tail = f"{_number(seconds, comma)}''" if seconds else ""
            return rf"{_number(degrees, comma)}^{{\circ}}{_number(minutes, comma)}'{tail}"
        case Grid(rows=rows):
            body = r" \\ ".join(" & ".join(latex_of(e, comma) for e in row) for row in rows)
            return rf"\begin{{bmatrix}} {body} \end{{bmatrix}}"
        case Index(matrix=matrix, row=row, column=column):
            return rf"{{{latex_of(matrix, comma)}}}_{{{row},{column}}}"
        case Relation(operators=operators, sides=sides):
            pieces = [latex_of(sides[0], comma)]
            for operator, side in zip(operators, sides[1:], strict=True):
                pieces.append(OPERATORS[operator] + latex_of(side, comma))
            return "".join(pieces)


def _number(number: Number, comma: bool) -> str:
    digits = number.digits.replace(".", "{,}") if comma else number.digits
    return rf"{digits} \times 10^{{{number.exponent}}}" if number.exponent else digits


def _name(name: str) -> str:
    letter, below, dots, primes = split_symbol(name)
    core = _letter(letter) if len(letter) == 1 else rf"\mathit{{{letter}}}"
    core = {0: core, 1: rf"\dot{{{core}}}", 2: rf"\ddot{{{core}}}"}[dots]
    return (f"{core}_{{{_below(below)}}}" if below else core) + primes


def _below(text: str) -> str:
    return r"\,".join(_letter(p) if len(p) < 2 or p.isdigit() else rf"\mathrm{{{p}}}" for p in text.split("_"))


def _letter(letter: str) -> str:
    word = GREEK.get(letter)
    return f"\\{word}" if word else letter


def _level(tree: Tree) -> int:
    """Give how tightly the written form binds: a fraction and a literal with a power of ten like a power."""
    match tree:
        case Binary(operator="/"):
            return ATOM - 1
        case Number(exponent=exponent) if exponent:
            return ATOM - 1
        case _:
            return level(tree)


def _fenced(tree: Tree, least: int, comma: bool) -> str:
    inner = latex_of(tree, comma)
    return inner if _level(tree) >= least else rf"\left({inner}\right)"


def _binary(tree: Binary, comma: bool) -> str:
    left, right = tree.left, tree.right
    if tree.operator == "/":
        return rf"\frac{{{latex_of(left, comma)}}}{{{latex_of(right, comma)}}}"
    if tree.operator == "^":
        return _power(left, right, comma)
    pieces: list[str] = []
    node: Tree = tree
    while isinstance(node, Binary) and node.operator in "+-*":  # a long sum is no deep one
        least = 1 if node.operator in "+-" else 2
        pieces.append(_after(node, least + 1, comma))
        node = node.left
        if _level(node) < least:
            break
    return _fenced(node, least, comma) + "".join(reversed(pieces))


def _after(tree: Binary, least: int, comma: bool) -> str:
    """Write an operator and its right operand."""
    sign = r" \, " if tree.implicit else OPERATORS[tree.operator]
    if _opens(tree.right, tree.implicit):
        return rf"{sign}\left({latex_of(tree.right, comma)}\right)"
    return sign + _fenced(tree.right, least, comma)


def _power(base: Tree, exponent: Tree, comma: bool) -> str:
    raised = f"^{{{latex_of(exponent, comma)}}}"
    if isinstance(base, Call) and base.function not in BUILT and isinstance(exponent, Number) and not exponent.exponent:
        return _call(base.function, raised, [latex_of(a, comma) for a in base.arguments])
    return _fenced(base, ATOM, comma) + raised


def _opens(tree: Tree, beside: bool) -> bool:
    """Tell whether a right operand opens with a sign, or beside another factor with a figure."""
    while isinstance(tree, Binary) and tree.operator != "/":
        if tree.operator == "^" and _level(tree.left) < ATOM:
            return False
        tree = tree.left
    if isinstance(tree, Unary) and tree.operator == "°":
        return beside
    return isinstance(tree, Unary) or (beside and isinstance(tree, Number | Angle))


def _call(function: str, raised: str, arguments: list[str]) -> str:
    if function == "sqrt":
        return rf"\sqrt{{{arguments[0]}}}"
    if function == "root":
        return rf"\sqrt[{arguments[1]}]{{{arguments[0]}}}"
    if function == "abs":
        return rf"\left|{arguments[0]}\right|"
    if function == "macaulay":
        return rf"\left\langle {arguments[0]} \right\rangle^{{{arguments[1]}}}"
    head = HEADS.get(function) or rf"\operatorname{{{function}}}"
    return rf"{head}{raised}\left({'; '.join(arguments)}\right)"
