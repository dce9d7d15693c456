"""The judges: one file an answer kind."""
