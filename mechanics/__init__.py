"""Reference solvers and oracles. SI in, SI out, no state.

One module a solver or a method; `docs/reference/mechanics.md` lists them by chapter. `wire/` reads and answers the
requests of programs.
"""
