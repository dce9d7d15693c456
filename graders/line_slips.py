"""Slips in one line of a solution: what students write for a formula, one thing in it changed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import lru_cache
from itertools import combinations

from graders.common_slips import CommonSlip
from graders.language.tree import Binary, Call, Grid, Index, Name, Number, Tree, Unary, children, mapped, names, walk

MOST = 240  # changed lines of a line
TURNING = ("sin", "cos", "tan", "cot")
SWAPPED = {"sin": ("cos",), "cos": ("sin",), "tan": ("cot",), "asin": ("acos", "atan"), "acos": ("asin", "atan")}
SWAPPED |= {"atan": ("asin", "acos", "acot"), "sinh": ("cosh",), "cosh": ("sinh",), "min": ("max",), "max": ("min",)}
Changed = tuple[CommonSlip, Tree]


@lru_cache(maxsize=1024)
def slips_in(line: Tree) -> tuple[Changed, ...]:
    """Give the lines that one slip makes of a line, each once."""
    found = dict.fromkeys((tree, slip) for slip, tree in (*_anywhere(line), *_throughout(line)) if tree != line)
    return tuple((slip, tree) for tree, slip in found)[:MOST]


def _throughout(line: Tree) -> Iterator[Changed]:
    """Change every sine, or every occurrence of a name."""
    yield CommonSlip.SINE_COSINE, mapped(line, _turned)
    yield CommonSlip.FACTOR_LOST, mapped(line, _unprojected)
    for stem in sorted({name.rstrip("0123456789") for name in names(line)}):
        yield CommonSlip.FACTOR_LOST, mapped(line, _without(stem))
    entries = dict.fromkeys(node for node in walk(line) if isinstance(node, Index))
    for entry, second in combinations(entries, 2):
        yield CommonSlip.EXCHANGED, mapped(line, _swapping(entry, second))
    matrices = {node.matrix for node in walk(line) if isinstance(node, Index)}
    for one, other in combinations(sorted(name for name in names(line) if Name(name) not in matrices), 2):
        if _alike(one, other):
            yield CommonSlip.EXCHANGED, mapped(line, _renamed({one: other, other: one}))
            if len(one) > 1:
                yield CommonSlip.EXCHANGED, mapped(line, _renamed({one: other}))
                yield CommonSlip.EXCHANGED, mapped(line, _renamed({other: one}))
                yield from ((CommonSlip.EXCHANGED, changed) for changed in _renamed_once(line, one, other))
                yield from ((CommonSlip.EXCHANGED, changed) for changed in _renamed_once(line, other, one))


def _renamed_once(tree: Tree, old: str, new: str) -> Iterator[Tree]:
    if tree == Name(old):
        yield Name(new)
    for child in dict.fromkeys(children(tree)):
        yield from (_with(tree, child, changed) for changed in _renamed_once(child, old, new))


def _alike(one: str, other: str) -> bool:
    """Tell whether two names are of one kind: `l1` and `l2`, or single letters such as `b` and `h`."""
    stem = one.rstrip("0123456789")
    return (len(one) == len(other) == 1) or (stem == other.rstrip("0123456789") and stem != one)


def _without(stem: str) -> Callable[[Tree], Tree]:
    """Leave a factor out of every term: the lengths `l1`, `l2`, … of all segments."""

    def kept(node: Tree) -> Tree:
        match node:
            case Binary(operator="*", left=left, right=Name(name=name)) if name.rstrip("0123456789") == stem:
                return left
            case Binary(operator="*", left=Name(name=name), right=right) if name.rstrip("0123456789") == stem:
                return right
            case _:
                return node

    return kept


def _swapping(one: Tree, other: Tree) -> Callable[[Tree], Tree]:
    pair = {one: other, other: one}
    return lambda node: pair.get(node, node) if isinstance(node, Index) else node


def _renamed(pairs: dict[str, str]) -> Callable[[Tree], Tree]:
    return lambda node: Name(pairs.get(node.name, node.name)) if isinstance(node, Name) else node


def _turned(node: Tree) -> Tree:
    if isinstance(node, Call) and node.function in ("sin", "cos"):
        return Call(SWAPPED[node.function][0], node.arguments)
    return node


def _unprojected(node: Tree) -> Tree:
    """Leave out a sine or a cosine that stands as a factor."""
    match node:
        case Binary(operator="*", left=left, right=Call(function="sin" | "cos")):
            return left
        case Binary(operator="*", left=Call(function="sin" | "cos"), right=right):
            return right
        case _:
            return node


def _anywhere(tree: Tree, inside: bool = False) -> Iterator[Changed]:
    """Change one node of a tree; inside a sine nobody halves a term."""
    yield from ((slip, changed) for slip, changed in _here(tree) if not (inside and slip is CommonSlip.FACTOR_TWO))
    for child in dict.fromkeys(_parts(tree)):
        for slip, changed in _anywhere(child, inside or (isinstance(tree, Call) and tree.function in TURNING)):
            yield slip, _with(tree, child, changed)


def _parts(tree: Tree) -> tuple[Tree, ...]:
    """Give the subtrees in which slips are made: no exponents, no brackets of Macaulay, which slips only close."""
    match tree:
        case Binary(operator="^", left=base):
            return (base,)
        case Call(function="macaulay"):
            return ()
        case _:
            return children(tree)


def _with(tree: Tree, old: Tree, new: Tree) -> Tree:
    """Put a subtree in the place of another."""
    match tree:
        case Unary():
            return replace(tree, operand=new)
        case Binary(left=left, right=right):
            return replace(tree, left=new) if left == old else replace(tree, right=new) if right == old else tree
        case Call(arguments=arguments):
            return replace(tree, arguments=_put(arguments, old, new))
        case Grid(rows=rows):
            return Grid(tuple(_put(row, old, new) for row in rows))
        case Index():
            return replace(tree, matrix=new)
        case _:
            return tree


def _put(entries: tuple[Tree, ...], old: Tree, new: Tree) -> tuple[Tree, ...]:
    if old not in entries:
        return entries
    at = entries.index(old)
    return (*entries[:at], new, *entries[at + 1 :])


def _here(tree: Tree) -> Iterator[Changed]:
    match tree:
        case Unary(operator="-", operand=operand):
            yield CommonSlip.TERM_SIGN, operand
        case Number() if tree.whole and int(tree.digits) > 1:
            yield CommonSlip.FACTOR_TWO, Number(str(2 * int(tree.digits)))
            if int(tree.digits) % 2 == 0:
                yield CommonSlip.FACTOR_TWO, Number(str(int(tree.digits) // 2))
        case Binary(operator="+" | "-"):
            yield from _in_sum(tree)
        case Binary(operator="*" | "/"):
            yield from _in_product(tree)
        case Binary(operator="^", left=base, right=Number(exponent=0, digits=power)) if power.isdigit():
            yield CommonSlip.POWER, base
            for other in {int(power) - 1, int(power) + 1} - {0, 1}:
                yield CommonSlip.POWER, Binary("^", base, Number(str(other)))
        case Call():
            yield from _in_call(tree)


def _in_sum(tree: Binary) -> Iterator[Changed]:
    left, right = tree.left, tree.right
    minus = tree.operator == "-"
    yield CommonSlip.TERM_SIGN, replace(tree, operator="+" if minus else "-")
    if minus:
        yield CommonSlip.TERM_SIGN, Binary("-", right, left)
    yield CommonSlip.TERM_LOST, left
    yield CommonSlip.FACTOR_TWO, replace(tree, right=_doubled(right))
    yield CommonSlip.FACTOR_TWO, replace(tree, right=_halved(right))
    if not (isinstance(left, Binary) and left.operator in "+-"):
        yield CommonSlip.TERM_SIGN, replace(tree, left=left.operand if isinstance(left, Unary) else Unary("-", left))
        yield CommonSlip.TERM_LOST, Unary("-", right) if minus else right
        yield CommonSlip.FACTOR_TWO, replace(tree, left=_doubled(left))
        yield CommonSlip.FACTOR_TWO, replace(tree, left=_halved(left))


def _doubled(term: Tree) -> Tree:
    return Binary("*", Number("2"), term)


def _halved(term: Tree) -> Tree:
    return Binary("/", term, Number("2"))


def _in_product(tree: Binary) -> Iterator[Changed]:
    left, right = tree.left, tree.right
    over = tree.operator == "/"
    yield CommonSlip.FACTOR_LOST, left
    turned = bool(names(tree))  # nobody turns over pi/2; and 2*pi would be an angle of zero
    if turned:
        yield CommonSlip.UPSIDE_DOWN, replace(tree, operator="*" if over else "/", implicit=False)
    if over and turned:
        yield CommonSlip.UPSIDE_DOWN, Binary("/", right, left)
        for factor, rest in _split(left):
            yield CommonSlip.UPSIDE_DOWN, Binary("/", Binary("*", factor, right), rest)
    if not (isinstance(left, Binary) and left.operator in "*/") or _plain_quotient(left):
        rest = Binary("/", Number("1"), right) if over else right
        yield CommonSlip.FACTOR_LOST, Unary("-", rest) if isinstance(left, Unary) else rest


def _split(product: Tree) -> Iterator[tuple[Tree, Tree]]:
    """Give each factor of a product with the product of the others; the sign goes with the others."""
    match product:
        case Unary(operator="-", operand=operand):
            yield from ((factor, Unary("-", rest)) for factor, rest in _split(operand))
        case Binary(operator="*", left=Binary(operator="*") | Unary() as left, right=right):
            yield right, left
            yield from ((factor, Binary("*", rest, right)) for factor, rest in _split(left))
        case Binary(operator="*", left=left, right=right):
            yield from ((right, left), (left, right))


def _plain_quotient(tree: Tree) -> bool:
    """Tell whether it is one ratio such as `z2/z1`."""
    return isinstance(tree, Binary) and tree.operator == "/" and not isinstance(tree.left, Binary)


def _bases(squares: Tree) -> Tree | None:
    """Draw the root of each square of a sum on its own."""
    match squares:
        case Binary(operator="^", left=base, right=Number(exponent=0, digits="2")):
            return base
        case Binary(operator="+", left=left, right=right) if (one := _bases(left)) and (other := _bases(right)):
            return Binary("+", one, other)
        case _:
            return None


def _in_call(tree: Call) -> Iterator[Changed]:
    slip = CommonSlip.SINE_COSINE if tree.function in ("sin", "cos") else CommonSlip.OTHER_FUNCTION
    for other in SWAPPED.get(tree.function, ()):
        yield slip, Call(other, tree.arguments)
    if tree.function in ("asin", "acos", "atan"):
        yield CommonSlip.TERM_SIGN, Call(tree.function, (Unary("-", tree.arguments[0]),))
    match tree:
        case Call(function="sqrt", arguments=(inner,)):
            yield CommonSlip.POWER, inner
            if isinstance(inner, Binary) and (bases := _bases(inner)):
                yield from ((CommonSlip.POWER, found) for found in (bases, Call("abs", (bases,))))
        case Call(function="root", arguments=(inner, Number(digits=degree))):
            yield CommonSlip.POWER, Call("root", (inner, Number("2" if degree != "2" else "3")))
            yield CommonSlip.POWER, Call("root", (inner, Number("3" if degree == "4" else "4")))
        case Call(function="atan2", arguments=(y, x)):
            yield CommonSlip.EXCHANGED, Call("atan2", (x, y))
            yield CommonSlip.TERM_SIGN, Call("atan2", (Unary("-", y), x))
            yield CommonSlip.TERM_SIGN, Call("atan2", (y, Unary("-", x)))
            yield CommonSlip.OTHER_FUNCTION, Call("atan", (Binary("/", y, x),))
        case Call(function="macaulay", arguments=(inner, Number(digits=order))) if order.isdigit():
            for power in {int(order) - 1, int(order) + 1} - {-1}:
                yield CommonSlip.POWER, Call("macaulay", (inner, Number(str(power))))
        case Call(function="abs", arguments=(inner,)):
            yield CommonSlip.TERM_SIGN, inner
