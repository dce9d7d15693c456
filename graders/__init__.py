"""The answer language, units and the judges of one answer."""

from graders.judge import Echo, Formula, Grader, Reference, Samples, States, Value
from graders.kinds.choice import Choice
from graders.kinds.choices import Choices
from graders.kinds.expression import Expression
from graders.kinds.integer import Integer
from graders.kinds.matrix import Matrix
from graders.kinds.ordering import Ordering
from graders.kinds.quantity import Quantity
from graders.kinds.rational import Rational
from graders.kinds.set import Set
from graders.kinds.text import Text
from graders.language import AnswerSyntaxError, Symbols
from graders.verdict import Code, Outcome, Verdict

KINDS: dict[str, type[Grader]] = {  # one row an answer kind
    "choice": Choice,
    "choices": Choices,
    "expression": Expression,
    "integer": Integer,
    "matrix": Matrix,
    "ordering": Ordering,
    "quantity": Quantity,
    "rational": Rational,
    "set": Set,
    "text": Text,
}

__all__ = [
    "KINDS",
    "AnswerSyntaxError",
    "Choice",
    "Choices",
    "Code",
    "Echo",
    "Expression",
    "Formula",
    "Grader",
    "Integer",
    "Matrix",
    "Ordering",
    "Outcome",
    "Quantity",
    "Rational",
    "Reference",
    "Samples",
    "Set",
    "States",
    "Symbols",
    "Text",
    "Value",
    "Verdict",
]
