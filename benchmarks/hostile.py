"""The dearest answers that could be thought of, at every judge: processor time and memory beside the promise.

Each text is handed in at every answer of the exercises whose kind it is meant for, and graded with all that belongs to
it, follow-through, mistakes and common slips. Kinds without an exercise are asked alone.
Times are also given as on a machine that adds a thousand squares in 28 µs, so that runs can be compared. Run:
``uv run python benchmarks/hostile.py``. Exit code 1 where an answer costs above 50 ms (so counted) or 20 MB.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import gc
import time
import tracemalloc
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

from exercises import catalogue, variants
from exercises.exercise import Submission
from exercises.grading import grade
from exercises.solving import Solved
from tests.graders.fuzzing.attack import Found, Target, forget, one, targets
from tests.graders.fuzzing.families import families

PROMISED, MOST_MEMORY, SHOWN = 50.0, 20.0, 12  # milliseconds, megabytes, lines
WORTH = 10.0  # milliseconds from which a case is measured well
USUAL = 28e-6  # s that a thousand squares take on the machine that the promise is about
RUNS = 3


def squares() -> float:
    """Give the seconds that this machine takes for a thousand squares, at its best of many tries."""

    def once() -> float:
        start, total = time.perf_counter(), 0
        for i in range(1000):
            total += i * i
        return time.perf_counter() - start

    return min(once() for _ in range(200))


def formulas(target: Target) -> Iterator[str]:
    """Give long formulas in the symbols of a judge."""
    usable = sorted(target.symbols.names) or ["1"]
    pick: Callable[[int], str] = lambda at: usable[at % len(usable)]  # noqa: E731
    yield "+".join(f"sign({pick(k)} - {k}/7)*<{pick(k + 1)} - {k}/9>^1" for k in range(60))
    yield "*".join(f"max({pick(k)}; {pick(k + 1)} - {k}/50)" for k in range(40))
    yield "+".join(f"sqrt({pick(k)}^2 + {k})*abs(sin({k + 3}*{pick(k + 1)}))" for k in range(50))
    yield "+".join(f"sin(1e{k % 9}*{pick(k)})^{k + 2}" for k in range(70))
    yield "+".join(f"exp(-1e{k % 12}*({pick(k)} - 0.3)^2)" for k in range(50))
    yield "max(" + ";".join(f"{pick(k)}*{k + 1}/3" for k in range(12)) + ")*" + f"atan2({pick(0)}; {pick(1)} - 0.5)" * 1
    yield "abs(" * 50 + pick(0) + "".join(f" - {k}/90)" for k in range(50))
    yield "sqrt(" * 50 + pick(0) + "".join(f" + {k})" for k in range(50))
    yield "atan(tan(" * 25 + pick(0) + "))" * 25
    yield "+".join(f"root({pick(k)}; {k + 3})^0.7" for k in range(60))
    yield "+".join(f"{pick(k)}^{90 + k}" for k in range(80))
    yield "-".join([f"({'+'.join(usable[:8])})^3"] * 30)
    for shown in (text for text in (target.grader.show(target.reference),) if len(text) < 300):
        yield f"({shown})*(1 + sign(sin({pick(0)})^2 + cos({pick(0)})^2 - 1))"
        yield f"({shown}) + max(0; sin(1e6*{pick(0)}) - 1.0000001)"
        yield "+".join([f"({shown})/20"] * max(1, min(20, 1500 // (len(shown) + 5))))


def equations(target: Target) -> Iterator[str]:
    """Give equations and inequalities of such formulas."""
    names = sorted(target.symbols.known)
    for text in formulas(target):
        yield f"{text} = {names[-1]}"
        yield f"{names[0]} < {text}"
        yield f"{text} = {names[-1]}; {names[0]} = {text}"[:1990]


def tables(target: Target) -> Iterator[str]:
    """Give long tables of numbers, all of them changed a little."""
    text = target.grader.show(target.reference)
    lines = text.splitlines()
    for factor in (-1.0, 1.013, 2.0):
        yield "\n".join([lines[0], *(";".join(_times(cell, factor) for cell in line.split(";")) for line in lines[1:])])
    yield "\n".join([lines[0], *(lines[1:] * 40)])[:190_000]
    yield "\n".join([lines[0], *reversed(lines[1:])])
    yield "\n".join([lines[0], *(";".join(reversed(line.split(";"))) for line in lines[1:])])
    yield "\n".join([lines[0], *(";".join([str((k * 37) % 101)] * len(lines[0].split(";"))) for k in range(2000))])


def _times(cell: str, factor: float) -> str:
    try:
        return repr(float(cell.replace(",", ".")) * factor)
    except ValueError:
        return cell


def items(target: Target) -> Iterator[str]:
    """Give as many items as may be typed, none or nearly all of them right."""
    width = target.grader.show(target.reference).split(";")[0].count(",") + 1
    for start in (0.1, 17.0, 359.0):
        rows = [[f"{start + 1.37 * k + 0.11 * j:.4f}" for j in range(8)] for k in range(24)]
        for count in (1, 2, 3, 4, 6, width):
            yield "; ".join("(" + "; ".join(row[:count]) + ")" for row in rows)
    yield "; ".join([target.grader.show(target.reference)] * 24)[:1990]


def rows(target: Target) -> Iterator[str]:
    """Give tables and matrices full of formulas."""
    usable = sorted(target.symbols.names) or ["1"]
    for size, width in ((3, 4), (4, 4), (6, 4), (1, 4), (3, 3)):
        for entry in (
            "+".join(f"sign({usable[k % len(usable)]})" for k in range(8)),
            "+".join(f"abs(sin({k}*{usable[k % len(usable)]}))" for k in range(6)),
            "(" + "+".join(usable[:6]) + ")^9",
            "max(" + ";".join(f"{name}" for name in (usable * 3)[:6]) + ")",
        ):
            yield "[" + ";".join("[" + ";".join([entry] * width) + "]" for _ in range(size)) + "]"


def curves(target: Target) -> Iterator[str]:
    """Give curves along a bar with as many brackets and pieces as may be typed."""
    usable = sorted(target.symbols.names - {"x"}) or ["1"]
    yield "+".join(f"<x - {k}/40>^{k % 4}" for k in range(1, 90))
    yield "+".join(f"{usable[k % len(usable)]}*<x - {usable[(k + 1) % len(usable)]}*{k}/40>^{k % 4}" for k in range(60))
    yield "*".join(f"<x - {k}/40>^1" for k in range(1, 7))
    yield "; ".join(f"{k}/50 .. {k + 1}/50: {k}*x^2 - x" for k in range(50))
    yield "(" + "+".join(f"<x - {k}/9>^1" for k in range(12)) + ")^5"


def lines(target: Target) -> Iterator[str]:
    """Give the lines of a right answer changed, doubled and many."""
    text = target.grader.show(target.reference)
    swapped = text.replace("sin", "tmp").replace("cos", "sin").replace("tmp", "cos")
    yield from (text, swapped, text.replace("+", "-"), text.replace("=", "= 0*3 +"), "\n".join([text] * 4))
    yield text.replace("cos", "abs(1)*cos").replace("sin", "sign(1)*sin")
    yield "\n".join(reversed(text.splitlines()))


KINDS: dict[str, tuple[Callable[[Target], Iterator[str]], ...]] = {
    "expression": (formulas,), "equation": (equations,), "system": (equations,), "inequality": (equations,),
    "symbolic_matrix": (rows,), "matrix": (rows,), "dh_table": (rows,), "function": (formulas, curves),
    "diagram": (curves,), "samples": (tables,), "set": (items,), "polygon": (lines,), "rates": (lines,),
    "quantity": (formulas,), "rational": (formulas,), "integer": (formulas,),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Case:
    """An answer to be handed in: alone at its judge, or as a submission that is graded as a whole."""

    kind: str
    text: str
    act: Callable[[], object]

    def once(self) -> float:
        """Give the milliseconds of processor time that it takes."""
        forget()
        start = time.process_time()
        self.act()
        return 1e3 * (time.process_time() - start)

    def cost(self) -> tuple[float, float]:
        """Give the least time of some runs, and the memory in megabytes."""
        least = min(self.once() for _ in range(RUNS))
        tracemalloc.start()
        self.act()
        memory = tracemalloc.get_traced_memory()[1] / 1e6
        tracemalloc.stop()
        return least, memory


def cases(exercises: Sequence[str]) -> Iterator[Case]:
    """Give all texts for all judges: of the exercises as submissions, of the kinds without an exercise alone.

    Repeated things are handed to the first judge of each kind.
    """
    met = set[str]()
    for exercise in exercises:
        variant = variants.deal(exercise, 1)
        for name, target in answers(exercise).items():
            for text in every_text(target, met):
                yield Case(target.grader.kind, text, partial(grade, Submission(variant, {name: text})))
    for target in targets(exercises[:1], (1,))[: -len(answers(exercises[0]))]:
        yield from (Case(target.grader.kind, text, partial(alone, target, text)) for text in every_text(target, met))


def every_text(target: Target, met: set[str]) -> list[str]:
    """Give the texts meant for a kind, and where it is met for the first time what is repeated."""
    repeated = [] if target.grader.kind in met else list(families())
    met.add(target.grader.kind)
    return [*texts(target), *repeated]


def answers(exercise: str) -> dict[str, Target]:
    """Give the judges of an exercise."""
    solved = Solved(catalogue.load(exercise).exercise, variants.deal(exercise, 1))
    return {n: Target(g, solved.reference(n), solved.symbols(n), ()) for n, g in solved.answers.items()}


def texts(target: Target) -> Iterator[str]:
    """Give the texts meant for a kind."""
    for source in KINDS.get(target.grader.kind, ()):
        yield from source(target)


def alone(target: Target, text: str) -> None:
    """Hand a text to a judge."""
    found = Found()
    one(target, text, found)
    if found.crashes:
        raise AssertionError(found.crashes[0])


def main() -> int:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("exercises", nargs="*", metavar="ID")
    exercises = parser.parse_args().exercises or catalogue.ids()
    gc.freeze()  # what the modules hold stays
    before, found = squares(), list[tuple[float, float, str, str]]()
    for case in cases(exercises):
        if case.once() > WORTH:
            found.append((*case.cost(), case.kind, case.text))
    speed = USUAL / min(before, squares())
    found.sort(reverse=True)
    print(f"this machine runs at {speed:.2f} of the speed that the promise is about")
    for took, memory, kind, text in found[:SHOWN]:
        print(
            f"{took * speed:7.1f} ms ({took:.1f} here) {memory:5.1f} MB {kind:16} {text[:60]!r}, {len(text)} characters"
        )
    worst, most = max(took for took, *_ in found) * speed, max(memory for _, memory, *_ in found)
    print(f"worst: {worst:.1f} ms of {PROMISED:.0f}, {most:.1f} MB of {MOST_MEMORY:.0f}")
    return 0 if worst <= PROMISED and most <= MOST_MEMORY else 1


if __name__ == "__main__":
    sys.exit(main())
