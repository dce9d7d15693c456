"""Equality of formulas as functions on a domain, decided by ball arithmetic."""

from graders.equality.comparing import between, compare, rounds
from graders.equality.deciding import Finding
from graders.equality.entries import between_entries, compare_entries
from graders.equality.pair import Comparison

__all__ = ["Comparison", "Finding", "between", "between_entries", "compare", "compare_entries", "rounds"]
