"""Reference solvers and oracles. SI in, SI out, no state."""
