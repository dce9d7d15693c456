"""Documents: the TMM-2 report as PDF, warm, and the sheets of a class with their key.

    uv run python benchmarks/documents.py [--sheets 100] [--rounds 30]

Prints the median and the 95th percentile of a report that was never written before, in each language: of one variant
under another name, its dealing included, and of another student, whose variant was dealt before as it is when reports
are asked for; of the clock, and of the processor where the machine does more. Then the seconds of the sheets and of
the key, and the ratio of the worst median to the promised 10 ms.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
from statistics import median, quantiles
from time import perf_counter, process_time

from exercises.variants import deal
from reports import formats, sheets
from reports.tmm2 import Person, tmm2

PROMISED = 10.0  # ms
Spent = tuple[float, float]  # of the clock, of the processor


def now() -> Spent:
    """Read the clock and the processor's."""
    return perf_counter(), process_time()


def since(start: Spent) -> Spent:
    """Give the milliseconds since then."""
    return 1000 * (perf_counter() - start[0]), 1000 * (process_time() - start[1])


def renamed(language: str, number: int) -> Spent:
    """Deal one variant again and write its skeleton under a new name."""
    start = now()
    formats.written(tmm2(deal("tmm2_oop", 7), language, Person(f"Anna {number}", "M2"), "7"), "pdf")
    return since(start)


def another(language: str, number: int) -> Spent:
    """Write the skeleton of a student whose variant was dealt before."""
    variant = deal("tmm2_oop", 1000 + number)
    start = now()
    formats.written(tmm2(variant, language, Person(f"Jan {number}", "M2"), str(number)), "pdf")
    return since(start)


def printed(count: int) -> tuple[float, float]:
    """Print sheets and their key; gives the seconds of both."""
    start = perf_counter()
    dealt = [sheets.sheet(str(seed), deal("simple_beam", seed), "pl") for seed in range(count)]
    formats.written(sheets.sheets(dealt, "pl"), "pdf")
    middle = perf_counter()
    formats.written(sheets.key(dealt, "pl"), "pdf")
    return middle - start, perf_counter() - middle


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sheets", type=int, default=100)
    parser.add_argument("--rounds", type=int, default=30)
    options = parser.parse_args()
    medians = []
    for language in ("pl", "en", "ru"):
        for who, report in (("under another name", renamed), ("of another student", another)):
            report(language, 0)
            times, worked = zip(*(report(language, number) for number in range(1, options.rounds + 1)), strict=True)
            medians.append(median(times))
            spread = f"median {medians[-1]:.1f} ms, p95 {quantiles(times, n=20)[-1]:.1f} ms"
            print(f"report {language} {who}: {spread}; processor {median(worked):.1f} ms")
    whole, key = printed(options.sheets)
    print(f"{options.sheets} sheets {whole:.1f} s, key {key:.1f} s")
    print(f"ratio {max(medians) / PROMISED:.2f}")


if __name__ == "__main__":
    main()
