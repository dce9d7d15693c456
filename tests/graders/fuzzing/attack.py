"""Hands texts to every reader and every judge and notes what comes of it."""

from __future__ import annotations

import random
import time
import traceback
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

from exercises import catalogue, variants
from exercises.solving import Solved
from graders import Choices, Code, Grader, Ordering, Rational, Set, Symbols, Text, units
from graders.kinds import quantity
from graders.language import AnswerSyntaxError, plain
from graders.language import symbols as spellings
from graders.language.tokens import tokenize
from graders.units import read_unit
from tests.graders.fuzzing.posed import posed
from tests.graders.fuzzing.texts import LONGER, Texts, hand_written

SLOW = 0.05  # s of processor time one answer may cost
READERS = (spellings, plain, units, quantity)
LONGEST_KEPT = 12
SAMPLED = 4  # one in so many inputs is handed to the tokenizer and the unit reader alone as well
FREE = ("expression", "function", "quantity", "matrix")  # a text of the grammar is often an answer of these kinds


@dataclass(frozen=True, slots=True)
class Target:
    """A judge with a reference, the symbols of its answer and texts that are answers to it."""

    grader: Grader
    reference: Any
    symbols: Symbols
    corpus: tuple[str, ...]


@dataclass(slots=True)
class Found:
    """What came of many texts."""

    inputs: int = 0
    seconds: float = 0.0  # of processor time
    tokenized: int = 0  # inputs handed to the tokenizer and the unit reader alone, as all judges hand them on too
    tokens: int = 0  # of these the texts that pass the tokenizer
    judged: int = 0
    right: int = 0
    overlong: int = 0  # texts longer than a formula may be that a judge took all the same: tables, sentences
    kinds: Counter[str] = field(default_factory=Counter)
    reasons: Counter[str] = field(default_factory=Counter)
    crashes: list[str] = field(default_factory=list)
    slow: list[str] = field(default_factory=list)
    slowest: list[tuple[float, str, str]] = field(default_factory=list)

    def add(self, other: Found) -> None:
        """Join what another process found."""
        self.inputs, self.tokenized = self.inputs + other.inputs, self.tokenized + other.tokenized
        self.seconds, self.tokens = self.seconds + other.seconds, self.tokens + other.tokens
        self.judged, self.right = self.judged + other.judged, self.right + other.right
        self.overlong += other.overlong
        self.kinds.update(other.kinds)
        self.reasons.update(other.reasons)
        self.crashes += other.crashes
        self.slow += other.slow
        self.slowest = sorted(self.slowest + other.slowest, reverse=True)[:LONGEST_KEPT]


OTHERS: tuple[tuple[Grader, Any], ...] = (
    (Rational(), -8 / 3),
    (Rational(rtol=0.01, either=True), 0.25),
    (Choices(("crank", "rod", "rocker", "slider")), "crank; rocker"),
    (Ordering(("draw", "solve", "check", "hand in")), "draw; solve; check; hand in"),
    (Text(), ""),
    (Set("mm"), ((0.0125,), (0.013,))),
    (Set(("deg", "deg", "mm")), ((0.5, 0.8, 0.1), (0.5, 0.2, -0.1))),
)


def targets(exercises: Sequence[str] = (), seeds: Sequence[int] = (1, 2)) -> list[Target]:
    """Give a target for every answer of the exercises on some seeds, and one for each kind of the small judges."""
    found = [_target(grader, reference, Symbols(())) for grader, reference in OTHERS]
    found += [_target(*each) for each in posed()]
    for exercise in exercises or catalogue.ids():
        for seed in seeds:
            solved = Solved(catalogue.load(exercise).exercise, variants.deal(exercise, seed))
            for name, grader in solved.answers.items():
                found.append(_target(grader, solved.reference(name), solved.symbols(name)))
    return found


def _target(grader: Grader, reference: Any, symbols: Symbols) -> Target:
    samples = grader.samples(reference)
    texts = (grader.show(reference), *samples.right, *samples.wrong, *samples.unreadable)
    return Target(grader, reference, symbols, tuple(text for text in texts if len(text) < 3000))


def attack(every: Sequence[Target], seed: int, inputs: int) -> Found:
    """Hand in texts that follow from a seed."""
    rng, found, start = random.Random(seed), Found(), time.process_time()
    written = hand_written()
    sources = [_source(rng, target, written) for target in every]
    for _ in range(inputs):
        at = rng.randrange(len(every))
        one(every[at], sources[at].text(), found)
    found.seconds = time.process_time() - start
    return found


def _source(rng: random.Random, target: Target, written: Sequence[str]) -> Texts:
    """Make the texts for a judge: those of a strict form are mostly handed answers of their own, a little changed."""
    if target.grader.kind in FREE:
        return Texts(rng, _names(target), (*target.corpus * 3, *written))
    return Texts(rng, _names(target), (*target.corpus * 40, *written), mutated=0.8)


def _names(target: Target) -> list[str]:
    """Give the names a text may use; a number is mostly written without."""
    usable = sorted(target.symbols.names) * 4 if target.grader.symbolic else ["pi"] * 40
    return [*usable, *sorted(target.symbols.known)]


def one(target: Target, text: str, found: Found) -> None:
    """Hand in one text; a crash is anything but a reading error."""
    found.inputs += 1
    start, crashes = time.process_time(), len(found.crashes)
    try:
        hand_in(target, text, found)
    except Exception:  # whatever it is, it is what is looked for
        found.crashes.append(f"{target.grader.kind} {text!r}: {traceback.format_exc(limit=-4)}")
    cost = time.process_time() - start
    if not found.slowest or cost > found.slowest[-1][0] or len(found.slowest) < LONGEST_KEPT:
        found.slowest = sorted([*found.slowest, (cost, target.grader.kind, text)], reverse=True)[:LONGEST_KEPT]
    if cost > SLOW and len(found.crashes) == crashes and again(target, text) > SLOW:
        found.slow.append(f"{target.grader.kind} {cost * 1e3:.0f} ms {text!r}")


def again(target: Target, text: str) -> float:
    """Time a text three times more, each as if for the first time, and give the least: the machine may be busy."""
    best = float("inf")
    for _ in range(3):
        forget()
        start = time.process_time()
        hand_in(target, text, Found())
        best = min(best, time.process_time() - start)
    return best


def forget() -> None:
    """Forget what the readers remember of texts: a text that is met again would cost less."""
    for reader in READERS:
        for thing in vars(reader).values():
            if callable(getattr(thing, "cache_clear", None)):
                thing.cache_clear()


def hand_in(target: Target, text: str, found: Found) -> None:
    """Hand a text to the readers and the judge; an exception is a crash."""
    if found.inputs % SAMPLED == 0:
        found.tokenized += 1
        found.tokens += readable(tokenize, text)
        readable(read_unit, text[-12:])
    grader = target.grader
    try:
        answer = grader.parse(text, target.symbols)
    except AnswerSyntaxError as error:
        found.reasons[error.reason.value] += 1
        if not 0 <= error.position <= len(text):
            raise ValueError(f"place {error.position} outside the text") from error
        return
    verdict = grader.check(answer, target.reference)
    grader.echo(answer, comma=True)
    grader.carried(answer)
    found.overlong += len(text) > LONGER
    found.judged += 1
    found.right += verdict.code is Code.RIGHT
    found.kinds[grader.kind] += 1
    if not 0 <= verdict.score <= 1:
        raise ValueError(f"score {verdict.score}")


def readable(read: Callable[[str], object], text: str) -> bool:
    """Tell whether a reader takes a text."""
    try:
        read(text)
    except AnswerSyntaxError:
        return False
    return True
