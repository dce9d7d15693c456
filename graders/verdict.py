"""Verdicts: a code and its small details, never a sentence; `graders/locales/` words each code."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TypeAlias

from graders.language.errors import AnswerSyntaxError, Proposal, Reason
from graders.remarks import Remarks


class Outcome(StrEnum):
    """What a student is told at a glance."""

    RIGHT = "right"
    PARTLY = "partly"
    WRONG = "wrong"
    UNREADABLE = "unreadable"
    UNDECIDED = "undecided"
    FAULT = "fault"


class Code(StrEnum):
    """What was found; each code has one outcome. Reading errors carry a `Reason` in their details."""

    RIGHT = "right"
    FOLLOWED = "followed"
    WRONG = "wrong"
    OPPOSITE_SIGN = "opposite_sign"
    FACTOR_OF_TEN = "factor_of_ten"
    WRONG_UNIT = "wrong_unit"
    WRONG_DIMENSION = "wrong_dimension"
    NOT_PRECISE = "not_precise"
    ROUNDED_NUMBER = "rounded_number"
    NO_SYMBOLS = "no_symbols"
    NOT_EXACT = "not_exact"
    INVERTED_RATIO = "inverted_ratio"
    UNDEFINED = "undefined"
    NOT_SOLVED = "not_solved"
    NOT_A_PRODUCT = "not_a_product"
    HOLDS_INVERSE = "holds_inverse"
    SOME_ENTRIES = "some_entries"
    SOME_ITEMS = "some_items"
    SOME_BRANCHES = "some_branches"
    LOST_BRANCH = "lost_branch"
    SURPLUS_BRANCH = "surplus_branch"
    DOUBLED_BRANCH = "doubled_branch"
    WRONG_SHAPE = "wrong_shape"
    OPPOSITE_CONVENTION = "opposite_convention"
    SOME_MARKS = "some_marks"
    NO_MARKS = "no_marks"
    # polygons and their derivatives
    NO_LINK = "no_link"
    WRONG_LENGTH = "wrong_length"
    LENGTH_VARIES = "length_varies"
    WRONG_ANGLE = "wrong_angle"
    ANGLE_VARIES = "angle_varies"
    REVERSED_ANGLE = "reversed_angle"
    INTERIOR_ANGLE = "interior_angle"
    OPEN_POLYGON = "open_polygon"
    CLOSURE_SIGN = "closure_sign"
    DEPENDENT_LOOP = "dependent_loop"
    MISSING_LOOP = "missing_loop"
    NO_CLOSURE = "no_closure"
    NO_PROJECTION = "no_projection"
    PROJECTION_SIGN = "projection_sign"
    SINE_COSINE = "sine_cosine"
    TERM_MISSING = "term_missing"
    SWAPPED_PROJECTIONS = "swapped_projections"
    WRONG_PROJECTION = "wrong_projection"
    NOT_DETERMINED = "not_determined"
    NO_UNKNOWNS = "no_unknowns"
    UNKNOWN_MISSING = "unknown_missing"
    UNKNOWN_EXTRA = "unknown_extra"
    CORIOLIS_MISSING = "coriolis_missing"
    CORIOLIS_FACTOR = "coriolis_factor"
    CENTRIPETAL_MISSING = "centripetal_missing"
    TANGENTIAL_MISSING = "tangential_missing"
    SQUARE_MISSING = "square_missing"
    RATE_SIGN = "rate_sign"
    CHAIN_RULE = "chain_rule"
    UNKNOWN_RATE = "unknown_rate"
    WRONG_RATES = "wrong_rates"
    # equations, systems, inequalities
    NOT_SATISFIED = "not_satisfied"
    SOME_EQUATIONS = "some_equations"
    UNDETERMINED = "undetermined"
    LOST_SOLUTION = "lost_solution"
    SURPLUS_SOLUTION = "surplus_solution"
    BORDER = "border"
    SENSE_TURNED = "sense_turned"
    # tables of Denavit and Hartenberg
    TABLE_DEGREES = "table_degrees"
    TABLE_ROUNDED = "table_rounded"
    TABLE_CONVENTION = "table_convention"
    TABLE_SWAPPED = "table_swapped"
    TABLE_COLUMNS = "table_columns"
    TABLE_ROWS = "table_rows"
    TABLE_VARIABLE = "table_variable"
    TABLE_PLACE = "table_place"
    TABLE_VARIABLE_SIGN = "table_variable_sign"
    TABLE_OFFSET = "table_offset"
    TABLE_ALPHA_SIGN = "table_alpha_sign"
    TABLE_ALPHA = "table_alpha"
    TABLE_LENGTH_SIGN = "table_length_sign"
    TABLE_LENGTH = "table_length"
    TABLE_TOOL = "table_tool"
    TABLE_ROW = "table_row"
    EMPTY = "empty"
    UNREADABLE = "unreadable"
    UNDECIDED = "undecided"
    KEPT = "kept"
    FAULT = "fault"


OUTCOMES = {
    Code.RIGHT: Outcome.RIGHT,
    Code.FOLLOWED: Outcome.RIGHT,
    Code.WRONG: Outcome.WRONG,
    Code.OPPOSITE_SIGN: Outcome.WRONG,
    Code.FACTOR_OF_TEN: Outcome.WRONG,
    Code.WRONG_UNIT: Outcome.PARTLY,
    Code.WRONG_DIMENSION: Outcome.WRONG,
    Code.NOT_PRECISE: Outcome.WRONG,
    Code.ROUNDED_NUMBER: Outcome.WRONG,
    Code.NO_SYMBOLS: Outcome.WRONG,
    Code.NOT_EXACT: Outcome.WRONG,
    Code.INVERTED_RATIO: Outcome.WRONG,
    Code.UNDEFINED: Outcome.WRONG,
    Code.NOT_SOLVED: Outcome.PARTLY,
    Code.NOT_A_PRODUCT: Outcome.PARTLY,
    Code.HOLDS_INVERSE: Outcome.PARTLY,
    Code.SOME_ENTRIES: Outcome.PARTLY,
    Code.SOME_ITEMS: Outcome.PARTLY,
    Code.SOME_BRANCHES: Outcome.PARTLY,
    Code.LOST_BRANCH: Outcome.PARTLY,
    Code.SURPLUS_BRANCH: Outcome.PARTLY,
    Code.DOUBLED_BRANCH: Outcome.PARTLY,
    Code.WRONG_SHAPE: Outcome.WRONG,
    Code.OPPOSITE_CONVENTION: Outcome.PARTLY,
    Code.SOME_MARKS: Outcome.PARTLY,
    Code.NO_MARKS: Outcome.WRONG,
    Code.NO_LINK: Outcome.PARTLY,
    Code.WRONG_LENGTH: Outcome.PARTLY,
    Code.LENGTH_VARIES: Outcome.PARTLY,
    Code.WRONG_ANGLE: Outcome.PARTLY,
    Code.ANGLE_VARIES: Outcome.PARTLY,
    Code.REVERSED_ANGLE: Outcome.PARTLY,
    Code.INTERIOR_ANGLE: Outcome.PARTLY,
    Code.OPEN_POLYGON: Outcome.PARTLY,
    Code.CLOSURE_SIGN: Outcome.PARTLY,
    Code.DEPENDENT_LOOP: Outcome.PARTLY,
    Code.MISSING_LOOP: Outcome.PARTLY,
    Code.NO_CLOSURE: Outcome.PARTLY,
    Code.NO_PROJECTION: Outcome.PARTLY,
    Code.PROJECTION_SIGN: Outcome.PARTLY,
    Code.SINE_COSINE: Outcome.PARTLY,
    Code.TERM_MISSING: Outcome.PARTLY,
    Code.SWAPPED_PROJECTIONS: Outcome.PARTLY,
    Code.WRONG_PROJECTION: Outcome.PARTLY,
    Code.NOT_DETERMINED: Outcome.PARTLY,
    Code.NO_UNKNOWNS: Outcome.PARTLY,
    Code.UNKNOWN_MISSING: Outcome.PARTLY,
    Code.UNKNOWN_EXTRA: Outcome.PARTLY,
    Code.CORIOLIS_MISSING: Outcome.PARTLY,
    Code.CORIOLIS_FACTOR: Outcome.PARTLY,
    Code.CENTRIPETAL_MISSING: Outcome.PARTLY,
    Code.TANGENTIAL_MISSING: Outcome.PARTLY,
    Code.SQUARE_MISSING: Outcome.PARTLY,
    Code.RATE_SIGN: Outcome.PARTLY,
    Code.CHAIN_RULE: Outcome.PARTLY,
    Code.UNKNOWN_RATE: Outcome.PARTLY,
    Code.WRONG_RATES: Outcome.PARTLY,
    Code.NOT_SATISFIED: Outcome.WRONG,
    Code.SOME_EQUATIONS: Outcome.PARTLY,
    Code.UNDETERMINED: Outcome.WRONG,
    Code.LOST_SOLUTION: Outcome.PARTLY,
    Code.SURPLUS_SOLUTION: Outcome.PARTLY,
    Code.BORDER: Outcome.PARTLY,
    Code.SENSE_TURNED: Outcome.WRONG,
    Code.TABLE_DEGREES: Outcome.PARTLY,
    Code.TABLE_ROUNDED: Outcome.PARTLY,
    Code.TABLE_CONVENTION: Outcome.PARTLY,
    Code.TABLE_SWAPPED: Outcome.PARTLY,
    Code.TABLE_COLUMNS: Outcome.PARTLY,
    Code.TABLE_ROWS: Outcome.PARTLY,
    Code.TABLE_VARIABLE: Outcome.PARTLY,
    Code.TABLE_PLACE: Outcome.PARTLY,
    Code.TABLE_VARIABLE_SIGN: Outcome.PARTLY,
    Code.TABLE_OFFSET: Outcome.PARTLY,
    Code.TABLE_ALPHA_SIGN: Outcome.PARTLY,
    Code.TABLE_ALPHA: Outcome.PARTLY,
    Code.TABLE_LENGTH_SIGN: Outcome.PARTLY,
    Code.TABLE_LENGTH: Outcome.PARTLY,
    Code.TABLE_TOOL: Outcome.PARTLY,
    Code.TABLE_ROW: Outcome.PARTLY,
    Code.EMPTY: Outcome.UNREADABLE,
    Code.UNREADABLE: Outcome.UNREADABLE,
    Code.UNDECIDED: Outcome.UNDECIDED,
    Code.KEPT: Outcome.UNDECIDED,
    Code.FAULT: Outcome.FAULT,
}


@dataclass(frozen=True, slots=True)
class Reading:
    """Details of an unreadable answer: the reason, its 0-based place, what stood there and what may be meant."""

    reason: Reason
    position: int
    proposal: Proposal


@dataclass(frozen=True, slots=True)
class Entries:
    """Details of a matrix that is right in part: rows and columns (from 1) of the entries that are not."""

    wrong: tuple[tuple[int, int], ...]
    total: int


@dataclass(frozen=True, slots=True)
class Flaw:
    """One defect of a polygon or of its derivatives: what it is, of which vector or name, in which equation."""

    code: Code
    subject: str = ""
    place: str = ""


@dataclass(frozen=True, slots=True)
class Flaws:
    """Details of a polygon that is right in part: every defect found, the first one first."""

    found: tuple[Flaw, ...]


@dataclass(frozen=True, slots=True)
class Witness:
    """A point at which the answer is proved to differ from the reference (names with exact decimals)."""

    point: tuple[tuple[str, float], ...]


@dataclass(frozen=True, slots=True)
class Branches:
    """Details of a set that is right in part: how many branches are right, and how many are given."""

    right: int
    given: int


@dataclass(frozen=True, slots=True)
class Named:
    """Details of a verdict about one name."""

    name: str


Details: TypeAlias = Reading | Named | Entries | Witness | Branches | Flaws | Remarks | None


@dataclass(frozen=True, slots=True)
class Verdict:
    """The judgement of one answer: a score from 0 to 1, a code and its details."""

    score: float
    code: Code
    details: Details = None

    @property
    def outcome(self) -> Outcome:
        """Give the outcome that belongs to the code."""
        return OUTCOMES[self.code]


RIGHT = Verdict(1.0, Code.RIGHT)
FOLLOWED = Verdict(1.0, Code.FOLLOWED)
EMPTY = Verdict(0.0, Code.EMPTY)
KEPT = Verdict(0.0, Code.KEPT)
UNDECIDED = Verdict(0.0, Code.UNDECIDED)
FAULT = Verdict(0.0, Code.FAULT)


def wrong(code: Code = Code.WRONG, details: Details = None) -> Verdict:
    """Make a verdict without credit."""
    return Verdict(0.0, code, details)


def unreadable(error: AnswerSyntaxError) -> Verdict:
    """Turn a reading error into a verdict: the one place that does."""
    return Verdict(0.0, Code.UNREADABLE, Reading(error.reason, error.position, error.proposal))
