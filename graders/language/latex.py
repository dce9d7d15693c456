"""Tree to LaTeX, for reports and worked solutions."""

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
NATIVE = ("sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "exp", "ln", "log", "min", "max")


def latex_of(tree: Tree) -> str:
    """Write a tree as LaTeX mathematics (no dollar signs)."""
    match tree:
        case Number(digits=digits, exponent=exponent):
            return rf"{digits} \cdot 10^{{{exponent}}}" if exponent else digits
        case Name(name=name):
            return _name(name)
        case Unary(operator="°", operand=operand):
            return _fenced(operand, ATOM) + r"^{\circ}"
        case Unary(operator=operator, operand=operand):
            return operator + _fenced(operand, 2)
        case Binary(operator=operator, left=left, right=right):
            return _binary(operator, left, right, tree.implicit)
        case Call(function=function, arguments=arguments):
            return _call(function, [latex_of(a) for a in arguments])
        case Angle(degrees=degrees, minutes=minutes, seconds=seconds):
            tail = f"{seconds.digits}''" if seconds else ""
            return rf"{degrees.digits}^{{\circ}}{minutes.digits}'{tail}"
        case Grid(rows=rows):
            body = r" \\ ".join(" & ".join(latex_of(e) for e in row) for row in rows)
            return rf"\begin{{bmatrix}} {body} \end{{bmatrix}}"
        case Index(matrix=matrix, row=row, column=column):
            return rf"{latex_of(matrix)}_{{{row},{column}}}"
        case Relation(operators=operators, sides=sides):
            pieces = [latex_of(sides[0])]
            for operator, side in zip(operators, sides[1:], strict=True):
                pieces.append(OPERATORS[operator] + latex_of(side))
            return "".join(pieces)


def _name(name: str) -> str:
    letter, below, dots, primes = split_symbol(name)
    core = _letter(letter) if len(letter) == 1 else rf"\mathit{{{letter}}}"
    core = {0: core, 1: rf"\dot{{{core}}}", 2: rf"\ddot{{{core}}}"}[dots]
    return (f"{core}_{{{_letter(below)}}}" if below else core) + primes


def _letter(letter: str) -> str:
    word = GREEK.get(letter)
    return f"\\{word}" if word else letter


def _fenced(tree: Tree, least: int) -> str:
    inner = latex_of(tree)
    return inner if level(tree) >= least else rf"\left({inner}\right)"


def _binary(operator: str, left: Tree, right: Tree, implicit: bool) -> str:
    if operator == "/":
        return rf"\frac{{{latex_of(left)}}}{{{latex_of(right)}}}"
    if operator == "^":
        return f"{_fenced(left, ATOM)}^{{{latex_of(right)}}}"
    least = 1 if operator in "+-" else 2
    sign = r"\," if implicit else OPERATORS[operator]
    return _fenced(left, least) + sign + _fenced(right, least + (operator != "+"))


def _call(function: str, arguments: list[str]) -> str:
    if function == "sqrt":
        return rf"\sqrt{{{arguments[0]}}}"
    if function == "root":
        return rf"\sqrt[{arguments[1]}]{{{arguments[0]}}}"
    if function == "abs":
        return rf"\left|{arguments[0]}\right|"
    if function == "macaulay":
        return rf"\left\langle {arguments[0]} \right\rangle^{{{arguments[1]}}}"
    head = f"\\{function}" if function in NATIVE else rf"\operatorname{{{function}}}"
    return rf"{head}\left({'; '.join(arguments)}\right)"
