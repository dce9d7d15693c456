"""The rules of a task set, as pure functions: windows, lateness, counted attempts, points."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime, timedelta
from enum import StrEnum
from math import ceil
from typing import Annotated, Literal, NamedTuple

from pydantic import BaseModel, ConfigDict, Field

from exercises.exercise import Grade
from graders import Code, Verdict

BEST, WORST = 0.9, 0.1  # how a second chance is weighed
DAY = timedelta(days=1)
PLACES = 6  # of a share


class Rules(BaseModel):
    """What holds in a set; each has a default that suits homework.

    Attributes:
        mode: In practice each answer is judged at once; in an exam the results are held until the set has closed for
            everybody.
        minutes: Time limit from the first open.
        late: After the due moment and before closing, work is refused, accepted, or loses a share a day.
        late_loss: The share lost with each day begun.
        keep: Whether the best or the last attempt gives the points.
        hints: Whether recognised slips are named.
        ladder: Whether a wrong answer may be helped on: by what it follows from, by its
            equation, by that with the numbers of the task.
        hint_price: The share lost, with each such hint opened, of the points of what is handed in to the task after it.
        solutions: When the worked solution opens; `after_close` is when the set has closed for everybody.
        follow_through: What a later answer is worth that is right from an earlier wrong one.
        second_chance_of: The set to which this one is a second chance.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)
    mode: Literal["practice", "exam"] = "practice"
    minutes: Annotated[int, Field(ge=1, le=10_000)] | None = None
    late: Literal["refused", "accepted", "reduced"] = "refused"
    late_loss: Annotated[float, Field(ge=0, le=1)] = 0.1
    keep: Literal["best", "last"] = "best"
    hints: bool = True
    ladder: bool = False
    hint_price: Annotated[float, Field(ge=0, le=1)] = 0.0
    solutions: Literal["never", "after_last_attempt", "after_close"] = "after_close"
    follow_through: Annotated[float, Field(ge=0, le=1)] = 1.0
    second_chance_of: Annotated[str, Field(max_length=32)] | None = None


class Stage(StrEnum):
    """Where a moment lies in a window."""

    BEFORE = "before"
    OPEN = "open"
    LATE = "late"
    CLOSED = "closed"


@dataclass(frozen=True, slots=True)
class Window:
    """When one student may work; a bound that is none does not bind. On the very second of a bound he still may."""

    opens: datetime | None
    due: datetime | None
    closes: datetime | None

    def stage(self, now: datetime) -> Stage:
        """Tell where a moment lies."""
        if self.opens is not None and now < self.opens:
            return Stage.BEFORE
        if self.closes is not None and now > self.closes:
            return Stage.CLOSED
        return Stage.LATE if self.due is not None and now > self.due else Stage.OPEN

    @property
    def late_until(self) -> datetime | None:
        """Until when late work is taken; none where it is refused, and where it is taken without end."""
        return self.closes if self.due is not None and self.closes is not None and self.closes > self.due else None


def window(
    opens: datetime | None, due: datetime | None, closes: datetime | None, rules: Rules,
    *, extra: int = 0, begun: datetime | None = None, extended: Sequence[tuple[datetime, int]] = (),
) -> Window:  # fmt: skip
    """Give the window of one student.

    Args:
        opens: When the set opens.
        due: Until when work is on time.
        closes: Until when late work is taken; none: as long as the late policy allows.
        rules: The rules of the set.
        extra: Minutes this student has more; they move due, closing and the time limit.
        begun: When this student opened the set first; from then the time limit runs.
        extended: When deadlines were moved, and by how many minutes; a time limit that ran then is so much longer.
    """
    more = timedelta(minutes=extra)
    due = due + more if due is not None else None
    closes = closes + more if closes is not None else None
    if rules.late == "refused":
        closes = _earliest(due, closes)
    if rules.minutes is not None and begun is not None:
        end = _end(begun, begun + timedelta(minutes=rules.minutes) + more, extended)
        due, closes = _earliest(due, end), _earliest(closes, end)
    return Window(opens, due, closes)


def _end(begun: datetime, end: datetime, extended: Sequence[tuple[datetime, int]]) -> datetime:
    for moment, minutes in extended:
        if begun <= moment <= end:
            end += timedelta(minutes=minutes)
    return end


def _earliest(*moments: datetime | None) -> datetime | None:
    return min((moment for moment in moments if moment is not None), default=None)


def worth(time: datetime, due: datetime | None, rules: Rules) -> float:
    """Give the share of the points that work received at a moment can still reach; each day begun takes its loss."""
    if rules.late != "reduced" or due is None or time <= due:
        return 1.0
    return max(0.0, 1 - rules.late_loss * ceil((time - due) / DAY))


def left_of_hints(hints: int, rules: Rules) -> float:
    """Give the share of the points that work can still reach after some hints were opened at their price."""
    return max(0.0, 1 - rules.hint_price * hints)


def same(one: Mapping[str, str | Sequence[str]], other: Mapping[str, str | Sequence[str]]) -> bool:
    """Tell whether two submissions say the same: space around an answer, and empty answers, do not matter."""
    return _said(one) == _said(other)


def _said(answers: Mapping[str, str | Sequence[str]]) -> dict[str, str]:
    texts = {name: text if isinstance(text, str) else "\n".join(text) for name, text in answers.items()}
    return {name: text.strip() for name, text in texts.items() if text.strip()}


def valued(grade: Grade, weights: Mapping[str, float], rules: Rules) -> Grade:
    """Give a grade the score it has in a set; answers that only a later version of its exercise asks for are left out.

    Args:
        grade: The grade, by the exercise as it is installed.
        weights: Of the answers that the card asks for.
        rules: The rules of the set.
    """
    verdicts = {name: verdict for name, verdict in grade.verdicts.items() if name in weights}
    return replace(grade, verdicts=verdicts, score=share(verdicts, weights, rules))


def share(verdicts: Mapping[str, Verdict], weights: Mapping[str, float], rules: Rules) -> float:
    """Give the share of the points that a grade is worth: the weighted mean, follow-through at its price."""
    earned = sum(weights[name] * _earned(verdict, rules) for name, verdict in verdicts.items())
    return round(earned / sum(weights.values()), PLACES)


def _earned(verdict: Verdict, rules: Rules) -> float:
    return rules.follow_through if verdict.code is Code.FOLLOWED else verdict.score


class Entry(NamedTuple):
    """A line of the ledger: a submission, what share it earned, whether it used up an attempt, and whether the lecturer
    has settled it; `hints` were opened at a price before it."""

    receipt: str
    time: datetime
    share: float
    counted: bool
    settled: bool = False
    hints: int = 0


def result(ledger: Iterable[Entry], due: datetime | None, rules: Rules) -> float | None:
    """Give the share of a slot's points that its ledger earns; None where nothing was judged."""
    entry = kept(ledger, due, rules)
    return None if entry is None else reached(entry, due, rules)


def reached(entry: Entry, due: datetime | None, rules: Rules) -> float:
    """Give the share of a slot's points that a submission reaches with its lateness and the hints before it."""
    return round(_reached(entry, due, rules), PLACES)


def _reached(entry: Entry, due: datetime | None, rules: Rules) -> float:
    share = entry.share * worth(entry.time, due, rules) if rules.late == "reduced" else entry.share
    return share * left_of_hints(entry.hints, rules) if entry.hints else share


def kept(ledger: Iterable[Entry], due: datetime | None, rules: Rules) -> Entry | None:
    """Give the submission that earns a slot its points; None where nothing was judged.

    One that did not count earns too once the lecturer has settled it.
    """
    judged = [entry for entry in ledger if entry.counted or entry.settled or entry.share > 0]
    if len(judged) < 2 or rules.keep == "last":
        return judged[-1] if judged else None
    return max(judged, key=lambda entry: _reached(entry, due, rules))


def left(attempts: int | None, counted: int) -> int | None:
    """Give how many attempts are left; None: as many as one likes."""
    return None if attempts is None else max(0, attempts - counted)


def combined(first: float, second: float | None) -> float:
    """Weigh a set with its second chance: nine tenths of the better and a tenth of the worse; not taken, the first."""
    if second is None:
        return first
    return round(BEST * max(first, second) + WORST * min(first, second), PLACES)


def held(rules: Rules, stage: Stage) -> bool:
    """Tell whether results are held back from the student."""
    return rules.mode == "exam" and stage is not Stage.CLOSED


def solution_open(rules: Rules, stage: Stage, attempts_left: int | None) -> bool:
    """Tell whether the worked solution is open to the student."""
    if rules.solutions == "never":
        return False
    if stage is Stage.CLOSED:
        return True
    return rules.solutions == "after_last_attempt" and rules.mode == "practice" and attempts_left == 0
