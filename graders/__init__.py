"""The answer language, units and the judges of one answer."""

from graders.judge import Echo, Formula, Grader, Reference, Samples, States, Value
from graders.kinds.choice import Choice
from graders.kinds.expression import Expression
from graders.kinds.integer import Integer
from graders.kinds.matrix import Matrix
from graders.kinds.quantity import Quantity
from graders.language import AnswerSyntaxError, Symbols
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
