"""What stands in `deploy/` fits to the program and keeps the promises of the manual."""
