"""Equations to residuals with the same zeros: signs, powers, roots and plain factors go."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from operator import add

from graders.language.program import Program
from graders.language.tree import Binary, Call, Name, Number, Relation, Tree, Unary, children, names, walk

TOTAL = frozenset(("abs", "atan", "sinh", "tanh", "sign"))  # zero where the argument is, with a value everywhere
SAME_ZEROS = TOTAL | {"sqrt", "asin"}
MOST_CLEARED = 4  # denominators that hold the unknown
BENT = 3  # a degree that is neither first nor second


def is_equation(tree: Tree) -> bool:
    """Tell whether a tree is one equation with one equals sign."""
    return isinstance(tree, Relation) and tree.operators == ("=",)


def residual(equation: Relation) -> Tree:
    """Give left minus right; a side that is zero is left out."""
    left, right = equation.sides
    if _zero(right):
        return left
    return right if _zero(left) else Binary("-", left, right)


def reduced(tree: Tree, unknowns: frozenset[str]) -> Tree:
    """Give a tree with the same zeros where it is defined, without what only changes sign, size or multiplicity.

    A root of what is free of the unknowns is left as it is: nothing else tells where it has no value.
    """
    bare = _bare(tree)
    if bare is not tree and unknowns.isdisjoint(names(bare)):
        return _bare(tree, roots=False)
    match bare:
        case Binary(operator="*", left=left, right=right):
            if _plain(left, unknowns):
                return reduced(right, unknowns)
            if _plain(right, unknowns):
                return reduced(left, unknowns)
            return Binary("*", reduced(left, unknowns), reduced(right, unknowns))
        case Binary(operator="/", left=left, right=right) if _plain(right, unknowns):
            return reduced(left, unknowns)
    return bare


def _bare(tree: Tree, roots: bool = True) -> Tree:
    """Leave out signs, powers and functions around a tree that are zero where it is; roots and arcs if asked."""
    while True:
        match tree:
            case Unary(operator="+" | "-" | "°", operand=inside):
                tree = inside
            case Call(function=function, arguments=(inside,)) if function in (SAME_ZEROS if roots else TOTAL):
                tree = inside
            case Call(function="root", arguments=(inside, degree)) if roots and _positive(degree):
                tree = inside
            case Binary(operator="^", left=inside, right=power) if _positive(power) and (roots or _whole(power)):
                tree = inside
            case _:
                return tree


def factors(tree: Tree) -> list[Tree]:
    """Give the factors of a reduced tree: it is zero where one of them is."""
    if isinstance(tree, Binary) and tree.operator == "*":
        return [*factors(tree.left), *factors(tree.right)]
    return [tree]


def cleared(tree: Tree, unknown: str) -> Tree:
    """Give the numerator of a tree over the denominators that hold an unknown: zero where the tree is, and at poles.

    A tree with many of them is given as it is: its numerator would be far longer.
    """
    held = sum(isinstance(node, Binary) and _divides_by(node, unknown) for node in walk(tree))
    return _fraction(tree, unknown)[0] if 0 < held <= MOST_CLEARED else tree


def _fraction(tree: Tree, unknown: str) -> tuple[Tree, Tree | None]:
    """Give a numerator and a denominator, if there is one."""
    match tree:
        case Binary(operator="+" | "-", left=left, right=right):
            (a, b), (c, d) = _fraction(left, unknown), _fraction(right, unknown)
            return Binary(tree.operator, _product(a, d), _product(c, b)), b if d is None else _product(d, b)
        case Binary(operator="*", left=left, right=right):
            (a, b), (c, d) = _fraction(left, unknown), _fraction(right, unknown)
            return _product(a, c), b if d is None else _product(d, b)
        case Binary(operator="/", left=left, right=right) if _divides_by(tree, unknown):
            (a, b), (c, d) = _fraction(left, unknown), _fraction(right, unknown)
            return _product(a, d), _product(c, b)
        case Binary(operator="/", left=left, right=right):
            a, b = _fraction(left, unknown)
            return Binary("/", a, right), b
    return tree, None


def _product(one: Tree, other: Tree | None) -> Tree:
    return one if other is None else Binary("*", one, other)


def _divides_by(tree: Binary, unknown: str) -> bool:
    """Tell a quotient by something of first or second degree in the unknown: it is finite where its parts are."""
    return tree.operator == "/" and 0 < degrees(tree.right, {}).get(unknown, 0) < BENT


def degrees(tree: Tree, known: Mapping[str, Mapping[str, int]]) -> dict[str, int]:
    """Give the degree of a tree in each symbol it holds, as it is written: 1, 2, or 3 for all else.

    Args:
        tree: The tree.
        known: The degrees of names that stand for other trees.
    """
    match tree:
        case Name(name=name):
            return dict(known.get(name, {name: 1}))
        case Unary(operand=operand):
            return degrees(operand, known)
        case Binary(operator="+" | "-", left=left, right=right):
            return _joined(degrees(left, known), degrees(right, known), max)
        case Binary(operator="*", left=left, right=right):
            return _joined(degrees(left, known), degrees(right, known), add)
        case Binary(operator="/", left=left, right=right):
            return _joined(degrees(left, known), _bent(degrees(right, known)), add)
        case Binary(operator="^", left=left, right=Number(digits="2", exponent=0)):
            found = degrees(left, known)
            return _joined(found, found, add)
        case _:
            return _bent({name: 1 for part in children(tree) for name in degrees(part, known)})


def degrees_along(program: Program, symbol: int) -> list[int]:
    """Give the degree of every slot of a program in one of its inputs, as `degrees` does for a tree."""
    first = len(program.inputs)
    found = [0] * (first + len(program.operations) + len(program.literals))  # literals count from the end
    found[symbol] = 1
    for slot, (name, arguments) in enumerate(program.operations, first):
        own = [found[at] for at in arguments]
        if any(own):
            found[slot] = min(BENT, _degree(name, own))
    return found


def _degree(name: str, own: Sequence[int]) -> int:
    match name:
        case "+" | "-":
            return max(own)
        case "*":
            return own[0] + own[1]
        case "/":
            return BENT if own[1] else own[0]
        case "power2":
            return 2 * own[0]
    return own[0] if name in ("negate", "degrees") else BENT


def divides(program: Program, along: Sequence[int]) -> bool:
    """Tell by the degrees of its slots whether a program divides by something that `cleared` multiplies with."""
    return any(name == "/" and 0 < along[arguments[1]] < BENT for name, arguments in program.operations)


def _joined(one: dict[str, int], other: dict[str, int], join: Callable[[int, int], int]) -> dict[str, int]:
    return one | {name: min(BENT, join(one[name], degree)) if name in one else degree for name, degree in other.items()}


def _bent(found: dict[str, int]) -> dict[str, int]:
    return dict.fromkeys(found, BENT)


def _zero(tree: Tree) -> bool:
    return isinstance(tree, Number) and not tree.digits.strip("0.")


def _positive(tree: Tree) -> bool:
    """Tell a positive constant exponent: a number, or a fraction of numbers."""
    if isinstance(tree, Binary) and tree.operator == "/":
        return _positive(tree.left) and _positive(tree.right)
    return isinstance(tree, Number) and not _zero(tree)


def _whole(power: Tree) -> bool:
    return isinstance(power, Number) and power.whole


def _plain(tree: Tree, unknowns: frozenset[str]) -> bool:
    """Tell a factor that is not zero at a general point and does not hold an unknown."""
    return (isinstance(tree, Number) and not _zero(tree)) or (isinstance(tree, Name) and tree.name not in unknowns)
