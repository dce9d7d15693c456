"""The catalogue: which exercises there are, for programs and as cards that a reader looks through."""
