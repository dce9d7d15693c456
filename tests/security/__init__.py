"""Attacks, one file for each row of the security table; the number of the row stands in the file's name."""
