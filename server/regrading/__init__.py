"""Regrading a set: what was handed in is judged again, and what changes is told before anything does."""
