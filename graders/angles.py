"""Angles in constant expressions: whether a number without a unit says that it is an angle."""

from __future__ import annotations

from dataclasses import replace

from graders.language.tree import Angle, Binary, Call, Name, Tree, Unary, walk

INVERSE = ("asin", "acos", "atan", "acot", "atan2")
PI = Name("pi")


def is_angle(tree: Tree, asked: bool = True) -> bool:
    """Tell whether a constant is an angle in radians: `30°`, `2*asin(0.2)`, `pi/6`, not `cos(30°)`, `0.2*180/pi`.

    Args:
        tree: The constant.
        asked: Whether an angle is asked for; elsewhere a product may be an arc, and an inverse function its factor.
    """
    return (asked and _power_of_pi(tree) == 1) or _turned(tree, asked)


def _turned(tree: Tree, asked: bool = True) -> bool:
    match tree:
        case Angle() | Unary(operator="°"):
            return True
        case Unary(operand=operand):
            return _turned(operand, asked)
        case Call(function=function):
            return asked and function in INVERSE
        case Binary(operator=("+" | "-"), left=left, right=right):
            return _turned(left, asked) or _turned(right, asked)
        case Binary(operator=("*" | "/"), left=left, right=right) if asked:
            turned = _turned(left), _turned(right)
            return any(turned) and PI not in walk(left if turned[1] else right)
    return False


def _power_of_pi(tree: Tree) -> int | None:
    """Give the power of pi that multiplies a constant: 1 for `3*pi/4`, -1 for `0.2*180/pi`; None for a mixed sum."""
    match tree:
        case Name(name="pi"):
            return 1
        case Unary(operator=("+" | "-"), operand=operand):
            return _power_of_pi(operand)
        case Binary(operator=("*" | "/" | "+" | "-") as operator, left=left, right=right):
            one, other = _power_of_pi(left), _power_of_pi(right)
            if one is None or other is None:
                return None
            if operator in "+-":
                return one if one == other else None
            return one + other if operator == "*" else one - other
    return 0


def without_last_degree(tree: Tree) -> Tree | None:
    """Take off the only degree sign where it ends the text, behind more than its number: `-0.0136*180/pi °`."""
    signs = sum(isinstance(node, Angle) or _is_degrees(node) for node in walk(tree))
    bare = _bare_end(tree) if signs == 1 else None
    return bare if bare is not None and not is_angle(bare) else None


def _bare_end(tree: Tree) -> Tree | None:
    match tree:
        case Unary(operator="°", operand=operand):
            return operand
        case Unary(operand=operand):
            end = _bare_end(operand)
            return end and replace(tree, operand=end)
        case Binary(operator=("+" | "-" | "*" | "/" | "^"), right=right):
            end = _bare_end(right)
            return end and replace(tree, right=end)
    return None


def _is_degrees(node: Tree) -> bool:
    return isinstance(node, Unary) and node.operator == "°"
