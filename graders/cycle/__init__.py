"""Tables of a cycle: read from CSV, compared with a periodic reference, slips told apart."""
