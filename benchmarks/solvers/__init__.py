"""Rows of `benchmarks/mechanics.py`, a module a chapter: each holds `ROWS`."""
