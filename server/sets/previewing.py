"""What a lecturer sees of an exercise before it is published: any seed, and twenty seeds in a table."""

from __future__ import annotations

from dataclasses import dataclass

from exercises import presenting
from exercises.givens import domains
from exercises.grading import reference
from exercises.variants import MAX_SEED, deal
from graders.words import marked
from server.sets.dealing import Limits, within

ROWS = 20


@dataclass(frozen=True, slots=True)
class Row:
    """One seed: the numbers drawn, and the answers they lead to."""

    seed: int
    givens: tuple[str, ...]
    answers: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Seen:
    """A variant as a student sees it, whether the limits let it be dealt, the domains of its givens as limits are
    written, and the seeds that follow."""

    exercise: str
    shown: presenting.Presented
    dealt: bool
    domains: tuple[str, ...]
    prompts: tuple[str, ...]
    rows: tuple[Row, ...]


def preview(exercise: str, seed: int, language: str, table: bool, limits: Limits) -> Seen:
    """Show a seed of an exercise; with a table, twenty from this one on."""
    variant = deal(exercise, seed)
    shown = presenting.presented(variant, language)
    named = tuple(
        f"{name} {_plain(one.low, language)} {_plain(one.high, language)}"
        for name, one in domains(variant.givens).items()
    )
    seeds = range(seed, min(seed + ROWS, MAX_SEED + 1)) if table else ()
    prompts = tuple(field.prompt_text for field in shown.answers.values())
    rows = tuple(_row(exercise, one, language) for one in seeds)
    return Seen(exercise, shown, within(variant, limits), named, prompts, rows)


def _plain(value: float, language: str) -> str:
    text = f"{value:.4g}"
    return marked(text, language)


def _row(exercise: str, seed: int, language: str) -> Row:
    variant = deal(exercise, seed)
    printed = presenting.printed_givens(variant, language)
    numbers = tuple(f"{one.name} = {one.number} {one.unit}".rstrip() for one in printed)
    return Row(seed, numbers, tuple(reference(variant).values()))
