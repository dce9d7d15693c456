"""What a student's relations say, as plain lists that a page can evaluate without running any text.

A formula is a number, a name, or a list of an operation and its formulas: `["+", "l1", ["*", 2, "l2"]]`. A diagram
is the rows of its table.
"""

from __future__ import annotations

from typing import Any, TypeAlias

from exercises import solving
from exercises.exercise import Variant
from graders import Diagram
from graders.language.errors import AnswerSyntaxError
from graders.language.tree import Angle, Binary, Call, Name, Number, Tree, Unary
from graders.polygon.drawn import Drawn, Equation
from graders.polygon.rates import Differentiated

Json: TypeAlias = Any
SIGNS = {"-": "negate", "°": "degrees"}


def relations(variant: Variant, answer: str, text: str) -> dict[str, Json] | None:
    """Give the formulas of one typed answer; None where it holds none, cannot be read, or is beyond doubles.

    Args:
        variant: The variant answered.
        answer: Name of the answer.
        text: What is typed.

    Raises:
        KeyError: The exercise does not ask for this answer.
    """
    solved = solving.solved(variant)
    grader = solved.answers[answer]
    try:
        read = grader.parse(text, solved.symbols(answer))
        if isinstance(grader, Diagram):
            return {"rows": grader.rows(read, getattr(variant.givens, "L", None))}
        return _listed(read)
    except (AnswerSyntaxError, OverflowError):
        return None


def _listed(read: Any) -> dict[str, Json] | None:
    match read:
        case Drawn():
            return _polygon(read)
        case Differentiated():
            return {"equations": _equations(read.equations), "said": [list(pair) for pair in read.said]}
        case Number() | Name() | Unary() | Binary() | Call() | Angle():
            return {"formula": listed(read)}
        case _:
            return None


def _polygon(drawn: Drawn) -> dict[str, Json]:
    vectors = [
        {"start": v.start, "end": v.end, "length": listed(v.length), "angle": listed(v.angle)} for v in drawn.vectors
    ]
    return {"vectors": vectors, "equations": _equations(drawn.equations)}


def _equations(equations: tuple[Equation, ...]) -> list[Json]:
    return [{"axis": one.axis, "zero": listed(one.difference)} for one in equations]


def listed(tree: Tree) -> Json:
    """Write a formula as lists.

    Raises:
        OverflowError: A number is too large for a double.
        TypeError: A matrix, an entry of one or a relation, which are no formulas of a number.
    """
    match tree:
        case Number():
            return float(tree.exact)
        case Name(name=name):
            return name
        case Unary(operator=operator, operand=operand):
            return [SIGNS[operator], listed(operand)] if operator in SIGNS else listed(operand)
        case Binary(operator=operator, left=left, right=right):
            return [operator, listed(left), listed(right)]
        case Call(function=function, arguments=arguments):
            return [function, *map(listed, arguments)]
        case Angle(degrees=degrees, minutes=minutes, seconds=seconds):
            parts = (degrees.exact, minutes.exact, seconds.exact if seconds else 0)
            return ["degrees", float(parts[0] + parts[1] / 60 + parts[2] / 3600)]
        case _:
            raise TypeError(f"{type(tree).__name__} is no formula of a number")
