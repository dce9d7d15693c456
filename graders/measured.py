"""Constants that carry a unit inside a formula, as entries of a matrix do: `1,5 m`, `-12 kN*m`, `2*3 rad/s`."""

from __future__ import annotations

import re

from graders.language import doubles
from graders.language.errors import AnswerSyntaxError
from graders.language.symbols import function_named, key
from graders.language.tree import Binary, Name, Number, Tree, Unary, names
from graders.units import NONE, Unit, read_unit, times

WORD = re.compile(r"[^\W\d_]{1,24}")
HIGHEST = 9  # power of a unit


def units_in(text: str) -> dict[str, str]:
    """Give the words of a text that are units, by the key under which a symbol is found."""
    found = {key(word): word for word in WORD.findall(text) if not function_named(word) and key(word) != "pi"}
    return {meant: word for meant, word in found.items() if _is_unit(word)}


def measured(tree: Tree) -> tuple[float, Unit] | None:
    """Give the number and the unit of a constant in which names are units; None for a sum or another formula of them.

    Raises:
        ValueError: The constant has no value.
    """
    if not names(tree):
        (number,) = doubles.run(doubles.line_runner(tree), [])
        return (number, NONE) if isinstance(number, float) else None
    match tree:
        case Name(name=name):
            return 1.0, read_unit(name)
        case Unary(operator="-" | "+" as sign, operand=operand):
            inner = measured(operand)
            return inner and ((-inner[0] if sign == "-" else inner[0]), inner[1])
        case Binary(operator="*" | "/" as operator, left=left, right=right):
            one, other = measured(left), measured(right)
            return one and other and _product(one, other, 1 if operator == "*" else -1)
        case Binary(operator="^", left=Name(name=name), right=Number(whole=True) as power):
            return (1.0, times(NONE, read_unit(name), int(power.exact))) if power.exact <= HIGHEST else None
    return None


def _product(one: tuple[float, Unit], other: tuple[float, Unit], power: int) -> tuple[float, Unit]:
    return one[0] * other[0] ** power, times(one[1], other[1], power)


def _is_unit(word: str) -> bool:
    try:
        read_unit(word)
    except AnswerSyntaxError:
        return False
    return True
