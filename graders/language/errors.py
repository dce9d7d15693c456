"""Why a text could not be read: a reason, a place, and where possible a proposal."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Reason(StrEnum):
    """Reasons for which a text is unreadable; `graders/locales/` words each of them."""

    EMPTY = "empty"
    TOO_LONG = "too_long"
    TOO_DEEP = "too_deep"
    TOO_LARGE = "too_large"
    BAD_CHARACTER = "bad_character"
    LOOK_ALIKE = "look_alike"
    UNKNOWN_NAME = "unknown_name"
    FORBIDDEN_NAME = "forbidden_name"
    UNKNOWN_UNIT = "unknown_unit"
    OTHER_UNIT = "other_unit"
    DIRECTION = "direction"
    TWO_VALUES = "two_values"
    NEEDS_OPERAND = "needs_operand"
    NEEDS_BRACKET = "needs_bracket"
    NEEDS_OPERATOR = "needs_operator"
    EMPTY_BOX = "empty_box"
    TURNED_CHAIN = "turned_chain"
    MIXED_NUMBER = "mixed_number"
    NEEDS_ARGUMENTS = "needs_arguments"
    EXTRA_BRACKET = "extra_bracket"
    EXTRA_TEXT = "extra_text"
    AMBIGUOUS_ARGUMENT = "ambiguous_argument"
    AMBIGUOUS_FRACTION = "ambiguous_fraction"
    INVERSE_OR_RECIPROCAL = "inverse_or_reciprocal"
    MISSING_ENTRY = "missing_entry"
    RAGGED_MATRIX = "ragged_matrix"
    WRONG_SHAPE = "wrong_shape"
    NOT_A_NUMBER = "not_a_number"
    NOT_AN_INTEGER = "not_an_integer"
    NOT_A_FRACTION = "not_a_fraction"
    NOT_A_CHOICE = "not_a_choice"
    REPEATED_ITEM = "repeated_item"
    MISSING_ITEM = "missing_item"
    NEEDS_COMPONENTS = "needs_components"
    NOT_AN_EXPRESSION = "not_an_expression"
    NEEDS_RANGE = "needs_range"
    NOT_A_POLYNOMIAL = "not_a_polynomial"
    NOT_A_TABLE = "not_a_table"
    NO_SUCH_COLUMN = "no_such_column"
    NEEDS_VECTORS = "needs_vectors"
    NOT_A_LINE = "not_a_line"
    UNKNOWN_NODE = "unknown_node"
    NEEDS_NODES = "needs_nodes"
    NEEDS_LENGTH_AND_ANGLE = "needs_length_and_angle"
    NOT_AN_EQUATION = "not_an_equation"
    NOT_AN_INEQUALITY = "not_an_inequality"
    NOT_A_CLOSURE = "not_a_closure"
    IMPULSE = "impulse"
    OUT_OF_RANGE = "out_of_range"


@dataclass(frozen=True, slots=True)
class Proposal:
    """What stood there, and what may have been meant (empty when nothing is proposed)."""

    found: str = ""
    meant: str = ""


class AnswerSyntaxError(ValueError):
    """The text is not an answer in the answer language.

    Attributes:
        reason: Why it could not be read.
        position: 0-based code point in the text as typed.
        proposal: What was found there and what may have been meant.
    """

    def __init__(self, reason: Reason, position: int, found: str = "", meant: str = "") -> None:
        super().__init__(f"{reason.value} at {position}: {found!r}" + (f", meant {meant!r}?" if meant else ""))
        self.reason = reason
        self.position = position
        self.proposal = Proposal(found, meant)

    def moved(self, position: int) -> AnswerSyntaxError:
        """Give the same error at another place."""
        return AnswerSyntaxError(self.reason, position, self.proposal.found, self.proposal.meant)
