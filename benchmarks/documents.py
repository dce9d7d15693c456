"""Documents: the TMM-2 report as PDF, warm, and the sheets of a class with their key.

    uv run python benchmarks/documents.py [--sheets 100] [--rounds 30]

Prints the median and the 95th percentile of a report that was never written before (another name each time), in each
language, the seconds of the sheets and of the key, and the ratio of the median to the 10 ms that are promised.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse  # noqa: E402
from statistics import median, quantiles  # noqa: E402
from time import perf_counter  # noqa: E402

from exercises.variants import deal  # noqa: E402
from reports import formats, sheets  # noqa: E402
from reports.tmm2 import Person, tmm2  # noqa: E402

PROMISED = 10.0  # ms


def report(language: str, number: int) -> float:
    """Write a skeleton under a new name; gives milliseconds."""
    start = perf_counter()
    formats.written(tmm2(deal("tmm2_oop", 7), language, Person(f"Anna {number}", "M2"), "7"), "pdf")
    return 1000 * (perf_counter() - start)


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
        report(language, 0)
        times = [report(language, number) for number in range(1, options.rounds + 1)]
        medians.append(median(times))
        print(f"report {language}: median {medians[-1]:.1f} ms, p95 {quantiles(times, n=20)[-1]:.1f} ms")
    whole, key = printed(options.sheets)
    print(f"{options.sheets} sheets {whole:.1f} s, key {key:.1f} s")
    print(f"ratio {max(medians) / PROMISED:.2f}")


if __name__ == "__main__":
    main()
