"""Seeds that nobody chooses, limits by redrawing, the gate, and the deck."""

from __future__ import annotations

import hashlib
import hmac
import json
import pickle
from collections.abc import Iterable, Iterator
from dataclasses import replace

import pytest

from exercises import verifying
from exercises.exercise import Submission
from exercises.givens import numbers
from exercises.grading import grade
from exercises.presenting import presented
from exercises.variants import MAX_SEED, deal, restore
from server.sets import dealing
from server.sets.dealing import Plan, Trouble, card, draw, prepare, seats, seed, template

SECRET = b"only the server knows it"


def unheard(ready: int) -> None:
    """Nobody asks how many cards are ready."""


PLAN = Plan("S1", 1, ("slider_crank",), {}, ("anna", "bob", "spare 1"), "SET")


def test_a_seed_is_the_hash_of_who_what_and_which_time() -> None:
    whole = hmac.new(SECRET, b"anna\x1fS1\x1f1\x1f0", hashlib.sha256).hexdigest()
    assert seed(SECRET, "anna", "S1", 1) == int(whole[:16], 16) % 2**53
    others = [("bob", "S1", 1), ("anna", "S2", 1), ("anna", "S1", 2)]
    found = {seed(SECRET, *words) for words in [("anna", "S1", 1), *others]} | {seed(b"x", "anna", "S1", 1)}
    assert len(found) == 5 and all(0 <= one <= MAX_SEED for one in found)


@pytest.mark.parametrize(("students", "cards"), [(0, 30), (25, 30), (26, 32), (300, 360)])
def test_a_class_gets_a_fifth_more_cards_and_at_least_thirty(students: int, cards: int) -> None:
    roster = [f"p{number}" for number in range(students)]
    found = seats(roster)
    assert len(found) == len(set(found)) == cards and list(found[:students]) == roster


def test_slots_of_one_pool_give_a_student_different_exercises() -> None:
    plan = replace(PLAN, pool=("tmm2_oop", "tmm2_opo", "tmm2_poo", "rrr_matrices"))
    for student in ("anna", "bob", "celia"):
        dealt = {template(SECRET, replace(plan, slot=f"S{n}", place=n), student) for n in range(4)}
        assert dealt == set(plan.pool)
    first = {template(SECRET, plan, f"student {n}") for n in range(40)}
    assert first == set(plan.pool)


def test_limits_are_kept_by_drawing_again() -> None:
    plan = replace(PLAN, limits={"l1": (0.05, 0.06), "omega1": (5.0, 20.0)})
    for student in map(str, range(20)):
        found = numbers(draw(SECRET, plan, student).givens)
        assert 0.05 <= found["l1"] <= 0.06 and 5 <= found["omega1"] <= 20


@pytest.mark.parametrize(
    ("plan", "code", "values"),
    [
        (replace(PLAN, limits={"l1": (0.9, 1.0)}), "limits", {"accepted": 0, "draws": 1000}),
        (replace(PLAN, limits={"l9": (0.0, 1.0)}), "unknown_given", {"name": "l9"}),
        (replace(PLAN, pool=("slider_crank", "four_bar"), seats=tuple(map(str, range(8)))), "steps", {}),
    ],
)
def test_what_cannot_be_published_is_told(plan: Plan, code: str, values: dict[str, object]) -> None:
    cards, trouble = prepare(SECRET, plan, unheard)
    assert cards == () and trouble is not None
    assert (trouble.slot, trouble.code) == (1, code)
    assert values.items() <= dict(trouble.values).items()


def test_equal_cards_are_drawn_again_and_at_last_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    twins = replace(PLAN, seats=("anna", "anna"))
    cards, _ = prepare(SECRET, twins, unheard)
    assert cards[0].givens != cards[1].givens
    monkeypatch.setattr(dealing, "ANEW", 1)
    cards, trouble = prepare(SECRET, twins, unheard)
    assert trouble == Trouble(1, "alike", {"alike": 2, "cards": 2})


def test_the_gate_looks_at_the_seeds_that_are_dealt(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[int] = []

    def verify(exercise: str, seeds: Iterable[int]) -> verifying.Report:
        seen.extend(seeds)
        return verifying.Report(exercise, len(seen), len(seen), (f"seed {seen[0]}: step x = 1, oracle 2",))

    monkeypatch.setattr(verifying, "verify", verify)
    cards, trouble = prepare(SECRET, PLAN, unheard)
    assert cards == () and trouble is not None and trouble.code == "gate" and "oracle 2" in str(trouble.values)
    assert seen == [draw(SECRET, PLAN, seat).seed for seat in PLAN.seats]


def test_a_card_is_told_as_soon_as_the_gate_has_looked_at_it(monkeypatch: pytest.MonkeyPatch) -> None:
    happened: list[object] = []

    def verify(exercise: str, seeds: Iterable[int]) -> verifying.Report:
        happened.extend(iter(seeds))
        return verifying.Report(exercise, 3, 3, ())

    monkeypatch.setattr(verifying, "verify", lambda exercise, seeds: verify(exercise, noted(seeds)))

    def noted(seeds: Iterable[int]) -> Iterator[int]:
        for one in seeds:
            happened.append("looked")
            yield one

    cards, _ = prepare(SECRET, PLAN, lambda ready: happened.append(f"{ready} ready"))
    order = [one for one in happened if isinstance(one, str)]
    assert order == ["looked", "1 ready", "looked", "2 ready", "looked", "3 ready"] and len(cards) == 3


def test_a_card_holds_what_was_shown_and_what_is_judged_against() -> None:
    cards, trouble = prepare(SECRET, PLAN, unheard)
    assert trouble is None and [one.seat for one in cards] == ["anna", "bob", "spare 1"]
    assert pickle.loads(pickle.dumps(cards)) == cards
    stored = json.loads(json.dumps(cards[0].reference))
    variant = restore({"exercise": "slider_crank", "version": cards[0].version, "seed": 0, "givens": cards[0].givens})
    assert stored["texts"].keys() == cards[0].shown["pl"]["answers"].keys()
    assert verifying.reproduced(variant, stored)
    assert grade(Submission(variant, stored["texts"]), kept=verifying.kept(stored)).score == 1.0
    for language in ("pl", "en", "ru"):
        assert cards[0].shown[language]["statement_html"] == presented(variant, language).statement_html


def test_the_kept_reference_judges_when_the_steps_have_changed() -> None:
    variant = deal("slider_crank", 7)
    recorded = json.loads(json.dumps(card("anna", variant).reference))
    recorded["values"]["l3"] *= 1.5
    right = f"{recorded['values']['l3'] * 1000!r} mm"
    assert not verifying.reproduced(variant, recorded)
    found = grade(Submission(variant, {"l3": right}), kept=verifying.kept(recorded))
    assert found.verdicts["l3"].score == 1.0 and grade(Submission(variant, {"l3": right})).verdicts["l3"].score == 0.0


@pytest.mark.parametrize("exercise", ["mobility", "tmm2_oop", "beam_diagrams", "slider_crank_cycle", "rrp_table"])
def test_what_is_recorded_survives_the_store(exercise: str) -> None:
    variant = deal(exercise, 3)
    recorded = json.loads(json.dumps(verifying.record(variant)))
    assert verifying.reproduced(variant, recorded)
    answers = {name: text for name, text in recorded["texts"].items() if exercise != "mobility" or text}
    plain, kept = (grade(Submission(variant, answers), kept=k) for k in ((), verifying.kept(recorded)))
    assert plain.score == kept.score > 0.9
