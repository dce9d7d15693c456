"""What a submission is worth once marks by hand are counted: the newest word of the lecturer goes before the judges."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from graders import Code
from server.sets.rules import PLACES, Entry, Rules
from server.storage.marks import Mark
from server.storage.sets import Line

OPEN = (Code.UNDECIDED.value, Code.KEPT.value, Code.FAULT.value)  # what the judges leave to the lecturer
Given = Mapping[str | None, Mark]  # the newest mark of each answer of a submission; of the whole under None
Weights = Mapping[str, Mapping[str, float]]  # of answers, by variant
NONE: Given = {}


def by_submission(marks: Iterable[Mark]) -> dict[str, dict[str | None, Mark]]:
    """Give the newest marks that carry a share, by receipt and answer; a comment alone changes no points."""
    found: dict[str, dict[str | None, Mark]] = {}
    for mark in marks:
        if mark.share is not None:
            found.setdefault(mark.submission, {})[mark.answer] = mark
    return found


def whole(given: Given) -> Mark | None:
    """Give the mark of the whole submission, unless an answer was marked after it."""
    last = given.get(None)
    return last if last is not None and all(last.number >= mark.number for mark in given.values()) else None


def earned(line: Line, given: Given, weights: Mapping[str, float], rules: Rules) -> float:
    """Give the share that a submission earns: by the mark of the whole, else by answers, marked ones as marked."""
    if not given:
        return float(line.grade["score"])
    mark = whole(given)
    if mark is not None and mark.share is not None:
        return mark.share
    total = sum(weights[name] * _answer(verdict, given.get(name), rules) for name, verdict in _verdicts(line))
    return round(total / sum(weights.values()), PLACES)


def left_open(line: Line, given: Given) -> list[str]:
    """List the answers of a submission that the lecturer has still to settle."""
    if not line.grade["verdicts"] or whole(given) is not None:
        return []
    return [name for name, verdict in _verdicts(line) if verdict["code"] in OPEN and name not in given]


def entries(lines: Iterable[Line], marks: Mapping[str, Given], weights: Weights, rules: Rules) -> tuple[Entry, ...]:
    """Make the ledger of a slot: marks by hand are counted in."""
    return tuple([
        Entry(line.receipt, line.time, line.grade["score"], line.counted, False, line.hints)
        if line.receipt not in marks
        else _marked(line, marks[line.receipt], weights.get(line.variant, {}), rules)
        for line in lines
    ])  # fmt: skip


def unsettled(
    lines: Sequence[Line], marks: Mapping[str, Given], kept: Entry | None, share: float | None, rules: Rules
) -> set[str]:
    """Give the codes of the answers that the lecturer has still to settle and that can change the points of a slot.

    Where the best counts, full points stand whatever comes; where the last counts, only what came after it matters.
    """
    doubtful = [line for line in lines if line.grade["verdicts"]]
    if rules.keep == "best":
        seen = [] if share is not None and share >= 1 else doubtful
    else:
        seen = [line for line in doubtful if kept is None or line.time >= kept.time]
    return {
        line.grade["verdicts"][name]["code"] for line in seen for name in left_open(line, marks.get(line.receipt, NONE))
    }


def _marked(line: Line, given: Given, weights: Mapping[str, float], rules: Rules) -> Entry:
    return Entry(line.receipt, line.time, earned(line, given, weights, rules), line.counted, True, line.hints)


def _verdicts(line: Line) -> Iterable[tuple[str, Mapping[str, object]]]:
    found: Mapping[str, Mapping[str, object]] = line.grade["verdicts"]
    return found.items()


def _answer(verdict: Mapping[str, object], mark: Mark | None, rules: Rules) -> float:
    if mark is not None and mark.share is not None:
        return mark.share
    if verdict["code"] == Code.FOLLOWED.value:
        return rules.follow_through
    return float(str(verdict["score"]))
