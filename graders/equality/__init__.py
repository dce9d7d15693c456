"""Equality of formulas as functions on a domain, decided by ball arithmetic."""

from graders.equality.comparing import Comparison, Finding, compare

__all__ = ["Comparison", "Finding", "compare"]
