"""The answer language, units and the judges of one answer.

A judge is imported when it is first named: a file of numbers is graded without the judges of matrices.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from graders.judge import Domain, Echo, Formula, Grader, Reference, Samples, States, Value
from graders.language import AnswerSyntaxError, Symbols
from graders.verdict import Code, Outcome, Verdict

if TYPE_CHECKING:
    from graders.kinds.choice import Choice
    from graders.kinds.choices import Choices
    from graders.kinds.dh_table import DHTable
    from graders.kinds.diagram import Diagram
    from graders.kinds.equation import Equation
    from graders.kinds.expression import Expression
    from graders.kinds.function import Function
    from graders.kinds.inequality import Inequality
    from graders.kinds.integer import Integer
    from graders.kinds.matrix import Matrix
    from graders.kinds.ordering import Ordering
    from graders.kinds.polygon import Polygon
    from graders.kinds.quantity import Quantity
    from graders.kinds.rates import Rates
    from graders.kinds.rational import Rational
    from graders.kinds.samples import Series
    from graders.kinds.set import Set
    from graders.kinds.symbolic_matrix import SymbolicMatrix
    from graders.kinds.system import System
    from graders.kinds.text import Text

    KINDS: dict[str, type[Grader]]

JUDGES = {  # one row an answer kind: the class and its module, which has the name of the kind
    "Choice": "choice",
    "Choices": "choices",
    "DHTable": "dh_table",
    "Diagram": "diagram",
    "Equation": "equation",
    "Expression": "expression",
    "Function": "function",
    "Inequality": "inequality",
    "Integer": "integer",
    "Matrix": "matrix",
    "Ordering": "ordering",
    "Polygon": "polygon",
    "Quantity": "quantity",
    "Rates": "rates",
    "Rational": "rational",
    "Series": "samples",
    "Set": "set",
    "SymbolicMatrix": "symbolic_matrix",
    "System": "system",
    "Text": "text",
}

__all__ = [
    "KINDS",
    "AnswerSyntaxError",
    "Choice",
    "Choices",
    "Code",
    "DHTable",
    "Diagram",
    "Domain",
    "Echo",
    "Equation",
    "Expression",
    "Formula",
    "Function",
    "Grader",
    "Inequality",
    "Integer",
    "Matrix",
    "Ordering",
    "Outcome",
    "Polygon",
    "Quantity",
    "Rates",
    "Rational",
    "Reference",
    "Samples",
    "Series",
    "Set",
    "States",
    "SymbolicMatrix",
    "Symbols",
    "System",
    "Text",
    "Value",
    "Verdict",
]


def __getattr__(name: str) -> Any:
    """Import a judge; `KINDS` maps the kinds to their judges."""
    if name == "KINDS":
        return {kind: getattr(import_module(f"graders.kinds.{kind}"), judge) for judge, kind in JUDGES.items()}
    if name in JUDGES:
        return getattr(import_module(f"graders.kinds.{JUDGES[name]}"), name)
    raise AttributeError(f"module 'graders' has no attribute {name!r}")
