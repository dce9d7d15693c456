"""Curves along a bar: stretches of polynomials, read from pieces or from a table, and the marks they earn."""
