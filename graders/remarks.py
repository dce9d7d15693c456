"""What is off in a curve or a table, and where: the details of an answer that is judged by several marks."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Slip(StrEnum):
    """What can be off; `graders/locales/` words each of them."""

    # diagrams
    GAP = "gap"
    OVERLAP = "overlap"
    BEYOND = "beyond"
    LOST_JUMP = "lost_jump"
    EXTRA_JUMP = "extra_jump"
    OPPOSITE_JUMP = "opposite_jump"
    JUMP = "jump"
    SLOPE = "slope"
    OPPOSITE_SLOPE = "opposite_slope"
    DEGREE = "degree"
    STRAIGHT = "straight"
    BENT = "bent"
    ORDINATE = "ordinate"
    EXTREME = "extreme"
    ZERO = "zero"
    OPEN_END = "open_end"
    # functions with brackets
    NOT_COVERED = "not_covered"
    COVERED_TWICE = "covered_twice"
    OPEN_TOO_EARLY = "open_too_early"
    FROM_HERE = "from_here"
    CONSTANT = "constant"
    FACTOR = "factor"
    STRETCH = "stretch"
    EVERYWHERE = "everywhere"
    NUMBERS = "numbers"
    # tables of a cycle
    FEW_ROWS = "few_rows"
    NOT_A_CYCLE = "not_a_cycle"
    NO_COLUMN = "no_column"
    DELAYED = "delayed"
    REVERSED = "reversed"
    DEGREES = "degrees"
    COLUMN_SIGN = "column_sign"
    COLUMN_UNIT = "column_unit"
    COLUMN_SCALE = "column_scale"
    COLUMN_SHIFT = "column_shift"
    PER_ANGLE = "per_angle"
    QUOTIENTS = "quotients"
    NOT_THE_RATE = "not_the_rate"
    COLUMN = "column"


@dataclass(frozen=True, slots=True)
class Remark:
    """One thing that is off: what, at which place or from which to which, of which name."""

    slip: Slip
    place: float | None = None
    until: float | None = None
    name: str = ""
    unit: str = ""  # of the places

    def in_unit(self, factor: float, unit: str) -> Remark:
        """Give the same remark with its places in another unit."""
        place, until = (None if x is None else x / factor for x in (self.place, self.until))
        return Remark(self.slip, place, until, self.name, unit)


@dataclass(frozen=True, slots=True)
class Remarks:
    """Details of an answer judged by several marks: how many are right, how many there are, and what is off."""

    right: int
    total: int
    found: tuple[Remark, ...]
