"""The answer language, units and the judges of one answer."""

from graders.choice import Choice
from graders.expression import Expression
from graders.integer import Integer
from graders.judge import Echo, Formula, Grader, Reference, Samples, States, Value
from graders.language import AnswerSyntaxError, Symbols
from graders.matrix import Matrix
from graders.quantity import Quantity
from graders.verdict import Code, Outcome, Verdict

KINDS: dict[str, type[Grader]] = {  # one row an answer kind
    "choice": Choice,
    "expression": Expression,
    "integer": Integer,
    "matrix": Matrix,
    "quantity": Quantity,
}

__all__ = [
    "KINDS",
    "AnswerSyntaxError",
    "Choice",
    "Code",
    "Echo",
    "Expression",
    "Formula",
    "Grader",
    "Integer",
    "Matrix",
    "Outcome",
    "Quantity",
    "Reference",
    "Samples",
    "States",
    "Symbols",
    "Value",
    "Verdict",
]
