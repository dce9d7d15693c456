"""Wrong values from which later answers may be solved."""

from __future__ import annotations

from graders.judge import Matrix, Value

PLAUSIBLE = 1e3  # follow-through only from values within this factor of the reference, either way
FULL = 2 / 3  # of the share of entries of a right matrix that are not zero
FEW = 3  # things counted: the freedoms of a link in the plane


def plausible(value: Value, right: Value, counts: bool = False) -> bool:
    """Tell whether later answers may be solved from a value: neither trivial nor far from the right one in size.

    The sign is free: to lose it is an ordinary slip. A matrix has the size of the right one, and is as full: zeros make
    what follows trivial. So does a zero, but one that counts (pairs, freedoms) may stand for a few, or a few for it.
    """
    if isinstance(value, str) or isinstance(right, str):
        return True
    if isinstance(value, tuple) and isinstance(right, tuple):
        (size, full), (right_size, right_full) = map(_filled, (value, right))
        return full >= FULL * right_full and right_size / PLAUSIBLE < size < right_size * PLAUSIBLE
    if isinstance(value, tuple) or isinstance(right, tuple):
        return False
    if counts and not (value and right):
        return abs(value - right) <= FEW
    return abs(right) / PLAUSIBLE < abs(value) < abs(right) * PLAUSIBLE


def _filled(matrix: Matrix) -> tuple[float, float]:
    """Give the largest entry of a matrix, and the share of entries that are not negligible beside it."""
    entries = [abs(entry) for row in matrix for entry in row]
    largest = max(entries)
    return largest, sum(entry > largest / PLAUSIBLE**2 for entry in entries) / len(entries)
