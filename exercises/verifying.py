"""The publish gate: what an exercise must hold on every seed before a student sees it."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from typing import Any

from exercises import catalogue, variants
from exercises.exercise import Submission, Values, Variant
from exercises.givens import Json, domains, numbers
from exercises.grading import grade, judge, reference
from exercises.presenting import presented, printed_givens, solution
from exercises.solving import Kept, Solved, solve
from exercises.words import Words
from graders import Code, Quantity, Reference, Value
from graders.language.doubles import UndefinedError
from graders.units import read_unit
from graders.words import LANGUAGES

AGREEMENT = 1e-9  # relative, between the steps and the oracle
DISTINCT = 0.9  # share of distinct givens among the seeds
SECTIONS = ("answers", "steps", "mistakes", "figure", "options", "choices", "units")
DIGEST_SEEDS = 20


@dataclass(frozen=True, slots=True)
class Report:
    """What the gate found: nothing in `failures` means that the exercise may be published."""

    exercise: str
    seeds: int
    distinct: int
    failures: tuple[str, ...]


def verify(exercise_id: str, seeds: Iterable[int]) -> Report:
    """Check an exercise on many seeds.

    Raises:
        UnknownExercise: No exercise has this id.
    """
    entry = catalogue.load(exercise_id)
    failures = [*_words(entry.words), *_digest(exercise_id), *_cases(exercise_id)]
    seen, count = set(), 0
    for seed in seeds:
        count += 1
        try:
            variant = variants.deal(exercise_id, seed)
        except variants.DrawError as error:
            failures.append(str(error))
            continue
        seen.add(repr(variant.givens))
        failures += [f"seed {seed}: {failure}" for failure in _variant(variant)]
    if len(seen) < DISTINCT * min(count, 1000):
        failures.append(f"only {len(seen)} distinct givens in {count} seeds")
    return Report(exercise_id, count, len(seen), tuple(failures))


def _variant(variant: Variant) -> Iterator[str]:
    entry = catalogue.load(variant.exercise)
    solved = Solved(entry.exercise, variant)
    yield from outside(variant.givens)
    yield from _oracle(solved, entry.exercise.oracle(variant.givens))
    yield from _degenerate(solved)
    yield from _spellings(solved)
    yield from _mistakes(solved)
    yield from _printed(solved)
    if grade(Submission(variant, {})).score > 0:
        yield "an empty submission gets credit"
    for lang in LANGUAGES:
        presented(variant, lang)
        solution(variant, lang)


def outside(givens: Any) -> Iterator[str]:
    """Tell which numbers are outside the domain they declare, in which formulas are compared."""
    declared = domains(givens)
    for name, value in numbers(givens).items():
        low, high = declared[name].low, declared[name].high
        slack = AGREEMENT * max(abs(low), abs(high))
        if not low - slack <= value <= high + slack:
            yield f"given {name} = {value!r} is outside its domain, {low!r} to {high!r}"


def _oracle(solved: Solved, independent: Values) -> Iterator[str]:
    """The steps agree with the oracle; a step that only the steps name is an intermediate one."""
    missing = {solved.step_of(name) for name in solved.answers} - set(independent)
    if missing:
        yield f"the oracle does not name {', '.join(sorted(missing))}"
    for name, other in independent.items():
        if not agree(solved.values[name], other):
            yield f"step {name} = {solved.values[name]!r}, oracle {other!r}"


def agree(one: Value, other: Value, relative: float = AGREEMENT) -> bool:
    """Tell whether two values agree; a matrix on the scale of its largest entry (at least 1)."""
    if isinstance(one, str) or isinstance(other, str):
        return one == other
    if isinstance(one, tuple) and isinstance(other, tuple):
        if [len(row) for row in one] != [len(row) for row in other]:
            return False
        pairs = [(a, b) for x, y in zip(one, other, strict=True) for a, b in zip(x, y, strict=True)]
        scale = max([1.0, *(abs(b) for _, b in pairs)])
        return all(abs(a - b) <= relative * scale for a, b in pairs)
    if isinstance(one, tuple) or isinstance(other, tuple):
        return False
    return abs(one - other) <= relative * max(abs(one), abs(other))


def _degenerate(solved: Solved) -> Iterator[str]:
    for name, grader in solved.answers.items():
        reference = solved.reference(name)
        if isinstance(grader, Quantity) and isinstance(reference, float | int) and abs(reference) <= 100 * grader.atol:
            yield f"answer {name} = {reference!r} is near zero for its tolerance"


def _spellings(solved: Solved) -> Iterator[str]:
    """The judge's own samples: right ones full marks, wrong ones not, unreadable ones no credit."""
    for name, grader in solved.answers.items():
        samples = grader.samples(solved.reference(name))
        for text in (*samples.right, grader.show(solved.reference(name))):
            if not _full(solved, name, text):
                yield f"answer {name}: {text!r} is not graded right"
        for text in samples.wrong:
            if _full(solved, name, text):
                yield f"answer {name}: {text!r} is graded right"
        for text in samples.unreadable:
            if judge(solved.variant, name, text).code not in (Code.UNREADABLE, Code.EMPTY):
                yield f"answer {name}: {text!r} is read"


def _full(solved: Solved, name: str, text: str) -> bool:
    return judge(solved.variant, name, text).code in (Code.RIGHT, Code.KEPT)  # a lecturer reads what is kept


def _mistakes(solved: Solved) -> Iterator[str]:
    """Each mistake is told from the reference and from the others, and is recognised when it is made."""
    right = {answer: solved.reference(answer) for answer in solved.answers}
    slips = {"the reference": right} | variants.predictions(solved)
    for name, expected in slips.items():
        if name == "the reference":
            continue
        for other, answers in slips.items():
            if other != name and not variants.differ(solved, expected, answers):
                yield f"mistake {name} is not three tolerances from {other}"
        found = grade(Submission(solved.variant, _typed(solved, expected))).mistake
        if found != name:
            yield f"mistake {name} is recognised as {found}"


def _typed(solved: Solved, expected: Mapping[str, Reference]) -> dict[str, str]:
    return {name: grader.show(expected[name]) for name, grader in solved.answers.items()}


def _printed(solved: Solved) -> Iterator[str]:
    """The printed numbers, read back, solve to the reference."""
    printed = printed_givens(solved.variant, "en")
    reread = {p.name: float(p.number.replace("−", "-")) * read_unit(p.unit or "1").factor for p in printed}
    missing = set(numbers(solved.variant.givens)) - set(reread)
    if missing:
        yield f"the statement does not print {', '.join(sorted(missing))}"
        return
    lines = {name: repr(value) for name, value in reread.items()}
    try:
        values = solve(solved.exercise, solved.variant.givens, replaced=lines)
    except UndefinedError:
        yield "the printed numbers have no solution"
        return
    for name in {solved.step_of(answer) for answer in solved.answers}:
        if not agree(values[name], solved.values[name], 1e-7):
            yield f"the printed numbers give {name} = {values[name]!r}, not {solved.values[name]!r}"


def _words(words: Mapping[str, Words]) -> Iterator[str]:
    """All three languages carry the same keys, and no control character slipped in by an unescaped string."""
    for section in sorted({*SECTIONS, *(s for w in words.values() for s in w if isinstance(w[s], Mapping))}):
        keys = {lang: frozenset(words[lang].get(section, {})) for lang in LANGUAGES}
        differing = frozenset.union(*keys.values()) - frozenset.intersection(*keys.values())
        if differing:
            yield f"the languages differ in [{section}]: {', '.join(sorted(differing))}"
    for lang in LANGUAGES:
        for text in _texts(words[lang]):
            if any(ord(c) < 32 and c != "\n" for c in text):
                yield f"{lang}.toml holds a control character in {text[:40]!r}: write words in literal strings"


def _texts(words: Any) -> Iterator[str]:
    if isinstance(words, str):
        yield words
    elif isinstance(words, Mapping | list):
        for inner in words.values() if isinstance(words, Mapping) else words:
            yield from _texts(inner)


def record(variant: Variant) -> dict[str, Json]:
    """Write down what a variant is judged against: the values of its steps, and a right text for each answer."""
    solved = Solved(catalogue.load(variant.exercise).exercise, variant)
    return {"values": {name: solved.values[name] for name in solved.steps}, "texts": reference(variant)}


def kept(recorded: Mapping[str, Json]) -> Kept:
    """Give the recorded values of the steps, as they go into grading."""
    values = recorded["values"].items()
    return tuple((name, tuple(map(tuple, value)) if isinstance(value, list) else value) for name, value in values)


def reproduced(variant: Variant, recorded: Mapping[str, Json]) -> bool:
    """Tell whether the exercise as it is installed still leads to what was recorded of a variant."""
    solved = Solved(catalogue.load(variant.exercise).exercise, variant)
    then, texts = dict(kept(recorded)), reference(variant)
    if set(then) != set(solved.steps) or set(texts) != set(recorded["texts"]):
        return False
    formulas = [name for name, grader in solved.answers.items() if grader.symbolic]
    return all(agree(solved.values[name], then[name]) for name in then) and all(
        texts[name] == recorded["texts"][name] for name in formulas
    )


def digest(exercise_id: str) -> str:
    """Digest givens and references of the first twenty seeds, to nine figures: it changes when a variant changes."""
    lines = []
    for seed in range(DIGEST_SEEDS):
        variant = variants.deal(exercise_id, seed)
        solved = Solved(catalogue.load(exercise_id).exercise, variant)
        values = [(name, _rounded(value)) for name, value in solved.values.items()]
        rules = [(name, sorted(grader.describe().items())) for name, grader in solved.answers.items()]
        lines.append(repr((values, rules)))
    return sha256("\n".join(lines).encode()).hexdigest()[:16]


def _rounded(value: Value) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, tuple):
        return repr([[f"{e + 0.0:.6f}" for e in row] for row in value])
    return f"{value:.8e}"


def _digest(exercise_id: str) -> Iterator[str]:
    entry = catalogue.load(exercise_id)
    stored = cases(exercise_id)["digest"]
    found = digest(exercise_id)
    if stored["value"] != found:
        yield (
            f"the variants of version {stored['version']} changed: raise `version` and store "
            f'[digest] version = {entry.exercise.version}, value = "{found}" in cases.toml'
        )
    elif stored["version"] != entry.exercise.version:
        yield f"cases.toml stores the digest of version {stored['version']}, the exercise is {entry.exercise.version}"


def cases(exercise_id: str) -> Mapping[str, Any]:
    """Read the worked cases and the stored digest beside an exercise."""
    return tomllib.loads((catalogue.load(exercise_id).folder / "cases.toml").read_text("utf-8"))


def _cases(exercise_id: str) -> Iterator[str]:
    """Published cases hold to the digits printed by their source."""
    from exercises.givens import restore

    exercise = catalogue.load(exercise_id).exercise
    for case in cases(exercise_id)["case"]:
        givens = restore(exercise.givens, case["givens"])
        values = solve(exercise, givens)
        for name, published in case["steps"].items():
            expected = tuple(tuple(row) for row in published) if isinstance(published, list) else published
            if not agree(values[name], expected, float(case.get("rtol", 1e-6))):
                yield f"{case['source']}: {name} = {values[name]!r}, published {published!r}"
