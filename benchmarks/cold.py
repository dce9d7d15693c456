"""A cold `grubler grade` of one file against a cold `python -c "import numpy"`; prints `ratio R` last.

Rounds alternate, so that a busy machine slows both; both find their byte code compiled. Run:
``uv run python benchmarks/cold.py``.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[1]
ROUNDS = 21
GRADE = "import sys; from cli.main import main; sys.exit(main())"
ANSWERS = str(ROOT / "docs/examples/answers.json")


def seconds(environment: dict[str, str], *arguments: str) -> float:
    """Time one run of Python."""
    start = time.perf_counter()
    subprocess.run([sys.executable, *arguments], cwd=ROOT, env=environment, stdout=subprocess.DEVNULL, check=True)
    return time.perf_counter() - start


def main() -> None:
    """Measure and print."""
    with TemporaryDirectory() as folder:
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        environment["PYTHONPYCACHEPREFIX"] = folder
        pairs = [
            (seconds(environment, "-c", "import numpy"), seconds(environment, "-c", GRADE, "grade", ANSWERS))
            for _ in range(ROUNDS + 1)
        ][1:]  # the first round compiles
    numpy, grade = (median(times) for times in zip(*pairs, strict=True))
    print(f"import numpy {1000 * numpy:.0f} ms, grubler grade {1000 * grade:.0f} ms")
    print(f"ratio {median(one / other for other, one in pairs):.2f}")


if __name__ == "__main__":
    main()
