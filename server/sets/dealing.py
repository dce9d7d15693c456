"""Dealing a set: the seeds nobody can choose, the limits on givens, and the deck with what each card shows.

Nothing here knows the store; it runs in processes of their own, so all that goes in and out is plain data.
"""

from __future__ import annotations

import hmac
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import partial
from math import ceil
from statistics import mode
from typing import Any, TypeAlias

from exercises import catalogue, presenting, variants, verifying
from exercises.exercise import Variant
from exercises.givens import numbers
from graders.words import LANGUAGES

LEAST_CARDS = 30
SPARE = 1.2  # cards for each student
DRAWS = 1000  # with which the limits are tried
LEAST_ACCEPTED = 10  # of them: 1 %
REDRAWS = 2000  # for one card; at 1 % accepted, one in 10^8 cards needs more
ALIKE = 0.01  # share of cards whose numbers may stand on another card too
ANEW = 20  # redraws of a card whose numbers are dealt already

Limits: TypeAlias = Mapping[str, tuple[float, float]]
Tell: TypeAlias = Callable[[int], None]  # takes how many cards are ready


@dataclass(frozen=True, slots=True)
class Plan:
    """A slot to be dealt.

    Attributes:
        slot: Its id.
        number: Its place in the set, from 1.
        pool: Ids of exercises, one of which is on each card.
        limits: Least and greatest value of givens, in SI units.
        seats: Names of those for whom a card is drawn: persons, then spares.
        turn: 1, more where a card is replaced.
        place: How many slots before this one have the same pool: they share it out without repetition.
        shuffle: Names the set, so that slots of one pool share it out in the same order.
    """

    slot: str
    number: int
    pool: tuple[str, ...]
    limits: Limits
    seats: tuple[str, ...]
    shuffle: str
    place: int = 0
    turn: int = 1


@dataclass(frozen=True, slots=True)
class Drawn:
    """A card as drawn: the variant, what it shows in three languages, what it is judged against."""

    seat: str
    exercise: str
    version: int
    seed: int
    givens: Mapping[str, Any]
    shown: Mapping[str, Any]
    reference: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Trouble:
    """Why a slot cannot be published: a code, worded by the pages, and what stands in its sentence."""

    slot: int
    code: str
    values: Mapping[str, str | int] = field(default_factory=dict)


class Unpublishable(ValueError):
    """A slot cannot be published."""

    def __init__(self, trouble: Trouble) -> None:
        super().__init__(trouble)
        self.trouble = trouble


def seats(roster: Sequence[str]) -> tuple[str, ...]:
    """Name the seats of a class: its students and a fifth more, at least thirty."""
    spare = max(LEAST_CARDS, ceil(SPARE * len(roster))) - len(roster)
    return (*roster, *(f"spare {number}" for number in range(1, spare + 1)))


def seed(secret: bytes, student: str, item: str, turn: int, redraw: int = 0) -> int:
    """Give the seed of a student's variant; without the server's secret nobody can tell it or choose it."""
    words = "\x1f".join((student, item, str(turn), str(redraw))).encode()
    return int.from_bytes(hmac.digest(secret, words, "sha256")[:8], "big") & variants.MAX_SEED


def template(secret: bytes, plan: Plan, student: str) -> str:
    """Choose the exercise of a student's card; slots with one pool give a student different exercises."""

    def lot(exercise: str) -> bytes:
        return hmac.digest(secret, "\x1f".join((plan.shuffle, student, exercise)).encode(), "sha256")

    order = sorted(plan.pool, key=lot)
    return order[(plan.place + plan.turn - 1) % len(order)]


def within(variant: Variant, limits: Limits) -> bool:
    """Tell whether the givens of a variant keep the limits that speak of them."""
    return kept(variant.givens, limits)


def kept(givens: Any, limits: Limits) -> bool:
    """Tell whether givens keep the limits that speak of them."""
    found = numbers(givens)
    return all(low <= found[name] <= high for name, (low, high) in limits.items() if name in found)


def prepare(secret: bytes, plan: Plan, tell: Tell) -> tuple[tuple[Drawn, ...], Trouble | None]:
    """Draw and check the cards of a slot, and tell how many are ready.

    Returns:
        The cards, one a seat; none, and the trouble, where the slot cannot be published.
    """
    try:
        _try_limits(secret, plan)
        drawn = tuple(_distinct(secret, plan))
        _compare(plan, drawn)
        cards: dict[int, Drawn] = {}
        for exercise in plan.pool:
            _verify(plan, exercise, _written(drawn, exercise, cards, tell))
        return tuple(cards[place] for place in range(len(drawn))), None
    except Unpublishable as error:
        return (), error.trouble
    except variants.DrawError as error:
        return (), Trouble(plan.number, "gate", {"reason": str(error)})


def _written(drawn: Sequence[tuple[str, Variant]], exercise: str, cards: dict[int, Drawn], tell: Tell) -> Iterator[int]:
    """Give the gate the seeds of an exercise, and write the card of each that it has looked at."""
    for place, (seat, variant) in enumerate(drawn):
        if variant.exercise == exercise:
            yield variant.seed
            cards[place] = card(seat, variant)
            tell(len(cards))


def card(seat: str, variant: Variant) -> Drawn:
    """Write down a variant as a card."""
    stored = variants.dump(variant)
    shown = {language: asdict(presenting.presented(variant, language)) for language in LANGUAGES}
    reference = verifying.record(variant)
    return Drawn(seat, variant.exercise, variant.version, variant.seed, stored["givens"], shown, reference)


def draw(secret: bytes, plan: Plan, student: str, skip: int = 0) -> Variant:
    """Draw a student's variant within the limits.

    Raises:
        Unpublishable: So many draws in a row were outside the limits.
    """
    exercise = template(secret, plan, student)
    tries = partial(seed, secret, student, plan.slot, plan.turn)
    for redraw in range(skip, skip + REDRAWS):
        variant = variants.deal(exercise, tries(redraw))
        if within(variant, plan.limits):
            return variant
    raise Unpublishable(_refusing(plan, exercise, 0, REDRAWS))


def _refusing(plan: Plan, exercise: str, accepted: int, draws: int) -> Trouble:
    return Trouble(plan.number, "limits", {"exercise": exercise, "accepted": accepted, "draws": draws})


def _try_limits(secret: bytes, plan: Plan) -> None:
    """Refuse limits that name nothing, and those that under 1 % of the draws keep."""
    unknown = set(plan.limits)
    for exercise in plan.pool if plan.limits else ():
        accepted = 0
        for number in range(DRAWS):
            variant = variants.deal(exercise, seed(secret, "limits", plan.slot, 0, number))
            unknown -= set(numbers(variant.givens))
            accepted += within(variant, plan.limits)
            if accepted == LEAST_ACCEPTED:
                break
        else:
            raise Unpublishable(_refusing(plan, exercise, accepted, DRAWS))
    if unknown:
        raise Unpublishable(Trouble(plan.number, "unknown_given", {"name": min(unknown)}))


def _distinct(secret: bytes, plan: Plan) -> Iterator[tuple[str, Variant]]:
    """Draw the cards; one whose numbers are dealt already is drawn again some times."""
    dealt: set[str] = set()
    for seat in plan.seats:
        for again in range(ANEW):
            variant = draw(secret, plan, seat, again * REDRAWS)
            if _numbers(variant) not in dealt:
                break
        dealt.add(_numbers(variant))
        yield seat, variant


def _numbers(variant: Variant) -> str:
    return f"{variant.exercise} {variant.givens!r}"


def _compare(plan: Plan, drawn: Sequence[tuple[str, Variant]]) -> None:
    """Refuse a deck with too many equal cards, and a pool whose exercises differ in the number of steps."""
    alike = sum(number for number in Counter(_numbers(v) for _, v in drawn).values() if number > 1)
    if alike >= max(2, ALIKE * len(drawn)):
        raise Unpublishable(Trouble(plan.number, "alike", {"alike": alike, "cards": len(drawn)}))
    steps: dict[str, list[int]] = {}
    for _, variant in drawn:
        lines = catalogue.load(variant.exercise).exercise.steps_of(variant.givens)
        steps.setdefault(variant.exercise, []).append(len(lines))
    usual = {exercise: mode(counts) for exercise, counts in steps.items()}
    if len(set(usual.values())) > 1:
        said = "; ".join(f"{exercise} ({count})" for exercise, count in sorted(usual.items()))
        raise Unpublishable(Trouble(plan.number, "steps", {"counts": said}))


def _verify(plan: Plan, exercise: str, seeds: Iterable[int]) -> None:
    """Pass an exercise through the publish gate on the very seeds that will be dealt."""
    failures = verifying.verify(exercise, seeds).failures
    if failures:
        raise Unpublishable(Trouble(plan.number, "gate", {"reason": failures[0], "exercise": exercise}))
