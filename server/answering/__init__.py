"""Answering: variants, drafts, hints, submissions and their receipts, and the pages on which students work."""
