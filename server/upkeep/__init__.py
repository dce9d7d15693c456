"""What an operator does with a whole store: copying it to a file, and moving it into another store."""
