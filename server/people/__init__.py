"""People: accounts, sessions, tokens, the ways in, and what is kept of a person."""
