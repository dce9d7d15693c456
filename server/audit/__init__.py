"""The audit log: who did what to whom, written with the act, and read by those it concerns."""
