"""Judges on the settled pairs of the corpus, kind by kind: wrong and open verdicts, times; formulas beside peers.

Every time is that of the cold texts: both are read, compiled and compared (least of three runs a pair). The peers get
the same pairs as texts: SymPy `simplify(a - b) == 0`, mpmath at 50 digits at sixteen points, and `a.equals(b)` as
PrairieLearn asks it; each has a limit a pair, and a pair without a verdict counts as open.
Run: ``uv run python benchmarks/judges.py [--peers 150] [--limit 2]``; ``--peers 0`` leaves them out.
Exit code 1 when a verdict is wrong or a target is missed.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import gc
import random
import signal
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import mpmath
import sympy

from graders import AnswerSyntaxError, Quantity, Symbols, comparison
from graders.equality import Finding, between
from graders.language import parse
from graders.language.program import Arithmetic, Builder, Program, Runner
from graders.language.tree import Number
from graders.states import spread
from tests.corpus import Pair, kinds, pairs
from tests.graders.comparison.test_corpus import asked

RUNS = 3
OPEN = "undecided"
VERDICTS = {Finding.EQUAL: "equal", Finding.DIFFERENT: "different", Finding.UNDEFINED: "different"}
TARGETS = {  # kind: median and 99th percentile, milliseconds
    "expression": (0.08, 0.5),
    "equation": (0.2, 4.0),
    "system": (1.0, None),
    "matrix": (0.3, None),
    "quantity field": (0.01, None),
}
FIELDS = [  # unit, what is typed, true value, right
    ("MPa", "12,5 MPa", 12.5e6, True), ("MPa", "12500 kPa", 12.5e6, True), ("MPa", "1.25e7 N/m^2", 12.5e6, True),
    ("MPa", "12.4", 12.5e6, False), ("deg", "-12,37°", -0.2158972, True), ("deg", "347.63", -0.2158972, True),
    ("N*m", "25 J", 25.0, False), ("mm", "3/8 mm", 3.75e-4, True), ("mm", "0,0375 cm", 3.75e-4, True),
    ("rpm", "1500 obr/min", 157.0796, True), ("kN", "-4.2", 4200.0, False), ("rad/s", "9,1 rad/s", 9.1, True),
]  # fmt: skip


class TooLong(Exception):
    """A peer has had its time."""


@dataclass(slots=True)
class Tally:
    """Verdicts and times of one judge on some pairs."""

    times: list[float] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)
    open: list[str] = field(default_factory=list)

    def add(self, place: str, expected: str, found: str, seconds: float) -> None:
        self.times.append(seconds)
        if found == OPEN:
            self.open.append(place)
        elif found != expected:
            self.wrong.append(f"{place} {expected}, found {found}")

    def quantile(self, share: float) -> float:
        """Give a quantile of the times in milliseconds."""
        return 1e3 * sorted(self.times)[min(len(self.times) - 1, int(share * len(self.times)))]

    def line(self, name: str) -> str:
        times = "".join(f"{self.quantile(share):10.3f}" for share in (0.5, 0.95, 0.99, 1.0))
        return f"{name:28}{len(self.times):6}{len(self.wrong):7}{len(self.open):6}{times}"


def expression(pair: Pair) -> str:
    """Judge two formulas on their box."""
    symbols = Symbols(name for name, _ in pair.domains)
    try:
        found = between(parse(pair.a[0], symbols), parse(pair.b[0], symbols), dict(pair.domains), b"judges").finding
    except AnswerSyntaxError:
        return "unreadable"
    return VERDICTS.get(found, OPEN)


def ours(kind: str) -> Tally:
    """Judge all pairs of a kind."""
    tally = Tally()
    for pair in pairs(kind):
        judge = partial(expression, pair) if kind == "expression" else partial(_answered, asked(pair))
        found, seconds = timed(judge)
        tally.add(pair.place, pair.verdict, found, seconds)
    return tally


def _answered(request: dict[str, Any]) -> str:
    return str(comparison.answer(request)["verdict"])


def fields() -> Tally:
    """Judge typed quantities at their fields."""
    tally = Tally()
    for unit, typed, true, right in FIELDS:
        judge = Quantity(unit)
        found, seconds = timed(partial(_field, judge, typed, true))
        tally.add(typed, str(right), str(found.score == 1), seconds)
    return tally


def _field(judge: Quantity, typed: str, true: float) -> Any:
    return judge.check(judge.parse(typed, Symbols(())), true)


def timed(judge: Callable[[], Any]) -> tuple[Any, float]:
    """Give a verdict and the least time of some runs."""
    least = float("inf")
    for _ in range(RUNS):
        start = time.perf_counter()
        found = judge()
        least = min(least, time.perf_counter() - start)
    return found, least


def rational(number: Number) -> sympy.Rational:
    """Give a literal exactly."""
    return sympy.Rational(number.exact.numerator, number.exact.denominator)


def macaulay(inside: Any, order: Any) -> Any:
    """Give a bracket as SymPy knows it."""
    return sympy.SingularityFunction(inside, 0, order)


SYMPY = Arithmetic(
    rational,
    {
        "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b, "/": lambda a, b: a / b,
        "^": lambda a, b: a**b, "negate": lambda a: -a, "degrees": lambda a: a * sympy.pi / 180, "pi": lambda: sympy.pi,
        "integer_power": lambda a, n: a**n, "sin": sympy.sin, "cos": sympy.cos, "tan": sympy.tan, "cot": sympy.cot,
        "asin": sympy.asin, "acos": sympy.acos, "atan": sympy.atan, "acot": lambda x: sympy.pi / 2 - sympy.atan(x),
        "atan2": sympy.atan2, "sinh": sympy.sinh, "cosh": sympy.cosh, "tanh": sympy.tanh, "exp": sympy.exp,
        "ln": sympy.log, "log": lambda x: sympy.log(x, 10), "log_base": sympy.log, "sqrt": sympy.sqrt,
        "root": sympy.real_root, "abs": sympy.Abs, "sign": sympy.sign, "min": sympy.Min, "max": sympy.Max,
        "macaulay": macaulay,
    },
)  # fmt: skip


def bracket(inside: Any, order: Any) -> Any:
    """Give the value of a bracket at a point."""
    return mpmath.mpf(0) if inside < 0 else inside**order


def root(x: Any, degree: Any) -> Any:
    """Give a root; one of odd degree has a sign."""
    return -((-x) ** (1 / degree)) if x < 0 and degree % 2 == 1 else x ** (1 / degree)


MPMATH = Arithmetic(
    lambda number: mpmath.mpf(number.exact.numerator) / number.exact.denominator,
    {
        "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b, "/": lambda a, b: a / b,
        "^": mpmath.power, "negate": lambda a: -a, "degrees": lambda a: a * mpmath.pi / 180, "pi": lambda: +mpmath.pi,
        "integer_power": lambda a, n: a**n, "sin": mpmath.sin, "cos": mpmath.cos, "tan": mpmath.tan, "cot": mpmath.cot,
        "asin": mpmath.asin, "acos": mpmath.acos, "atan": mpmath.atan, "acot": lambda x: mpmath.pi / 2 - mpmath.atan(x),
        "atan2": mpmath.atan2, "sinh": mpmath.sinh, "cosh": mpmath.cosh, "tanh": mpmath.tanh, "exp": mpmath.exp,
        "ln": mpmath.log, "log": mpmath.log10, "log_base": mpmath.log, "sqrt": mpmath.sqrt, "root": root, "abs": abs,
        "sign": mpmath.sign, "min": min, "max": max, "macaulay": bracket,
    },
)  # fmt: skip


def program_of(pair: Pair) -> Program:
    """Read a pair for the peers."""
    symbols = Symbols(name for name, _ in pair.domains)
    builder = Builder([name for name, _ in pair.domains])
    return builder.program(*(builder.add(parse(text, symbols)) for text in (pair.a[0], pair.b[0])))


def in_sympy(pair: Pair) -> tuple[Any, Any]:
    """Give both sides with symbols that are real, positive and whole where their domains are."""
    symbols = [
        sympy.Symbol(name, real=True, positive=domain.low > 0 or None, integer=domain.integer or None)
        for name, domain in pair.domains
    ]
    a, b = Runner(program_of(pair), SYMPY).run(symbols)
    return a, b


def simplified(pair: Pair) -> str:
    """Ask SymPy whether the difference simplifies to zero."""
    a, b = in_sympy(pair)
    return "equal" if sympy.simplify(a - b) == 0 else "different"


def equals(pair: Pair) -> str:
    """Ask as PrairieLearn does."""
    a, b = in_sympy(pair)
    return "equal" if a.equals(b) else "different"


def at_points(pair: Pair) -> str:
    """Compare at sixteen points with 50 digits."""
    runner, seen = Runner(program_of(pair), MPMATH), 0
    with mpmath.workdps(50):
        for point in spread(dict(pair.domains), b"mpmath").points[:16]:
            try:
                a, b = runner.run([mpmath.mpf(x) for x in point])
            except (ZeroDivisionError, ValueError):
                continue
            seen += 1
            if abs(a - b) > mpmath.mpf(10) ** -40 * max(abs(a), abs(b), 1):
                return "different"
    return "equal" if seen else OPEN


PEERS = {"SymPy simplify(a - b) == 0": simplified, "mpmath, 50 digits": at_points, "SymPy a.equals(b)": equals}


@contextmanager
def at_most(seconds: float) -> Iterator[None]:
    """Stop whatever takes longer."""

    def stop(*_: object) -> None:
        raise TooLong

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def beside(judge: Callable[[Pair], str], chosen: Sequence[Pair], limit: float) -> Tally:
    """Let a judge decide some pairs; what takes too long is no verdict, nor what SymPy raises on its own NaN."""
    tally = Tally()
    for pair in chosen:
        sympy.core.cache.clear_cache()
        gc.collect()
        start = time.perf_counter()
        try:
            with at_most(limit):
                found = judge(pair)
        except (TooLong, ArithmeticError, TypeError, ValueError):
            found = OPEN
        tally.add(pair.place, pair.verdict, found, time.perf_counter() - start)
    return tally


def met(name: str, tally: Tally) -> bool:
    """Say how a kind stands beside its targets."""
    median, high = TARGETS.get(name, (None, None))
    failures = [f"wrong: {line}" for line in tally.wrong]
    failures += [f"open: {len(tally.open)}"] if len(tally.open) > 0.005 * len(tally.times) else []
    failures += [f"median above {median} ms"] if median and tally.quantile(0.5) > median else []
    failures += [f"99th percentile above {high} ms"] if high and tally.quantile(0.99) > high else []
    print(*(f"    {failure}" for failure in failures), sep="\n", end="\n" if failures else "")
    return not failures


def main() -> int:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--peers", type=int, default=150, help="pairs that the peers get")
    parser.add_argument("--limit", type=float, default=2.0, help="seconds a pair for a peer")
    arguments = parser.parse_args()
    head = "".join(f"{title:>10}" for title in ("median", "95 %", "99 %", "max"))
    gc.disable()  # the peers leave much behind
    print(f"{'milliseconds':28}{'pairs':>6}{'wrong':>7}{'open':>6}{head}")
    passed = True
    for kind in kinds():
        tally = ours(kind)
        print(tally.line(kind))
        passed &= met(kind, tally)
    tally = fields()
    print(tally.line("quantity field"))
    passed &= met("quantity field", tally)
    if arguments.peers:
        readable = [pair for pair in pairs("expression") if pair.verdict != "unreadable"]
        chosen = random.Random(1).sample(readable, min(arguments.peers, len(readable)))
        print(beside(expression, chosen, arguments.limit).line("ours, the peers' pairs"))
        for name, judge in PEERS.items():
            print(beside(judge, chosen, arguments.limit).line(name), flush=True)
    print("targets:", "; ".join(f"{k} {m} ms" + (f", 99 % {h} ms" if h else "") for k, (m, h) in TARGETS.items()))
    print("all targets met" if passed else "FAILED")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
