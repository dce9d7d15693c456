"""Tree to text that reads back as the same tree, and to LaTeX and MathML for eyes."""

from __future__ import annotations

from graders.language.tree import Angle, Binary, Call, Grid, Index, Name, Number, Relation, Tree, Unary

LEVELS = {"+": 1, "-": 1, "±": 1, "*": 2, "/": 2, "^": 4}
ATOM = 5


def level(tree: Tree) -> int:
    """Give how tightly the outermost operation binds: sum 1, product 2, sign 3, power 4, atom 5."""
    match tree:
        case Relation():
            return 0
        case Binary(operator=operator):
            return LEVELS[operator]
        case Unary(operator="°") | Angle():
            return ATOM - 1
        case Unary():
            return 3
        case Call(function="macaulay"):  # written with its power: <u>^n
            return ATOM - 1
        case _:
            return ATOM


def number_text(number: Number) -> str:
    """Write a literal."""
    return f"{number.digits}e{number.exponent}" if number.exponent else number.digits


def text_of(tree: Tree) -> str:
    """Write a tree as a student could type it; `parse` reads the same tree back."""
    match tree:
        case Number():
            return number_text(tree)
        case Name(name=name):
            return name
        case Unary(operator="°", operand=operand):
            return _in(operand, ATOM) + "°"
        case Unary(operator=operator, operand=operand):
            return operator + _in(operand, 3)
        case Binary():
            return _binary(tree)
        case Call(function="macaulay", arguments=(inside, power)):
            return f"<{_in(inside, 1)}>^{_in(power, 3)}"
        case Call(function=function, arguments=arguments):
            return f"{function}({'; '.join(text_of(a) for a in arguments)})"
        case Angle(degrees=degrees, minutes=minutes, seconds=seconds):
            tail = f'{number_text(seconds)}"' if seconds else ""
            return f"{number_text(degrees)}°{number_text(minutes)}'{tail}"
        case Grid(rows=rows):
            return "[" + ", ".join("[" + "; ".join(text_of(e) for e in row) + "]" for row in rows) + "]"
        case Index(matrix=matrix, row=row, column=column):
            return f"{text_of(matrix)}[{row}; {column}]"
        case Relation(operators=operators, sides=sides):
            pieces = [text_of(sides[0])]
            for operator, side in zip(operators, sides[1:], strict=True):
                pieces += [operator, text_of(side)]
            return " ".join(pieces)


def _in(tree: Tree, least: int) -> str:
    return text_of(tree) if level(tree) >= least else f"({text_of(tree)})"


def _binary(tree: Binary) -> str:
    if tree.operator == "^":
        return f"{_in(tree.left, ATOM)}^{_in(tree.right, 3)}"
    pieces: list[str] = []
    node: Tree = tree
    while isinstance(node, Binary) and node.operator != "^":  # a long sum is no deep one
        least, doubt = LEVELS[node.operator], node.implicit and fraction(node.left)
        pieces.append(_after(node))
        node = node.left
        if level(node) < least or doubt:
            return f"({text_of(node)})" + "".join(reversed(pieces))
    return text_of(node) + "".join(reversed(pieces))


def _after(tree: Binary) -> str:
    """Write an operator and its right operand."""
    if tree.implicit:
        return f" ({text_of(tree.right)})" if _glues(tree.right) else f" {_in(tree.right, 4)}"
    here = LEVELS[tree.operator]
    gap = " " if here == 1 else ""
    return f"{gap}{tree.operator}{gap}{_in(tree.right, here + 1)}"


def fraction(tree: Tree) -> bool:
    """Tell whether a tree is a fraction whose end is in doubt when something follows; 1/2 x is not."""
    plain = isinstance(tree, Binary) and isinstance(tree.left, Number) and isinstance(tree.right, Number)
    return isinstance(tree, Binary) and tree.operator == "/" and not plain


def _glues(tree: Tree) -> bool:
    """Tell whether a right factor, put beside another, would read as something else."""
    while isinstance(tree, Binary) and tree.operator == "^":
        tree = tree.left
    return isinstance(tree, Number | Grid | Angle) or (isinstance(tree, Unary) and tree.operator == "°")
