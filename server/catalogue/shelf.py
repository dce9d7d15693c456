"""The catalogue as a reader looks through it: cards, and which of them are wished."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from exercises import catalogue, presenting
from exercises.exercise import AnyExercise
from server.catalogue.api import sample
from server.web.templating import counted
from server.workbench import Bench

WAYS: Mapping[str, tuple[str, ...]] = {  # in which one answers, with the kinds of answers
    "number": ("quantity", "integer", "rational", "set"),
    "formula": ("expression", "equation", "system", "inequality", "function", "rates"),
    "polygon": ("polygon",),
    "diagram": ("diagram",),
    "matrix": ("matrix", "symbolic_matrix", "dh_table"),
    "table": ("samples",),
    "choice": ("choice", "choices", "ordering"),
    "text": ("text",),
}


@dataclass(frozen=True, slots=True)
class Card:
    """An exercise on the shelf."""

    id: str
    chapter: str
    exercise: AnyExercise
    shown: presenting.Presented
    answers: str

    @property
    def ways(self) -> frozenset[str]:
        """The ways in which one answers."""
        kinds = {field.kind for field in self.shown.answers.values()}
        return frozenset(way for way, those in WAYS.items() if kinds & set(those))

    def says(self, wish: str) -> bool:
        """Whether the card says what is looked for."""
        text = " ".join((self.id, self.shown.title, self.shown.summary, *self.exercise.systems))
        return all(word in text.casefold() for word in wish.casefold().split())


@dataclass(frozen=True, slots=True)
class Wish:
    """What a reader looks for: a chapter, words, ways of answering of which one is enough; empty for anything."""

    chapter: str = ""
    words: str = ""
    ways: frozenset[str] = frozenset()
    by_time: bool = False  # the shortest first, not by chapter

    def found(self, cards: Iterable[Card]) -> list[Card]:
        """Give the cards that are wished, in the order that is wished."""
        found = [one for one in self._answered(cards) if self.chapter in ("", one.chapter)]
        return sorted(found, key=lambda one: one.exercise.minutes) if self.by_time else found

    def chapters(self, cards: Sequence[Card]) -> dict[str, int]:
        """Count the cards of each chapter that are wished but for it."""
        return {one.chapter: 0 for one in cards} | Counter(one.chapter for one in self._answered(cards))

    def answered_by(self, cards: Sequence[Card]) -> dict[str, int]:
        """Count the cards of each way of answering that are wished but for it."""
        rest = Counter(way for one in Wish(self.chapter, self.words).found(cards) for way in one.ways)
        return {way: rest[way] for way in WAYS if any(way in one.ways for one in cards)}

    def _answered(self, cards: Iterable[Card]) -> Iterable[Card]:
        known = self.ways & WAYS.keys()
        return (one for one in cards if one.says(self.words) and (not known or known & one.ways))


async def card(bench: Bench, exercise: str, language: str) -> Card:
    """Make the card of an exercise."""
    entry = catalogue.load(exercise)
    shown = await bench.judging.run(sample, exercise, language)
    kinds = Counter(field.kind for field in shown.answers.values())
    asked = ", ".join(counted(language, number, f"kinds.{kind}") for kind, number in kinds.items())
    return Card(exercise, entry.chapter, entry.exercise, shown, asked)
